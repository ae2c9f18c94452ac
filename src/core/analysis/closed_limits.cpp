// SPDX-License-Identifier: LGPL-2.1-or-later
#include "closed_limits.h"

#include "analytic_form.h"

#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

//! Writes limits down by their side: inwards is against the normal that a right-handed frame gives.
class LimitWriter
{
public:
    //! S_u x S_v points outwards of the kind's right-handed normal, or inwards for a left-handed frame.
    LimitWriter(const AnalyticForm &form, const gp_Ax3 &position)
        : m_shift(form.shift), m_sign(position.Direct() ? 1.0 : -1.0)
    {
    }

    void inwards(double length, double u, double v) { write(-m_sign, length, u, v); }
    void outwards(double length, double u, double v) { write(m_sign, length, u, v); }
    [[nodiscard]] const ClosedLimits &limits() const { return m_limits; }

private:
    void write(double sign, double length, double u, double v)
    {
        const gp_Pnt2d uv(u - m_shift.X(), v - m_shift.Y());
        (sign < 0.0 ? m_limits.negative : m_limits.positive) = CurvatureLimit{sign * length, sign * length, uv};
    }

    gp_Vec2d m_shift;
    double m_sign;
    ClosedLimits m_limits;
};

ClosedLimits limits_of_round(const AnalyticForm &form, const gp_Ax3 &position, double radius)
{
    LimitWriter writer(form, position);
    writer.inwards(radius, form.box.umin, form.box.vmin);
    return writer.limits();
}

//! The tube ends at its own radius and, on the inner side, where it reaches the axis: R + (r + d) cos v = 0.
ClosedLimits limits_of_torus(const AnalyticForm &form, const Geom_ToroidalSurface &torus)
{
    LimitWriter writer(form, torus.Position());
    const ParameterBox &box = form.box;
    writer.inwards(torus.MinorRadius(), box.umin, box.vmin);
    const double turn = 2.0 * M_PI;
    const double inner = M_PI + turn * std::ceil((box.vmin - M_PI) / turn);
    const double v = inner <= box.vmax ? inner : std::cos(box.vmin) < std::cos(box.vmax) ? box.vmin : box.vmax;
    const double cosine = std::cos(v);
    if (cosine >= 0.0)
        return writer.limits();
    const double room = -torus.MajorRadius() / cosine - torus.MinorRadius();
    writer.outwards(std::max(0.0, room), box.umin, v);
    if (room <= 0.0)
        writer.inwards(0.0, box.umin, v);
    return writer.limits();
}

//! A cone ends where its tight end closes up; on the far nappe (negative radius) its normal has turned over.
ClosedLimits limits_of_cone(const AnalyticForm &form, const Geom_ConicalSurface &cone, double diagonal)
{
    LimitWriter writer(form, cone.Position());
    const auto radius = [&](double v) { return cone.RefRadius() + v * std::sin(cone.SemiAngle()); };
    const double v = radius(form.box.vmin) < radius(form.box.vmax) ? form.box.vmin : form.box.vmax;
    writer.inwards(std::max(0.0, radius(v)) / std::cos(cone.SemiAngle()), form.box.umin, v);
    const double tiny = 1e-9 * diagonal;
    if (radius(v) < -tiny)
        writer.outwards(0.0, form.box.umin, v);
    return writer.limits();
}

} // namespace

std::optional<ClosedLimits> closed_limits(const InputFace &input)
{
    const std::optional<AnalyticForm> form = analytic_form(input);
    if (!form)
        return std::nullopt;
    if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(form->surface))
        return limits_of_round(*form, cylinder->Position(), cylinder->Radius());
    if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(form->surface))
        return limits_of_round(*form, sphere->Position(), sphere->Radius());
    if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(form->surface))
        return limits_of_cone(*form, *cone, input.diagonal);
    if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(form->surface))
        return limits_of_torus(*form, *torus);
    return ClosedLimits{};
}

} // namespace laminate_offset
