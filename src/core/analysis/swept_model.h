// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A spline that stands for a surface of revolution or for an extruded conic, with proven errors.
//!
//! In coordinates that turn with the angle u about the axis, and with x + i y as a complex number,
//! S = (q(v), z(v)), and the model with E~ = e^(iu) (1 + a) is S~ = ((1 + a) q, z). Its derivatives are
//! S~_u = i (1 + b) q, S~_v = ((1 + a) q', z'), with |a|, |b| at most the errors e0, e1 of the spline of cos
//! and sin (conic_functions.h). Their product has the relative error h = e0 + e1 + e0 e1, so for the least sine s
//! between S_u and S_v, |N - N~| <= 2 x / (2 - x) with x = h / s, on the axis too. A profile in a plane through the axis
//! has s = 1: there S~_u x S~_v ~ (z' (1 + b), -r' Re((1 + conj a)(1 + b))).
//! A conic as the profile, or extruded, is a linear image P + L E~ of the same splines: with x = |L| |L^-1| e1 its
//! tangent turns by 2 x / (2 - x), and its curvature det(L) (E' x E'') / |L E'|^3 has a relative error. A parallel's
//! curvature N_r / r adds (turn + error of r / r) / r, or, where an axis of an ellipse or hyperbola is the
//! axis, a relative error again: on the axis r and N_r both start from zero exactly.
//! Profiles that are splines, lines and parabolas are exact up to rounding, which is added.
//!
//! Curvatures depend on v only (of an extrusion, on u only). They are searched on a narrow strip of the
//! exact turn of the profile's spline, so that only errors of the profile count.
#pragma once

#include "base_surface.h"

#include <optional>
#include <vector>

namespace laminate_offset
{

struct SweptModel
{
    TensorSpline spline;
    CurvatureStrip strip;
    ModelError error;                      //!< point and normal of the spline, curvature of the strip
    std::vector<SmoothnessBreak> breaks_u; //!< of the base; where the model's own pieces join, the base is smooth
    std::vector<SmoothnessBreak> breaks_v;
};

//! The model over a box of parameters, with an error that is a small part of the tolerance.
//! \return nothing for any other kind of surface, and where no such model can be proven: offset curves as profiles,
//! a circle that meets the axis at a slant, distances or sizes past what double numbers resolve.
std::optional<SweptModel> swept_model(const Handle(Geom_Surface) & surface, const ParameterBox &box,
                                      const ModelDemand &demand);

} // namespace laminate_offset
