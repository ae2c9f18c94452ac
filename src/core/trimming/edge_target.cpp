// SPDX-License-Identifier: LGPL-2.1-or-later
#include "edge_target.h"

#include "edge_certificate.h"

#include "../spline/geom_values.h"
#include "../spline/vector_kernels.h"

#include <Geom2dAdaptor_Curve.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineCurve.hxx>

#include <algorithm>
#include <array>
#include <cmath>

namespace laminate_offset
{
namespace
{

constexpr int checks_per_interval = 24;
constexpr int least_checks = 200;

} // namespace

gp_Pnt CurveOnSurface::value(double t) const
{
    const gp_Pnt2d uv = pcurve->Value(t);
    return surface->Value(uv.X(), uv.Y());
}

double largest_distance(const Handle(Geom_Curve) & curve, const CurveOnSurface &on_surface)
{
    std::vector<double> ends{on_surface.first};
    if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve))
        for (int i = 1; i <= spline->NbKnots(); ++i)
            if (spline->Knot(i) > on_surface.first && spline->Knot(i) < on_surface.last)
                ends.push_back(spline->Knot(i));
    ends.push_back(on_surface.last);
    const GeomAdaptor_Curve in_space(curve);
    const Geom2dAdaptor_Curve pcurve(on_surface.pcurve);
    const GeomAdaptor_Surface surface(on_surface.surface);
    const auto square_at = [&](double t) {
        const gp_Pnt2d uv = pcurve.Value(t);
        return in_space.Value(t).SquareDistance(surface.Value(uv.X(), uv.Y()));
    };
    double worst = square_at(ends.front());
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    {
        // short intervals are looked at as closely as long ones: the error has its own peaks in each
        const double part = (ends[i + 1] - ends[i]) / (on_surface.last - on_surface.first);
        const int checks = std::max(checks_per_interval, static_cast<int>(std::ceil(least_checks * part)));
        for (int k = 1; k <= checks; ++k)
        {
            const double t = ends[i] + (ends[i + 1] - ends[i]) * k / checks;
            worst = std::max(worst, square_at(t));
        }
    }
    return std::sqrt(worst);
}

EdgeTarget::EdgeTarget(const CurveOnSurface &on_surface, const AnalyticSurface *form)
    : m_on_surface(on_surface), m_form(form),
      m_pcurve(AnalyticCurve::make(on_surface.pcurve, on_surface.first, on_surface.last))
{
}

const TensorSpline *EdgeTarget::spline() const { return m_form ? m_form->spline() : nullptr; }

Eigen::Vector2d EdgeTarget::uv(double t) const
{
    if (m_pcurve)
        return m_pcurve->value(t).head<2>();
    const gp_Pnt2d uv = m_on_surface.pcurve->Value(t);
    return {uv.X(), uv.Y()};
}

Eigen::Vector3d EdgeTarget::value(double t) const
{
    const Eigen::Vector2d at = uv(t);
    if (m_form)
        return m_form->value(at.x(), at.y(), m_form->cell_at(at.x(), at.y()));
    const gp_Pnt p = m_on_surface.surface->Value(at.x(), at.y());
    return {p.X(), p.Y(), p.Z()};
}

void EdgeTarget::add_values(const CurvePiece &piece, const double *parameters, RowMatrix &rows, Eigen::Index first,
                            Eigen::Index last) const
{
    using Rows = Eigen::Array<double, lanes, 3>;
    Rows uv, points;
    std::array<double, lanes> t;
    std::optional<AnalyticSurface::OnCell> surface;
    AnalyticSurface::Cell cell;
    for (Eigen::Index from = first; from < last; from += lanes)
    {
        const auto count = std::min<Eigen::Index>(lanes, last - from);
        for (Eigen::Index k = 0; k < lanes; ++k)
            t[static_cast<std::size_t>(k)] = parameters[from + std::min(k, count - 1)];
        piece.lane_values(t.data(), uv.data());
        for (Eigen::Index k = 0; k < count;)
        {
            const AnalyticSurface::Cell here = m_form->cell_at(uv(k, 0), uv(k, 1));
            if (!surface || here != cell)
                surface.emplace(*m_form, cell = here);
            surface->lane_values(uv.data(), uv.data() + lanes, points.data());
            do
                rows.row(from + k) += points.row(k).matrix();
            while (++k < count && m_form->cell_at(uv(k, 0), uv(k, 1)) == cell);
        }
    }
}

RowMatrix EdgeTarget::values(const std::vector<double> &parameters, const Eigen::Vector3d &origin) const
{
    const auto count = static_cast<Eigen::Index>(parameters.size());
    RowMatrix rows = (-origin).transpose().replicate(count, 1);
    if (!m_form || !m_pcurve)
    {
        for (Eigen::Index i = 0; i < count; ++i)
            rows.row(i) += value(parameters[static_cast<std::size_t>(i)]).transpose();
        return rows;
    }
    const std::vector<double> ends = analytic_ends(*m_pcurve, m_on_surface.first, m_on_surface.last);
    Eigen::Index first = 0;
    for (std::size_t i = 1; i < ends.size(); ++i)
    {
        const bool rest = i + 1 == ends.size();
        const auto behind = std::upper_bound(parameters.begin() + first, parameters.end(), ends[i]);
        const Eigen::Index last = rest ? count : behind - parameters.begin();
        if (last > first)
            add_values(CurvePiece(*m_pcurve, ends[i - 1], ends[i]), parameters.data(), rows, first, last);
        first = last;
    }
    return rows;
}

std::optional<double> EdgeTarget::proven(const std::optional<AnalyticCurve> &curve, double target) const
{
    if (!curve || !m_form || !m_pcurve)
        return std::nullopt;
    const double bound = proven_deviation({*m_form, *m_pcurve, *curve, m_on_surface.first, m_on_surface.last, target});
    return std::isfinite(bound) ? std::optional<double>(bound) : std::nullopt;
}

Deviation EdgeTarget::deviation(const Handle(Geom_Curve) & curve, double target) const
{
    const auto bound = proven(AnalyticCurve::make(curve, m_on_surface.first, m_on_surface.last), target);
    return bound ? Deviation{*bound, true} : Deviation{largest_distance(curve, m_on_surface), false};
}

Deviation EdgeTarget::deviation(const gp_Pnt &point, double target) const
{
    const Eigen::Vector3d place(point.X(), point.Y(), point.Z());
    if (const auto bound = proven(AnalyticCurve::point(place), target))
        return {*bound, true};
    double widest = 0.0;
    for (int i = 0; i <= least_checks; ++i)
    {
        const double t = m_on_surface.first + (m_on_surface.last - m_on_surface.first) * i / least_checks;
        widest = std::max(widest, (value(t) - place).norm());
    }
    return {widest, false};
}

} // namespace laminate_offset
