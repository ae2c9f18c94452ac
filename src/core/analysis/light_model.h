// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A light model of a base that carries many more knots than its shape needs: the surface with fewer knots, and a
//! proof of how far it stands from the base.
//!
//! The base minus its model is a spline over the base's own knots. Its poles, and those of its derivatives, bound
//! |S - S*|, |S_u - S*_u| and so on over blocks of spans; the poles of the base's derivatives say how long and how
//! oblique S_u and S_v are there. With M = S_u x S_v,
//!     |M - M*| <= |S_u - S*_u| |S_v| + |S_u| |S_v - S*_v| + |S_u - S*_u| |S_v - S*_v|
//! bounds the angle of the normals. For a unit tangent a S_u + b S_v, |a| |S_u| and |b| |S_v| are at most 1 / sine
//! of the angle between S_u and S_v, which bounds the change of the normal curvature in every direction, and with it
//! that of the principal curvatures.
#pragma once

#include "base_surface.h"

#include <optional>

namespace laminate_offset
{

struct LightModel
{
    TensorSpline spline;
    ModelError error; //!< its curvature is infinite where the model serves offsets only, but no limits
};

//! \param distance [mm] at which the model serves an offset.
//! \param tolerance [mm] of that offset; the model takes a few percent of it.
//! \param base_operations how far the poles may be from those that are meant (CertificateRequest): the error includes that.
//! \return nothing where the base has few spans, or needs most of them, or has places without a normal.
std::optional<LightModel> light_model(const TensorSpline &base, double distance, double tolerance,
                                      double base_operations = 0.0);

} // namespace laminate_offset
