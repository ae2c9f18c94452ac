// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analytic_curve.h"

#include "../spline/bernstein.h"
#include "../spline/geom_values.h"
#include "../spline/vector_kernels.h"

#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <GeomAbs_CurveType.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <gp_Circ.hxx>
#include <gp_Circ2d.hxx>
#include <gp_Elips.hxx>
#include <gp_Elips2d.hxx>
#include <gp_Hypr.hxx>
#include <gp_Hypr2d.hxx>
#include <gp_Lin.hxx>
#include <gp_Lin2d.hxx>
#include <gp_Parab.hxx>
#include <gp_Parab2d.hxx>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace laminate_offset
{
namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();
// A spline of degree 25 takes some 150 roundings to its Bernstein coefficients and 80 more to their sum, all of positive
// terms; binomial coefficients add two for each degree, a conic takes a dozen.
constexpr double operations = 256.0;
constexpr double infinity = std::numeric_limits<double>::infinity();

using laminate_offset::vector; // else the overloads below hide it
Eigen::Vector3d vector(const gp_XY &p) { return {p.X(), p.Y(), 0.0}; }
Eigen::Vector3d vector(const gp_Pnt &p) { return vector(p.XYZ()); }
Eigen::Vector3d vector(const gp_Pnt2d &p) { return vector(p.XY()); }
Eigen::Vector3d vector(const gp_Dir &d) { return vector(d.XYZ()); }
Eigen::Vector3d vector(const gp_Dir2d &d) { return vector(d.XY()); }

gp_Ax1 x_axis(const gp_Parab &parabola) { return {parabola.Location(), parabola.Position().XDirection()}; }
gp_Ax1 y_axis(const gp_Parab &parabola) { return {parabola.Location(), parabola.Position().YDirection()}; }
gp_Ax2d x_axis(const gp_Parab2d &parabola) { return parabola.Axis().XAxis(); }
gp_Ax2d y_axis(const gp_Parab2d &parabola) { return parabola.Axis().YAxis(); }

//! Value of the quadratic c0 + c1 t + c2 t^2 blossomed at x and y.
Eigen::Vector3d blossom(const Eigen::Vector3d &c0, const Eigen::Vector3d &c1, const Eigen::Vector3d &c2, double x,
                        double y)
{
    return c0 + 0.5 * (x + y) * c1 + x * y * c2;
}

//! A line or conic of either dimension.
template <class Adaptor> std::optional<AnalyticCurve> conic(const Adaptor &curve)
{
    switch (curve.GetType())
    {
    case GeomAbs_Line:
    {
        const auto line = curve.Line();
        return AnalyticCurve::power(vector(line.Location()), vector(line.Direction()), Eigen::Vector3d::Zero());
    }
    case GeomAbs_Circle:
    {
        const auto circle = curve.Circle();
        return AnalyticCurve::circular(vector(circle.Location()), circle.Radius() * vector(circle.XAxis().Direction()),
                                       circle.Radius() * vector(circle.YAxis().Direction()));
    }
    case GeomAbs_Ellipse:
    {
        const auto ellipse = curve.Ellipse();
        return AnalyticCurve::circular(vector(ellipse.Location()),
                                       ellipse.MajorRadius() * vector(ellipse.XAxis().Direction()),
                                       ellipse.MinorRadius() * vector(ellipse.YAxis().Direction()));
    }
    case GeomAbs_Hyperbola:
    {
        const auto hyperbola = curve.Hyperbola();
        return AnalyticCurve::hyperbolic(vector(hyperbola.Location()),
                                         hyperbola.MajorRadius() * vector(hyperbola.XAxis().Direction()),
                                         hyperbola.MinorRadius() * vector(hyperbola.YAxis().Direction()));
    }
    case GeomAbs_Parabola:
    {
        const auto parabola = curve.Parabola();
        return AnalyticCurve::power(vector(parabola.Location()), vector(y_axis(parabola).Direction()),
                                    vector(x_axis(parabola).Direction()) / (4.0 * parabola.Focal()));
    }
    default: return std::nullopt;
    }
}

template <class Spline> std::vector<Eigen::Vector4d> homogeneous_poles(const Spline &spline)
{
    std::vector<Eigen::Vector4d> poles(static_cast<std::size_t>(spline.NbPoles()));
    for (int i = 1; i <= spline.NbPoles(); ++i)
        poles[static_cast<std::size_t>(i) - 1] << spline.Weight(i) * vector(spline.Pole(i)), spline.Weight(i);
    return poles;
}

template <class Spline> std::optional<AnalyticCurve> spline(const Spline &source, double first, double last)
{
    const auto copy = opencascade::handle<Spline>::DownCast(source.Copy());
    if (copy->IsPeriodic())
        copy->SetNotPeriodic();
    const double low = copy->FirstParameter();
    const double high = copy->LastParameter();
    const double admissible = 1e-9 * (high - low);
    if (source.IsPeriodic() && (first < low - admissible || last > high + admissible))
        return std::nullopt;
    if (copy->Multiplicity(1) != copy->Degree() + 1 || copy->Multiplicity(copy->NbKnots()) != copy->Degree() + 1)
        copy->Segment(low, high);
    return AnalyticCurve(knots_of(*copy), homogeneous_poles(*copy), copy->IsRational());
}

template <class Adaptor> std::optional<AnalyticCurve> curve_of(const Adaptor &adaptor, double first, double last)
{
    if (adaptor.GetType() == GeomAbs_BSplineCurve)
        return spline(*adaptor.BSpline(), first, last);
    if (adaptor.GetType() != GeomAbs_BezierCurve)
        return conic(adaptor);
    const auto bezier = adaptor.Bezier();
    return AnalyticCurve(clamped_knots(bezier->Degree(), 0.0, 1.0, {}), homogeneous_poles(*bezier),
                         bezier->IsRational());
}

} // namespace

CurvePiece::CurvePiece(const AnalyticCurve &curve, double a, double b) : m_curve(&curve), m_a(a), m_b(b)
{
    using Kind = AnalyticCurve::Kind;
    if (curve.m_kind == Kind::Spline)
        prepare_spline();
    else if (curve.m_kind == Kind::Power)
        prepare_power();
    else
        prepare_conic();
}

void CurvePiece::prepare_spline()
{
    const KnotVector &kv = m_curve->m_knots;
    m_degree = kv.degree;
    m_span = kv.span(0.5 * (m_a + m_b));
    const int width = m_degree + 1;
    Eigen::Vector3d size = Eigen::Vector3d::Zero();
    double least_weight = infinity;
    fill_coefficients();
    for (int i = 0; i < width; ++i)
    {
        m_scaled[static_cast<std::size_t>(i)] = binomial(m_degree, i) * m_coefficients[static_cast<std::size_t>(i)];
        const Eigen::Vector4d &pole = m_curve->m_poles[static_cast<std::size_t>(m_span - m_degree + i)];
        size = size.cwiseMax(pole.head<3>().cwiseAbs());
        least_weight = std::min(least_weight, pole.w());
    }
    m_middle = value(0.5 * (m_a + m_b));
    m_rounding = operations * epsilon * (m_curve->m_rational ? 2.0 / least_weight : 1.0) * size;
}

void CurvePiece::fill_coefficients()
{
    auto &c = m_coefficients;
    std::copy_n(m_curve->m_poles.data() + (m_span - m_degree), m_degree + 1, c.begin());
    const auto mix = [&](double s, int i, int j, int k) {
        c[static_cast<std::size_t>(k)] =
            (1.0 - s) * c[static_cast<std::size_t>(i)] + s * c[static_cast<std::size_t>(j)];
    };
    to_bernstein(m_curve->m_knots.knots.data() + m_span, m_degree, m_a, m_b, mix);
}

void CurvePiece::prepare_power()
{
    const AnalyticCurve &c = *m_curve;
    m_degree = 2;
    const double ends[4] = {m_a, m_a, m_b, m_b};
    for (std::size_t i = 0; i <= 2; ++i)
        m_coefficients[i] << blossom(c.m_a0, c.m_a1, c.m_a2, ends[i], ends[i + 1]), 1.0;
    m_middle = value(0.5 * (m_a + m_b));
    const double t = std::max(std::abs(m_a), std::abs(m_b));
    m_rounding = operations * epsilon * (c.m_a0.cwiseAbs() + t * c.m_a1.cwiseAbs() + t * t * c.m_a2.cwiseAbs());
}

void CurvePiece::prepare_conic()
{
    m_middle = value(0.5 * (m_a + m_b));
    const double t = std::max(std::abs(m_a), std::abs(m_b));
    const double growth = m_curve->m_kind == AnalyticCurve::Kind::Hyperbolic ? std::cosh(t) : 1.0;
    m_rounding = operations * epsilon * (1.0 + t) *
                 (m_curve->m_a0.cwiseAbs() + growth * (m_curve->m_a1.cwiseAbs() + m_curve->m_a2.cwiseAbs()));
}

Eigen::Vector3d CurvePiece::value(double t) const
{
    if (m_curve->m_kind != AnalyticCurve::Kind::Spline)
        return m_curve->value_on(m_span, t);
    const double s = (t - m_a) / (m_b - m_a);
    std::array<double, max_spline_degree + 1> rest;
    rest[0] = 1.0;
    for (int i = 1; i <= m_degree; ++i)
        rest[static_cast<std::size_t>(i)] = rest[static_cast<std::size_t>(i) - 1] * (1.0 - s);
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    double power = 1.0;
    for (int i = 0; i <= m_degree; ++i)
    {
        sum += (power * rest[static_cast<std::size_t>(m_degree - i)]) * m_scaled[static_cast<std::size_t>(i)];
        power *= s;
    }
    return m_curve->m_rational ? Eigen::Vector3d(sum.head<3>() / sum.w()) : Eigen::Vector3d(sum.head<3>());
}

void CurvePiece::lane_values(const double *t, double *rows) const
{
    if (m_curve->m_kind != AnalyticCurve::Kind::Spline)
    {
        for (int k = 0; k < lanes; ++k)
            Eigen::Map<Eigen::Vector3d, 0, Eigen::InnerStride<lanes>>(rows + k) = m_curve->value_on(m_span, t[k]);
        return;
    }
    std::array<double, lanes> s;
    for (std::size_t k = 0; k < s.size(); ++k)
        s[k] = (t[k] - m_a) / (m_b - m_a);
    std::array<double, 4 * lanes> sums;
    bernstein_sum(m_scaled.front().data(), m_degree, s.data(), sums.data());
    without_weights(sums.data(), m_curve->m_rational, rows);
}

CurveReach CurvePiece::conic_reach(double rho) const
{
    // Taylor's series about the middle: the first term is linear, the bounds of the others sum to e^|s| - 1 - |s|
    CurveReach reach{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 0.5 * (rho + 1.0 / rho)};
    const double m = 0.5 * (m_a + m_b);
    const double half = 0.5 * (m_b - m_a);
    const double s = half * reach.stretch;
    const bool circular = m_curve->m_kind == AnalyticCurve::Kind::Circular;
    const Eigen::Vector3d slope = circular
                                      ? Eigen::Vector3d(std::cos(m) * m_curve->m_a2 - std::sin(m) * m_curve->m_a1)
                                      : Eigen::Vector3d(std::sinh(m) * m_curve->m_a1 + std::cosh(m) * m_curve->m_a2);
    const double remainder = circular && rho == 1.0 ? 0.5 * s * s : std::expm1(s) - s;
    reach.chord = half * slope.cwiseAbs();
    reach.total = reach.stretch * reach.chord +
                  (circular ? 1.0 : std::cosh(m)) * remainder * (m_curve->m_a1.cwiseAbs() + m_curve->m_a2.cwiseAbs());
    return reach;
}

CurveReach CurvePiece::reach(double rho) const
{
    using Kind = AnalyticCurve::Kind;
    if (m_curve->m_kind == Kind::Circular || m_curve->m_kind == Kind::Hyperbolic)
        return conic_reach(rho);
    // Bernstein polynomials sum up to stretch^degree at most in absolute value, the chord grows like the stretch
    CurveReach reach{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 0.5 * (rho + 1.0 / rho)};
    const auto relative = [&](int i) -> Eigen::Vector3d {
        const Eigen::Vector4d &c = m_coefficients[static_cast<std::size_t>(i)];
        return c.head<3>() - c.w() * m_middle;
    };
    const Eigen::Vector3d low = relative(0);
    const Eigen::Vector3d high = relative(m_degree);
    const double middle_weight = 0.5 * (m_coefficients[0].w() + m_coefficients[static_cast<std::size_t>(m_degree)].w());
    double weight_reach = 0.0;
    Eigen::Vector3d bend = Eigen::Vector3d::Zero();
    for (int i = 0; i <= m_degree; ++i)
    {
        const double s = m_degree > 0 ? static_cast<double>(i) / m_degree : 0.0;
        bend = bend.cwiseMax((relative(i) - (1.0 - s) * low - s * high).cwiseAbs());
        weight_reach =
            std::max(weight_reach, std::abs(m_coefficients[static_cast<std::size_t>(i)].w() - middle_weight));
    }
    const double power = std::pow(reach.stretch, m_degree);
    const double weight = middle_weight - power * weight_reach;
    if (!(weight > 0.0))
    {
        reach.total.setConstant(infinity);
        return reach;
    }
    const Eigen::Vector3d chord = 0.5 * (high - low).cwiseAbs();
    reach.total = (0.5 * (low + high).cwiseAbs() + reach.stretch * chord + power * bend) / weight;
    if (weight_reach == 0.0)
        reach.chord = chord;
    return reach;
}

CurveRange CurvePiece::range() const
{
    using Kind = AnalyticCurve::Kind;
    if (m_curve->m_kind == Kind::Circular)
        return arc_range();
    if (m_curve->m_kind == Kind::Hyperbolic)
    {
        const Eigen::Vector3d total = conic_reach(1.0).total;
        return {m_middle - total, m_middle + total};
    }
    CurveRange range{Eigen::Vector3d::Constant(infinity), Eigen::Vector3d::Constant(-infinity)};
    for (int i = 0; i <= m_degree; ++i)
    {
        const Eigen::Vector4d &c = m_coefficients[static_cast<std::size_t>(i)];
        if (!(c.w() > 0.0))
            return {Eigen::Vector3d::Constant(-infinity), Eigen::Vector3d::Constant(infinity)};
        const Eigen::Vector3d point = c.head<3>() / c.w();
        range.low = range.low.cwiseMin(point);
        range.high = range.high.cwiseMax(point);
    }
    return range;
}

CurveRange CurvePiece::arc_range() const
{
    const Eigen::Vector3d start = m_curve->value_on(m_span, m_a);
    const Eigen::Vector3d end = m_curve->value_on(m_span, m_b);
    CurveRange range{start.cwiseMin(end), start.cwiseMax(end)};
    for (int e = 0; e < 3; ++e)
    {
        // cosine and sine sum to a wave, which has a crest or a trough at every half turn
        const double amplitude = std::hypot(m_curve->m_a1[e], m_curve->m_a2[e]);
        const double crest = std::atan2(m_curve->m_a2[e], m_curve->m_a1[e]);
        const auto passes = [&](double place) {
            return place + 2.0 * M_PI * std::ceil((m_a - place) / (2.0 * M_PI)) <= m_b;
        };
        if (passes(crest))
            range.high[e] = m_curve->m_a0[e] + amplitude;
        if (passes(crest + M_PI))
            range.low[e] = m_curve->m_a0[e] - amplitude;
    }
    return range;
}

std::optional<int> CurvePiece::degree(int coordinate, double slack) const
{
    using Kind = AnalyticCurve::Kind;
    if (m_curve->m_kind == Kind::Circular || m_curve->m_kind == Kind::Hyperbolic)
        return std::nullopt;
    const auto at = [&](int i) { return m_coefficients[static_cast<std::size_t>(i)][coordinate]; };
    const bool rational = m_curve->m_kind == Kind::Spline && m_curve->m_rational;
    double spread = 0.0;
    double bend = 0.0;
    for (int i = 0; i <= m_degree; ++i)
    {
        const double w = m_coefficients[static_cast<std::size_t>(i)].w();
        const double s = m_degree > 0 ? static_cast<double>(i) / m_degree : 0.0;
        spread = std::max(spread, std::abs(at(i) / w - m_middle[coordinate]));
        bend = std::max(bend, std::abs(at(i) - (1.0 - s) * at(0) - s * at(m_degree)));
    }
    if (spread <= slack)
        return 0;
    if (rational)
        return std::nullopt;
    return bend <= slack ? std::min(1, m_degree) : m_degree;
}

AnalyticCurve::AnalyticCurve(KnotVector knots, std::vector<Eigen::Vector4d> poles, bool rational)
    : m_knots(std::move(knots)), m_poles(std::move(poles)), m_rational(rational)
{
    const std::vector<double> ends = m_knots.breaks();
    m_breaks.assign(ends.begin() + 1, ends.end() - 1);
}

AnalyticCurve AnalyticCurve::power(const Eigen::Vector3d &a0, const Eigen::Vector3d &a1, const Eigen::Vector3d &a2)
{
    return {Kind::Power, a0, a1, a2};
}

AnalyticCurve AnalyticCurve::circular(const Eigen::Vector3d &a0, const Eigen::Vector3d &a1, const Eigen::Vector3d &a2)
{
    return {Kind::Circular, a0, a1, a2};
}

AnalyticCurve AnalyticCurve::hyperbolic(const Eigen::Vector3d &a0, const Eigen::Vector3d &a1, const Eigen::Vector3d &a2)
{
    return {Kind::Hyperbolic, a0, a1, a2};
}

AnalyticCurve AnalyticCurve::point(const Eigen::Vector3d &place)
{
    return power(place, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
}

Eigen::Vector3d AnalyticCurve::value(double t) const
{
    return value_on(m_kind == Kind::Spline ? m_knots.span(t) : 0, t);
}

Eigen::Vector3d AnalyticCurve::value_on(int span, double t) const
{
    switch (m_kind)
    {
    case Kind::Power: return m_a0 + t * m_a1 + (t * t) * m_a2;
    case Kind::Circular: return m_a0 + std::cos(t) * m_a1 + std::sin(t) * m_a2;
    case Kind::Hyperbolic: return m_a0 + std::cosh(t) * m_a1 + std::sinh(t) * m_a2;
    case Kind::Spline: break;
    }
    std::array<double, max_spline_degree + 1> basis;
    basis_values(m_knots, span, t, basis.data());
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (int i = 0; i <= m_knots.degree; ++i)
        sum += basis[static_cast<std::size_t>(i)] * m_poles[static_cast<std::size_t>(span - m_knots.degree + i)];
    if (m_rational)
        return sum.head<3>() / sum.w();
    return sum.head<3>();
}

std::optional<AnalyticCurve> AnalyticCurve::make(const Handle(Geom_Curve) & curve, double first, double last)
{
    return curve_of(GeomAdaptor_Curve(curve), first, last);
}

std::optional<AnalyticCurve> AnalyticCurve::make(const Handle(Geom2d_Curve) & curve, double first, double last)
{
    return curve_of(Geom2dAdaptor_Curve(curve), first, last);
}

std::vector<double> analytic_ends(const AnalyticCurve &a, double first, double last)
{
    std::vector<double> ends{first};
    for (const double t : a.breaks())
        if (t > first && t < last)
            ends.push_back(t);
    ends.push_back(last);
    return ends;
}

std::vector<double> analytic_ends(const AnalyticCurve &a, const AnalyticCurve &b, double first, double last)
{
    const std::vector<double> of_a = analytic_ends(a, first, last);
    const std::vector<double> of_b = analytic_ends(b, first, last);
    std::vector<double> ends;
    std::set_union(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(ends));
    return ends;
}

} // namespace laminate_offset
