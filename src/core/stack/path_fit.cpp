// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path_fit.h"

#include "../projection/image_wire.h"
#include "../spline/knot_choice.h"
#include "../spline/least_squares.h"

#include <Geom2d_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>

#include <algorithm>
#include <vector>

namespace laminate_offset
{
namespace
{

constexpr int degree = 3;
constexpr int samples_per_span = 5;
constexpr int checks_per_span = 3;
constexpr int most_spans = 256;

Handle(Geom2d_BSplineCurve) pcurve_on(const KnotVector &kv, const PathPart &part)
{
    const std::vector<double> parameters = chebyshev_parameters(kv.breaks(), samples_per_span);
    const auto solver = LeastSquaresFit::make(kv, parameters);
    if (!solver)
        return {};
    RowMatrix rows = RowMatrix::Zero(static_cast<Eigen::Index>(parameters.size()), 3);
    for (std::size_t i = 0; i < parameters.size(); ++i)
        rows.row(static_cast<Eigen::Index>(i)).head<2>() = part.at(parameters[i]).transpose();
    const RowMatrix net = solver->solve(rows);
    TColgp_Array1OfPnt2d poles(1, kv.pole_count());
    for (int i = 0; i < kv.pole_count(); ++i)
        poles(i + 1) = gp_Pnt2d(net(i, 0), net(i, 1));
    const std::vector<Knot> distinct = kv.distinct();
    TColStd_Array1OfReal knots(1, static_cast<int>(distinct.size()));
    TColStd_Array1OfInteger multiplicities(1, static_cast<int>(distinct.size()));
    for (std::size_t i = 0; i < distinct.size(); ++i)
    {
        knots(static_cast<int>(i) + 1) = distinct[i].parameter;
        multiplicities(static_cast<int>(i) + 1) = distinct[i].multiplicity;
    }
    return new Geom2d_BSplineCurve(poles, knots, multiplicities, kv.degree);
}

//! The largest error seen between a pcurve and the part that it stands for [mm].
double deviation(const GeodesicWalker &walker, const Geom2d_BSplineCurve &pcurve, const KnotVector &kv,
                 const PathPart &part)
{
    double worst = 0.0;
    for (const double t : span_parameters(kv, kv.breaks(), checks_per_span * samples_per_span + 1, 1))
    {
        const gp_Pnt2d p = pcurve.Value(t);
        worst = std::max(worst, (walker.point({p.X(), p.Y()}) - walker.point(part.at(t))).norm());
    }
    return worst;
}

} // namespace

std::optional<ImagePiece> fitted_piece(const GeodesicWalker &walker, const PathPart &part, double tolerance)
{
    for (int spans = 1; spans <= most_spans; spans *= 2)
    {
        std::vector<double> interior;
        for (int i = 1; i < spans; ++i)
            interior.push_back(static_cast<double>(i) / spans);
        const KnotVector kv = clamped_knots(degree, 0.0, 1.0, interior);
        const Handle(Geom2d_BSplineCurve) pcurve = pcurve_on(kv, part);
        const double seen = pcurve.IsNull() ? 2.0 * tolerance : deviation(walker, *pcurve, kv, part);
        if (!(seen <= 0.5 * tolerance))
            continue;
        const auto form = AnalyticSurface::make(walker.surface());
        const EdgeTarget target({walker.surface(), Handle(Geom2d_Curve)(pcurve), 0.0, 1.0}, form ? &*form : nullptr);
        const std::optional<EdgeCurve> curve = edge_curve(target, 0.5 * tolerance);
        if (!curve)
            break;
        return ImagePiece{
            Handle(Geom2d_Curve)(pcurve), curve->curve, 0.0, 1.0, curve->deviation, false, seen, std::nullopt, false};
    }
    return std::nullopt;
}

} // namespace laminate_offset
