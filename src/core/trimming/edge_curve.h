// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The curve in space of one pcurve on the offset surface.
#pragma once

#include "edge_target.h"

#include <Geom_Curve.hxx>

#include <optional>

namespace laminate_offset
{

struct EdgeCurve
{
    Handle(Geom_Curve) curve;
    Deviation deviation;
};

//! The exact curve of an isoparametric pcurve (a line, a circle, a B-spline's own isoparametric curve) and of any pcurve
//! on a plane.
//! \return nothing for any other pcurve, or where rounding exceeds the tolerance [mm].
std::optional<EdgeCurve> exact_curve(const EdgeTarget &target, double tolerance);

//! Isoparametric pcurves give an exact curve (a line, a circle, a B-spline's own isoparametric curve), all
//! pcurves on a plane too; any other pcurve is fitted with few poles. The curve has the pcurve's
//! parameters.
//! \param like a curve whose knots and weights are taken where they serve; null for none.
//! \return nothing when the tolerance [mm] cannot be reached.
std::optional<EdgeCurve> edge_curve(const EdgeTarget &target, double tolerance,
                                    const Handle(Geom_Curve) &like = nullptr);

} // namespace laminate_offset
