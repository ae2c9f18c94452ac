// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A spline curve made longer past one of its ends (Ravi Kumar, Shastry, Prakash, CAD 35 (2003) 411-420, 3.2.1).
#pragma once

#include "../base/result.h"

#include <Geom_BSplineCurve.hxx>

namespace laminate_offset
{

enum class CurveExtension
{
    Straight, //!< a straight piece along the end tangent, eq. 3.5 to 3.9: G1
    Mirrored, //!< the mirror image of the part next to the end: tangent and curvature are continuous
    Natural   //!< the last polynomial piece goes on: every derivative is continuous
};

//! The parameter increment of a straight extension, eq. 3.9: length divided by the speed at the end, so that the
//! join is C1 (the paper's formula with the weights' ratio, which is 1 for a polynomial curve).
//! Infinite where the curve stands still at its end.
double straight_increment(const Geom_Curve &curve, double end_parameter, double length);

//! The curve with `length` [mm] of arc more past its last (else first) parameter. It keeps its parameters and, to
//! rounding, its points. Knots at the join that are not needed are taken out.
//! Refusals at stage Extension: SelfIntersection for a closed curve, SingularNormal where it stands still at the end,
//! InvalidOption for a length that is not positive or, except Straight, more than 16 times the curve's own parameter
//! range needs, NotSupported where a natural continuation's weights vanish.
Result<Handle(Geom_BSplineCurve)> extend_curve(const Handle(Geom_BSplineCurve) & curve, double length, bool at_end,
                                               CurveExtension kind);

} // namespace laminate_offset
