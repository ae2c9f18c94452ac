// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept_form.h"

#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>

#include <cmath>

namespace laminate_offset
{
namespace
{

//! The axis about which the first parameter turns X towards Y, also in a left-handed system.
gp_Ax1 turning_axis(const gp_Ax3 &frame) { return {frame.Location(), frame.XDirection().Crossed(frame.YDirection())}; }

//! A circle in the plane of X and the main direction, from X on.
Handle(Geom_Circle) meridian(const gp_Ax3 &frame, double away, double radius)
{
    const gp_Pnt centre = frame.Location().Translated(away * gp_Vec(frame.XDirection()));
    return new Geom_Circle(gp_Ax2(centre, frame.XDirection().Crossed(frame.Direction()), frame.XDirection()), radius);
}

Handle(Geom_Line) ruling(const gp_Ax3 &frame, double radius, double angle)
{
    const gp_Vec direction = std::sin(angle) * gp_Vec(frame.XDirection()) + std::cos(angle) * gp_Vec(frame.Direction());
    return new Geom_Line(frame.Location().Translated(radius * gp_Vec(frame.XDirection())), gp_Dir(direction));
}

} // namespace

Handle(Geom_Surface) swept_form(const Handle(Geom_Surface) & surface)
{
    if (const auto plane = Handle(Geom_Plane)::DownCast(surface))
    {
        const gp_Ax3 &frame = plane->Position();
        return new Geom_SurfaceOfLinearExtrusion(new Geom_Line(frame.Location(), frame.XDirection()),
                                                 frame.YDirection());
    }
    const auto elementary = Handle(Geom_ElementarySurface)::DownCast(surface);
    if (elementary.IsNull())
        return surface;
    const gp_Ax3 &frame = elementary->Position();
    Handle(Geom_Curve) profile;
    if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface))
        profile = ruling(frame, cylinder->Radius(), 0.0);
    else if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface))
        profile = ruling(frame, cone->RefRadius(), cone->SemiAngle());
    else if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface))
        profile = meridian(frame, 0.0, sphere->Radius());
    else if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface))
        profile = meridian(frame, torus->MajorRadius(), torus->MinorRadius());
    if (profile.IsNull())
        return surface;
    return new Geom_SurfaceOfRevolution(profile, turning_axis(frame));
}

} // namespace laminate_offset
