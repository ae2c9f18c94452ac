// SPDX-License-Identifier: LGPL-2.1-or-later
#include "closed_limits.h"

#include "analytic_form.h"

#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

// Of the few operations behind a limit.
constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();

//! Writes limits down by their side: inwards is against the normal that the kind has in a right-handed frame.
class LimitWriter
{
public:
    explicit LimitWriter(const AnalyticForm &form) : m_shift(form.shift), m_sign(form.normal_sign) {}

    void inwards(double length, double u, double v) { write(-m_sign, length, length, u, v); }
    //! Feasible up to a length, folded from a larger one on.
    void inwards(double length, double folds, double u, double v) { write(-m_sign, length, folds, u, v); }
    void outwards(double length, double u, double v) { write(m_sign, length, length, u, v); }
    [[nodiscard]] const ClosedLimits &limits() const { return m_limits; }

private:
    void write(double sign, double length, double folds, double u, double v)
    {
        const gp_Pnt2d uv(u - m_shift.X(), v - m_shift.Y());
        (sign < 0.0 ? m_limits.negative : m_limits.positive) = CurvatureLimit{sign * length, sign * folds, uv};
    }

    gp_Vec2d m_shift;
    double m_sign;
    ClosedLimits m_limits;
};

ClosedLimits limits_of_round(const AnalyticForm &form, double radius)
{
    LimitWriter writer(form);
    writer.inwards(radius, form.box.umin, form.box.vmin);
    return writer.limits();
}

//! Of a circle of radius R turned about an axis that misses its centre by m: with r = R cos v + e and rho^2 = r^2 + p^2 for
//! |(e, p)| = m, the surface's curvatures are at most 1 / (R - m / cos v) across the circle and (1 + p^2 / r^2) / R along it,
//! which is less where sqrt(m R) <= R cos v and m <= 1e-6 R. Both are above zero there. Along the circle it is at least
//! (1 - 3 q) / R with q = m^2 / (R cos v - m)^2.
ClosedLimits limits_of_sphere(const AnalyticForm &form, const Geom_SphericalSurface &sphere)
{
    const double beside = form.error.point;
    if (beside == 0.0)
        return limits_of_round(form, sphere.Radius());
    const double radius = sphere.Radius();
    const ParameterBox &box = form.box;
    const double v = std::abs(box.vmin) > std::abs(box.vmax) ? box.vmin : box.vmax; // nearer to a pole
    const double least_cosine = std::max(std::cos(v), std::sqrt(beside / radius));
    const double at_widest =
        box.vmin <= 0.0 && box.vmax >= 0.0 ? 0.0 : std::min(std::abs(box.vmin), std::abs(box.vmax));
    const double room = radius * std::cos(at_widest) - beside;
    const double q = room > 0.0 ? beside * beside / (room * room) : 1.0;
    const double folds =
        q < 0.1 ? radius * (1.0 + rounding) / (1.0 - 3.0 * q) : std::numeric_limits<double>::infinity();
    LimitWriter writer(form);
    writer.inwards(radius * (1.0 - rounding) - beside / least_cosine, folds, box.umin, v);
    return writer.limits();
}

//! Past the axis the tube may grow without end and shrink until it touches the axis: R + (r + d) cos v = 0.
ClosedLimits limits_past_axis(const AnalyticForm &form, const Geom_ToroidalSurface &torus)
{
    LimitWriter writer(form);
    const double v = std::cos(form.box.vmin) > std::cos(form.box.vmax) ? form.box.vmin : form.box.vmax;
    writer.inwards(std::max(0.0, torus.MinorRadius() + torus.MajorRadius() / std::cos(v)), form.box.umin, v);
    return writer.limits();
}

//! The tube ends at its own radius and, on the inner side, where it reaches the axis: R + (r + d) cos v = 0. A face that goes
//! through the axis can be offset to neither side.
ClosedLimits limits_of_torus(const AnalyticForm &form, const Geom_ToroidalSurface &torus, double tiny)
{
    if (form.past_axis)
        return limits_past_axis(form, torus);
    LimitWriter writer(form);
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
    if (room < -tiny)
        writer.inwards(0.0, box.umin, v);
    return writer.limits();
}

//! A cone ends where its tight end closes up. A face that goes through the apex can be offset to neither side.
ClosedLimits limits_of_cone(const AnalyticForm &form, const Geom_ConicalSurface &cone, double tiny)
{
    LimitWriter writer(form);
    const auto radius = [&](double v) { return cone.RefRadius() + v * std::sin(cone.SemiAngle()); };
    const double v = radius(form.box.vmin) < radius(form.box.vmax) ? form.box.vmin : form.box.vmax;
    writer.inwards(std::max(0.0, radius(v)) / std::cos(cone.SemiAngle()), form.box.umin, v);
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
    const double tiny = axis_slack * input.diagonal;
    if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(form->surface))
        return limits_of_round(*form, cylinder->Radius());
    if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(form->surface))
        return limits_of_sphere(*form, *sphere);
    if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(form->surface))
        return limits_of_cone(*form, *cone, tiny);
    if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(form->surface))
        return limits_of_torus(*form, *torus, tiny);
    return ClosedLimits{};
}

} // namespace laminate_offset
