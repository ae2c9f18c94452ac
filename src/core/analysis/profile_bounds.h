// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Proven bounds of a profile curve in coordinates of an axis: z along it, x and y across.
#pragma once

#include "profile_spline.h"

#include <optional>

namespace laminate_offset
{

struct ProfileBounds
{
    double slowest = 0.0;      //!< lower bound of |C'|
    double largest_radius = 0; //!< upper bound of the distance from the axis
    //! Lower bound of the radius; where a piece ends on the axis, of its other Bernstein coefficients.
    double least_radius = 0.0;
    bool touches_axis = false;
    double least_sine = 1.0; //!< lower bound of the sine between C' and the turn about the axis
};

//! \param planar the profile lies in the plane y = 0; the sine is 1.
//! \return nothing where the bounds do not come out positive.
std::optional<ProfileBounds> profile_bounds(const ProfileSpline &profile, bool planar);

} // namespace laminate_offset
