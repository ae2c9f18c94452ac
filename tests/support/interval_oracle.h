// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The deviation of a spline from the exact offset of another one in interval arithmetic (Boost.Interval): an
//! enclosure of the true figure, rounding included, by formulas of its own.
#pragma once

#include <laminate_offset/spline/tensor_spline.h>

namespace test_support
{

struct Enclosure
{
    double low = 0.0;
    double high = 0.0;
};

//! Parameters between two ends; equal ends are a point. Must lie inside one knot span of both splines.
struct ParameterRange
{
    double low = 0.0;
    double high = 0.0;
};

//! Encloses |O - (S + distance N)| over the parameters, N = S_u x S_v scaled to 1. Nothing is known of it
//! (low 0, high infinite) where the enclosure of S_u x S_v holds zero.
Enclosure enclose_deviation(const laminate_offset::TensorSpline &base, const laminate_offset::TensorSpline &offset,
                            double distance, const ParameterRange &u, const ParameterRange &v);

//! Encloses x * x + y: shows that the intervals are rounded outwards.
Enclosure enclose_square_plus(double x, double y);

} // namespace test_support
