// SPDX-License-Identifier: LGPL-2.1-or-later
#include "conic_functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

using Real = long double;

constexpr int least_degree = 5;
constexpr int most_degree = 9;
constexpr int further_terms = 7; // of the series, beyond the degree, that are looked at singly
constexpr int most_terms = most_degree + further_terms + 1;
constexpr int most_spans = 256;
constexpr double widest_half = 1.0;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
// Largest over sampled value of a polynomial of degree K at 3 K + 1 Chebyshev points: 1 / cos(pi / 6) < 1.1548.
constexpr double between_points = 1.1548;
// Roundings of a pole: its own, those of the knots, and a zero that is made exact.
constexpr double pole_roundings = 8.0;
// Proving costs about this power of the degree + 1 for each piece.
constexpr double cost_power = 1.5;

using Series = std::array<Real, most_terms>;

//! J_k(h) or I_k(h), by their power series.
Real bessel(ConicKind kind, int k, Real h)
{
    const Real x = h / 2;
    Real term = 1;
    for (int i = 1; i <= k; ++i)
        term *= x / i;
    Real sum = 0;
    for (int m = 0; m < 24; ++m)
    {
        sum += term;
        term *= (kind == ConicKind::Circle ? -x : x) * x / ((m + 1) * static_cast<Real>(m + 1 + k));
    }
    return sum;
}

//! Coefficients of exp(k h s) over T_0, T_1, ...; the odd ones belong to the second component.
Series chebyshev_series(ConicKind kind, Real h, int terms)
{
    Series series{};
    for (int k = 0; k < terms; ++k)
    {
        const bool negative = kind == ConicKind::Circle && (k / 2) % 2 == 1;
        series[static_cast<std::size_t>(k)] = (k == 0 ? 1 : 2) * (negative ? -1 : 1) * bessel(kind, k, h);
    }
    return series;
}

//! Splits a series into the polynomial and what it leaves out.
struct Cut
{
    Series kept{};
    Series left{};
};

//! T_k(1) = 1 and T_k'(1) = k k: two coefficients of each parity take over what the rest has there.
Cut cut(const Series &series, int degree, int terms)
{
    Cut result;
    for (int k = 0; k < terms; ++k)
        (k <= degree ? result.kept : result.left)[static_cast<std::size_t>(k)] = series[static_cast<std::size_t>(k)];
    for (int parity = 0; parity < 2; ++parity)
    {
        const int high = degree - (degree % 2 == parity ? 0 : 1);
        const int low = high - 2;
        Real value = 0;
        Real slope = 0;
        for (int k = high + 2; k < terms; k += 2)
        {
            value += result.left[static_cast<std::size_t>(k)];
            slope += static_cast<Real>(k) * k * result.left[static_cast<std::size_t>(k)];
        }
        const Real upper = (slope - static_cast<Real>(low) * low * value) / (high * high - low * low);
        for (const auto &[k, x] : {std::pair(high, upper), std::pair(low, value - upper)})
        {
            result.kept[static_cast<std::size_t>(k)] += x;
            result.left[static_cast<std::size_t>(k)] -= x;
        }
    }
    return result;
}

//! The sizes of value, first and second derivative of a complex Chebyshev series at s.
std::array<Real, 3> sizes_at(const Series &series, int terms, Real s)
{
    std::array<std::array<Real, 2>, 3> sum{};
    std::array<Real, 3> before{1, 0, 0};
    std::array<Real, 3> here{s, 1, 0};
    for (int k = 0; k < terms; ++k)
    {
        for (std::size_t d = 0; d < 3; ++d)
            sum[d][static_cast<std::size_t>(k % 2)] += series[static_cast<std::size_t>(k)] * before[d];
        const std::array<Real, 3> next{2 * s * here[0] - before[0], 2 * here[0] + 2 * s * here[1] - before[1],
                                       4 * here[1] + 2 * s * here[2] - before[2]};
        before = here;
        here = next;
    }
    std::array<Real, 3> sizes{};
    for (std::size_t d = 0; d < 3; ++d)
        sizes[d] = std::hypot(sum[d][0], sum[d][1]);
    return sizes;
}

//! Bounds of the terms from `first` on and of their derivatives; each is at most 1/8 of the one before.
std::array<Real, 3> tail(Real h, int first)
{
    Real term = 2 * std::exp(h * h / 4);
    for (int i = 1; i <= first; ++i)
        term *= h / 2 / i;
    const Real square = static_cast<Real>(first) * first;
    return {2 * term, 2 * square * term, square * square * term};
}

//! Bounds on [-1, 1] of what the polynomial leaves out, by order of the derivative.
std::array<Real, 3> left_out(const Cut &parts, Real h, int terms)
{
    std::array<Real, 3> bounds{};
    const int points = 3 * (terms - 1);
    for (int j = 0; 2 * j <= points + 1; ++j) // the sizes are even in s
    {
        const std::array<Real, 3> sizes = sizes_at(parts.left, terms, std::cos(static_cast<Real>(M_PIl) * j / points));
        for (std::size_t d = 0; d < 3; ++d)
            bounds[d] = std::max(bounds[d], sizes[d]);
    }
    const std::array<Real, 3> rest = tail(h, terms);
    for (std::size_t d = 0; d < 3; ++d)
        bounds[d] = between_points * bounds[d] + rest[d];
    return bounds;
}

struct Layout
{
    int degree = 0;
    int spans = 0;
    Real half = 0;
    Cut parts;
    ConicErrors errors;
};

Layout layout(ConicKind kind, double a, double b, int degree, int spans)
{
    Layout result;
    result.degree = degree;
    result.spans = spans;
    result.half = (static_cast<Real>(b) - a) / (2 * spans);
    const int terms = degree + further_terms + 1;
    result.parts = cut(chebyshev_series(kind, result.half, terms), degree, terms);
    const std::array<Real, 3> bounds = left_out(result.parts, result.half, terms);
    // a rounded pole moves derivatives by up to 2 degree / width, and those twice over
    const Real rounding = pole_roundings * epsilon * std::max({1.0, std::abs(a), std::abs(b)});
    const Real steps = degree / result.half;
    const Real growth = kind == ConicKind::Circle ? 1 : 2 * std::exp(result.half);
    result.errors.value = static_cast<double>(growth * (bounds[0] + rounding));
    result.errors.slope = static_cast<double>(growth * (bounds[1] / result.half + rounding * steps));
    result.errors.bend =
        static_cast<double>(growth * (bounds[2] / (result.half * result.half) + rounding * steps * steps));
    return result;
}

bool within(const ConicErrors &errors, const ConicErrors &wanted)
{
    return errors.value <= wanted.value && errors.slope <= wanted.slope && errors.bend <= wanted.bend;
}

//! The fewest spans of one degree.
std::optional<Layout> fewest_spans(ConicKind kind, double a, double b, int degree, const ConicErrors &wanted)
{
    int spans = std::max(1, static_cast<int>(std::ceil((b - a) / (2.0 * widest_half))));
    while (spans <= most_spans)
    {
        const Layout trial = layout(kind, a, b, degree, spans);
        if (within(trial.errors, wanted))
            return trial;
        // the errors fall at least with these powers of the width
        const double factor = std::max({std::pow(trial.errors.value / wanted.value, 1.0 / (degree + 1)),
                                        std::pow(trial.errors.slope / wanted.slope, 1.0 / degree),
                                        std::pow(trial.errors.bend / wanted.bend, 1.0 / (degree - 1))});
        if (!(factor < most_spans))
            return std::nullopt;
        spans = std::max(spans + 1, static_cast<int>(std::ceil(0.98 * factor * spans)));
    }
    return std::nullopt;
}

Real binomial_of(int n, int k)
{
    Real result = 1;
    for (int i = 1; i <= k; ++i)
        result = result * (n - k + i) / i;
    return result;
}

//! Bernstein coefficients on [-1, 1] of both components.
std::vector<std::array<Real, 2>> bernstein_form(const Series &series, int degree)
{
    std::vector<std::array<Real, 2>> form(static_cast<std::size_t>(degree) + 1, {0, 0});
    for (int k = 0; k <= degree; ++k)
        for (int j = 0; j <= k; ++j)
        {
            // T_k has the coefficients (-1)^(k-j) C(2k, 2j) / C(k, j) of degree k; raise them
            const Real scaled = ((k - j) % 2 == 0 ? 1 : -1) * binomial_of(2 * k, 2 * j);
            for (int r = 0; r <= degree - k; ++r)
                form[static_cast<std::size_t>(j + r)][static_cast<std::size_t>(k % 2)] +=
                    series[static_cast<std::size_t>(k)] * scaled * binomial_of(degree - k, r) /
                    binomial_of(degree, j + r);
        }
    return form;
}

Eigen::Vector2d rounded(Real x, Real y)
{
    const auto exact_zero = [](Real t) { return std::abs(t) < 2.0L * epsilon ? 0.0 : static_cast<double>(t); };
    return {exact_zero(x), exact_zero(y)};
}

Eigen::Vector2d place(ConicKind kind, Real t)
{
    return kind == ConicKind::Circle ? rounded(std::cos(t), std::sin(t)) : rounded(std::cosh(t), std::sinh(t));
}

ConicSpline build(ConicKind kind, double a, double b, const Layout &from)
{
    ConicSpline spline;
    spline.errors = from.errors;
    std::vector<double> interior;
    const std::vector<std::array<Real, 2>> form = bernstein_form(from.parts.kept, from.degree);
    for (int i = 0; i < from.spans; ++i)
    {
        const Real middle = a + (2 * i + 1) * from.half;
        const bool circle = kind == ConicKind::Circle;
        const Real x = circle ? std::cos(middle) : std::cosh(middle);
        const Real y = circle ? std::sin(middle) : std::sinh(middle);
        spline.poles.push_back(place(kind, a + 2 * i * from.half));
        for (int j = 1; j < from.degree; ++j)
        {
            const auto &[even, odd] = form[static_cast<std::size_t>(j)];
            spline.poles.push_back(rounded(x * even + (circle ? -y : y) * odd, y * even + x * odd));
        }
        if (i > 0)
            interior.insert(interior.end(), static_cast<std::size_t>(from.degree),
                            static_cast<double>(a + 2 * i * from.half));
    }
    const bool full_turn =
        kind == ConicKind::Circle && std::abs(b - a - 2.0 * M_PI) <= 4.0 * epsilon * std::max(std::abs(a), std::abs(b));
    spline.poles.push_back(full_turn ? spline.poles.front() : place(kind, b));
    spline.knots = clamped_knots(from.degree, a, b, interior);
    return spline;
}

} // namespace

std::optional<ConicSpline> conic_spline(ConicKind kind, double a, double b, const ConicErrors &wanted)
{
    std::optional<Layout> best;
    const auto cost = [](const Layout &l) { return l.spans * std::pow(l.degree + 1.0, cost_power); };
    for (int degree = least_degree; degree <= most_degree; ++degree)
        if (const std::optional<Layout> trial = fewest_spans(kind, a, b, degree, wanted))
            if (!best || cost(*trial) < cost(*best))
                best = trial;
    if (!best)
        return std::nullopt;
    return build(kind, a, b, *best);
}

} // namespace laminate_offset
