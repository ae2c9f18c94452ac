// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scalar_spline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace laminate_offset
{
namespace
{

//! Both lists of interior knots as one, each knot as often as it stands in either; knots that agree to rounding are one.
std::vector<double> union_of(const KnotVector &a, const KnotVector &b)
{
    const double same = 1e-12 * (a.back() - a.front());
    std::vector<double> interior;
    auto x = a.knots.begin() + a.degree + 1;
    auto y = b.knots.begin() + b.degree + 1;
    const auto x_end = a.knots.end() - a.degree - 1;
    const auto y_end = b.knots.end() - b.degree - 1;
    while (x != x_end || y != y_end)
    {
        const bool both = x != x_end && y != y_end && std::abs(*x - *y) <= same;
        const bool from_a = y == y_end || (x != x_end && *x <= *y);
        interior.push_back(from_a || both ? *x : *y);
        if (from_a || both)
            ++x;
        if (!from_a || both)
            ++y;
    }
    return interior;
}

//! The knots of a spline moved onto the nearest of `fine`, which they agree with to rounding.
KnotVector snapped(KnotVector kv, const KnotVector &fine)
{
    std::size_t at = 0;
    for (double &knot : kv.knots)
    {
        while (at + 1 < fine.knots.size() && std::abs(fine.knots[at + 1] - knot) <= std::abs(fine.knots[at] - knot))
            ++at;
        knot = fine.knots[at];
    }
    return kv;
}

//! Weights are not negative and add up to 1 but for rounding. Equal numbers, and a single one that counts, are kept as
//! they are: the sum is taken from the number of the largest weight.
double mean(const double *weights, const double *values, std::ptrdiff_t step, int count)
{
    const std::ptrdiff_t main = std::max_element(weights, weights + count) - weights;
    double total = 0.0;
    for (int i = 0; i < count; ++i)
        total += weights[i] * (values[i * step] - values[main * step]);
    return values[main * step] + total;
}

ScalarSpline refined(const ScalarSpline &spline, const KnotVector &u, const KnotVector &v)
{
    const int degree_u = spline.u.degree;
    const int degree_v = spline.v.degree;
    if (degree_u != u.degree || degree_v != v.degree) // a constant
        return {u, v,
                std::vector<double>(static_cast<std::size_t>(u.pole_count()) * static_cast<std::size_t>(v.pole_count()),
                                    spline.poles.front())};
    const BasisRows rows_u = BasisRows::insertion(snapped(spline.u, u), u);
    const BasisRows rows_v = BasisRows::insertion(snapped(spline.v, v), v);
    const std::ptrdiff_t across = spline.v.pole_count();
    std::vector<double> half;
    for (int i = 0; i < rows_u.rows(); ++i)
        for (std::ptrdiff_t j = 0; j < across; ++j)
            half.push_back(
                mean(rows_u.row(i), spline.poles.data() + rows_u.first(i) * across + j, across, rows_u.width()));
    ScalarSpline result{u, v, {}};
    for (int i = 0; i < rows_u.rows(); ++i)
        for (int j = 0; j < rows_v.rows(); ++j)
            result.poles.push_back(mean(rows_v.row(j), half.data() + i * across + rows_v.first(j), 1, rows_v.width()));
    return result;
}

} // namespace

ScalarSpline ScalarSpline::constant(double value, double u0, double u1, double v0, double v1)
{
    return {clamped_knots(1, u0, u1, {}), clamped_knots(1, v0, v1, {}), std::vector<double>(4, value)};
}

std::vector<double> ScalarSpline::values(const std::vector<double> &us, const std::vector<double> &vs) const
{
    const BasisRows rows_u(u, us);
    const BasisRows rows_v(v, vs);
    const std::ptrdiff_t across = v.pole_count();
    std::vector<double> result;
    result.reserve(us.size() * vs.size());
    std::vector<double> column(static_cast<std::size_t>(across));
    for (int k = 0; k < rows_u.rows(); ++k)
    {
        const double *first = poles.data() + rows_u.first(k) * across;
        for (std::ptrdiff_t j = 0; j < across; ++j)
            column[static_cast<std::size_t>(j)] = mean(rows_u.row(k), first + j, across, rows_u.width());
        for (int l = 0; l < rows_v.rows(); ++l)
            result.push_back(mean(rows_v.row(l), column.data() + rows_v.first(l), 1, rows_v.width()));
    }
    return result;
}

double ScalarSpline::low() const { return *std::min_element(poles.begin(), poles.end()); }
double ScalarSpline::high() const { return *std::max_element(poles.begin(), poles.end()); }

std::optional<double> ScalarSpline::constant_where(const Touched &touched) const
{
    const std::vector<double> us = u.breaks();
    const std::vector<double> vs = v.breaks();
    std::optional<double> value;
    for (std::size_t k = 0; k + 1 < us.size(); ++k)
        for (std::size_t l = 0; l + 1 < vs.size(); ++l)
        {
            if (!touched(us[k], us[k + 1], vs[l], vs[l + 1]))
                continue;
            const int first_u = u.span(us[k]) - u.degree;
            const int first_v = v.span(vs[l]) - v.degree;
            for (int i = first_u; i <= first_u + u.degree; ++i)
                for (int j = first_v; j <= first_v + v.degree; ++j)
                {
                    if (value && *value != pole(i, j))
                        return std::nullopt;
                    value = pole(i, j);
                }
        }
    return value;
}

TensorSpline ScalarSpline::as_surface() const
{
    TensorSpline surface{u, v, {}, false};
    surface.poles.reserve(poles.size());
    for (const double value : poles)
        surface.poles.emplace_back(value, 0.0, 0.0, 1.0);
    return surface;
}

ScalarSpline sum(const ScalarSpline &a, double factor, const ScalarSpline &b)
{
    const bool a_leads = a.u.degree >= b.u.degree;
    const ScalarSpline &leader = a_leads ? a : b;
    const bool equal = a.u.degree == b.u.degree && a.v.degree == b.v.degree;
    const auto knots = [&](const KnotVector &of_leader, const KnotVector &x, const KnotVector &y) {
        return equal ? clamped_knots(x.degree, x.front(), x.back(), union_of(x, y)) : of_leader;
    };
    const KnotVector u = knots(leader.u, a.u, b.u);
    const KnotVector v = knots(leader.v, a.v, b.v);
    ScalarSpline result = refined(a, u, v);
    const ScalarSpline other = refined(b, u, v);
    for (std::size_t i = 0; i < result.poles.size(); ++i)
        result.poles[i] += factor * other.poles[i];
    return result;
}

} // namespace laminate_offset
