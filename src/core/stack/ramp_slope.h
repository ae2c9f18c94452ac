// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! How steep a ramp is.
#pragma once

#include "../analysis/base_surface.h"
#include "../analysis/loop_region.h"
#include "../spline/scalar_spline.h"

namespace laminate_offset
{

//! The largest slope of a share along the surface, seen at places inside [1/mm].
double steepest_slope(const BaseSurface &base, const ScalarSpline &share, const LoopRegion &inside);

} // namespace laminate_offset
