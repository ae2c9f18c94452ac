// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Straight pcurves in their simplest form.
//!
//! Files often carry a straight pcurve as a spline. As a line it has a closed form on most surfaces, and every
//! later step is cheaper by it.
#pragma once

#include <Geom2d_Curve.hxx>

#include <optional>

namespace laminate_offset
{

struct StraightPcurve
{
    Handle(Geom2d_Curve) curve; //!< a line, or a spline of degree 1 with two poles where the speed is not one
    double deviation = 0.0;     //!< bound of the distance from the given pcurve at equal parameters, in parameters
};

//! The pcurve over [first, last] in its simplest form.
//! \return nothing where it is no polynomial spline, not straight and evenly run through up to rounding, or as simple
//! already.
std::optional<StraightPcurve> straight_pcurve(const Handle(Geom2d_Curve) & pcurve, double first, double last);

} // namespace laminate_offset
