// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Where the curve of a pcurve on a surface is less than smooth, and curves from knots and poles.
#pragma once

#include "edge_curve.h"

#include "../spline/knot_choice.h"

#include <Geom_BSplineCurve.hxx>

#include <functional>
#include <vector>

namespace laminate_offset
{

//! All interior parameters at which the pcurve has a knot or crosses one of the knot lines, increasing, with the
//! continuity that a spline of those knots has there.
//! \param uv the pcurve.
//! \param u, v the knots crossed; null for none.
std::vector<DataBreak> curve_breaks(const CurveOnSurface &c, const std::function<Eigen::Vector2d(double)> &uv,
                                    const KnotVector *u, const KnotVector *v);

//! The curve with poles `poles` + origin, one row a pole.
Handle(Geom_BSplineCurve) spline_curve(const KnotVector &kv, const RowMatrix &poles, const Eigen::Vector3d &origin);

} // namespace laminate_offset
