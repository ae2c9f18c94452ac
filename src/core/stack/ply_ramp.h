// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! How much of a ply's thickness lies below the plies above it: all of it on the ply, nothing far from it, and a ramp
//! between.
//!
//! The share is a cubic spline with simple knots, so it is C2 and level at both ends of the ramp. It is exactly 1 on the ply,
//! because every pole that acts on a span touched by the ply is 1, and exactly 0 from the ramp's end on, because every
//! pole that acts past it is 0. Poles between fall with the distance in space from the ply's edge. Knots stand only where
//! a ramp crosses their direction, some six to a ramp. In the middle of a straight ramp the share is some 1.4 to 1.8
//! times as steep as in the mean; a ply whose edge runs along a parameter line needs nearly none in
//! the other direction.
#pragma once

#include "ply_region.h"

#include "../analysis/base_surface.h"
#include "../analysis/loop_region.h"
#include "../spline/scalar_spline.h"

namespace laminate_offset
{

//! \param base the whole face's surface; the share is made over its box.
//! \param length of the ramp in space, outwards from the ply's edge [mm], above zero.
//! \param most_poles a share of more poles is refused.
//! Refusal at Stage::Surface: NotSupported, with the ramp that would be long enough.
Result<ScalarSpline> ply_share(const BaseSurface &base, const PlyRegion &region, double length, int most_poles);

//! The inside of a region whose cut edges are in pieces short enough for ramps of a length [mm]: a span next to a long
//! piece's box would count as touched.
LoopRegion fine_region(const BaseSurface &base, const PlyRegion &region, double length);

} // namespace laminate_offset
