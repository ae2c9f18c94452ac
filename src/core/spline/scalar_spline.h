// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Tensor-product splines with one number as their value: a distance, or a share between 0 and 1, over the parameters
//! of a surface.
#pragma once

#include "tensor_spline.h"

#include <functional>
#include <optional>
#include <vector>

namespace laminate_offset
{

struct ScalarSpline
{
    KnotVector u;
    KnotVector v;
    std::vector<double> poles; //!< pole (i, j) at i * v.pole_count() + j

    //! The same number everywhere on [u0, u1] x [v0, v1].
    static ScalarSpline constant(double value, double u0, double u1, double v0, double v1);

    [[nodiscard]] double pole(int i, int j) const
    {
        return poles[static_cast<std::size_t>(i) * static_cast<std::size_t>(v.pole_count()) +
                     static_cast<std::size_t>(j)];
    }

    //! Values on the grid us x vs, (k, l) at k * vs.size() + l.
    [[nodiscard]] std::vector<double> values(const std::vector<double> &us, const std::vector<double> &vs) const;

    //! Least and largest pole: between them lie all values.
    [[nodiscard]] double low() const;
    [[nodiscard]] double high() const;

    //! The number that the spline is on every rectangle between its knots for which `touched` (u0, u1, v0, v1) says
    //! yes; nothing where it varies there, or where none is touched.
    using Touched = std::function<bool(double, double, double, double)>;
    [[nodiscard]] std::optional<double> constant_where(const Touched &touched) const;

    //! A surface of the same knots whose x is the value; y and z are 0.
    [[nodiscard]] TensorSpline as_surface() const;
};

//! a + factor * b over the knots of both. Degrees are equal, or one of the two is a constant of lower degree. Rounding is
//! a few units in the last place of the largest pole; poles that are all equal stay equal exactly.
ScalarSpline sum(const ScalarSpline &a, double factor, const ScalarSpline &b);

} // namespace laminate_offset
