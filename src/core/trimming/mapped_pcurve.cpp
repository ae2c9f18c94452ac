// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mapped_pcurve.h"

#include "curve_breaks.h"

#include "../spline/least_squares.h"

#include <Geom2dConvert.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>

#include <functional>
#include <optional>
#include <utility>

namespace laminate_offset
{
namespace
{

constexpr int lowest_degree = 1;
constexpr int highest_degree = 5;
constexpr double choice_share = 0.8; // of the accuracy, for the choice of knots

//! A pcurve whose conversion to a spline keeps its parameter.
bool is_spline(Handle(Geom2d_Curve) curve)
{
    while (const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(curve))
        curve = trimmed->BasisCurve();
    return curve->IsKind(STANDARD_TYPE(Geom2d_Line)) || curve->IsKind(STANDARD_TYPE(Geom2d_BSplineCurve)) ||
           curve->IsKind(STANDARD_TYPE(Geom2d_BezierCurve));
}

double scaled(const MonotoneMap &map, double value)
{
    const std::vector<double> &from = map.values();
    const std::vector<double> &to = map.parameters();
    const double part = (value - from.front()) / (from.back() - from.front());
    return (1.0 - part) * to.front() + part * to.back();
}

//! Under linear maps the poles move with the curve.
Handle(Geom2d_BSplineCurve) scaled_pcurve(const CurveOnSurface &c, const ParameterMap &map)
{
    const Handle(Geom2d_TrimmedCurve) part = new Geom2d_TrimmedCurve(c.pcurve, c.first, c.last);
    const Handle(Geom2d_BSplineCurve) spline = Geom2dConvert::CurveToBSplineCurve(part);
    if (spline->IsPeriodic())
        spline->SetNotPeriodic();
    for (int i = 1; i <= spline->NbPoles(); ++i)
    {
        const gp_Pnt2d pole = spline->Pole(i);
        spline->SetPole(i, gp_Pnt2d(scaled(map.u, pole.X()), scaled(map.v, pole.Y())));
    }
    return spline;
}

//! Knots at which a curve through the map is C1 only; the map is smooth in between.
KnotVector node_knots(const MonotoneMap &map)
{
    constexpr int degree = 2;
    const std::vector<double> &nodes = map.values();
    return clamped_knots(degree, nodes.front(), nodes.back(), {nodes.begin() + 1, nodes.end() - 1});
}

Handle(Geom2d_Curve) planar_curve(const KnotVector &kv, const RowMatrix &poles)
{
    TColgp_Array1OfPnt2d points(1, static_cast<int>(poles.rows()));
    for (int i = 0; i < poles.rows(); ++i)
        points(i + 1) = gp_Pnt2d(poles(i, 0), poles(i, 1));
    const std::vector<Knot> distinct = kv.distinct();
    TColStd_Array1OfReal knots(1, static_cast<int>(distinct.size()));
    TColStd_Array1OfInteger multiplicities(1, knots.Length());
    for (int i = 1; i <= knots.Length(); ++i)
    {
        knots(i) = distinct[static_cast<std::size_t>(i) - 1].parameter;
        multiplicities(i) = distinct[static_cast<std::size_t>(i) - 1].multiplicity;
    }
    return new Geom2d_BSplineCurve(points, knots, multiplicities, kv.degree);
}

using PlaneCurve = std::function<Eigen::Vector2d(double)>;

//! A spline with few poles within the accuracy of `point` at samples.
Handle(Geom2d_Curve) fitted(const CurveOnSurface &c, const PlaneCurve &point, std::vector<DataBreak> breaks,
                            double accuracy, int max_degree)
{
    const auto sample = [&](const std::vector<double> &parameters) {
        RowMatrix rows = RowMatrix::Zero(static_cast<Eigen::Index>(parameters.size()), 3);
        for (std::size_t i = 0; i < parameters.size(); ++i)
            rows.row(static_cast<Eigen::Index>(i)).head<2>() = point(parameters[i]).transpose();
        return rows;
    };
    KnotProblem problem;
    problem.low = c.first;
    problem.high = c.last;
    problem.breaks = std::move(breaks);
    problem.sample = sample;
    problem.tolerance = choice_share * accuracy;
    problem.min_degree = lowest_degree;
    problem.max_degree = max_degree;
    const std::optional<KnotChoice> choice = choose_knots(problem);
    if (!choice)
        return {};
    std::vector<double> ends{c.first};
    for (const DataBreak &b : problem.breaks)
        ends.push_back(b.parameter);
    ends.push_back(c.last);
    const std::vector<double> parameters =
        chebyshev_parameters(merged_breaks(ends, choice->knots.breaks()), choice->knots.degree + 3);
    const auto fit = LeastSquaresFit::make(choice->knots, parameters);
    return fit ? planar_curve(choice->knots, fit->solve(sample(parameters))) : Handle(Geom2d_Curve)();
}

PlaneCurve on_pcurve(const CurveOnSurface &c)
{
    return [&c](double t) -> Eigen::Vector2d {
        const gp_Pnt2d uv = c.pcurve->Value(t);
        return {uv.X(), uv.Y()};
    };
}

} // namespace

bool is_polynomial(const CurveOnSurface &c)
{
    if (!is_spline(c.pcurve))
        return false;
    const Handle(Geom2d_TrimmedCurve) part = new Geom2d_TrimmedCurve(c.pcurve, c.first, c.last);
    return !Geom2dConvert::CurveToBSplineCurve(part)->IsRational();
}

Handle(Geom2d_Curve) polynomial_pcurve(const CurveOnSurface &c, double accuracy)
{
    constexpr int degree = 7;
    return fitted(c, on_pcurve(c), curve_breaks(c, on_pcurve(c), nullptr, nullptr), accuracy, degree);
}

Handle(Geom2d_Curve) mapped_pcurve(const CurveOnSurface &on_base, const ParameterMap &map, double accuracy)
{
    if (map.u.degree() == 1 && map.v.degree() == 1 && is_spline(on_base.pcurve))
        return scaled_pcurve(on_base, map);
    const KnotVector u = node_knots(map.u);
    const KnotVector v = node_knots(map.v);
    const auto image = [&](double t) -> Eigen::Vector2d {
        const gp_Pnt2d uv = on_base.pcurve->Value(t);
        return {map.u.parameter(uv.X()), map.v.parameter(uv.Y())};
    };
    return fitted(on_base, image, curve_breaks(on_base, on_pcurve(on_base), &u, &v), accuracy, highest_degree);
}

} // namespace laminate_offset
