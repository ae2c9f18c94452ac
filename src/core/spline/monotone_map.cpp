// SPDX-License-Identifier: LGPL-2.1-or-later
#include "monotone_map.h"

#include "bernstein.h"

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

// A cubic with end slopes below 1.5 times the mean one has increasing coefficients; a little less leaves room for
// rounding. A slope near zero would crowd the parameters.
constexpr double steepest = 1.4;
constexpr double flattest = 0.05;

double tamed(double slope, double least_rise)
{
    return std::clamp(slope, flattest * least_rise, steepest * least_rise);
}

//! Bernstein coefficients of B_k(f) for k = 0..degree: row r holds the r-th coefficients. f is increasing from 0 to 1,
//! so that all products have positive terms only.
Eigen::MatrixXd composition(int degree, const MonotoneMap &map, std::size_t piece)
{
    const int n = map.degree();
    const std::array<double, 2> inner = map.inner_coefficients(piece);
    Bernstein rise(n, 0);
    Bernstein rest(n, 0);
    for (int k = 0; k <= n; ++k)
    {
        const double c = k == 0 ? 0.0 : (k == n ? 1.0 : inner[static_cast<std::size_t>(k) - 1]);
        rise.set_coefficient(k, 0, c);
        rest.set_coefficient(k, 0, 1.0 - c);
    }
    Eigen::MatrixXd matrix(degree * n + 1, degree + 1);
    for (int k = 0; k <= degree; ++k)
    {
        Bernstein product(0, 0);
        product.set_coefficient(0, 0, binomial(degree, k));
        Bernstein next;
        for (int factor = 0; factor < degree; ++factor)
        {
            assign_product(product, factor < k ? rise : rest, next);
            std::swap(product, next);
        }
        for (int r = 0; r <= degree * n; ++r)
            matrix(r, k) = product.coefficient(r, 0);
    }
    return matrix;
}

//! What takes the poles of one direction to those of all its pieces, whose common ends are kept once.
std::vector<Eigen::MatrixXd> piece_matrices(const KnotVector &kv, const MonotoneMap &map, std::vector<int> &first)
{
    std::vector<Eigen::MatrixXd> result;
    const std::vector<SpanExtraction> spans = extractions(kv, map.values());
    for (std::size_t i = 0; i < spans.size(); ++i)
    {
        const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> extraction(
            spans[i].matrix.data(), kv.degree + 1, kv.degree + 1);
        result.emplace_back(composition(kv.degree, map, i) * extraction);
        first.push_back(spans[i].first);
    }
    return result;
}

KnotVector piece_knots(int degree, const std::vector<double> &ends)
{
    std::vector<double> interior;
    for (std::size_t i = 1; i + 1 < ends.size(); ++i)
        interior.insert(interior.end(), static_cast<std::size_t>(degree), ends[i]);
    return clamped_knots(degree, ends.front(), ends.back(), interior);
}

} // namespace

MonotoneMap::MonotoneMap(std::vector<Node> nodes)
{
    const std::size_t pieces = nodes.size() - 1;
    std::vector<double> rise(pieces);
    for (std::size_t i = 0; i < pieces; ++i)
        rise[i] = (nodes[i + 1].value - nodes[i].value) / (nodes[i + 1].parameter - nodes[i].parameter);
    std::vector<bool> changed(pieces + 1);
    for (std::size_t i = 0; i <= pieces; ++i)
    {
        const MonotoneMap::Node wish = nodes[i];
        const double before = rise[i == 0 ? 0 : i - 1];
        const double after = rise[std::min(i, pieces - 1)];
        const bool smooth = nodes[i].slope_before == nodes[i].slope_after;
        nodes[i].slope_before = tamed(nodes[i].slope_before, smooth ? std::min(before, after) : before);
        nodes[i].slope_after = tamed(nodes[i].slope_after, smooth ? std::min(before, after) : after);
        changed[i] = nodes[i].slope_before != wish.slope_before || nodes[i].slope_after != wish.slope_after;
        m_continuity.push_back(smooth ? 2 : 0);
        m_parameters.push_back(nodes[i].parameter);
        m_values.push_back(nodes[i].value);
    }
    for (std::size_t i = 1; i < pieces; ++i)
        if (changed[i - 1] || changed[i] || changed[i + 1])
            m_continuity[i] = std::min(m_continuity[i], 1);
    for (std::size_t i = 0; i < pieces; ++i)
        m_inner.push_back({nodes[i].slope_after / (3.0 * rise[i]), 1.0 - nodes[i + 1].slope_before / (3.0 * rise[i])});
}

MonotoneMap MonotoneMap::linear(const std::vector<Node> &nodes)
{
    MonotoneMap map;
    map.m_linear = true;
    for (const Node &node : nodes)
    {
        map.m_parameters.push_back(node.parameter);
        map.m_values.push_back(node.value);
    }
    map.m_inner.resize(nodes.size() - 1);
    map.m_continuity.assign(nodes.size(), max_spline_degree);
    return map;
}

double MonotoneMap::fraction(std::size_t piece, double x) const
{
    if (m_linear)
        return x;
    const double y = 1.0 - x;
    return x * (3.0 * y * (y * m_inner[piece][0] + x * m_inner[piece][1]) + x * x);
}

double MonotoneMap::value(double parameter) const
{
    const auto next = std::upper_bound(m_parameters.begin() + 1, m_parameters.end() - 1, parameter);
    const auto i = static_cast<std::size_t>(next - m_parameters.begin()) - 1;
    const double x = std::clamp((parameter - m_parameters[i]) / (m_parameters[i + 1] - m_parameters[i]), 0.0, 1.0);
    const double f = fraction(i, x);
    return (1.0 - f) * m_values[i] + f * m_values[i + 1];
}

double MonotoneMap::parameter(double value) const
{
    const auto next = std::upper_bound(m_values.begin() + 1, m_values.end() - 1, value);
    const auto i = static_cast<std::size_t>(next - m_values.begin()) - 1;
    const double wanted = std::clamp((value - m_values[i]) / (m_values[i + 1] - m_values[i]), 0.0, 1.0);
    double low = 0.0;
    double high = 1.0;
    double x = wanted;
    for (int step = 0; step < 80 && high - low > 0.0; ++step)
    {
        const double f = fraction(i, x);
        if (f == wanted)
            break;
        (f < wanted ? low : high) = x;
        // Newton's step by a secant of the cubic's slope, halved where it leaves the bracket
        constexpr double small = 1e-7;
        const double slope = (fraction(i, x + small) - fraction(i, x - small)) / (2.0 * small);
        double to = x + (wanted - f) / slope;
        if (!(to > low && to < high))
            to = 0.5 * (low + high);
        if (to == x)
            break;
        x = to;
    }
    return (1.0 - x) * m_parameters[i] + x * m_parameters[i + 1];
}

TensorSpline reparametrised(const TensorSpline &surface, const ParameterMap &map)
{
    std::vector<int> first_u;
    std::vector<int> first_v;
    const std::vector<Eigen::MatrixXd> along_u = piece_matrices(surface.u, map.u, first_u);
    const std::vector<Eigen::MatrixXd> along_v = piece_matrices(surface.v, map.v, first_v);
    TensorSpline result;
    result.rational = surface.rational;
    const int m = surface.u.degree * map.u.degree();
    const int n = surface.v.degree * map.v.degree();
    result.u = piece_knots(m, map.u.parameters());
    result.v = piece_knots(n, map.v.parameters());
    const int count_v = result.v.pole_count();
    result.poles.resize(static_cast<std::size_t>(result.u.pole_count()) * count_v);
    for (std::size_t i = 0; i < along_u.size(); ++i)
        for (std::size_t j = 0; j < along_v.size(); ++j)
            for (int e = 0; e < 4; ++e)
            {
                Eigen::MatrixXd net(surface.u.degree + 1, surface.v.degree + 1);
                for (int k = 0; k <= surface.u.degree; ++k)
                    for (int l = 0; l <= surface.v.degree; ++l)
                        net(k, l) = surface.pole(first_u[i] + k, first_v[j] + l)[e];
                const Eigen::MatrixXd fine = along_u[i] * net * along_v[j].transpose();
                for (int k = 0; k <= m; ++k)
                    for (int l = 0; l <= n; ++l)
                        result.poles[(i * m + k) * count_v + j * n + l][e] = fine(k, l);
            }
    if (!result.rational)
        for (Eigen::Vector4d &pole : result.poles)
            pole.w() = 1.0;
    return result;
}

double reparametrisation_operations(const TensorSpline &surface)
{
    // Each direction: some 10 operations of the extraction, six for each factor of a product, and the sums.
    return 64.0 + 16.0 * (surface.u.degree + surface.v.degree);
}

} // namespace laminate_offset
