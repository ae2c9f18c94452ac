// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The limits of planes, cylinders, cones, spheres and tori in closed form.
#pragma once

#include "surface_analysis.h"

#include <optional>

namespace laminate_offset
{

//! Limits along S_u x S_v; an empty side has none.
struct ClosedLimits
{
    std::optional<CurvatureLimit> negative;
    std::optional<CurvatureLimit> positive;
};

//! The limits inside the box of the loops, of every surface that has an analytic form; nothing for any other.
//! A sphere that is one but for a rounding (AnalyticForm::error) has limits that hold for the surface as it stands, on all of it
//! that keeps sqrt(m R) away from the axis, where the axis misses the circle's centre by m and R is the radius: they are
//! m / cos v short of R. Nearer to the axis than that (0.003 mm for R = 100 mm and m = 1e-7 mm) the surface counts as the sphere.
//! A cone across its apex, and the part of a torus beyond its axis, are folded themselves: both limits are 0.
std::optional<ClosedLimits> closed_limits(const InputFace &input);

} // namespace laminate_offset
