// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The curve in space of one pcurve on the offset surface.
#pragma once

#include "../base/result.h"

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

#include <optional>

namespace laminate_offset
{

//! A pcurve on a surface over a parameter range.
struct CurveOnSurface
{
    Handle(Geom_Surface) surface;
    Handle(Geom2d_Curve) pcurve;
    double first = 0.0;
    double last = 0.0;

    [[nodiscard]] gp_Pnt value(double t) const;
};

//! A curve with the distance that it was seen to keep from the surface at its pcurve's points.
struct EdgeCurve
{
    Handle(Geom_Curve) curve;
    double deviation = 0.0; //!< [mm]
};

//! Isoparametric pcurves give an exact curve (a line, a circle, a B-spline's own isoparametric curve);
//! any other pcurve is fitted with few poles. The curve has the pcurve's parameters.
//! \return nothing when the tolerance [mm] cannot be reached.
std::optional<EdgeCurve> edge_curve(const CurveOnSurface &on_surface, double tolerance);

//! Largest distance seen between a curve and a pcurve's points, over samples dense in both.
double largest_distance(const Handle(Geom_Curve) & curve, const CurveOnSurface &on_surface);

} // namespace laminate_offset
