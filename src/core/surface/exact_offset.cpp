// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_surface.h"

#include "../analysis/analytic_form.h"

#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

// All five kinds keep S + d N in their own parameters, so the only error is rounding: a few dozen
// operations on coordinates of the face's size.
constexpr double rounding_operations = 64.0;
// An extrusion or revolution agrees with its form to 64 units in the last place for each of the frame's three
// directions and its origin, and so do the normals.
constexpr double disguise_operations = 16.0 * 64.0;
// Part of the tolerance that a base may be off its form.
constexpr double form_share = 0.1;

Handle(Geom_Surface) offset_plane(const Geom_Plane &plane, double d)
{
    gp_Ax3 position = plane.Position();
    const gp_Vec normal = gp_Vec(position.XDirection()).Crossed(gp_Vec(position.YDirection()));
    position.Translate(d * normal);
    return new Geom_Plane(position);
}

//! S(u, v) = P + (R + v sin a) radial(u) + v cos a Z, so S + d N has the radius R + d cos a at v = 0 and
//! its origin lower by d sin a.
Handle(Geom_Surface) offset_cone(const AnalyticForm &form, const Geom_ConicalSurface &cone, double d, gp_Vec2d &shift)
{
    const double s = form.normal_sign;
    const double angle = cone.SemiAngle();
    const auto radius_at = [&](double v) { return cone.RefRadius() + v * std::sin(angle) + s * d * std::cos(angle); };
    gp_Ax3 position = cone.Position();
    double radius = radius_at(0.0);
    if (radius < 0.0) // the reference circle would turn inside out: measure v from the tight end instead
    {
        const double tight = radius_at(form.box.vmin) < radius_at(form.box.vmax) ? form.box.vmin : form.box.vmax;
        shift.SetY(shift.Y() - tight);
        radius = std::max(0.0, radius_at(tight));
        position.Translate(tight * std::cos(angle) * gp_Vec(position.Direction()));
    }
    position.Translate(-s * d * std::sin(angle) * gp_Vec(position.Direction()));
    return new Geom_ConicalSurface(position, angle, radius);
}

Handle(Geom_Surface) offset_form(const AnalyticForm &form, double d, gp_Vec2d &shift)
{
    if (const auto plane = Handle(Geom_Plane)::DownCast(form.surface))
        return offset_plane(*plane, d);
    if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(form.surface))
        return offset_cone(form, *cone, d, shift);
    if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(form.surface))
        return new Geom_CylindricalSurface(cylinder->Position(), cylinder->Radius() + form.normal_sign * d);
    if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(form.surface))
        return new Geom_SphericalSurface(sphere->Position(), sphere->Radius() + form.normal_sign * d);
    const auto torus = Handle(Geom_ToroidalSurface)::DownCast(form.surface);
    return new Geom_ToroidalSurface(torus->Position(), torus->MajorRadius(),
                                    torus->MinorRadius() + form.normal_sign * d);
}

//! How far the numbers that a surface is given by reach beyond the face: its location, radii and poles may be far away.
double frame_size(const InputFace &input)
{
    if (const auto elementary = Handle(Geom_ElementarySurface)::DownCast(input.surface))
    {
        const gp_Pnt location = elementary->Location();
        const gp_Pnt probe = input.point({input.box.umin, input.box.vmin});
        return 2.0 * location.XYZ().Modulus() + location.Distance(probe);
    }
    const auto spline = Handle(Geom_BSplineSurface)::DownCast(input.surface);
    double largest = 0.0;
    for (int i = 1; !spline.IsNull() && i <= spline->NbUPoles(); ++i)
        for (int j = 1; j <= spline->NbVPoles(); ++j)
            largest = std::max(largest, spline->Pole(i, j).XYZ().Modulus());
    return largest;
}

} // namespace

double rounding_of(const InputFace &input, double distance)
{
    const gp_Pnt probe =
        input.point({0.5 * (input.box.umin + input.box.umax), 0.5 * (input.box.vmin + input.box.vmax)});
    const double size = probe.XYZ().Modulus() + input.diagonal + std::abs(distance) + frame_size(input);
    return rounding_operations * std::numeric_limits<double>::epsilon() * size;
}

std::optional<OffsetSurface> exact_offset(const InputFace &input, double distance, double tolerance)
{
    const std::optional<AnalyticForm> form = analytic_form(input);
    if (!form || form->error.of_offset(distance) > form_share * tolerance)
        return std::nullopt;
    OffsetSurface result;
    result.parameter_shift = form->shift;
    result.geometry = offset_form(*form, distance, result.parameter_shift);
    double error = rounding_of(input, distance) + form->error.of_offset(distance);
    if (form->disguised)
    {
        const gp_Pnt origin = Handle(Geom_ElementarySurface)::DownCast(form->surface)->Location();
        const gp_Pnt probe = input.point({input.box.umin, input.box.vmin});
        const double reach = 2.0 * origin.XYZ().Modulus() + probe.Distance(origin) + input.diagonal;
        error += disguise_operations * std::numeric_limits<double>::epsilon() * (reach + std::abs(distance));
    }
    result.certified_error = error;
    return result;
}

} // namespace laminate_offset
