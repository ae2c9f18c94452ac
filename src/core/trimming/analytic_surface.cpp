// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analytic_surface.h"

#include "../spline/geom_values.h"
#include "../spline/vector_kernels.h"

#include <Eigen/Geometry>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();
// Two bases and a double sum of positive terms, of degree 25 at most.
constexpr double operations = 256.0;
// Patches are at least this part of their cell wide.
constexpr double narrowest_patch = 1e-6;
// A patch may reach over its cell by that much; the blossom's weights then turn a little negative.
constexpr double blossom_margin = 1.001;

using Basis = std::array<double, max_spline_degree + 1>;

} // namespace

std::optional<AnalyticSurface> AnalyticSurface::make(const Handle(Geom_Surface) & surface)
{
    AnalyticSurface result;
    if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface))
    {
        result.m_spline = from_geom(spline);
        result.prepare_spline();
        return result;
    }
    if (const auto elementary = Handle(Geom_ElementarySurface)::DownCast(surface))
        result.take_elementary(elementary);
    else if (!result.take_turned_circle(surface))
        return std::nullopt;
    result.m_size += result.m_origin.norm() + result.m_radius + result.m_tube;
    return result;
}

void AnalyticSurface::take_elementary(const Handle(Geom_ElementarySurface) & surface)
{
    const gp_Ax3 &position = surface->Position();
    m_origin = vector(position.Location().XYZ());
    m_x = vector(position.XDirection().XYZ());
    m_y = vector(position.YDirection().XYZ());
    m_z = vector(position.Direction().XYZ());
    if (!Handle(Geom_Plane)::DownCast(surface).IsNull())
        m_kind = Kind::Plane;
    else if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface))
    {
        m_kind = Kind::Cone;
        m_radius = cylinder->Radius();
    }
    else if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface))
    {
        m_kind = Kind::Cone;
        m_radius = cone->RefRadius();
        m_sine = std::sin(cone->SemiAngle());
        m_cosine = std::cos(cone->SemiAngle());
    }
    else
    {
        const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface);
        const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface);
        m_kind = Kind::Torus;
        m_radius = sphere.IsNull() ? torus->MajorRadius() : 0.0;
        m_tube = sphere.IsNull() ? torus->MinorRadius() : sphere->Radius();
    }
}

//! The frame stands at the height of the circle's centre, its first axis towards the centre.
bool AnalyticSurface::take_turned_circle(const Handle(Geom_Surface) & surface)
{
    const auto turned = Handle(Geom_SurfaceOfRevolution)::DownCast(surface);
    if (turned.IsNull())
        return false;
    Handle(Geom_Curve) profile = turned->BasisCurve();
    while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(profile))
        profile = trimmed->BasisCurve();
    const auto circle = Handle(Geom_Circle)::DownCast(profile);
    if (circle.IsNull())
        return false;
    const Eigen::Vector3d centre = vector(circle->Location().XYZ());
    m_kind = Kind::Torus;
    m_origin = vector(turned->Axis().Location().XYZ());
    m_size = m_origin.norm() + centre.norm(); // what the frame is rounded from
    m_z = vector(turned->Axis().Direction().XYZ());
    m_origin += (centre - m_origin).dot(m_z) * m_z;
    m_radius = (centre - m_origin).norm();
    m_tube = circle->Radius();
    const Eigen::Vector3d out = centre - m_origin;
    m_x = (out - out.dot(m_z) * m_z).norm() > 0.0 ? (out - out.dot(m_z) * m_z).normalized() : m_z.unitOrthogonal();
    m_y = m_z.cross(m_x);
    const Eigen::Matrix3d to_frame = (Eigen::Matrix3d() << m_x, m_y, m_z).finished().transpose();
    m_a = to_frame * vector(circle->XAxis().Direction().XYZ());
    m_b = to_frame * vector(circle->YAxis().Direction().XYZ());
    return true;
}

void AnalyticSurface::prepare_spline()
{
    double least_weight = infinity;
    for (const Eigen::Vector4d &pole : m_spline.poles)
    {
        m_size = std::max(m_size, pole.head<3>().norm() / pole.w());
        least_weight = std::min(least_weight, pole.w());
    }
    m_origin = m_spline.poles.front().head<3>() / m_spline.poles.front().w();
    for (int direction = 0; direction < 2; ++direction)
        m_speed[direction] = derivative_bound(direction);
}

//! Largest pole of the derivative; for a rational surface that of (A' - (S - o) w') / w, about the origin o.
double AnalyticSurface::derivative_bound(int direction) const
{
    const KnotVector &along = direction == 0 ? m_spline.u : m_spline.v;
    const int lines = direction == 0 ? m_spline.v.pole_count() : m_spline.u.pole_count();
    double numerator = 0.0;
    double weight = 0.0;
    double radius = 0.0;
    double least_weight = infinity;
    const auto pole = [&](int i, int line) {
        Eigen::Vector4d p = direction == 0 ? m_spline.pole(i, line) : m_spline.pole(line, i);
        p.head<3>() -= p.w() * m_origin;
        return p;
    };
    for (int line = 0; line < lines; ++line)
    {
        Eigen::Vector4d previous = pole(0, line);
        for (int i = 0; i < along.pole_count(); ++i)
        {
            const Eigen::Vector4d here = pole(i, line);
            radius = std::max(radius, here.head<3>().norm() / here.w());
            least_weight = std::min(least_weight, here.w());
            const double width =
                along.knots[static_cast<std::size_t>(i + along.degree)] - along.knots[static_cast<std::size_t>(i)];
            if (i > 0 && width > 0.0)
            {
                numerator = std::max(numerator, along.degree / width * (here - previous).head<3>().norm());
                weight = std::max(weight, along.degree / width * std::abs(here.w() - previous.w()));
            }
            previous = here;
        }
    }
    return (numerator + radius * weight) / least_weight;
}

AnalyticSurface::Cell AnalyticSurface::cell_at(double u, double v) const
{
    return m_kind == Kind::Spline ? Cell{m_spline.u.span(u), m_spline.v.span(v)} : Cell{};
}

AnalyticSurface::Ends AnalyticSurface::ends(const Cell &cell, int direction) const
{
    if (m_kind != Kind::Spline)
        return {-infinity, infinity};
    const KnotVector &kv = direction == 0 ? m_spline.u : m_spline.v;
    const auto span = static_cast<std::size_t>(direction == 0 ? cell.span_u : cell.span_v);
    const double low = kv.knots[span];
    const double high = kv.knots[span + 1];
    return {low > kv.front() ? low : -infinity, high < kv.back() ? high : infinity};
}

AnalyticSurface::Ends AnalyticSurface::domain(int direction) const
{
    if (m_kind != Kind::Spline)
        return {-infinity, infinity};
    const KnotVector &kv = direction == 0 ? m_spline.u : m_spline.v;
    return {kv.front(), kv.back()};
}

Eigen::Vector4d AnalyticSurface::homogeneous(double u, double v, const Cell &cell) const
{
    Basis basis_u, basis_v;
    basis_values(m_spline.u, cell.span_u, u, basis_u.data());
    basis_values(m_spline.v, cell.span_v, v, basis_v.data());
    return combined(basis_u.data(), basis_v.data(), cell);
}

Eigen::Vector4d AnalyticSurface::combined(const double *basis_u, const double *basis_v, const Cell &cell) const
{
    const int q = m_spline.v.degree;
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (int i = 0; i <= m_spline.u.degree; ++i)
    {
        const Eigen::Vector4d *row = &m_spline.pole(cell.span_u - m_spline.u.degree + i, cell.span_v - q);
        Eigen::Vector4d along = Eigen::Vector4d::Zero();
        for (int j = 0; j <= q; ++j)
            along += basis_v[j] * row[j];
        sum += basis_u[i] * along;
    }
    return sum;
}

Eigen::Vector3d AnalyticSurface::without_weight(const Eigen::Vector4d &point) const
{
    return m_spline.rational ? Eigen::Vector3d(point.head<3>() / point.w()) : Eigen::Vector3d(point.head<3>());
}

AnalyticSurface::OnCell::OnCell(const AnalyticSurface &surface, const Cell &cell) : m_surface(surface), m_cell(cell)
{
    if (surface.m_kind != Kind::Spline)
        return;
    const TensorSpline &spline = surface.m_spline;
    m_u.reset(spline.u.knots.data() + cell.span_u, spline.u.degree);
    m_v.reset(spline.v.knots.data() + cell.span_v, spline.v.degree);
}

Eigen::Vector3d AnalyticSurface::OnCell::value(double u, double v) const
{
    if (m_surface.m_kind != Kind::Spline)
        return m_surface.value(u, v, m_cell);
    Basis basis_u, basis_v;
    m_u.values_of_degree(m_surface.m_spline.u.degree, u, basis_u.data());
    m_v.values_of_degree(m_surface.m_spline.v.degree, v, basis_v.data());
    return m_surface.without_weight(m_surface.combined(basis_u.data(), basis_v.data(), m_cell));
}

void AnalyticSurface::OnCell::lane_values(const double *u, const double *v, double *rows) const
{
    if (m_surface.m_kind != Kind::Spline)
    {
        for (int k = 0; k < lanes; ++k)
            Eigen::Map<Eigen::Vector3d, 0, Eigen::InnerStride<lanes>>(rows + k) = m_surface.value(u[k], v[k], m_cell);
        return;
    }
    using LaneBasis = std::array<double, lanes *(max_spline_degree + 1)>;
    const TensorSpline &spline = m_surface.m_spline;
    LaneBasis basis_u, basis_v;
    m_u.lane_values(spline.u.degree, u, basis_u.data());
    m_v.lane_values(spline.v.degree, v, basis_v.data());
    const Eigen::Vector4d &first = spline.pole(m_cell.span_u - spline.u.degree, m_cell.span_v - spline.v.degree);
    std::array<double, 4 * lanes> sums;
    tensor_sum(first.data(), 4 * spline.v.pole_count(), spline.u.degree, spline.v.degree, basis_u.data(),
               basis_v.data(), sums.data());
    without_weights(sums.data(), spline.rational, rows);
}

Eigen::Vector3d AnalyticSurface::value(double u, double v, const Cell &cell) const
{
    if (m_kind == Kind::Spline)
        return without_weight(homogeneous(u, v, cell));
    if (m_kind == Kind::Plane)
        return m_origin + u * m_x + v * m_y;
    const Eigen::Vector3d outwards = std::cos(u) * m_x + std::sin(u) * m_y;
    if (m_kind == Kind::Cone)
        return m_origin + (m_radius + v * m_sine) * outwards + (v * m_cosine) * m_z;
    const Eigen::Vector3d arm = m_tube * (std::cos(v) * m_a + std::sin(v) * m_b);
    return m_origin + (m_radius + arm.x()) * outwards + arm.y() * m_z.cross(outwards) + arm.z() * m_z;
}

double AnalyticSurface::speed(int direction, double v) const
{
    switch (m_kind)
    {
    case Kind::Spline: return m_speed[direction];
    case Kind::Plane: return 1.0;
    case Kind::Cone: return direction == 0 ? m_radius + std::abs(v * m_sine) : 1.0;
    case Kind::Torus: break;
    }
    return direction == 0 ? m_radius + m_tube : m_tube;
}

std::optional<int> AnalyticSurface::composed_degree(std::optional<int> u, std::optional<int> v) const
{
    if (!u || !v)
        return std::nullopt;
    switch (m_kind)
    {
    case Kind::Spline:
        if (m_spline.rational)
            return std::nullopt;
        return m_spline.u.degree * *u + m_spline.v.degree * *v;
    case Kind::Plane: return std::max(*u, *v);
    case Kind::Cone: return *u == 0 ? v : std::nullopt;
    case Kind::Torus: break;
    }
    return *u == 0 && *v == 0 ? std::optional<int>(0) : std::nullopt;
}

AnalyticSurface::Patch AnalyticSurface::patch(const Cell &cell, const Eigen::Vector3d &middle,
                                              const CurveReach &real) const
{
    Patch result;
    result.middle = middle.head<2>();
    result.half = real.total.head<2>();
    if (m_kind != Kind::Spline)
        return result;
    // Bernstein coefficients are values of the blossom, which moves no faster than the derivative's poles
    // while its arguments stay in the cell
    const Eigen::Vector3d centre = value(middle.x(), middle.y(), cell);
    double weight_reach = 0.0;
    for (int direction = 0; direction < 2; ++direction)
    {
        const KnotVector &kv = direction == 0 ? m_spline.u : m_spline.v;
        const auto span = static_cast<std::size_t>(direction == 0 ? cell.span_u : cell.span_v);
        double &half = result.half[direction];
        half = std::max(half, narrowest_patch * (kv.knots[span + 1] - kv.knots[span]));
        const LocalSpeed speed = local_speed(cell, direction, centre);
        result.longest += blossom_margin * half * speed.numerator;
        weight_reach += blossom_margin * half * speed.weight;
    }
    const double weight = m_spline.rational ? homogeneous(middle.x(), middle.y(), cell).w() : 1.0;
    result.weight_low = weight - weight_reach;
    result.weight_high = weight + weight_reach;
    return result;
}

AnalyticSurface::LocalSpeed AnalyticSurface::local_speed(const Cell &cell, int direction,
                                                         const Eigen::Vector3d &centre) const
{
    const KnotVector &along = direction == 0 ? m_spline.u : m_spline.v;
    const int lines = (direction == 0 ? m_spline.v : m_spline.u).degree;
    const int first_u = cell.span_u - m_spline.u.degree;
    const int first_v = cell.span_v - m_spline.v.degree;
    const int span = direction == 0 ? cell.span_u : cell.span_v;
    LocalSpeed speed;
    for (int i = 1; i <= along.degree; ++i)
    {
        const int pole = span - along.degree + i;
        const double factor = along.degree / (along.knots[static_cast<std::size_t>(pole + along.degree)] -
                                              along.knots[static_cast<std::size_t>(pole)]);
        for (int line = 0; line <= lines; ++line)
        {
            const int a = first_u + (direction == 0 ? i : line);
            const int b = first_v + (direction == 0 ? line : i);
            const Eigen::Vector4d step =
                m_spline.pole(a, b) - (direction == 0 ? m_spline.pole(a - 1, b) : m_spline.pole(a, b - 1));
            speed.numerator = std::max(speed.numerator, factor * (step.head<3>() - step.w() * centre).norm());
            speed.weight = std::max(speed.weight, factor * std::abs(step.w()));
        }
    }
    return speed;
}

double AnalyticSurface::growth(const Patch &patch, const CurveReach &reach) const
{
    // |cos z|^2 + |sin z|^2 = cosh(2 Im z), so e(u) is no longer than exp |Im u|, and a turn by u stretches no more
    const Eigen::Vector3d &d = reach.total;
    switch (m_kind)
    {
    case Kind::Spline: return spline_growth(patch, reach);
    case Kind::Plane: return d.x() + d.y();
    case Kind::Cone:
    {
        const double radius = std::abs(m_radius + patch.middle.y() * m_sine);
        return radius + (radius + std::abs(m_sine) * d.y()) * std::exp(d.x()) + std::abs(m_cosine) * d.y();
    }
    case Kind::Torus: break;
    }
    const double tube = m_tube * std::exp(d.y());
    return m_radius + 2.0 * m_tube + (m_radius + tube) * std::exp(d.x()) + tube;
}

//! Bernstein polynomials of degree p over [0, 1] sum up to (|s| + |1 - s|)^p at most in absolute value. That
//! is 1 + 2 D at a distance D from the middle, and no more than the stretch inside the ellipse about the
//! interval, plus twice the distance from there.
double AnalyticSurface::spline_growth(const Patch &patch, const CurveReach &reach) const
{
    double factor = 1.0;
    for (int direction = 0; direction < 2; ++direction)
    {
        const double off_chord = reach.total[direction] - reach.stretch * reach.chord[direction];
        const double sum = std::min(1.0 + reach.total[direction] / patch.half[direction],
                                    reach.stretch + off_chord / patch.half[direction]);
        factor *= std::pow(sum, (direction == 0 ? m_spline.u : m_spline.v).degree);
    }
    if (!m_spline.rational)
        return factor * patch.longest;
    const double weight =
        0.5 * (patch.weight_low + patch.weight_high) - 0.5 * factor * (patch.weight_high - patch.weight_low);
    return weight > 0.0 ? factor * patch.longest / weight : infinity;
}

double AnalyticSurface::rounding(double v) const
{
    const double weights = m_kind == Kind::Spline && m_spline.rational ? 4.0 : 1.0;
    return operations * epsilon * weights * (m_size + (m_kind == Kind::Spline ? 0.0 : std::abs(v)));
}

} // namespace laminate_offset
