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
inline constexpr double one_weight = 1e-13;

//! A side whose poles miss each other by no more than this part of their largest coordinate is meant to be a point: 32 roundings.
inline constexpr double meant_as_point = 7.2e-15;

//! How far the surface as it is meant is from the one that was given.
struct UndoneRounding
{
    double moved = 0.0; //!< bound at equal parameters [mm]; of an offset, too, but nearer to a tip than the tolerance
    double operations = 0.0; //!< see CertificateRequest::base_operations; of the weights alone
};

//! The largest coordinate of all poles, with which their rounding goes [mm].
double largest_coordinate(const TensorSpline &spline);

//! Makes weights that are one constant 1, and points of the sides that are meant to be some, with the rows behind them that
//! are points as well (a cusp). The given surface's normals turn with its last digits near such a tip; a side is left
//! alone where that may move an offset by a hundredth of the tolerance, which is counted, farther from the tip than the tolerance.
//! \param distance of the offset [mm].
//! \param tolerance of the offset [mm].
UndoneRounding undo_rounding(TensorSpline &spline, double distance, double tolerance);

} // namespace laminate_offset
