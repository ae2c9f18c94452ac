// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! What the searches for meetings of a surface with itself (self_intersection.h) and with others (part_meetings.h) have in
//! common: how far they go, and what counts as a meeting.
#pragma once

#include "../input/input_face.h"

#include <algorithm>
#include <cmath>

namespace laminate_offset
{

//! Pairs of patches that one search looks at.
inline constexpr int most_pairs = 60000;
//! Newton's method is tried once in so many halvings of a pair.
inline constexpr int newton_interval = 3;
//! Patches of this part of the tolerance are as good as points.
inline constexpr double resolution_share = 0.5;
//! Points that coincide to this part of the face's size are one point.
inline constexpr double coincidence = 1e-10;

//! Base points of a meeting lie apart by this much at least [mm]: a good part of the distance (normals differ by some ten
//! degrees), and what the tolerance cannot tell apart.
inline double least_apart(double distance, double tolerance)
{
    constexpr double separation = 0.2;
    return std::max(separation * std::abs(distance), 4.0 * tolerance);
}

inline ParameterBox hull(const ParameterBox &a, const ParameterBox &b)
{
    return {std::min(a.umin, b.umin), std::max(a.umax, b.umax), std::min(a.vmin, b.vmin), std::max(a.vmax, b.vmax)};
}

inline ParameterBox shifted(const ParameterBox &box, double du, double dv)
{
    return {box.umin + du, box.umax + du, box.vmin + dv, box.vmax + dv};
}

} // namespace laminate_offset
