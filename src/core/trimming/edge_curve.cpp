// SPDX-License-Identifier: LGPL-2.1-or-later
#include "edge_curve.h"

#include "curve_breaks.h"
#include "edge_fit.h"
#include "same_knots.h"

#include "../spline/knot_choice.h"
#include "../spline/least_squares.h"

#include <Adaptor3d_CurveOnSurface.hxx>
#include <BSplCLib.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomAbs_CurveType.hxx>
#include <GeomAbs_SurfaceType.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomLib.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace laminate_offset
{
namespace
{

constexpr int most_rounds = 6;
constexpr int smooth_rounds = 3;
// A pcurve counts as isoparametric when it strays from the line by less than this part of its length.
constexpr double iso_straightness = 1e-12;
// Part of an edge's tolerance that a parallelogram may be twisted by.
constexpr double twist_share = 1e-3;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
// The image of a pole takes a dozen roundings of what it is the sum of.
constexpr double affine_operations = 32.0;

//! A pcurve that runs along u = value or v = value, linearly in its own parameter.
struct IsoLine
{
    bool constant_u = false;
    double value = 0.0;
    double start = 0.0; //!< the running parameter at the pcurve's first and last parameter
    double end = 0.0;
};

std::optional<IsoLine> iso_line(const CurveOnSurface &c)
{
    const gp_Pnt2d a = c.pcurve->Value(c.first);
    const gp_Pnt2d b = c.pcurve->Value(c.last);
    const bool constant_u = std::abs(a.X() - b.X()) < std::abs(a.Y() - b.Y());
    IsoLine iso{constant_u, constant_u ? a.X() : a.Y(), constant_u ? a.Y() : a.X(), constant_u ? b.Y() : b.X()};
    double u0, u1, v0, v1;
    c.surface->Bounds(u0, u1, v0, v1);
    const double length = std::abs(iso.end - iso.start);
    if (!(length > 0.0))
        return std::nullopt;
    constexpr int probes = 9;
    for (int i = 0; i <= probes; ++i)
    {
        const double s = static_cast<double>(i) / probes;
        const gp_Pnt2d p = c.pcurve->Value(c.first + (c.last - c.first) * s);
        const double across = constant_u ? p.X() : p.Y();
        const double along = constant_u ? p.Y() : p.X();
        if (std::abs(across - iso.value) > iso_straightness * std::max(length, std::abs(iso.value)) ||
            std::abs(along - (iso.start + (iso.end - iso.start) * s)) > iso_straightness * length)
            return std::nullopt;
    }
    return iso;
}

//! The isoparametric curve of a B-spline surface with the pcurve's parameters.
Handle(Geom_Curve) iso_curve(const Geom_BSplineSurface &surface, const IsoLine &iso, double first, double last)
{
    const Handle(Geom_Curve) whole = iso.constant_u ? surface.UIso(iso.value) : surface.VIso(iso.value);
    const auto curve = Handle(Geom_BSplineCurve)::DownCast(whole);
    double low = std::min(iso.start, iso.end);
    double high = std::max(iso.start, iso.end);
    // ends that rounding has put outside belong to the border
    const double slack = iso_straightness * (curve->LastParameter() - curve->FirstParameter());
    if (low < curve->FirstParameter() - slack || high > curve->LastParameter() + slack)
        return {};
    low = std::max(low, curve->FirstParameter());
    high = std::min(high, curve->LastParameter());
    curve->Segment(low, high);
    if (iso.start > iso.end)
        curve->Reverse();
    TColStd_Array1OfReal knots(1, curve->NbKnots());
    curve->Knots(knots);
    BSplCLib::Reparametrize(first, last, knots);
    curve->SetKnots(knots);
    return Handle(Geom_Curve)(curve);
}

Handle(Geom_BSplineCurve) segment(const gp_Pnt &start, const gp_Pnt &end, double first, double last)
{
    TColgp_Array1OfPnt poles(1, 2);
    poles(1) = start;
    poles(2) = end;
    TColStd_Array1OfReal knots(1, 2);
    knots(1) = first;
    knots(2) = last;
    TColStd_Array1OfInteger multiplicities(1, 2);
    multiplicities.Init(2);
    return new Geom_BSplineCurve(poles, knots, multiplicities, 1);
}

//! A parallelogram as the affine map that it is, up to a twist.
class AffineMap
{
public:
    //! \return nothing for any other spline, or where the twist exceeds `slack` [mm].
    static std::optional<AffineMap> make(const Geom_BSplineSurface &s, double slack)
    {
        if (s.NbUPoles() != 2 || s.NbVPoles() != 2 || s.IsURational() || s.IsVRational())
            return std::nullopt;
        AffineMap map;
        double v1, u1;
        s.Bounds(map.m_u, u1, map.m_v, v1);
        map.m_origin = s.Pole(1, 1).XYZ();
        map.m_along_u = s.Pole(2, 1).XYZ() - map.m_origin;
        map.m_along_v = s.Pole(1, 2).XYZ() - map.m_origin;
        map.m_twist = (s.Pole(2, 2).XYZ() - map.m_origin - map.m_along_u - map.m_along_v).Modulus();
        if (map.m_twist > slack)
            return std::nullopt;
        map.m_width = u1 - map.m_u;
        map.m_height = v1 - map.m_v;
        map.m_along_u /= map.m_width;
        map.m_along_v /= map.m_height;
        return map;
    }

    //! Bound of the distance between the surface, which goes on outside, and the computed image of a pcurve with these
    //! poles: twist and rounding. It holds at the poles, and so for what they weigh.
    [[nodiscard]] double deviation(const std::vector<gp_Pnt2d> &poles) const
    {
        double along_u = 1.0; // how far the poles go, in sides of the parallelogram
        double along_v = 1.0;
        for (const gp_Pnt2d &pole : poles)
        {
            along_u = std::max(along_u, std::abs(pole.X() - m_u) / m_width);
            along_v = std::max(along_v, std::abs(pole.Y() - m_v) / m_height);
        }
        const double size = m_origin.Modulus() + (2.0 * std::abs(m_u) + along_u * m_width) * m_along_u.Modulus() +
                            (2.0 * std::abs(m_v) + along_v * m_height) * m_along_v.Modulus();
        return along_u * along_v * m_twist + affine_operations * epsilon * size;
    }

    [[nodiscard]] gp_Pnt operator()(const gp_Pnt2d &uv) const
    {
        return gp_Pnt(m_origin + (uv.X() - m_u) * m_along_u + (uv.Y() - m_v) * m_along_v);
    }

private:
    double m_u = 0.0;
    double m_v = 0.0;
    double m_twist = 0.0; //!< [mm]
    double m_width = 1.0;
    double m_height = 1.0;
    gp_XYZ m_origin;
    gp_XYZ m_along_u;
    gp_XYZ m_along_v;
};

//! An affine map takes a spline's poles to those of its image; what it is off by is known beforehand.
std::optional<EdgeCurve> affine_image(const AffineMap &map, const CurveOnSurface &c)
{
    Handle(Geom2d_Curve) pcurve = c.pcurve;
    while (const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(pcurve))
        pcurve = trimmed->BasisCurve();
    const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(pcurve);
    const bool line = !Handle(Geom2d_Line)::DownCast(pcurve).IsNull();
    if (!line && (spline.IsNull() || spline->IsPeriodic()))
        return std::nullopt;
    std::vector<gp_Pnt2d> own;
    if (line)
        own = {pcurve->Value(c.first), pcurve->Value(c.last)};
    else
        own.assign(spline->Poles().begin(), spline->Poles().end());
    const Deviation deviation{map.deviation(own), true};
    if (line)
        return EdgeCurve{segment(map(own.front()), map(own.back()), c.first, c.last), deviation};
    TColgp_Array1OfPnt poles(1, spline->NbPoles());
    TColStd_Array1OfReal weights(1, spline->NbPoles());
    for (int i = 1; i <= spline->NbPoles(); ++i)
    {
        poles(i) = map(own[static_cast<std::size_t>(i) - 1]);
        weights(i) = spline->Weight(i);
    }
    return EdgeCurve{new Geom_BSplineCurve(poles, weights, spline->Knots(), spline->Multiplicities(), spline->Degree()),
                     deviation};
}

//! An isoparametric curve of a spline surface.
Handle(Geom_Curve) spline_curve(const CurveOnSurface &c, const Geom_BSplineSurface &surface)
{
    const std::optional<IsoLine> iso = iso_line(c);
    return iso ? iso_curve(surface, *iso, c.first, c.last) : nullptr;
}

//! The curve that a pcurve on a plane is, and the line, circle or ellipse that a simple one on another
//! analytic surface is, in the pcurve's parameters.
Handle(Geom_Curve) analytic_curve(const CurveOnSurface &c)
{
    if (const auto plane = Handle(Geom_Plane)::DownCast(c.surface); !plane.IsNull() && plane->Position().Direct())
        return GeomLib::To3d(plane->Position().Ax2(), c.pcurve);
    const Adaptor3d_CurveOnSurface on_surface(new Geom2dAdaptor_Curve(c.pcurve, c.first, c.last),
                                              new GeomAdaptor_Surface(c.surface));
    switch (on_surface.GetType())
    {
    case GeomAbs_Line: return new Geom_Line(on_surface.Line());
    case GeomAbs_Circle: return new Geom_Circle(on_surface.Circle());
    case GeomAbs_Ellipse: return new Geom_Ellipse(on_surface.Ellipse());
    default: break;
    }
    const GeomAbs_SurfaceType type = GeomAdaptor_Surface(c.surface).GetType();
    if (type == GeomAbs_Cylinder || type == GeomAbs_Cone)
        if (const std::optional<IsoLine> iso = iso_line(c); iso && iso->constant_u)
            return segment(c.value(c.first), c.value(c.last), c.first, c.last);
    return {};
}

//! The curve over chosen knots and its deviation.
EdgeCurve judged(const EdgeTarget &target, const KnotVector &knots, const RowMatrix &poles,
                 const Eigen::Vector3d &origin, double tolerance)
{
    EdgeCurve result;
    result.curve = spline_curve(knots, poles, origin);
    result.deviation = target.deviation(result.curve, tolerance);
    return result;
}

//! How much smaller the samples' tolerance has to be after a fit that was not good enough.
double cut(double bound, double tolerance) { return std::clamp(0.8 * tolerance / bound, 0.2, 0.7); }

//! A fit whose knots follow from its errors by law: over simple knots where there are no joins.
std::optional<EdgeCurve> smooth_curve(const EdgeTarget &target, const KnotProblem &problem,
                                      const std::vector<double> &ends, const std::vector<DataBreak> &joins,
                                      const Eigen::Vector3d &origin, double tolerance)
{
    double at_samples = problem.tolerance;
    for (int round = 0; round < smooth_rounds; ++round)
    {
        const SmoothCurve curve{problem.sample, ends};
        const std::optional<CurveFit> fit =
            joins.empty() ? smooth_fit(curve, at_samples) : joined_fit(curve, joins, at_samples);
        if (!fit)
            return std::nullopt;
        EdgeCurve result = judged(target, fit->knots, fit->poles, origin, tolerance);
        if (result.deviation.bound <= tolerance)
            return result;
        at_samples *= cut(result.deviation.bound, tolerance);
    }
    return std::nullopt;
}

//! A fit to data with kinks, where knots have to stand at the breaks, perhaps several at one.
std::optional<EdgeCurve> kinked_curve(const EdgeTarget &target, KnotProblem problem, const std::vector<double> &ends,
                                      const Eigen::Vector3d &origin, double tolerance)
{
    for (int round = 0; round < most_rounds; ++round)
    {
        const std::optional<KnotChoice> choice = choose_knots(problem);
        if (!choice)
            return std::nullopt;
        const std::vector<double> parameters =
            chebyshev_parameters(merged_breaks(ends, choice->knots.breaks()), choice->knots.degree + 3);
        const auto solver = LeastSquaresFit::make(choice->knots, parameters);
        if (!solver)
            return std::nullopt;
        EdgeCurve result = judged(target, choice->knots, solver->solve(problem.sample(parameters)), origin, tolerance);
        if (result.deviation.bound <= tolerance)
            return result;
        problem.tolerance *= cut(result.deviation.bound, tolerance);
    }
    return std::nullopt;
}

std::optional<EdgeCurve> fitted_curve(const EdgeTarget &target, double tolerance)
{
    const CurveOnSurface &c = target.on_surface();
    const Eigen::Vector3d origin = target.value(0.5 * (c.first + c.last));
    KnotProblem problem;
    problem.low = c.first;
    problem.high = c.last;
    const TensorSpline *spline = target.spline();
    problem.breaks = curve_breaks(
        c, [&](double t) { return target.uv(t); }, spline ? &spline->u : nullptr, spline ? &spline->v : nullptr);
    problem.tolerance = 0.8 * tolerance;
    problem.min_degree = 4; // cubics hardly ever win by then, and cost a third of the search
    problem.max_degree = 5;
    problem.sample = [&](const std::vector<double> &parameters) { return target.values(parameters, origin); };
    std::vector<double> ends{c.first};
    for (const DataBreak &b : problem.breaks)
        ends.push_back(b.parameter);
    ends.push_back(c.last);
    std::vector<DataBreak> joins;
    std::copy_if(problem.breaks.begin(), problem.breaks.end(), std::back_inserter(joins),
                 [](const DataBreak &b) { return b.continuity <= 1; });
    const bool kinked = std::any_of(joins.begin(), joins.end(), [](const DataBreak &b) { return b.continuity < 1; });
    if (!kinked)
        if (auto smooth = smooth_curve(target, problem, ends, {}, origin, tolerance))
            return smooth;
    if (!joins.empty())
        if (auto joined = smooth_curve(target, problem, ends, joins, origin, tolerance))
            return joined;
    if (joins.size() < problem.breaks.size()) // noise in a pcurve shows in the higher derivatives at its knots
        if (auto joined = smooth_curve(target, problem, ends, problem.breaks, origin, tolerance))
            return joined;
    return kinked_curve(target, problem, ends, origin, tolerance);
}

//! On the knots of another curve, where that is near enough.
std::optional<EdgeCurve> alike_curve(const EdgeTarget &target, double tolerance, const Handle(Geom_Curve) & like)
{
    const auto pattern = Handle(Geom_BSplineCurve)::DownCast(like);
    if (pattern.IsNull() || !clamped(*pattern))
        return std::nullopt;
    const Handle(Geom_BSplineCurve) curve = through_samples(*pattern, target);
    if (curve.IsNull())
        return std::nullopt;
    const Deviation deviation = target.deviation(curve, tolerance);
    return deviation.bound <= tolerance ? std::optional<EdgeCurve>(EdgeCurve{Handle(Geom_Curve)(curve), deviation})
                                        : std::nullopt;
}

} // namespace

std::optional<EdgeCurve> exact_curve(const EdgeTarget &target, double tolerance)
{
    const CurveOnSurface &c = target.on_surface();
    const auto spline = Handle(Geom_BSplineSurface)::DownCast(c.surface);
    if (const auto map = spline.IsNull() ? std::nullopt : AffineMap::make(*spline, twist_share * tolerance))
        if (std::optional<EdgeCurve> image = affine_image(*map, c); image && image->deviation.bound <= tolerance)
            return image;
    const Handle(Geom_Curve) exact = spline.IsNull() ? analytic_curve(c) : spline_curve(c, *spline);
    if (!exact.IsNull())
        if (const Deviation deviation = target.deviation(exact, tolerance); deviation.bound <= tolerance)
            return EdgeCurve{exact, deviation};
    return std::nullopt;
}

std::optional<EdgeCurve> edge_curve(const EdgeTarget &target, double tolerance, const Handle(Geom_Curve) & like)
{
    if (std::optional<EdgeCurve> exact = exact_curve(target, tolerance))
        return exact;
    if (std::optional<EdgeCurve> alike = alike_curve(target, tolerance, like))
        return alike;
    return fitted_curve(target, tolerance);
}

} // namespace laminate_offset
