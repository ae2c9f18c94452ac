// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! How steep a ramp is.
#pragma once

#include "../analysis/base_surface.h"
#include "../analysis/loop_region.h"
#include "../spline/scalar_spline.h"

#include <gp_Pnt2d.hxx>

#include <vector>

namespace laminate_offset
{

//! A slope along the surface, of a share [1/mm] or of a distance (1), and where.
struct SteepPlace
{
    double slope = 0.0;
    gp_Pnt2d uv;
};

//! The largest slope of a share or of a distance along the surface, seen at places inside; 0 where it is level.
SteepPlace steepest_place(const BaseSurface &base, const ScalarSpline &share, const LoopRegion &inside);

//! The same for every span of the share's knots on its own: the steepest place of each that is steeper than `least`.
std::vector<SteepPlace> steep_places(const BaseSurface &base, const ScalarSpline &share, const LoopRegion &inside,
                                     double least);

//! The slope at one place.
//! \param share as ScalarSpline::as_surface gives it.
double slope_at(const BaseSurface &base, const TensorSpline &share, const gp_Pnt2d &uv);

} // namespace laminate_offset
