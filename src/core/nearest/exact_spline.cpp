// SPDX-License-Identifier: LGPL-2.1-or-later
#include "exact_spline.h"

#include "../analysis/base_surface.h"
#include "../spline/geom_values.h"

#include <Eigen/Geometry>
#include <ElCLib.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <gp_Ax1.hxx>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace laminate_offset
{
namespace
{

// No arc is wider than a third of the circle, so that weights stay above a half.
constexpr double widest_arc = 2.0 * M_PI / 3.0;

//! One direction of a surface, its poles in whatever frame they belong to.
struct Profile
{
    KnotVector knots;
    std::vector<Eigen::Vector4d> poles; //!< homogeneous
    ParameterLaw law;
    bool rational = false;
};

double middle_of(double a, double b) { return 0.5 * (a + b); }

//! The arc's ends around a parameter.
std::pair<double, double> arc_around(const std::vector<double> &arcs, double parameter)
{
    auto high = std::upper_bound(arcs.begin(), arcs.end(), parameter);
    high = std::clamp(high, arcs.begin() + 1, arcs.end() - 1);
    return {*(high - 1), *high};
}

//! cos t x + sin t y about `centre` for t in [low, high], as rational quadratic arcs.
Profile arcs(const Eigen::Vector3d &centre, const Eigen::Vector3d &x, const Eigen::Vector3d &y, double low, double high)
{
    const int count = std::max(1, static_cast<int>(std::ceil((high - low) / widest_arc - 1e-9)));
    const double half = 0.5 * (high - low) / count;
    Profile profile;
    profile.rational = true;
    std::vector<double> interior;
    for (int i = 0; i <= count; ++i)
        profile.law.arcs.push_back(i == count ? high : low + 2.0 * half * i);
    for (int i = 0; i <= 2 * count; ++i)
    {
        const double t = i == 2 * count ? high : low + half * i;
        const double weight = i % 2 == 0 ? 1.0 : std::cos(half);
        Eigen::Vector4d pole;
        pole.head<3>() = weight * centre + std::cos(t) * x + std::sin(t) * y;
        pole.w() = weight;
        profile.poles.push_back(pole);
        if (i % 2 == 0 && i > 0 && i < 2 * count)
            interior.insert(interior.end(), 2, profile.law.arcs[static_cast<std::size_t>(i / 2)]);
    }
    profile.knots = clamped_knots(2, low, high, interior);
    return profile;
}

Eigen::Vector4d homogeneous(const gp_Pnt &point, double weight)
{
    Eigen::Vector4d pole;
    pole.head<3>() = weight * vector(point.XYZ());
    pole.w() = weight;
    return pole;
}

Profile segment(const gp_Pnt &start, const gp_Pnt &end, double low, double high)
{
    return {clamped_knots(1, low, high, {}), {homogeneous(start, 1.0), homogeneous(end, 1.0)}, {}, false};
}

//! A parabola is a polynomial of degree 2: its middle pole lies where the end tangents meet.
Profile parabola(const Geom_Parabola &curve, double low, double high)
{
    gp_Pnt start;
    gp_Vec along;
    curve.D1(low, start, along);
    const gp_Pnt corner = start.Translated(0.5 * (high - low) * along);
    return {clamped_knots(2, low, high, {}),
            {homogeneous(start, 1.0), homogeneous(corner, 1.0), homogeneous(curve.Value(high), 1.0)},
            {},
            false};
}

Profile spline_profile(const Handle(Geom_BSplineCurve) & whole, double low, double high)
{
    const auto curve = Handle(Geom_BSplineCurve)::DownCast(whole->Copy());
    if (!curve->IsPeriodic())
        curve->Segment(std::max(low, curve->FirstParameter()), std::min(high, curve->LastParameter()));
    else
    {
        std::tie(low, high) = period_cut(low, high, curve->FirstParameter(), curve->LastParameter());
        curve->Segment(low, high);
    }
    Profile profile;
    profile.knots.degree = curve->Degree();
    const TColStd_Array1OfReal &knots = curve->KnotSequence();
    for (int i = knots.Lower(); i <= knots.Upper(); ++i)
        profile.knots.knots.push_back(knots(i));
    realign(profile.knots, low, high);
    profile.rational = curve->IsRational();
    for (int i = 1; i <= curve->NbPoles(); ++i)
        profile.poles.push_back(homogeneous(curve->Pole(i), curve->Weight(i)));
    return profile;
}

template <typename Conic> Profile conic(const Conic &curve, double major, double minor, double low, double high)
{
    const gp_Ax2 &frame = curve.Position();
    return arcs(vector(frame.Location().XYZ()), major * vector(frame.XDirection().XYZ()),
                minor * vector(frame.YDirection().XYZ()), low, high);
}

std::optional<Profile> profile_of(const Handle(Geom_Curve) & given, double low, double high)
{
    Handle(Geom_Curve) curve = given;
    while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve))
        curve = trimmed->BasisCurve();
    if (!Handle(Geom_Line)::DownCast(curve).IsNull())
        return segment(curve->Value(low), curve->Value(high), low, high);
    if (const auto circle = Handle(Geom_Circle)::DownCast(curve))
        return conic(*circle, circle->Radius(), circle->Radius(), low, high);
    if (const auto ellipse = Handle(Geom_Ellipse)::DownCast(curve))
        return conic(*ellipse, ellipse->MajorRadius(), ellipse->MinorRadius(), low, high);
    if (const auto bent = Handle(Geom_Parabola)::DownCast(curve))
        return parabola(*bent, low, high);
    if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve))
        return spline_profile(spline, low, high);
    if (const auto bezier = Handle(Geom_BezierCurve)::DownCast(curve))
        return spline_profile(GeomConvert::CurveToBSplineCurve(bezier), low, high);
    return std::nullopt;
}

//! The profile (over v) turned about an axis by angles u.
ExactSpline turned(const Profile &profile, const Eigen::Vector3d &origin, const Eigen::Vector3d &axis, double low,
                   double high)
{
    // the unit circle in the plane of its first two coordinates
    const Profile circle = arcs(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), low, high);
    ExactSpline result{{circle.knots, profile.knots, {}, true}, circle.law, profile.law};
    for (const Eigen::Vector4d &turn : circle.poles)
        for (const Eigen::Vector4d &pole : profile.poles)
        {
            const Eigen::Vector3d from_origin = pole.head<3>() - pole.w() * origin;
            const Eigen::Vector3d along = from_origin.dot(axis) * axis;
            const Eigen::Vector3d radial = from_origin - along;
            Eigen::Vector4d product;
            product.head<3>() =
                turn.w() * (pole.w() * origin + along) + turn.x() * radial + turn.y() * axis.cross(radial);
            product.w() = turn.w() * pole.w();
            result.spline.poles.push_back(product);
        }
    return result;
}

//! The profile (over u) moved along a direction by lengths v.
ExactSpline extruded(const Profile &profile, const Eigen::Vector3d &direction, double low, double high)
{
    ExactSpline result{{profile.knots, clamped_knots(1, low, high, {}), {}, profile.rational}, profile.law, {}};
    for (const Eigen::Vector4d &pole : profile.poles)
        for (const double length : {low, high})
        {
            Eigen::Vector4d moved = pole;
            moved.head<3>() += pole.w() * length * direction;
            result.spline.poles.push_back(moved);
        }
    return result;
}

//! Cylinders, cones, spheres and tori: the isoparametric curve u = 0 turned about their axis.
ExactSpline turned_elementary(const Geom_ElementarySurface &surface, const ParameterBox &box)
{
    const gp_Ax3 &frame = surface.Position();
    const Eigen::Vector3d x = vector(frame.XDirection().XYZ());
    const Eigen::Vector3d y = vector(frame.YDirection().XYZ());
    const std::optional<Profile> profile = profile_of(surface.UIso(0.0), box.vmin, box.vmax);
    return turned(profile.value(), vector(frame.Location().XYZ()), x.cross(y), box.umin, box.umax);
}

std::optional<ExactSpline> swept(const Handle(Geom_Surface) & surface, const ParameterBox &box)
{
    if (const auto turn = Handle(Geom_SurfaceOfRevolution)::DownCast(surface))
    {
        const std::optional<Profile> profile = profile_of(turn->BasisCurve(), box.vmin, box.vmax);
        const gp_Ax1 &axis = turn->Axis();
        if (profile)
            return turned(*profile, vector(axis.Location().XYZ()), vector(axis.Direction().XYZ()), box.umin, box.umax);
    }
    if (const auto extrusion = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface))
    {
        const std::optional<Profile> profile = profile_of(extrusion->BasisCurve(), box.umin, box.umax);
        if (profile)
            return extruded(*profile, vector(extrusion->Direction().XYZ()), box.vmin, box.vmax);
    }
    return std::nullopt;
}

} // namespace

double ParameterLaw::to_surface(double spline_parameter) const
{
    if (arcs.empty())
        return spline_parameter;
    const auto [low, high] = arc_around(arcs, spline_parameter);
    if (spline_parameter == low || spline_parameter == high)
        return spline_parameter;
    const double half = 0.5 * (high - low);
    return middle_of(low, high) +
           2.0 * std::atan(std::tan(0.5 * half) * (spline_parameter - middle_of(low, high)) / half);
}

double ParameterLaw::to_spline(double surface_parameter) const
{
    if (arcs.empty())
        return surface_parameter;
    const auto [low, high] = arc_around(arcs, surface_parameter);
    if (surface_parameter == low || surface_parameter == high)
        return surface_parameter;
    const double half = 0.5 * (high - low);
    return middle_of(low, high) +
           half * std::tan(0.5 * (surface_parameter - middle_of(low, high))) / std::tan(0.5 * half);
}

std::optional<ExactSpline> exact_spline(const Handle(Geom_Surface) & surface, const ParameterBox &box)
{
    if (const auto plane = Handle(Geom_Plane)::DownCast(surface))
    {
        const Profile side = segment(plane->Value(box.umin, 0.0), plane->Value(box.umax, 0.0), box.umin, box.umax);
        return extruded(side, vector(plane->Position().YDirection().XYZ()), box.vmin, box.vmax);
    }
    if (const auto elementary = Handle(Geom_ElementarySurface)::DownCast(surface))
        return turned_elementary(*elementary, box);
    if (std::optional<ExactSpline> result = swept(surface, box))
        return result;
    const BaseSurface base(surface, box);
    return base.spline() ? std::optional<ExactSpline>({*base.spline(), {}, {}}) : std::nullopt;
}

} // namespace laminate_offset
