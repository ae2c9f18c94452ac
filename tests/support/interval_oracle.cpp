// SPDX-License-Identifier: LGPL-2.1-or-later
#include "interval_oracle.h"

#include <boost/numeric/interval.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace test_support
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

//! Rounds outwards by one unit in the last place around the nearest result. It needs no rounding mode of the
//! processor, which optimising compilers do not respect.
struct OutwardRounding
{
    using unprotected_rounding = OutwardRounding;

    static double down(double x) { return std::nextafter(x, -infinity); }
    static double up(double x) { return std::nextafter(x, infinity); }

    void init() const {}
    double conv_down(double x) const { return x; }
    double conv_up(double x) const { return x; }
    double add_down(double x, double y) const { return down(x + y); }
    double add_up(double x, double y) const { return up(x + y); }
    double sub_down(double x, double y) const { return down(x - y); }
    double sub_up(double x, double y) const { return up(x - y); }
    double mul_down(double x, double y) const { return down(x * y); }
    double mul_up(double x, double y) const { return up(x * y); }
    double div_down(double x, double y) const { return down(x / y); }
    double div_up(double x, double y) const { return up(x / y); }
    double sqrt_down(double x) const { return std::max(0.0, down(std::sqrt(x))); }
    double sqrt_up(double x) const { return up(std::sqrt(x)); }
    double median(double x, double y) const { return 0.5 * (x + y); }
};

using Policies =
    boost::numeric::interval_lib::policies<OutwardRounding, boost::numeric::interval_lib::checking_strict<double>>;
using Interval = boost::numeric::interval<double, Policies>;
using Vector3 = std::array<Interval, 3>;
using Vector4 = std::array<Interval, 4>;

//! Values of the basis functions of one degree on a span, by the recurrence of Cox and de Boor; function
//! span - degree + k stands at k.
std::vector<Interval> basis(const std::vector<double> &knots, int span, int degree, const Interval &t)
{
    std::vector<Interval> values{Interval(1.0)};
    for (int p = 1; p <= degree; ++p)
    {
        std::vector<Interval> raised(static_cast<std::size_t>(p) + 1, Interval(0.0));
        for (int k = 0; k < p; ++k)
        {
            const Interval low(knots[static_cast<std::size_t>(span - p + 1 + k)]);
            const Interval high(knots[static_cast<std::size_t>(span + 1 + k)]);
            const Interval width = high - low;
            raised[static_cast<std::size_t>(k)] += (high - t) / width * values[static_cast<std::size_t>(k)];
            raised[static_cast<std::size_t>(k) + 1] += (t - low) / width * values[static_cast<std::size_t>(k)];
        }
        values = std::move(raised);
    }
    return values;
}

//! Derivatives of the same functions.
std::vector<Interval> basis_slopes(const std::vector<double> &knots, int span, int degree, const Interval &t)
{
    std::vector<Interval> slopes(static_cast<std::size_t>(degree) + 1, Interval(0.0));
    if (degree == 0)
        return slopes;
    const std::vector<Interval> lower = basis(knots, span, degree - 1, t);
    for (int k = 0; k < degree; ++k)
    {
        const Interval width = Interval(knots[static_cast<std::size_t>(span + 1 + k)]) -
                               Interval(knots[static_cast<std::size_t>(span - degree + 1 + k)]);
        const Interval share = static_cast<double>(degree) * lower[static_cast<std::size_t>(k)] / width;
        slopes[static_cast<std::size_t>(k)] -= share;
        slopes[static_cast<std::size_t>(k) + 1] += share;
    }
    return slopes;
}

int span_of(const laminate_offset::KnotVector &kv, const ParameterRange &range)
{
    int span = kv.degree;
    while (span + 1 < kv.pole_count() && kv.knots[static_cast<std::size_t>(span) + 1] <= range.low)
        ++span;
    return span;
}

//! Homogeneous value or derivative, as the given weights of the poles say.
Vector4 combine(const laminate_offset::TensorSpline &spline, int first_u, int first_v, const std::vector<Interval> &a,
                const std::vector<Interval> &b)
{
    Vector4 sum;
    sum.fill(Interval(0.0));
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
        {
            const Interval weight = a[i] * b[j];
            const Eigen::Vector4d &pole = spline.pole(first_u + static_cast<int>(i), first_v + static_cast<int>(j));
            for (std::size_t e = 0; e < 4; ++e)
                sum[e] += weight * pole[static_cast<Eigen::Index>(e)];
        }
    return sum;
}

struct IntervalJet
{
    Vector3 s, u, v;
};

IntervalJet evaluate(const laminate_offset::TensorSpline &spline, const ParameterRange &u, const ParameterRange &v)
{
    const int su = span_of(spline.u, u), sv = span_of(spline.v, v);
    const Interval tu(u.low, u.high), tv(v.low, v.high);
    const auto nu = basis(spline.u.knots, su, spline.u.degree, tu);
    const auto nv = basis(spline.v.knots, sv, spline.v.degree, tv);
    const int fu = su - spline.u.degree, fv = sv - spline.v.degree;
    const Vector4 p = combine(spline, fu, fv, nu, nv);
    const Vector4 pu = combine(spline, fu, fv, basis_slopes(spline.u.knots, su, spline.u.degree, tu), nv);
    const Vector4 pv = combine(spline, fu, fv, nu, basis_slopes(spline.v.knots, sv, spline.v.degree, tv));
    IntervalJet jet;
    for (std::size_t e = 0; e < 3; ++e)
    {
        if (!spline.rational)
        {
            jet.s[e] = p[e];
            jet.u[e] = pu[e];
            jet.v[e] = pv[e];
            continue;
        }
        jet.s[e] = p[e] / p[3];
        jet.u[e] = (pu[e] - jet.s[e] * pu[3]) / p[3];
        jet.v[e] = (pv[e] - jet.s[e] * pv[3]) / p[3];
    }
    return jet;
}

Interval length(const Vector3 &a)
{
    return sqrt(boost::numeric::square(a[0]) + boost::numeric::square(a[1]) + boost::numeric::square(a[2]));
}

} // namespace

Enclosure enclose_deviation(const laminate_offset::TensorSpline &base, const laminate_offset::TensorSpline &offset,
                            double distance, const ParameterRange &u, const ParameterRange &v)
{
    const IntervalJet s = evaluate(base, u, v);
    const IntervalJet o = evaluate(offset, u, v);
    Vector3 normal;
    for (std::size_t e = 0; e < 3; ++e)
    {
        const std::size_t f = (e + 1) % 3, g = (e + 2) % 3;
        normal[e] = s.u[f] * s.v[g] - s.u[g] * s.v[f];
    }
    const Interval size = length(normal);
    if (!(size.lower() > 0.0))
        return {0.0, infinity};
    Vector3 difference;
    for (std::size_t e = 0; e < 3; ++e)
        difference[e] = o.s[e] - s.s[e] - distance * (normal[e] / size);
    const Interval deviation = length(difference);
    return {deviation.lower(), deviation.upper()};
}

Enclosure enclose_square_plus(double x, double y)
{
    const Interval result = boost::numeric::square(Interval(x)) + Interval(y);
    return {result.lower(), result.upper()};
}

} // namespace test_support
