// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A spline surface that carries more knots than its shape needs, with as many of them taken out as a tolerance
//! allows (data reduction by knot removal, Lyche & Morken 1987).
#pragma once

#include "tensor_spline.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace laminate_offset
{

struct ReducedSpline
{
    TensorSpline spline; //!< over some of the original knots, of the same degree
    //! Original minus reduced surface as poles over the original knots, in their order: exact up to rounding.
    std::vector<Eigen::Vector3d> change;
    double rounding = 0.0; //!< bound of the rounding of each coordinate of `change`
    double largest = 0.0;  //!< length of the longest change, its rounding included: nowhere do the two differ by more
};

//! \param tolerance [mm] that no change of a pole may exceed.
//! \return nothing for a rational surface, or where fewer knots do not suffice.
std::optional<ReducedSpline> reduced(const TensorSpline &spline, double tolerance);

} // namespace laminate_offset
