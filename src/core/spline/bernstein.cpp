// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bernstein.h"

#include "vector_kernels.h"

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

constexpr BinomialTable pascal_triangle()
{
    BinomialTable table{};
    for (std::size_t n = 0; n < table.size(); ++n)
    {
        table[n][0] = 1.0;
        for (std::size_t k = 1; k <= n; ++k)
            table[n][k] = table[n - 1][k - 1] + (k < n ? table[n - 1][k] : 0.0);
    }
    return table;
}

constexpr BinomialTable inverted(BinomialTable table)
{
    for (auto &row : table)
        for (double &c : row)
            c = c > 0.0 ? 1.0 / c : 0.0;
    return table;
}

const double *binomials(int n) { return binomial_table[static_cast<std::size_t>(n)].data(); }
const double *inverse_binomials(int n) { return inverse_binomial_table[static_cast<std::size_t>(n)].data(); }

//! Fills the matrix of one span: its coefficients from the poles as unit vectors.
void extract(const KnotVector &kv, int span, SpanExtraction &extraction)
{
    const int p = kv.degree;
    const auto width = static_cast<std::size_t>(p) + 1;
    extraction.matrix.assign(width * width, 0.0);
    const auto row = [&](int k) { return extraction.matrix.data() + static_cast<std::size_t>(k) * width; };
    for (int k = 0; k <= p; ++k)
        row(k)[k] = 1.0;
    to_bernstein(kv.knots.data() + span, p, extraction.a, extraction.b, [&](double s, int i, int j, int k) {
        for (std::size_t column = 0; column < width; ++column)
            row(k)[column] = (1.0 - s) * row(i)[column] + s * row(j)[column];
    });
}

} // namespace

constinit const BinomialTable binomial_table = pascal_triangle();
constinit const BinomialTable inverse_binomial_table = inverted(pascal_triangle());

double Bernstein::Range::size() const { return std::max(std::abs(low), std::abs(high)); }

void Bernstein::reset(int m, int n)
{
    m_m = m;
    m_n = n;
    m_c.assign(static_cast<std::size_t>((m + 1) * (n + 1)), 0.0);
}

void Bernstein::add_product(double factor, const Bernstein &a, const Bernstein &b)
{
    // With b's rows as far apart as those of the product, each coefficient of a adds one long run.
    const int width = m_n + 1;
    const auto run_of = [width](const Bernstein &x) { return x.m_m * width + x.m_n + 1; };
    const int run = run_of(b);
    if (a.m_c.size() * static_cast<std::size_t>(run) > b.m_c.size() * static_cast<std::size_t>(run_of(a)))
        return add_product(factor, b, a);
    thread_local std::vector<double> spread;
    spread.assign(static_cast<std::size_t>(run + 2 * convolution_margin), 0.0);
    double *const from = spread.data() + convolution_margin;
    for (int i = 0; i <= b.m_m; ++i)
        for (int j = 0; j <= b.m_n; ++j)
            from[i * width + j] = factor * b.scaled(i, j);
    add_convolution(a.m_c.data(), a.m_m + 1, a.m_n + 1, width, from, run, m_c.data(), static_cast<int>(m_c.size()));
}

void Bernstein::add_raised(double factor, const Bernstein &a)
{
    const int rise_u = m_m - a.m_m;
    const int rise_v = m_n - a.m_n;
    if (rise_u == 0 && rise_v == 0)
        return add_multiple(factor, a.m_c.data(), m_c.data(), static_cast<int>(m_c.size()));
    const double *one_u = binomials(rise_u);
    const double *one_v = binomials(rise_v);
    for (int i = 0; i <= a.m_m; ++i)
        for (int k = 0; k <= rise_u; ++k)
            for (int l = 0; l <= rise_v; ++l)
                add_multiple(factor * one_u[k] * one_v[l], &a.m_c[static_cast<std::size_t>(i * (a.m_n + 1))],
                             &scaled(i + k, l), a.m_n + 1);
}

void Bernstein::scale(double factor)
{
    for (double &c : m_c)
        c *= factor;
}

void Bernstein::assign_derivative_u(const Bernstein &a)
{
    reset(std::max(0, a.m_m - 1), a.m_n);
    // m (c_{i+1} - c_i) C(m-1, i) in scaled coefficients
    for (int i = 0; i < a.m_m; ++i)
        for (int j = 0; j <= a.m_n; ++j)
            scaled(i, j) = (i + 1) * a.scaled(i + 1, j) - (a.m_m - i) * a.scaled(i, j);
}

void Bernstein::assign_derivative_v(const Bernstein &a)
{
    reset(a.m_m, std::max(0, a.m_n - 1));
    for (int i = 0; i <= a.m_m; ++i)
        for (int j = 0; j < a.m_n; ++j)
            scaled(i, j) = (j + 1) * a.scaled(i, j + 1) - (a.m_n - j) * a.scaled(i, j);
}

void Bernstein::halve(bool along_u, Bernstein &upper)
{
    upper.reset(m_m, m_n);
    const int degree = along_u ? m_m : m_n;
    const int lines = along_u ? m_n : m_m;
    const double *weights = binomials(degree);
    std::array<double, largest_bernstein_degree + 1> points;
    for (int line = 0; line <= lines; ++line)
    {
        const auto at = [&](Bernstein &b, int k) -> double & {
            return along_u ? b.scaled(k, line) : b.scaled(line, k);
        };
        for (int k = 0; k <= degree; ++k)
            points[static_cast<std::size_t>(k)] = at(*this, k) / weights[k];
        for (int r = 0; r <= degree; ++r)
        {
            at(*this, r) = points[0] * weights[r];
            at(upper, degree - r) = points[static_cast<std::size_t>(degree - r)] * weights[r];
            for (int k = 0; k < degree - r; ++k)
                points[static_cast<std::size_t>(k)] =
                    0.5 * (points[static_cast<std::size_t>(k)] + points[static_cast<std::size_t>(k) + 1]);
        }
    }
}

void Bernstein::divide(Border border)
{
    // In scaled coefficients the factor u (or v) shifts the index by one and 1 - u leaves it alone.
    const bool along_u = border == Border::LowU || border == Border::HighU;
    const int shift_u = border == Border::LowU ? 1 : 0;
    const int shift_v = border == Border::LowV ? 1 : 0;
    Bernstein quotient(along_u ? m_m - 1 : m_m, along_u ? m_n : m_n - 1);
    for (int i = 0; i <= quotient.m_m; ++i)
        for (int j = 0; j <= quotient.m_n; ++j)
            quotient.scaled(i, j) = scaled(i + shift_u, j + shift_v);
    *this = std::move(quotient);
}

double Bernstein::border_size(Border border) const
{
    double largest = 0.0;
    const bool along_u = border == Border::LowU || border == Border::HighU;
    for (int k = 0; k <= (along_u ? m_n : m_m); ++k)
    {
        const double c = border == Border::LowU    ? coefficient(0, k)
                         : border == Border::HighU ? coefficient(m_m, k)
                         : border == Border::LowV  ? coefficient(k, 0)
                                                   : coefficient(k, m_n);
        largest = std::max(largest, std::abs(c));
    }
    return largest;
}

Bernstein::Range Bernstein::range() const
{
    const double *rows = inverse_binomials(m_m);
    const double *columns = inverse_binomials(m_n);
    Range range{scaled(0, 0), scaled(0, 0)};
    const double *next = m_c.data();
    for (int i = 0; i <= m_m; ++i)
        for (int j = 0; j <= m_n; ++j, ++next)
        {
            const double c = *next * (rows[i] * columns[j]);
            range.low = c < range.low ? c : range.low;
            range.high = c > range.high ? c : range.high;
        }
    return range;
}

double Bernstein::centre() const
{
    double sum = 0.0;
    for (const double c : m_c)
        sum += c;
    return std::ldexp(sum, -(m_m + m_n));
}

double longest(const Bernstein3 &a)
{
    double largest = 0.0;
    for (int i = 0; i <= a[0].degree_u(); ++i)
        for (int j = 0; j <= a[0].degree_v(); ++j)
        {
            const double share = inverse_binomials(a[0].degree_u())[i] * inverse_binomials(a[0].degree_v())[j];
            const double square = a[0].scaled(i, j) * a[0].scaled(i, j) + a[1].scaled(i, j) * a[1].scaled(i, j) +
                                  a[2].scaled(i, j) * a[2].scaled(i, j);
            largest = std::max(largest, square * (share * share));
        }
    return std::sqrt(largest);
}

Eigen::Vector3d centre(const Bernstein3 &a) { return {a[0].centre(), a[1].centre(), a[2].centre()}; }

void assign_dot(const Bernstein3 &a, const Bernstein3 &b, Bernstein &out)
{
    out.reset(a[0].degree_u() + b[0].degree_u(), a[0].degree_v() + b[0].degree_v());
    for (std::size_t e = 0; e < 3; ++e)
        out.add_product(1.0, a[e], b[e]);
}

void assign_cross(const Bernstein3 &a, const Bernstein3 &b, Bernstein3 &out)
{
    for (std::size_t e = 0; e < 3; ++e)
    {
        const std::size_t f = (e + 1) % 3;
        const std::size_t g = (e + 2) % 3;
        out[e].reset(a[0].degree_u() + b[0].degree_u(), a[0].degree_v() + b[0].degree_v());
        out[e].add_product(1.0, a[f], b[g]);
        out[e].add_product(-1.0, a[g], b[f]);
    }
}

void assign_product(const Bernstein &a, const Bernstein &b, Bernstein &out)
{
    out.reset(a.degree_u() + b.degree_u(), a.degree_v() + b.degree_v());
    out.add_product(1.0, a, b);
}

std::vector<SpanExtraction> extractions(const KnotVector &kv, const std::vector<double> &breaks)
{
    std::vector<SpanExtraction> result;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    {
        SpanExtraction extraction{breaks[i], breaks[i + 1], 0, {}};
        const int span = kv.span(0.5 * (extraction.a + extraction.b));
        extraction.first = span - kv.degree;
        extract(kv, span, extraction);
        result.push_back(std::move(extraction));
    }
    return result;
}

} // namespace laminate_offset
