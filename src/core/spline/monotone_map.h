// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Increasing maps from one parameter to another, and splines seen through them.
#pragma once

#include "tensor_spline.h"

#include <array>
#include <vector>

namespace laminate_offset
{

//! An increasing, continuous map between two ranges: a cubic between any two neighbouring nodes, with one slope on both
//! sides of a smooth node. With the Bernstein coefficients 0 < c1 <= c2 < 1 of every cubic it is proven to increase.
class MonotoneMap
{
public:
    //! A node between two ranges. The slopes d(value)/d(parameter) on both sides are wishes: they are cut down to what
    //! keeps the map increasing.
    struct Node
    {
        double parameter = 0.0;
        double value = 0.0;
        double slope_before = 1.0;
        double slope_after = 1.0;
    };

    //! \param nodes at least two, increasing in parameter and value.
    explicit MonotoneMap(std::vector<Node> nodes);
    //! The linear map with these nodes, which have to lie on one line but for rounding.
    static MonotoneMap linear(const std::vector<Node> &nodes);

    [[nodiscard]] double value(double parameter) const;
    //! The parameter of a value, to rounding; values outside the range go to its ends.
    [[nodiscard]] double parameter(double value) const;
    //! Parameters and values of the nodes.
    [[nodiscard]] const std::vector<double> &parameters() const { return m_parameters; }
    [[nodiscard]] const std::vector<double> &values() const { return m_values; }
    //! At an inner node: 0 for a kink, 1 where the slopes had to be changed there or beside it, else that of the wishes
    //! but at most 2; of a linear map max_spline_degree.
    [[nodiscard]] int continuity(std::size_t i) const { return m_continuity[i]; }
    //! 1 or 3.
    [[nodiscard]] int degree() const { return m_linear ? 1 : 3; }
    //! Inner Bernstein coefficients of the piece after node i, as parts of its rise.
    [[nodiscard]] std::array<double, 2> inner_coefficients(std::size_t i) const { return m_inner[i]; }

private:
    MonotoneMap() = default;
    [[nodiscard]] double fraction(std::size_t piece, double x) const;

    bool m_linear = false;
    std::vector<double> m_parameters;
    std::vector<double> m_values;
    std::vector<std::array<double, 2>> m_inner;
    std::vector<int> m_continuity;
};

//! Parameters of a surface in terms of those of another one.
struct ParameterMap
{
    MonotoneMap u;
    MonotoneMap v;
};

//! S(map.u(x), map.v(y)) in Bernstein pieces between the nodes. The poles are off by rounding of at most
//! reparametrisation_operations(S) units in the last place of the largest coordinate.
//! \pre all distinct knots of the surface are among the nodes' values, and its degrees times the maps' do not exceed
//! max_spline_degree.
TensorSpline reparametrised(const TensorSpline &surface, const ParameterMap &map);
double reparametrisation_operations(const TensorSpline &surface);

} // namespace laminate_offset
