// SPDX-License-Identifier: LGPL-2.1-or-later
#include "side_surface.h"

#include "../spline/conic_functions.h"

#include <Geom2d_Circle.hxx>
#include <Geom2d_Line.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

// Exact forms hold to rounding, measured against the curves' own size.
constexpr double rounding = 1e-12;
// Knots nearer than this part of the range are one.
constexpr double same_knot = 1e-12;
// Lines and conics that keep their distance at so many places keep it everywhere.
constexpr int probes = 9;
// How near a spline comes to a circle [mm], or as a part of its radius where that is more.
constexpr double conic_error = 1e-8;
constexpr double relative_conic_error = 1e-12;

Handle(Geom_Curve) unwrapped(Handle(Geom_Curve) curve)
{
    while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve))
        curve = trimmed->BasisCurve();
    return curve;
}

//! Both curves over one range.
struct Pair
{
    Handle(Geom_Curve) low;
    Handle(Geom_Curve) high;
    double first;
    double last;

    [[nodiscard]] gp_Vec step(double part) const
    {
        const double t = first + part * (last - first);
        return {low->Value(t), high->Value(t)};
    }

    [[nodiscard]] double size() const
    {
        const gp_XYZ a = low->Value(first).XYZ();
        const gp_XYZ b = low->Value(0.5 * (first + last)).XYZ();
        return std::max({a.Modulus(), b.Modulus(), (b - a).Modulus(), step(0.0).Magnitude()});
    }
};

Handle(Geom2d_Curve) along_u(double u, double v) { return new Geom2d_Line(gp_Pnt2d(u, v), gp_Dir2d(1.0, 0.0)); }

bool is_spline(const Handle(Geom_Curve) & curve)
{
    return curve->IsKind(STANDARD_TYPE(Geom_BSplineCurve)) || curve->IsKind(STANDARD_TYPE(Geom_BezierCurve));
}

//! Is every pole moved by the same vector?
bool moved_spline(const Geom_BSplineCurve &low, const Geom_BSplineCurve &high, const gp_Vec &step, double near)
{
    if (low.NbPoles() != high.NbPoles() || low.Degree() != high.Degree() || low.NbKnots() != high.NbKnots())
        return false;
    for (int i = 1; i <= low.NbKnots(); ++i)
        if (low.Knot(i) != high.Knot(i) || low.Multiplicity(i) != high.Multiplicity(i))
            return false;
    for (int i = 1; i <= low.NbPoles(); ++i)
        if ((gp_Vec(low.Pole(i), high.Pole(i)) - step).Magnitude() > near || low.Weight(i) != high.Weight(i))
            return false;
    return true;
}

//! The vector by which the one curve is the other one moved.
std::optional<gp_Vec> move_of(const Pair &pair)
{
    const gp_Vec step = pair.step(0.0);
    const double near = rounding * pair.size();
    if (pair.low->DynamicType() != pair.high->DynamicType() || step.Magnitude() <= Precision::Confusion())
        return std::nullopt;
    const auto low = Handle(Geom_BSplineCurve)::DownCast(pair.low);
    if (!low.IsNull())
        return moved_spline(*low, *Handle(Geom_BSplineCurve)::DownCast(pair.high), step, near)
                   ? std::optional<gp_Vec>(step)
                   : std::nullopt;
    for (int i = 1; i <= probes; ++i)
        if ((pair.step(static_cast<double>(i) / probes) - step).Magnitude() > near)
            return std::nullopt;
    return step;
}

//! Of a line and the same line moved.
std::optional<SideSurface> plane_between(const Geom_Line &line, const gp_Vec &step)
{
    const gp_Dir along = line.Lin().Direction();
    const gp_Vec normal = gp_Vec(along).Crossed(step);
    if (normal.Magnitude() <= Precision::Angular() * step.Magnitude())
        return std::nullopt;
    const gp_Ax3 axes(line.Lin().Location(), gp_Dir(normal), along);
    return SideSurface{new Geom_Plane(axes), along_u(0.0, 0.0),
                       along_u(step.Dot(gp_Vec(along)), step.Dot(gp_Vec(axes.YDirection())))};
}

std::optional<SideSurface> moved(const Pair &pair, const gp_Vec &step)
{
    if (const auto line = Handle(Geom_Line)::DownCast(pair.low))
        return plane_between(*line, step);
    const auto circle = Handle(Geom_Circle)::DownCast(pair.low);
    if (!circle.IsNull() && gp_Vec(circle->Axis().Direction()).IsParallel(step, rounding))
    {
        const double height = step.Dot(gp_Vec(circle->Axis().Direction()));
        return SideSurface{new Geom_CylindricalSurface(gp_Ax3(circle->Position()), circle->Radius()), along_u(0.0, 0.0),
                           along_u(0.0, height), height < 0.0};
    }
    return SideSurface{new Geom_SurfaceOfLinearExtrusion(pair.low, gp_Dir(step)), along_u(0.0, 0.0),
                       along_u(0.0, step.Magnitude())};
}

//! Of two circles about one axis, at equal angles.
std::optional<SideSurface> round_side(const Pair &pair)
{
    const auto low = Handle(Geom_Circle)::DownCast(pair.low);
    const auto high = Handle(Geom_Circle)::DownCast(pair.high);
    if (low.IsNull() || high.IsNull())
        return std::nullopt;
    const gp_Ax3 axes(low->Position());
    const gp_Vec step(low->Location(), high->Location());
    const double height = step.Dot(gp_Vec(axes.Direction()));
    const double near = rounding * std::max({pair.size(), low->Radius(), high->Radius()});
    const bool coaxial = (step - height * gp_Vec(axes.Direction())).Magnitude() <= near &&
                         axes.XDirection().IsEqual(high->XAxis().Direction(), rounding) &&
                         axes.YDirection().IsEqual(high->YAxis().Direction(), rounding);
    if (!coaxial)
        return std::nullopt;
    const double growth = high->Radius() - low->Radius();
    if (std::abs(height) <= near)
    {
        const gp_Ax2d axis(gp_Pnt2d(0.0, 0.0), gp_Dir2d(1.0, 0.0));
        return SideSurface{new Geom_Plane(axes), new Geom2d_Circle(axis, low->Radius()),
                           new Geom2d_Circle(axis, high->Radius()), growth > 0.0, true};
    }
    const double angle = std::atan(growth / height);
    return SideSurface{new Geom_ConicalSurface(axes, angle, low->Radius()), along_u(0.0, 0.0),
                       along_u(0.0, height / std::cos(angle)), height < 0.0};
}

//! A spline with the parameter of a circle or an ellipse, within the error [mm]; null where there is none.
Handle(Geom_BSplineCurve)
    conic_as_spline(const Geom_Conic &conic, double major, double minor, double first, double last, double &error)
{
    constexpr double any = 1.0; // the slope and the bend do not count
    const double wanted = std::max(conic_error / major, relative_conic_error);
    const std::optional<ConicSpline> unit = conic_spline(ConicKind::Circle, first, last, {wanted, any, any});
    if (!unit)
        return {};
    error = unit->errors.value * major;
    const gp_Ax2 &axes = conic.Position();
    TColgp_Array1OfPnt poles(1, static_cast<int>(unit->poles.size()));
    for (std::size_t i = 0; i < unit->poles.size(); ++i)
        poles(static_cast<int>(i) + 1) = axes.Location().XYZ() + major * unit->poles[i].x() * axes.XDirection().XYZ() +
                                         minor * unit->poles[i].y() * axes.YDirection().XYZ();
    const std::vector<Knot> distinct = unit->knots.distinct();
    TColStd_Array1OfReal knots(1, static_cast<int>(distinct.size()));
    TColStd_Array1OfInteger multiplicities(1, static_cast<int>(distinct.size()));
    for (std::size_t i = 0; i < distinct.size(); ++i)
    {
        knots(static_cast<int>(i) + 1) = distinct[i].parameter;
        multiplicities(static_cast<int>(i) + 1) = distinct[i].multiplicity;
    }
    return new Geom_BSplineCurve(poles, knots, multiplicities, unit->knots.degree);
}

//! The curve over the range as a clamped B-spline with the same parameter, within the error [mm]; null for a curve of
//! another kind.
Handle(Geom_BSplineCurve) as_spline(const Handle(Geom_Curve) & curve, double first, double last, double &error)
{
    if (const auto circle = Handle(Geom_Circle)::DownCast(curve); !circle.IsNull())
        return conic_as_spline(*circle, circle->Radius(), circle->Radius(), first, last, error);
    if (const auto ellipse = Handle(Geom_Ellipse)::DownCast(curve); !ellipse.IsNull())
        return conic_as_spline(*ellipse, ellipse->MajorRadius(), ellipse->MinorRadius(), first, last, error);
    if (!is_spline(curve) && !curve->IsKind(STANDARD_TYPE(Geom_Line)))
        return {};
    const bool line = curve->IsKind(STANDARD_TYPE(Geom_Line));
    const Handle(Geom_Curve) finite = line ? Handle(Geom_Curve)(new Geom_TrimmedCurve(curve, first, last)) : curve;
    const Handle(Geom_BSplineCurve) spline =
        Handle(Geom_BSplineCurve)::DownCast(GeomConvert::CurveToBSplineCurve(finite)->Copy());
    if (spline->IsPeriodic() || spline->FirstParameter() != first || spline->LastParameter() != last)
        spline->Segment(first, last);
    return spline;
}

void take_knots(const Handle(Geom_BSplineCurve) & to, const Handle(Geom_BSplineCurve) & from)
{
    const double same = same_knot * (from->LastParameter() - from->FirstParameter());
    for (int i = 2; i < from->NbKnots(); ++i)
        to->InsertKnot(from->Knot(i), from->Multiplicity(i), same, false);
}

//! The B-spline of degree 1 from one curve to the other.
std::optional<SideSurface> ruled(const Pair &pair)
{
    double low_error = 0.0;
    double high_error = 0.0;
    const Handle(Geom_BSplineCurve) low = as_spline(pair.low, pair.first, pair.last, low_error);
    const Handle(Geom_BSplineCurve) high = as_spline(pair.high, pair.first, pair.last, high_error);
    if (low.IsNull() || high.IsNull())
        return std::nullopt;
    const int degree = std::max(low->Degree(), high->Degree());
    low->IncreaseDegree(degree);
    high->IncreaseDegree(degree);
    take_knots(low, high);
    take_knots(high, low);
    if (low->NbPoles() != high->NbPoles() || low->NbKnots() != high->NbKnots())
        return std::nullopt;
    TColgp_Array2OfPnt poles(1, low->NbPoles(), 1, 2);
    TColStd_Array2OfReal weights(1, low->NbPoles(), 1, 2);
    for (int i = 1; i <= low->NbPoles(); ++i)
    {
        poles(i, 1) = low->Pole(i);
        poles(i, 2) = high->Pole(i);
        weights(i, 1) = low->Weight(i);
        weights(i, 2) = high->Weight(i);
    }
    TColStd_Array1OfReal along(1, low->NbKnots());
    TColStd_Array1OfInteger multiplicities(1, low->NbKnots());
    low->Knots(along);
    low->Multiplicities(multiplicities);
    TColStd_Array1OfReal across(1, 2);
    across(1) = 0.0;
    across(2) = 1.0;
    TColStd_Array1OfInteger ends(1, 2);
    ends.Init(2);
    const bool rational = low->IsRational() || high->IsRational();
    const Handle(Geom_Surface) surface =
        rational ? new Geom_BSplineSurface(poles, weights, along, across, multiplicities, ends, degree, 1)
                 : new Geom_BSplineSurface(poles, along, across, multiplicities, ends, degree, 1);
    return SideSurface{surface, along_u(0.0, 0.0), along_u(0.0, 1.0), false, false, low_error, high_error};
}

} // namespace

std::optional<SideSurface> side_surface(const Handle(Geom_Curve) & low, const Handle(Geom_Curve) & high, double first,
                                        double last)
{
    const Pair pair{unwrapped(low), unwrapped(high), first, last};
    if (const std::optional<gp_Vec> step = move_of(pair))
        return moved(pair, *step);
    if (std::optional<SideSurface> side = round_side(pair))
        return side;
    return ruled(pair);
}

} // namespace laminate_offset
