// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Newton's step towards a place where a surface meets itself.
#pragma once

#include "../input/input_face.h"
#include "../spline/tensor_spline.h"

#include <Eigen/Core>

namespace laminate_offset
{

//! Moves two places (u, v, u, v) towards one common point of a surface, by the shortest step in parts of the box, and
//! keeps them inside the box.
//! \param a, b the surface at the two places, with first derivatives.
void step_together(const SurfaceJet &a, const SurfaceJet &b, const ParameterBox &box, Eigen::Vector4d &place);

} // namespace laminate_offset
