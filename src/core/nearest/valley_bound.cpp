// SPDX-License-Identifier: LGPL-2.1-or-later
#include "valley_bound.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace laminate_offset
{
namespace
{

constexpr int most_steps = 12;
// The given bound of the second derivative is itself computed.
constexpr double sure_part = 0.99;

//! Bernstein coefficients of a polynomial as rows across the valley, the rows one after the other along it.
class Rows
{
public:
    Rows(const Bernstein &h, bool across_v)
        : m_along(across_v ? h.degree_u() : h.degree_v()), m_across(across_v ? h.degree_v() : h.degree_u())
    {
        for (int i = 0; i <= m_along; ++i)
            for (int j = 0; j <= m_across; ++j)
                m_c.push_back(across_v ? h.coefficient(i, j) : h.coefficient(j, i));
    }

    [[nodiscard]] int along() const { return m_along; }
    [[nodiscard]] int across() const { return m_across; }
    [[nodiscard]] double *row(int i) { return m_c.data() + i * (m_across + 1); }

    //! The derivative across the valley.
    [[nodiscard]] Rows slope() const
    {
        Rows result(m_along, m_across - 1);
        for (int i = 0; i <= m_along; ++i)
            for (int j = 0; j < m_across; ++j)
            {
                const auto k = static_cast<std::size_t>(i * (m_across + 1) + j);
                result.m_c.push_back(m_across * (m_c[k + 1] - m_c[k]));
            }
        return result;
    }

    //! The polynomial along the straight line from (0, from) to (1, to): over [from, to] instead of [0, 1] it is the
    //! diagonal of the square.
    [[nodiscard]] Bernstein along_line(double from, double to)
    {
        Bernstein result(m_along + m_across, 0);
        for (int i = 0; i <= m_along; ++i)
        {
            cut(row(i), from, to);
            for (int j = 0; j <= m_across; ++j)
                result.scaled(i + j, 0) += binomial(m_along, i) * binomial(m_across, j) * row(i)[j];
        }
        return result;
    }

private:
    Rows(int along, int across) : m_along(along), m_across(across) {}

    //! To the coefficients over [from, to] by de Casteljau's scheme.
    void cut(double *c, double from, double to) const
    {
        if (from > to)
        {
            std::reverse(c, c + m_across + 1);
            from = 1.0 - from;
            to = 1.0 - to;
        }
        for (int r = 1; r <= m_across; ++r)
            for (int k = 0; k <= m_across - r; ++k)
                c[k] = (1.0 - from) * c[k] + from * c[k + 1];
        const double part = from < 1.0 ? std::clamp((to - from) / (1.0 - from), 0.0, 1.0) : 1.0;
        for (int r = 1; r <= m_across; ++r)
            for (int k = m_across; k >= r; --k)
                c[k] = (1.0 - part) * c[k - 1] + part * c[k];
    }

    int m_along;
    int m_across;
    std::vector<double> m_c;
};

//! Value and derivative of a polynomial by its coefficients.
std::pair<double, double> value_and_slope(const double *c, int degree, double x)
{
    static thread_local std::vector<double> b;
    b.assign(c, c + degree + 1);
    double slope = 0.0;
    for (int r = 1; r <= degree; ++r)
    {
        if (r == degree)
            slope = degree * (b[1] - b[0]);
        for (int k = 0; k <= degree - r; ++k)
        {
            const auto at = static_cast<std::size_t>(k);
            b[at] = (1.0 - x) * b[at] + x * b[at + 1];
        }
    }
    return {b.front(), slope};
}

//! The zero of an increasing polynomial in [0, 1], or the end beyond which it lies. Need not be exact.
double zero_of(const double *c, int degree)
{
    if (!(c[0] < 0.0))
        return 0.0;
    if (!(c[degree] > 0.0))
        return 1.0;
    double low = 0.0;
    double high = 1.0;
    double x = c[0] / (c[0] - c[degree]);
    for (int step = 0; step < most_steps; ++step)
    {
        const auto [value, slope] = value_and_slope(c, degree, x);
        (value < 0.0 ? low : high) = x;
        const double newton = slope > 0.0 ? x - value / slope : low;
        const double next = newton >= low && newton <= high ? newton : 0.5 * (low + high);
        if (next == x)
            break;
        x = next;
    }
    return x;
}

} // namespace

double valley_rounding(int degree)
{
    // three roundings for each step of de Casteljau's scheme, twice as many steps as the degree, and some for the products
    constexpr double unit = 0.5 * std::numeric_limits<double>::epsilon();
    return (6.0 * degree + 8.0) * unit;
}

bool valley_is_above(const Bernstein &h, double lift, bool across_v, double curvature)
{
    Rows rows(h, across_v);
    if (rows.across() < 1)
        return false;
    Rows slopes = rows.slope();
    const double from = zero_of(slopes.row(0), slopes.across());
    const double to = zero_of(slopes.row(slopes.along()), slopes.across());
    const Bernstein slope = slopes.along_line(from, to);
    const Bernstein value = rows.along_line(from, to);
    const bool falls_to_low_side = from == 0.0 && to == 0.0 && slope.range().low >= 0.0;
    const bool falls_to_high_side = from == 1.0 && to == 1.0 && slope.range().high <= 0.0;
    if (falls_to_low_side || falls_to_high_side)
        return value.range().low + lift >= 0.0;
    const double c = sure_part * curvature;
    Bernstein bound(2 * slope.degree_u(), 0);
    bound.add_product(-1.0 / (2.0 * c), slope, slope);
    Bernstein raised(std::max(bound.degree_u(), value.degree_u()), 0);
    raised.add_raised(1.0, value);
    raised.add_raised(1.0, bound);
    // the rounding of a slope, twice the coefficients' size for each degree, in its square, and that of the square
    const double steepest = slope.range().size();
    const double of_slope = 2.0 * rows.across() * h.range().size();
    return raised.range().low + lift >= valley_rounding(rows.across()) * steepest * (of_slope + steepest) / c;
}

} // namespace laminate_offset
