// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The image of a pcurve in new parameters of its surface.
#pragma once

#include "edge_curve.h"

#include "../spline/monotone_map.h"

namespace laminate_offset
{

//! The pcurve in the parameters that the map takes to the base's, with its own parameter kept: exactly where the map and
//! the pcurve allow it, else fitted to what samples show to be the accuracy. A straight isoparametric line stays on its
//! line. The edge's proof judges the result.
//! \param accuracy in the new parameters.
//! \return nothing where the accuracy is not reached.
Handle(Geom2d_Curve) mapped_pcurve(const CurveOnSurface &on_base, const ParameterMap &map, double accuracy);

//! Is the pcurve a line or a polynomial spline?
bool is_polynomial(const CurveOnSurface &c);

//! A polynomial spline near a pcurve, with its parameter. The accuracy was seen at samples; null where it is not reached.
Handle(Geom2d_Curve) polynomial_pcurve(const CurveOnSurface &c, double accuracy);

} // namespace laminate_offset
