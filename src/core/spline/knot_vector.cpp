// SPDX-License-Identifier: LGPL-2.1-or-later
#include "knot_vector.h"

#include "vector_kernels.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>

namespace laminate_offset
{

int KnotVector::span(double u) const
{
    const auto begin = knots.begin() + degree;
    const auto end = knots.begin() + pole_count();
    int s = static_cast<int>(std::upper_bound(begin, end, u) - knots.begin()) - 1;
    s = std::max(s, degree);
    while (s > degree && knots[static_cast<std::size_t>(s)] >= knots[static_cast<std::size_t>(s) + 1])
        --s;
    return s;
}

std::vector<Knot> KnotVector::distinct() const
{
    std::vector<Knot> result;
    for (const double t : knots)
        if (!result.empty() && t <= result.back().parameter)
            ++result.back().multiplicity;
        else
            result.push_back({t, 1});
    return result;
}

std::vector<double> KnotVector::breaks() const
{
    std::vector<double> result;
    for (const Knot &knot : distinct())
        result.push_back(knot.parameter);
    return result;
}

std::vector<double> KnotVector::pole_parameters() const
{
    std::vector<double> result;
    for (auto first = knots.begin() + 1; first + degree != knots.end(); ++first)
        result.push_back(std::accumulate(first, first + degree, 0.0) / degree);
    return result;
}

KnotVector clamped_knots(int degree, double a, double b, const std::vector<double> &interior)
{
    KnotVector kv;
    kv.degree = degree;
    kv.knots.reserve(interior.size() + 2 * static_cast<std::size_t>(degree) + 2);
    kv.knots.assign(static_cast<std::size_t>(degree) + 1, a);
    kv.knots.insert(kv.knots.end(), interior.begin(), interior.end());
    kv.knots.insert(kv.knots.end(), static_cast<std::size_t>(degree) + 1, b);
    return kv;
}

std::vector<double> merged_breaks(const std::vector<double> &a, const std::vector<double> &b)
{
    std::vector<double> all;
    all.reserve(a.size() + b.size());
    std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
    if (all.empty())
        return all;
    const double same = 1e-12 * (all.back() - all.front());
    all.erase(std::unique(all.begin(), all.end(), [same](double x, double y) { return y - x <= same; }), all.end());
    return all;
}

namespace
{

//! Values of degree q on the span that starts at t[0] (Cox-de Boor, NURBS Book A2.2).
void values_of_degree(const double *t, int q, double u, double *values)
{
    std::array<double, max_spline_degree + 1> left;
    std::array<double, max_spline_degree + 1> right;
    values[0] = 1.0;
    for (int j = 1; j <= q; ++j)
    {
        left[j] = u - t[1 - j];
        right[j] = t[j] - u;
        double saved = 0.0;
        for (int r = 0; r < j; ++r)
        {
            const double part = values[r] / (right[r + 1] + left[j - r]);
            values[r] = saved + right[r + 1] * part;
            saved = left[j - r] * part;
        }
        values[j] = saved;
    }
}

//! Differentiates in place: from the q values of degree q - 1 to the q + 1 derivatives of degree q,
//! N' = q (N_i / (t_{i+q} - t_i) - N_{i+1} / (t_{i+q+1} - t_{i+1})).
void differentiate(const double *t, int q, double *values)
{
    double previous = 0.0;
    for (int i = 0; i <= q; ++i)
    {
        const double here = i < q ? values[i] / (t[i + 1] - t[i + 1 - q]) : 0.0;
        values[i] = q * (previous - here);
        previous = here;
    }
}

//! The blossom's weights at x[0..p-1] on the span that starts at t[0]: values_of_degree with an argument of its
//! own for every degree.
void blossom_values(const double *t, int p, const double *x, double *values)
{
    values[0] = 1.0;
    for (int j = 1; j <= p; ++j)
    {
        double saved = 0.0;
        for (int r = 0; r < j; ++r)
        {
            const double right = t[r + 1] - x[j - 1];
            const double left = x[j - 1] - t[1 - j + r];
            const double part = values[r] / (right + left);
            values[r] = saved + right * part;
            saved = left * part;
        }
        values[j] = saved;
    }
}

} // namespace

void SpanBasis::reset(const double *t, int p)
{
    m_t = t;
    double *inverse = m_inverses.data();
    for (int j = 1; j <= p; ++j)
        for (int r = 0; r < j; ++r)
            *inverse++ = 1.0 / (t[r + 1] - t[1 - j + r]);
}

void SpanBasis::values_of_degree(int q, double u, double *values) const
{
    const double *inverse = m_inverses.data();
    values[0] = 1.0;
    for (int j = 1; j <= q; ++j)
    {
        double saved = 0.0;
        for (int r = 0; r < j; ++r)
        {
            const double part = values[r] * *inverse++;
            values[r] = saved + (m_t[r + 1] - u) * part;
            saved = (u - m_t[1 - j + r]) * part;
        }
        values[j] = saved;
    }
}

void SpanBasis::lane_values(int q, const double *u, double *rows) const
{
    span_basis(m_t, m_inverses.data(), q, u, rows);
}

void basis_values(const KnotVector &kv, int span, double u, double *values)
{
    values_of_degree(kv.knots.data() + span, kv.degree, u, values);
}

namespace
{

//! basis_derivatives by any way `values(degree, out)` to the values alone.
template <class Values> void derivatives_from(const Values &values, const double *t, int p, int order, double *out)
{
    values(p, out);
    for (int k = 1; k <= order; ++k)
    {
        double *row = out + k * (p + 1);
        std::fill(row, row + p + 1, 0.0);
        if (k > p)
            continue;
        values(p - k, row);
        for (int q = p - k + 1; q <= p; ++q)
            differentiate(t, q, row);
    }
}

} // namespace

void basis_derivatives(const KnotVector &kv, int span, double u, int order, double *out)
{
    const double *t = kv.knots.data() + span;
    derivatives_from([&](int degree, double *values) { values_of_degree(t, degree, u, values); }, t, kv.degree, order,
                     out);
}

BasisRows::BasisRows(const KnotVector &kv, const std::vector<double> &parameters, int order)
    : m_width(kv.degree + 1), m_orders(order + 1)
{
    const std::size_t count = parameters.size();
    m_first.resize(count);
    m_values.resize(count * m_orders * m_width);
    SpanBasis basis;
    for (std::size_t r = 0; r < count; ++r)
    {
        const double u = parameters[r];
        const int s = kv.span(u);
        const double *t = kv.knots.data() + s;
        if (basis.t() != t)
            basis.reset(t, kv.degree);
        m_first[r] = s - kv.degree;
        derivatives_from([&](int degree, double *values) { basis.values_of_degree(degree, u, values); }, t, kv.degree,
                         order, m_values.data() + r * m_orders * m_width);
    }
}

BasisRows BasisRows::insertion(const KnotVector &coarse, const KnotVector &fine)
{
    const int poles = fine.pole_count();
    BasisRows rows;
    rows.m_width = coarse.degree + 1;
    rows.m_first.resize(static_cast<std::size_t>(poles));
    rows.m_values.resize(static_cast<std::size_t>(poles * rows.m_width));
    for (int r = 0; r < poles; ++r)
    {
        const int span = coarse.span(fine.knots[static_cast<std::size_t>(r)]);
        rows.m_first[static_cast<std::size_t>(r)] = span - coarse.degree;
        blossom_values(coarse.knots.data() + span, coarse.degree, fine.knots.data() + r + 1,
                       rows.m_values.data() + static_cast<std::ptrdiff_t>(r) * rows.m_width);
    }
    return rows;
}

} // namespace laminate_offset
