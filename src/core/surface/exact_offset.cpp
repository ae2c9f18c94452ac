// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_surface.h"

#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

// All five kinds keep S + d N in their own parameters, so the only error is rounding: a few dozen
// operations on coordinates of the face's size.
constexpr double rounding_operations = 64.0;

//! S_u x S_v points outwards of the kind's right-handed normal, or inwards for a left-handed frame.
double handedness(const gp_Ax3 &position) { return position.Direct() ? 1.0 : -1.0; }

Failure folded(const InputFace &input, double distance, double limit, const gp_Pnt2d &uv)
{
    FeasibleRange range;
    // the side is that of the distance asked for: the limit itself may be zero
    (distance * input.normal_sign < 0.0 ? range.negative : range.positive) = limit * input.normal_sign;
    return {Status::CurvatureLimit, Stage::Surface,
            fmt::format("The distance {:.6g} mm reaches the radius of curvature {:.6g} mm at the reported place; stay "
                        "below that distance or trim the tight region away.",
                        input.normal_sign * distance, std::abs(limit)),
            input.place(uv), range};
}

OffsetSurface exact(const InputFace &input, const Handle(Geom_Surface) & geometry, double distance)
{
    OffsetSurface result;
    result.geometry = geometry;
    const gp_Pnt probe =
        input.surface->Value(0.5 * (input.box.umin + input.box.umax), 0.5 * (input.box.vmin + input.box.vmax));
    const double size = probe.XYZ().Modulus() + input.diagonal + std::abs(distance);
    result.certified_error = rounding_operations * std::numeric_limits<double>::epsilon() * size;
    return result;
}

Result<OffsetSurface> offset_plane(const InputFace &input, const Geom_Plane &plane, double d)
{
    gp_Ax3 position = plane.Position();
    const gp_Vec normal = gp_Vec(position.XDirection()).Crossed(gp_Vec(position.YDirection()));
    position.Translate(d * normal);
    return exact(input, new Geom_Plane(position), d);
}

Result<OffsetSurface> offset_cylinder(const InputFace &input, const Geom_CylindricalSurface &cylinder, double d)
{
    const double s = handedness(cylinder.Position());
    const double radius = cylinder.Radius() + s * d;
    if (radius <= 0.0)
        return folded(input, d, -s * cylinder.Radius(), {input.box.umin, input.box.vmin});
    return exact(input, new Geom_CylindricalSurface(cylinder.Position(), radius), d);
}

Result<OffsetSurface> offset_sphere(const InputFace &input, const Geom_SphericalSurface &sphere, double d)
{
    const double s = handedness(sphere.Position());
    const double radius = sphere.Radius() + s * d;
    if (radius <= 0.0)
        return folded(input, d, -s * sphere.Radius(), {input.box.umin, input.box.vmin});
    return exact(input, new Geom_SphericalSurface(sphere.Position(), radius), d);
}

Result<OffsetSurface> offset_torus(const InputFace &input, const Geom_ToroidalSurface &torus, double d)
{
    const double s = handedness(torus.Position());
    const double minor = torus.MinorRadius() + s * d;
    if (minor <= 0.0)
        return folded(input, d, -s * torus.MinorRadius(), {input.box.umin, input.box.vmin});
    // On the inner side the offset tube reaches the axis where R + (r + d) cos v = 0.
    const double turn = 2.0 * M_PI;
    const double inner = M_PI + turn * std::ceil((input.box.vmin - M_PI) / turn);
    const double v = inner <= input.box.vmax                               ? inner
                     : std::cos(input.box.vmin) < std::cos(input.box.vmax) ? input.box.vmin
                                                                           : input.box.vmax;
    const double cosine = std::cos(v);
    if (cosine < 0.0 && torus.MajorRadius() + minor * cosine <= 0.0)
        return folded(input, d, s * (-torus.MajorRadius() / cosine - torus.MinorRadius()), {input.box.umin, v});
    return exact(input, new Geom_ToroidalSurface(torus.Position(), torus.MajorRadius(), minor), d);
}

//! S(u, v) = P + (R + v sin a) radial(u) + v cos a Z, so S + d N has the radius R + d cos a at v = 0 and
//! its origin lower by d sin a.
Result<OffsetSurface> offset_cone(const InputFace &input, const Geom_ConicalSurface &cone, double d)
{
    const double s = handedness(cone.Position());
    const double angle = cone.SemiAngle();
    const auto radius_at = [&](double v, double distance) {
        return cone.RefRadius() + v * std::sin(angle) + s * distance * std::cos(angle);
    };
    const bool low_is_tight = radius_at(input.box.vmin, 0.0) < radius_at(input.box.vmax, 0.0);
    const double tight = low_is_tight ? input.box.vmin : input.box.vmax;
    // On the far nappe (negative radius) the surface normal has turned over: keep to one nappe.
    const double base_radius = radius_at(tight, 0.0);
    const double tiny = 1e-9 * input.diagonal;
    if (base_radius < -tiny || (s * d < 0.0 && radius_at(tight, d) <= 0.0))
        return folded(input, d, -s * std::max(0.0, base_radius) / std::cos(angle), {input.box.umin, tight});
    gp_Ax3 position = cone.Position();
    double radius = radius_at(0.0, d);
    double shift = 0.0;
    if (radius < 0.0) // the reference circle would turn inside out: measure v from the tight end instead
    {
        shift = -tight;
        radius = std::max(0.0, radius_at(tight, d));
        position.Translate(tight * std::cos(angle) * gp_Vec(position.Direction()));
    }
    position.Translate(-s * d * std::sin(angle) * gp_Vec(position.Direction()));
    OffsetSurface result = exact(input, new Geom_ConicalSurface(position, angle, radius), d);
    result.parameter_shift = gp_Vec2d(0.0, shift);
    return result;
}

} // namespace

std::optional<Result<OffsetSurface>> exact_offset(const InputFace &input, double distance)
{
    const Handle(Geom_Surface) &base = input.surface;
    if (const auto plane = Handle(Geom_Plane)::DownCast(base))
        return offset_plane(input, *plane, distance);
    if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(base))
        return offset_cylinder(input, *cylinder, distance);
    if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(base))
        return offset_cone(input, *cone, distance);
    if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(base))
        return offset_sphere(input, *sphere, distance);
    if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(base))
        return offset_torus(input, *torus, distance);
    return std::nullopt;
}

} // namespace laminate_offset
