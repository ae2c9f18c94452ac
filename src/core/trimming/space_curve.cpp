// SPDX-License-Identifier: LGPL-2.1-or-later
#include "space_curve.h"

#include "curve_breaks.h"
#include "knot_removal.h"

#include <Geom_BSplineCurve.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace laminate_offset
{
namespace
{

constexpr int cubic = 3;
constexpr int deepest = 24;
constexpr int most_pieces = 20000;
constexpr int samples_of_paper = 4;
// A derivative from one side of a break is taken so near to it, as a part of the interval.
constexpr double beside_break = 1e-9;

//! A Hermite piece [a, b] with its control points (eq. 3.13).
struct Piece
{
    double a = 0.0;
    double b = 0.0;
    Eigen::Matrix<double, 4, 3, Eigen::RowMajor> points;
};

class HermiteFitter
{
public:
    HermiteFitter(const EdgeTarget &target, double tolerance, PieceCheck check)
        : m_target(target), m_tolerance(tolerance), m_check(check),
          m_origin(target.value(0.5 * (target.on_surface().first + target.on_surface().last)))
    {
    }

    //! The pieces joined to one cubic with two knots where they join, three at a break.
    std::optional<CurvePoles> run()
    {
        const CurveOnSurface &c = m_target.on_surface();
        const TensorSpline *spline = m_target.spline();
        const std::vector<DataBreak> breaks = curve_breaks(
            c, [&](double t) { return m_target.uv(t); }, spline ? &spline->u : nullptr, spline ? &spline->v : nullptr);
        std::vector<double> ends{c.first};
        for (const DataBreak &b : breaks)
            if (b.continuity < 1)
                ends.push_back(b.parameter);
        ends.push_back(c.last);
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
            if (!fit_interval(ends[i], ends[i + 1], breaks))
                return std::nullopt;
        return joined(ends);
    }

    [[nodiscard]] const Eigen::Vector3d &origin() const { return m_origin; }

private:
    //! The knot intervals of one part without kinks, each halved as needed.
    bool fit_interval(double a, double b, const std::vector<DataBreak> &breaks)
    {
        m_low = a;
        m_high = b;
        std::vector<double> ends{a};
        for (const DataBreak &inner : breaks)
            if (inner.parameter > a && inner.parameter < b)
                ends.push_back(inner.parameter);
        ends.push_back(b);
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
            if (!fit(ends[i], ends[i + 1], 0))
                return false;
        return true;
    }

    bool fit(double a, double b, int depth)
    {
        const Piece piece = hermite(a, b);
        if (near_enough(piece))
        {
            m_pieces.push_back(piece);
            return true;
        }
        const double middle = 0.5 * (a + b);
        return depth < deepest && m_pieces.size() < most_pieces && fit(a, middle, depth + 1) &&
               fit(middle, b, depth + 1);
    }

    //! D = S_u u' + S_v v' (eq. 3.12), from inside the part.
    [[nodiscard]] Eigen::Vector3d derivative(double t) const
    {
        const double inside = beside_break * (m_high - m_low);
        const double at = std::clamp(t, m_low + inside, m_high - inside);
        const CurveOnSurface &c = m_target.on_surface();
        gp_Pnt2d uv;
        gp_Vec2d rate;
        c.pcurve->D1(at, uv, rate);
        gp_Pnt p;
        gp_Vec su;
        gp_Vec sv;
        c.surface->D1(uv.X(), uv.Y(), p, su, sv);
        const gp_Vec d = rate.X() * su + rate.Y() * sv;
        return {d.X(), d.Y(), d.Z()};
    }

    [[nodiscard]] Piece hermite(double a, double b) const
    {
        const Eigen::Vector3d start = m_target.value(a) - m_origin;
        const Eigen::Vector3d end = m_target.value(b) - m_origin;
        Piece piece{a, b, {}};
        piece.points.row(0) = start.transpose();                                     // (3.13a)
        piece.points.row(1) = (start + (b - a) / cubic * derivative(a)).transpose(); // (3.13b)
        piece.points.row(2) = (end - (b - a) / cubic * derivative(b)).transpose();   // (3.13c)
        piece.points.row(3) = end.transpose();                                       // (3.13d)
        return piece;
    }

    [[nodiscard]] bool near_enough(const Piece &piece) const
    {
        const Handle(Geom_Curve) curve =
            spline_curve(clamped_knots(cubic, piece.a, piece.b, {}), RowMatrix(piece.points), m_origin);
        double seen = 0.0;
        for (int k = 1; k <= samples_of_paper; ++k)
        {
            const double t = piece.a + (piece.b - piece.a) * k / (samples_of_paper + 1);
            const gp_Pnt p = curve->Value(t);
            seen = std::max(seen, (Eigen::Vector3d(p.X(), p.Y(), p.Z()) - m_target.value(t)).norm());
        }
        if (!(seen <= m_tolerance) || m_check == PieceCheck::FourSamples)
            return seen <= m_tolerance;
        const CurveOnSurface &c = m_target.on_surface();
        const EdgeTarget part({c.surface, c.pcurve, piece.a, piece.b}, m_target.form());
        return part.deviation(curve, m_tolerance).bound <= m_tolerance;
    }

    [[nodiscard]] CurvePoles joined(const std::vector<double> &kinks) const
    {
        std::vector<double> interior;
        std::vector<Eigen::Vector3d> poles{m_pieces.front().points.row(0).transpose()};
        for (std::size_t i = 0; i < m_pieces.size(); ++i)
        {
            const Piece &piece = m_pieces[i];
            poles.emplace_back(piece.points.row(1).transpose());
            poles.emplace_back(piece.points.row(2).transpose());
            if (i + 1 == m_pieces.size())
                break;
            const bool kink = std::binary_search(kinks.begin(), kinks.end(), piece.b);
            interior.insert(interior.end(), kink ? 3 : 2, piece.b);
            if (kink)
                poles.emplace_back(piece.points.row(3).transpose());
        }
        poles.emplace_back(m_pieces.back().points.row(3).transpose());
        CurvePoles curve{clamped_knots(cubic, m_pieces.front().a, m_pieces.back().b, interior),
                         RowMatrix(static_cast<Eigen::Index>(poles.size()), 3)};
        for (std::size_t i = 0; i < poles.size(); ++i)
            curve.poles.row(static_cast<Eigen::Index>(i)) = poles[i].transpose();
        return curve;
    }

    const EdgeTarget &m_target;
    double m_tolerance;
    PieceCheck m_check;
    Eigen::Vector3d m_origin;
    double m_low = 0.0;
    double m_high = 0.0;
    std::vector<Piece> m_pieces;
};

} // namespace

std::optional<EdgeCurve> space_curve(const EdgeTarget &target, double tolerance, const SpaceCurveOptions &options)
{
    if (std::optional<EdgeCurve> exact = exact_curve(target, tolerance))
        return exact;
    HermiteFitter fitter(target, options.piece_share * tolerance, options.check);
    const std::optional<CurvePoles> pieces = fitter.run();
    if (!pieces)
        return std::nullopt;
    const auto made = [&](const CurvePoles &curve) {
        EdgeCurve result;
        result.curve = spline_curve(curve.knots, curve.poles, fitter.origin());
        result.deviation = target.deviation(result.curve, tolerance);
        return result;
    };
    const EdgeCurve light = made(without_needless_knots(*pieces, (1.0 - options.piece_share) * tolerance));
    if (light.deviation.bound <= tolerance || options.check == PieceCheck::FourSamples)
        return light;
    const EdgeCurve full = made(*pieces);
    return full.deviation.bound <= tolerance ? std::optional(full) : std::nullopt;
}

} // namespace laminate_offset
