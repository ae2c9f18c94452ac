// SPDX-License-Identifier: LGPL-2.1-or-later
#include "control_points.h"

#include "geom_values.h"

#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2dConvert.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Precision.hxx>

#include <algorithm>
#include <array>

namespace laminate_offset
{

ControlPoints weighted_poles(const Geom2d_BSplineCurve &curve)
{
    ControlPoints poles;
    poles.reserve(static_cast<std::size_t>(curve.NbPoles()));
    for (int i = 1; i <= curve.NbPoles(); ++i)
        poles.push_back(curve.Weight(i) * Eigen::Vector3d(curve.Pole(i).X(), curve.Pole(i).Y(), 1.0));
    return poles;
}

ControlPoints span_points(const KnotVector &kv, const ControlPoints &poles, int span)
{
    const int p = kv.degree;
    const double *t = kv.knots.data() + span;
    // one level of de Boor's algorithm at x, in place
    const auto level = [&](Eigen::Vector3d *points, int r, double x) {
        for (int k = p; k >= r; --k)
        {
            const double s = (x - t[k - p]) / (t[k + 1 - r] - t[k - p]);
            points[k] = (1.0 - s) * points[k - 1] + s * points[k];
        }
    };
    std::array<Eigen::Vector3d, max_spline_degree + 1> at_start;
    std::array<Eigen::Vector3d, max_spline_degree + 1> points;
    std::copy_n(poles.begin() + (span - p), p + 1, at_start.begin());
    ControlPoints result(static_cast<std::size_t>(p) + 1);
    // point i is the blossom of the start, p - i times, and of the end, i times: all share their levels at the start
    for (int i = p; i >= 0; --i)
    {
        points = at_start;
        for (int r = p - i + 1; r <= p; ++r)
            level(points.data(), r, t[1]);
        result[static_cast<std::size_t>(i)] = points[static_cast<std::size_t>(p)];
        if (i > 0)
            level(at_start.data(), p - i + 1, t[0]);
    }
    return result;
}

ControlPoints cut_off(ControlPoints &points, double s)
{
    ControlPoints before;
    before.reserve(points.size());
    before.push_back(points.front());
    for (std::size_t count = points.size() - 1; count > 0; --count)
    {
        for (std::size_t k = 0; k < count; ++k)
            points[k] = (1.0 - s) * points[k] + s * points[k + 1];
        before.push_back(points.front());
    }
    return before;
}

std::vector<std::vector<ControlPoints>> pieces_between(const Geom2d_BSplineCurve &curve,
                                                       const std::vector<double> &ends)
{
    const KnotVector kv = knots_of(curve);
    const ControlPoints poles = weighted_poles(curve);
    std::vector<std::vector<ControlPoints>> pieces(ends.size() - 1);
    std::size_t piece = 0;
    for (int span = kv.span(ends.front()); span <= kv.span(ends.back()); ++span)
    {
        double low = kv.knots[static_cast<std::size_t>(span)];
        const double high = kv.knots[static_cast<std::size_t>(span) + 1];
        if (!(low < high) || !(low < ends.back()))
            continue;
        ControlPoints rest = span_points(kv, poles, span);
        if (low < ends.front())
        {
            cut_off(rest, (ends.front() - low) / (high - low));
            low = ends.front();
        }
        for (; piece + 1 < pieces.size() && ends[piece + 1] < high; ++piece)
        {
            pieces[piece].push_back(cut_off(rest, (ends[piece + 1] - low) / (high - low)));
            low = ends[piece + 1];
        }
        if (ends.back() < high)
            rest = cut_off(rest, (ends.back() - low) / (high - low));
        pieces[piece].push_back(std::move(rest));
        if (piece + 1 < pieces.size() && ends[piece + 1] == high)
            ++piece;
    }
    return pieces;
}

namespace
{

std::vector<ControlPoints> converted(const Handle(Geom2d_Curve) & curve, double first, double last)
{
    try
    {
        const Handle(Geom2d_BSplineCurve) spline =
            Geom2dConvert::CurveToBSplineCurve(new Geom2d_TrimmedCurve(curve, first, last));
        return pieces_between(*spline, {spline->FirstParameter(), spline->LastParameter()}).front();
    }
    catch (const Standard_Failure &) // a range that OpenCASCADE takes for empty
    {
        return {};
    }
}

} // namespace

std::vector<ControlPoints> bezier_pieces(const Handle(Geom2d_Curve) & curve, double first, double last)
{
    const Geom2dAdaptor_Curve adaptor(curve, first, last);
    const GeomAbs_CurveType type = adaptor.GetType();
    if (type == GeomAbs_OffsetCurve || type == GeomAbs_OtherCurve)
        return {};
    if (type == GeomAbs_Line)
    {
        const gp_Pnt2d a = adaptor.Value(first);
        const gp_Pnt2d b = adaptor.Value(last);
        return {{Eigen::Vector3d(a.X(), a.Y(), 1.0), Eigen::Vector3d(b.X(), b.Y(), 1.0)}};
    }
    if (!curve->IsPeriodic())
    {
        if (first < curve->FirstParameter() - Precision::PConfusion() ||
            last > curve->LastParameter() + Precision::PConfusion())
            return {};
        first = std::max(first, curve->FirstParameter());
        last = std::min(last, curve->LastParameter());
    }
    if (type == GeomAbs_BSplineCurve && !adaptor.BSpline()->IsPeriodic())
        return pieces_between(*adaptor.BSpline(), {first, last}).front();
    return converted(curve, first, last);
}

bool positive_weights(const std::vector<ControlPoints> &pieces)
{
    return std::all_of(pieces.begin(), pieces.end(), [](const ControlPoints &piece) {
        return std::all_of(piece.begin(), piece.end(), [](const Eigen::Vector3d &p) { return p.z() > 0.0; });
    });
}

} // namespace laminate_offset
