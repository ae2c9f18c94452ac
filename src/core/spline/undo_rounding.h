// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! What rounding alone has made of a surface: weights that differ in their last digits, tips whose poles miss each other by
//! theirs. Lofts of sections come with the former, and cost several times as much as the polynomials they are; fillets that
//! run out come with the latter, and have no normals where the poles overtake each other.
#pragma once

#include "tensor_spline.h"

namespace laminate_offset
{

//! Weights that differ relatively by no more than this are one constant.
inline constexpr double one_weight = 1e-12;

//! A side whose poles miss each other by no more than this part of their largest coordinate is meant to be a point.
inline constexpr double meant_as_point = 1e-12;

//! How far the surface as it is meant is from the one that was given.
struct UndoneRounding
{
    double moved = 0.0; //!< bound of the distance at equal parameters [mm]
    double operations =
        0.0; //!< see CertificateRequest::base_operations; of the weights alone: a tip is what it is meant to be
};

//! Makes weights that are one constant 1, and points of the sides that are meant to be some, with the rows behind them that
//! are points as well (a cusp).
UndoneRounding undo_rounding(TensorSpline &spline);

} // namespace laminate_offset
