// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A spline seen along one parameter: lines of poles over common knots. A curve has one line, a surface as many as it
//! has poles in its other parameter. What is done at the end of the lines extends curves and surfaces alike.
//!
//! Equation numbers are those of Ravi Kumar, Shastry, Prakash, CAD 35 (2003) 411-420, section 3.2.
#pragma once

#include "../spline/tensor_spline.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace laminate_offset
{

using PoleLine = std::vector<Eigen::Vector4d>; //!< homogeneous (w x, w y, w z, w)

struct PoleLines
{
    KnotVector knots;
    std::vector<PoleLine> lines;
    bool rational = false;
};

//! A line that its neighbours fix: pole `line` = before_share * pole `before` + after_share * pole `after`, in
//! homogeneous coordinates, all along the lines. That is how a surface whose knots across allow a crease (a knot as
//! often as the degree, or the seam of a closed surface) is smooth nevertheless.
struct FixedLine
{
    std::size_t line = 0;
    std::size_t before = 0;
    std::size_t after = 0;
    double before_share = 0.5;
    double after_share = 0.5;
};

//! The fixed lines of a surface whose knots in the other parameter are `across`.
std::vector<FixedLine> fixed_lines(const PoleLines &lines, const KnotVector &across);

//! The lines of a surface along u (else v).
PoleLines lines_of(const TensorSpline &surface, bool along_u);

//! The surface again; \param across its knots in the other parameter.
TensorSpline surface_of(const PoleLines &lines, const KnotVector &across, bool along_u);

//! The same points in the opposite sense: the parameter t became -t. What extends the end then extends the start.
PoleLines turned(const PoleLines &lines);

//! The part up to the parameter `end`, inside the range.
PoleLines cut_at_end(const PoleLines &lines, double end);

//! The part from the parameter `start` on.
PoleLines cut_at_start(const PoleLines &lines, double start);

//! Mirror images of the part next to the end up to the parameter `end` past it, eq. 3.2 to 3.4. Each line is mirrored
//! in Euclidean space about the plane through its last pole normal to its last leg. The join keeps the multiplicity
//! p: taking out what is not needed there is left to the caller. The inserted knot u_d of the paper is never part of
//! the result, so that its removal needs no tolerance.
//!
//! Where the ratio of the last two weights differs from line to line, the mirror image alone is not G1. The first
//! mirrored pole then takes the weight and the place, on the same leg, that make it so:
//! Q_{n+1} = 2 r P_n - P_{n-1} in homogeneous coordinates with the mean ratio r = w_{n-1} / w_n (for equal ratios
//! this is the mirror image).
//! Mirroring turns every line about an axis of its own, and would crease the surface along fixed lines: they follow
//! their neighbours instead.
//! \pre end lies past the end of the range.
//! A line that is a single point, along a side that has collapsed, stays that point.
//! \return nothing where the last leg of another line has no length or a weight cannot be kept positive.
std::optional<PoleLines> mirrored_to(const PoleLines &lines, double end, const std::vector<FixedLine> &fixed = {});

//! The last polynomial piece continued to the parameter `end`; same number of poles, every derivative continuous.
//! \return nothing where a weight would not be positive.
std::optional<PoleLines> continued_to(const PoleLines &lines, double end);

} // namespace laminate_offset
