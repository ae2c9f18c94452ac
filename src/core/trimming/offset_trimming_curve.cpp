// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_trimming_curve.h"

#include "curve_breaks.h"
#include "edge_certificate.h"
#include "knot_removal.h"
#include "mapped_pcurve.h"
#include "offset_curve_certificate.h"
#include "space_curve.h"

#include <Eigen/Geometry>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Plane.hxx>
#include <gp.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace laminate_offset
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int most_rounds = 14;
constexpr int most_parts_of_piece = 500;
constexpr int most_poles = 20000;
constexpr int checks_per_span = 5;
constexpr int checks_without_proof = 24;
// A pcurve that is no polynomial is replaced by one so near to it, as a part of the surface's range.
constexpr double pcurve_accuracy = 1e-12;

Eigen::Vector3d vector(const gp_Vec &v) { return {v.X(), v.Y(), v.Z()}; }

class OffsetCurveMaker
{
public:
    OffsetCurveMaker(const OffsetCurveBase &base, const OffsetCurveOptions &options)
        : m_base(base), m_options(options), m_c(base.target.on_surface())
    {
    }

    std::optional<EdgeCurve> run(double tolerance)
    {
        const std::optional<EdgeCurve> space = space_curve(m_base.target, tolerance);
        if (!space)
            return std::nullopt;
        find_breaks();
        prepare_pieces(space->curve);
        m_origin = m_base.target.value(0.5 * (m_c.first + m_c.last));
        double share = 1.0;
        double finer = 1.0;
        for (int round = 0; round < most_rounds; ++round)
        {
            const double accuracy = share * m_options.interpolation_share * tolerance;
            const std::optional<CurvePoles> full = interpolant(finer * accuracy);
            if (!full)
                return std::nullopt;
            if (const double seen = largest_seen(*full, checks_per_span); !(seen <= accuracy))
            {
                if (!std::isfinite(seen))
                    return std::nullopt;
                finer *= std::clamp(0.7 * accuracy / seen, 1e-3, 0.7);
                continue;
            }
            const double removal = share * (1.0 - m_options.interpolation_share) * tolerance;
            const EdgeCurve light = judged(without_needless_knots(*full, removal), tolerance);
            if (light.deviation.bound <= tolerance)
                return light;
            if (!std::isfinite(light.deviation.bound))
                return std::nullopt;
            share *= std::clamp(0.8 * tolerance / light.deviation.bound, 0.1, 0.8);
        }
        return std::nullopt;
    }

private:
    struct Piece
    {
        double a = 0.0;
        double b = 0.0;
        double bend = 0.0; //!< |second derivative of the offset| times the square of the length [mm]
    };

    //! The normal of a C^k base is C^(k-1).
    void find_breaks()
    {
        const TensorSpline *spline = m_base.target.spline();
        KnotVector u;
        KnotVector v;
        if (spline)
        {
            u = {spline->u.degree - 1, spline->u.knots};
            v = {spline->v.degree - 1, spline->v.knots};
        }
        m_breaks = curve_breaks(
            m_c, [&](double t) { return m_base.target.uv(t); }, spline ? &u : nullptr, spline ? &v : nullptr);
    }

    [[nodiscard]] std::optional<Eigen::Vector3d> exact(double t) const
    {
        const Eigen::Vector2d uv = m_base.target.uv(t);
        std::optional<gp_Pnt2d> singular;
        const auto points = m_base.surface.offset_grid({uv.x()}, {uv.y()}, m_base.distance, singular);
        return singular ? std::nullopt : std::optional(points.front());
    }

    //! The Bezier pieces of the space curve, cut at the breaks, with the second derivative's bound.
    void prepare_pieces(const Handle(Geom_Curve) & space)
    {
        std::vector<double> ends{m_c.first, m_c.last};
        for (const DataBreak &b : m_breaks)
            ends.push_back(b.parameter);
        if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(space))
            for (int i = 1; i <= spline->NbKnots(); ++i)
                if (spline->Knot(i) > m_c.first && spline->Knot(i) < m_c.last)
                    ends.push_back(spline->Knot(i));
        std::sort(ends.begin(), ends.end());
        const double same = 1e-7 * (m_c.last - m_c.first);
        std::vector<double> kept;
        for (const double t : ends) // a break moves a knot beside it, never the other way round
            if (kept.empty() || t - kept.back() > same)
                kept.push_back(t);
            else if (is_break(t) || t == m_c.last)
                kept.back() = kept.size() == 1 ? kept.back() : t;
        const int samples = 2 * (m_options.degree + 1);
        for (std::size_t i = 0; i + 1 < kept.size(); ++i)
        {
            Piece piece{kept[i], kept[i + 1], 0.0};
            const double length = piece.b - piece.a;
            for (int k = 0; k < samples; ++k)
            {
                const double t = piece.a + length * (k + 0.5) / samples;
                piece.bend = std::max(piece.bend, second_derivative(space, t) * length * length);
            }
            m_pieces.push_back(piece);
        }
    }

    [[nodiscard]] bool is_break(double t) const
    {
        return std::any_of(m_breaks.begin(), m_breaks.end(), [&](const DataBreak &b) { return b.parameter == t; });
    }

    //! |C'' + d (n)''| with n = N x t, where N = t x n (eq. 3.11) is kept: the plane of the curve does not turn.
    [[nodiscard]] double second_derivative(const Handle(Geom_Curve) & space, double t) const
    {
        gp_Pnt point;
        gp_Vec first;
        gp_Vec second;
        gp_Vec third;
        space->D3(t, point, first, second, third);
        const double speed = first.Magnitude();
        const Eigen::Vector2d uv = m_base.target.uv(t);
        const SurfaceJet jet = m_base.surface.jets({uv.x()}, {uv.y()}, 1).front();
        const std::optional<Eigen::Vector3d> normal = m_base.surface.unit_normal(jet, uv.x(), uv.y());
        if (!(speed > 0.0) || !normal)
            return 0.0;
        const Eigen::Vector3d tangent = vector(first) / speed;
        const Eigen::Vector3d c2 = vector(second);
        const double rate = tangent.dot(c2);
        const Eigen::Vector3d turn = (c2 - rate * tangent) / speed;
        const double acceleration = turn.dot(c2) + tangent.dot(vector(third));
        const Eigen::Vector3d turn_rate = (vector(third) - acceleration * tangent - 2.0 * rate * turn) / speed;
        const Eigen::Vector3d plane = tangent.cross(*normal);
        return (c2 + m_base.distance * plane.cross(turn_rate)).norm();
    }

    //! Interpolates samples of the exact offset, their number by eq. 3.10.
    [[nodiscard]] std::optional<CurvePoles> interpolant(double accuracy) const
    {
        const double exponent = m_options.exponent > 0.0 ? m_options.exponent : 1.0 / (m_options.degree + 1.0);
        std::vector<double> interior;
        for (std::size_t i = 0; i < m_pieces.size(); ++i)
        {
            const Piece &piece = m_pieces[i];
            const double wanted = std::ceil(std::pow(piece.bend / (8.0 * accuracy), exponent)); // (3.10)
            const int parts = static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(most_parts_of_piece)));
            for (int k = 1; k < parts; ++k)
                interior.push_back(piece.a + (piece.b - piece.a) * k / parts);
            if (i + 1 < m_pieces.size())
                interior.insert(interior.end(), static_cast<std::size_t>(multiplicity(piece.b)), piece.b);
        }
        if (interior.size() > most_poles)
            return std::nullopt;
        const KnotVector kv = clamped_knots(m_options.degree, m_c.first, m_c.last, interior);
        std::vector<double> parameters = kv.pole_parameters();
        parameters.front() = kv.front();
        parameters.back() = kv.back();
        RowMatrix samples(static_cast<Eigen::Index>(parameters.size()), 3);
        for (std::size_t i = 0; i < parameters.size(); ++i)
        {
            const std::optional<Eigen::Vector3d> point = exact(parameters[i]);
            if (!point)
                return std::nullopt;
            samples.row(static_cast<Eigen::Index>(i)) = (*point - m_origin).transpose();
        }
        const auto fit = LeastSquaresFit::make(kv, parameters);
        return fit ? std::optional(CurvePoles{kv, fit->solve(samples)}) : std::nullopt;
    }

    //! Of a knot at the end of a piece.
    [[nodiscard]] int multiplicity(double t) const
    {
        for (const DataBreak &b : m_breaks)
            if (b.parameter == t)
                return m_options.degree - std::clamp(b.continuity, 0, m_options.degree - 1);
        return 1;
    }

    [[nodiscard]] double largest_seen(const CurvePoles &curve, int checks) const
    {
        const Handle(Geom_Curve) made = spline_curve(curve.knots, curve.poles, m_origin);
        double worst = 0.0;
        const std::vector<double> ends = curve.knots.breaks();
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
            for (int k = 0; k < checks; ++k)
            {
                const double t = ends[i] + (ends[i + 1] - ends[i]) * (k + 0.5) / checks;
                const std::optional<Eigen::Vector3d> point = exact(t);
                if (!point)
                    return infinity;
                const gp_Pnt p = made->Value(t);
                worst = std::max(worst, (*point - Eigen::Vector3d(p.X(), p.Y(), p.Z())).norm());
            }
        return worst;
    }

    [[nodiscard]] EdgeCurve judged(const CurvePoles &curve, double tolerance) const
    {
        EdgeCurve result;
        result.curve = spline_curve(curve.knots, curve.poles, m_origin);
        result.deviation = offset_deviation(m_base, result.curve, tolerance);
        if (!result.deviation.proven)
            result.deviation.bound = largest_seen(curve, checks_without_proof);
        return result;
    }

    const OffsetCurveBase &m_base;
    const OffsetCurveOptions &m_options;
    const CurveOnSurface &m_c;
    Eigen::Vector3d m_origin = Eigen::Vector3d::Zero();
    std::vector<DataBreak> m_breaks;
    std::vector<Piece> m_pieces;
};

//! A polynomial pcurve, proven to be near the one that is meant.
struct NearPcurve
{
    AnalyticCurve curve;
    double slack = 0.0;
};

std::optional<NearPcurve> near_pcurve(const CurveOnSurface &c, const TensorSpline &surface)
{
    std::optional<AnalyticCurve> exact = AnalyticCurve::make(c.pcurve, c.first, c.last);
    if (!exact)
        return std::nullopt;
    if (is_polynomial(c))
        return NearPcurve{*std::move(exact), 0.0};
    const double range = std::max(surface.u.back() - surface.u.front(), surface.v.back() - surface.v.front());
    const double accuracy = pcurve_accuracy * range;
    const Handle(Geom2d_Curve) near = polynomial_pcurve(c, accuracy);
    const std::optional<AnalyticCurve> polynomial =
        near.IsNull() ? std::nullopt : AnalyticCurve::make(near, c.first, c.last);
    const auto plane = AnalyticSurface::make(new Geom_Plane(gp::XOY()));
    if (!polynomial || !plane)
        return std::nullopt;
    const double slack = proven_deviation({*plane, *exact, *polynomial, c.first, c.last, accuracy});
    return std::isfinite(slack) ? std::optional(NearPcurve{*polynomial, slack}) : std::nullopt;
}

} // namespace

Deviation offset_deviation(const OffsetCurveBase &base, const Handle(Geom_Curve) & curve, double target)
{
    const CurveOnSurface &c = base.target.on_surface();
    const AnalyticSurface *form = base.target.form();
    const std::optional<AnalyticCurve> made = AnalyticCurve::make(curve, c.first, c.last);
    const std::optional<NearPcurve> pcurve = form && form->spline() ? near_pcurve(c, *form->spline()) : std::nullopt;
    if (!pcurve || !made)
        return {infinity, false};
    const double of_model = base.surface.model_error().of_offset(base.distance);
    const double bound = proven_offset_deviation(
        {*form, pcurve->curve, *made, c.first, c.last, base.distance, pcurve->slack, target - of_model});
    return {bound + of_model, std::isfinite(bound)};
}

std::optional<EdgeCurve> offset_trimming_curve(const OffsetCurveBase &base, double tolerance,
                                               const OffsetCurveOptions &options)
{
    return OffsetCurveMaker(base, options).run(tolerance);
}

} // namespace laminate_offset
