// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analytic_form.h"

#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax3.hxx>

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

// Directions are normalised and points transformed in a few operations each; what differs by more is another shape.
constexpr double same = 64.0 * std::numeric_limits<double>::epsilon();
// A circle's centre is meant to lie on its axis if it is as near in proportion to the radius, too.
constexpr double meant_on_axis_share = 1e-6;
// A revolved line that rises less than this is a disc, whose parameters no plane has.
constexpr double least_rise = 1e-6;

Handle(Geom_Curve) untrimmed(Handle(Geom_Curve) curve)
{
    while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve))
        curve = trimmed->BasisCurve();
    return curve;
}

//! Axes with Y = around x X where `around` is the direction that angles turn about: left-handed if `main` is opposite.
gp_Ax3 axes(const gp_Pnt &origin, const gp_Vec &main, const gp_Vec &x, const gp_Vec &around)
{
    gp_Ax3 result(origin, gp_Dir(main), gp_Dir(x));
    if (main.Dot(around) < 0.0)
        result.YReverse();
    return result;
}

AnalyticForm form(const Handle(Geom_Surface) & surface, double shift_v = 0.0)
{
    return {surface, {0.0, shift_v}, {}, true};
}

std::optional<AnalyticForm> extruded(const Geom_SurfaceOfLinearExtrusion &extrusion)
{
    const Handle(Geom_Curve) profile = untrimmed(extrusion.BasisCurve());
    const gp_Vec along(extrusion.Direction());
    if (const auto line = Handle(Geom_Line)::DownCast(profile))
    {
        const gp_Vec t(line->Position().Direction());
        if (std::abs(t.Dot(along)) > same)
            return std::nullopt;
        return form(new Geom_Plane(gp_Ax3(line->Position().Location(), gp_Dir(t.Crossed(along)), gp_Dir(t))));
    }
    if (const auto circle = Handle(Geom_Circle)::DownCast(profile))
    {
        const gp_Vec normal(circle->Position().Direction());
        if (normal.Crossed(along).Magnitude() > same)
            return std::nullopt;
        const gp_Vec x(circle->Position().XDirection());
        return form(new Geom_CylindricalSurface(axes(circle->Location(), along, x, normal), circle->Radius()));
    }
    return std::nullopt;
}

//! A profile curve seen from the axis that it is revolved about.
class Revolved
{
public:
    Revolved(const Geom_SurfaceOfRevolution &surface, const ParameterBox &box)
        : m_box(box), m_middle(0.5 * (box.vmin + box.vmax)), m_profile(untrimmed(surface.BasisCurve())),
          m_origin(surface.Location()), m_z(surface.Direction())
    {
    }

    [[nodiscard]] std::optional<AnalyticForm> form_of_profile() const
    {
        if (const auto line = Handle(Geom_Line)::DownCast(m_profile))
            return revolved_line(line->Position());
        if (const auto circle = Handle(Geom_Circle)::DownCast(m_profile))
            return revolved_circle(*circle);
        return std::nullopt;
    }

private:
    [[nodiscard]] double height(const gp_Pnt &p) const { return gp_Vec(m_origin, p).Dot(m_z); }
    [[nodiscard]] gp_Vec radial(const gp_Pnt &p) const { return gp_Vec(m_origin, p) - height(p) * m_z; }
    [[nodiscard]] gp_Pnt foot(double height) const { return m_origin.Translated(height * m_z); }
    //! Lengths below this are rounding.
    [[nodiscard]] double tiny(const gp_Pnt &p) const
    {
        return same * (p.XYZ().Modulus() + m_origin.XYZ().Modulus() + p.Distance(m_origin));
    }

    //! The direction away from the axis in the middle of the loops.
    [[nodiscard]] std::optional<gp_Vec> outwards() const
    {
        const gp_Pnt p = m_profile->Value(m_middle);
        const gp_Vec x = radial(p);
        if (!(x.Magnitude() > tiny(p)))
            return std::nullopt;
        return x.Normalized();
    }

    [[nodiscard]] std::optional<AnalyticForm> revolved_line(const gp_Ax1 &line) const
    {
        const std::optional<gp_Vec> x = outwards();
        if (!x)
            return std::nullopt;
        const gp_Pnt p = line.Location();
        const gp_Vec t(line.Direction());
        const gp_Vec y = m_z.Crossed(*x);
        if (std::abs(t.Dot(y)) > same || std::abs(radial(p).Dot(y)) > tiny(p))
            return std::nullopt;
        const double rise = t.Dot(m_z);
        const double spread = t.Dot(*x);
        const double radius = radial(p).Dot(*x);
        if (std::abs(rise) < least_rise)
            return std::nullopt;
        const gp_Vec main = rise > 0.0 ? m_z : -m_z;
        if (std::abs(spread) <= same)
            return form(new Geom_CylindricalSurface(axes(foot(height(p)), main, *x, m_z), radius));
        // v is counted from a place where the radius is positive
        const double start = radius >= 0.0 ? 0.0 : m_middle;
        const gp_Pnt origin = foot(height(p) + start * rise);
        return form(new Geom_ConicalSurface(axes(origin, main, *x, m_z), std::atan2(spread, std::abs(rise)),
                                            radius + start * spread),
                    -start);
    }

    [[nodiscard]] std::optional<AnalyticForm> revolved_circle(const Geom_Circle &circle) const
    {
        const gp_Pnt centre = circle.Location();
        const gp_Vec normal(circle.Position().Direction());
        if (std::abs(normal.Dot(m_z)) > same)
            return std::nullopt;
        const double major = radial(centre).Magnitude();
        const double beside = std::abs(radial(centre).Dot(normal)); // off the plane through the axis
        const bool exact = major <= tiny(centre);
        const bool sphere = exact || major <= std::min(meant_on_axis, meant_on_axis_share * circle.Radius());
        if (!sphere && (beside > tiny(centre) || major <= circle.Radius()))
            return std::nullopt; // no plane through the axis holds it, or it passes through the axis
        std::optional<gp_Vec> x = sphere ? outwards() : radial(centre).Normalized();
        if (!x)
            return std::nullopt;
        if (sphere)
            *x -= x->Dot(normal) * normal;
        x->Normalize();
        const gp_Vec a(circle.Position().XDirection());
        const gp_Vec b(circle.Position().YDirection());
        const double start = std::atan2(a.Dot(m_z), a.Dot(*x));
        const bool rising = b.Dot(m_z) * std::cos(start) > b.Dot(*x) * std::sin(start);
        const gp_Ax3 position = axes(foot(height(centre)), rising ? m_z : -m_z, *x, m_z);
        const double shift = rising ? start : -start;
        const double turn = 2.0 * M_PI;
        if (!sphere)
            return form(new Geom_ToroidalSurface(position, major, circle.Radius()),
                        shift - turn * std::floor((m_box.vmin + shift) / turn));
        const double latitude_shift = shift - turn * std::round((m_middle + shift) / turn);
        const double end = M_PI_2 * (1.0 + same) + (exact ? 0.0 : major / circle.Radius());
        if (m_box.vmin + latitude_shift < -end || m_box.vmax + latitude_shift > end)
            return std::nullopt; // it goes on past a pole
        AnalyticForm result = form(new Geom_SphericalSurface(position, circle.Radius()), latitude_shift);
        if (!exact)
            result.error = {major, 2.0 * beside / circle.Radius(), 0.0, 0.0};
        return result;
    }

    ParameterBox m_box;
    double m_middle;
    Handle(Geom_Curve) m_profile;
    gp_Pnt m_origin;
    gp_Vec m_z;
};

std::optional<AnalyticForm> form_of(const Handle(Geom_Surface) & surface, const ParameterBox &box)
{
    // elementary surfaces are these five kinds
    if (surface->IsKind(STANDARD_TYPE(Geom_ElementarySurface)))
        return AnalyticForm{surface};
    if (const auto extrusion = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface))
        return extruded(*extrusion);
    if (const auto revolution = Handle(Geom_SurfaceOfRevolution)::DownCast(surface))
        return Revolved(*revolution, box).form_of_profile();
    return std::nullopt;
}

//! The same points of a cone whose radii are negative all over the box: half a turn about the axis makes them positive.
AnalyticForm on_near_nappe(const AnalyticForm &far, const Geom_ConicalSurface &cone)
{
    const double sine = std::sin(cone.SemiAngle());
    const double wide = sine > 0.0 ? far.box.vmin : far.box.vmax;
    gp_Ax3 position = cone.Position();
    position.Rotate(position.Axis(), M_PI);
    position.Translate(wide * std::cos(cone.SemiAngle()) * gp_Vec(position.Direction()));
    AnalyticForm near = far;
    near.surface = new Geom_ConicalSurface(position, -cone.SemiAngle(), -(cone.RefRadius() + wide * sine));
    near.shift.SetY(far.shift.Y() - wide);
    near.box.vmin -= wide;
    near.box.vmax -= wide;
    near.disguised = true;
    return near;
}

//! Are the cone's radii negative all over the box, but for an apex?
bool past_apex(const AnalyticForm &form, const Geom_ConicalSurface &cone, double on_axis)
{
    const auto radius = [&](double v) { return cone.RefRadius() + v * std::sin(cone.SemiAngle()); };
    const double at_low = radius(form.box.vmin), at_high = radius(form.box.vmax);
    return std::max(at_low, at_high) < on_axis && std::min(at_low, at_high) < -on_axis;
}

//! The same of a torus, but for a point on the axis.
bool past_axis(const AnalyticForm &form, const Geom_ToroidalSurface &torus, double on_axis)
{
    const ParameterBox &box = form.box;
    const double turn = 2.0 * M_PI;
    const double outermost = turn * std::ceil(box.vmin / turn);
    const double cosine = outermost <= box.vmax ? 1.0 : std::max(std::cos(box.vmin), std::cos(box.vmax));
    return torus.MajorRadius() + torus.MinorRadius() * cosine < on_axis && torus.MinorRadius() > torus.MajorRadius();
}

} // namespace

std::optional<AnalyticForm> analytic_form(const InputFace &input)
{
    std::optional<AnalyticForm> form = form_of(input.surface, input.box);
    if (!form)
        return std::nullopt;
    const double on_axis = axis_slack * input.diagonal;
    const gp_Vec2d &shift = form->shift;
    form->box = {input.box.umin + shift.X(), input.box.umax + shift.X(), input.box.vmin + shift.Y(),
                 input.box.vmax + shift.Y()};
    if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(form->surface);
        !cone.IsNull() && past_apex(*form, *cone, on_axis))
        form = on_near_nappe(*form, *cone);
    if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(form->surface); !torus.IsNull())
        form->past_axis = past_axis(*form, *torus, on_axis);
    const bool direct = Handle(Geom_ElementarySurface)::DownCast(form->surface)->Position().Direct();
    form->normal_sign = direct != form->past_axis ? 1.0 : -1.0;
    return form;
}

} // namespace laminate_offset
