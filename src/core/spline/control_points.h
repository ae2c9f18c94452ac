// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Plane splines by the control points of their Bezier pieces.
#pragma once

#include "knot_vector.h"

#include <Eigen/Core>
#include <Geom2d_BSplineCurve.hxx>

#include <vector>

namespace laminate_offset
{

//! Points (x, y, 1) times a weight, of one Bezier piece.
using ControlPoints = std::vector<Eigen::Vector3d>;

//! The poles of a spline, each with its weight.
ControlPoints weighted_poles(const Geom2d_BSplineCurve &curve);

//! The Bezier piece of one span of a spline, by de Boor's scheme with both ends of the span as arguments: neighbouring
//! pieces share their common end to the last bit.
ControlPoints span_points(const KnotVector &kv, const ControlPoints &poles, int span);

//! Cuts off what lies before s of [0, 1] (de Casteljau): returned, and the rest remains.
ControlPoints cut_off(ControlPoints &points, double s);

//! The Bezier pieces of a spline that does not go round, cut at its knots and at `ends`: the pieces between the first two
//! ends, those between the next two, and so on. One cut serves both pieces beside it, whose control points there are the same.
//! \param ends increasing, at least two, none of them beyond the ends of the curve by more than rounding.
std::vector<std::vector<ControlPoints>> pieces_between(const Geom2d_BSplineCurve &curve,
                                                       const std::vector<double> &ends);

//! The Bezier pieces of a curve of any kind between two of its parameters.
//! \return none for kinds that have no exact ones (offset curves), and beyond the ends of the curve.
std::vector<ControlPoints> bezier_pieces(const Handle(Geom2d_Curve) & curve, double first, double last);

//! Are all weights above zero? Only then does a piece lie between its control points.
bool positive_weights(const std::vector<ControlPoints> &pieces);

} // namespace laminate_offset
