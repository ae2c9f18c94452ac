// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analytic_nearest.h"

#include "../spline/geom_values.h"

#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

constexpr double whole_turn = 2.0 * M_PI;
// A box as wide as a period may be wider by rounding.
constexpr double rounding = 1e-12;
// Lengths of the frame against the size of the box: rounding grows with them.
constexpr double most_reach = 1e3;

Eigen::Vector2d direction_of(double angle) { return {std::cos(angle), std::sin(angle)}; }

} // namespace

AnalyticNearest::Range AnalyticNearest::angles(double low, double high)
{
    return {low, high, direction_of(low), direction_of(high)};
}

std::optional<AnalyticNearest> AnalyticNearest::make(const Handle(Geom_Surface) & surface, const ParameterBox &box,
                                                     const gp_Vec2d &shift)
{
    AnalyticNearest result;
    if (!result.take_kind(surface))
        return std::nullopt;
    const gp_Ax3 &frame = Handle(Geom_ElementarySurface)::DownCast(surface)->Position();
    result.m_origin = vector(frame.Location().XYZ());
    result.m_frame << vector(frame.XDirection().XYZ()), vector(frame.YDirection().XYZ()),
        vector(frame.Direction().XYZ());
    result.m_shift = {shift.X(), shift.Y()};
    result.m_u = angles(box.umin + shift.X(), box.umax + shift.X());
    result.m_v = angles(box.vmin + shift.Y(), box.vmax + shift.Y());
    return result.admissible() ? std::optional<AnalyticNearest>(result) : std::nullopt;
}

bool AnalyticNearest::take_kind(const Handle(Geom_Surface) & surface)
{
    if (!Handle(Geom_Plane)::DownCast(surface).IsNull())
        return true;
    if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface))
    {
        m_kind = Kind::Line;
        m_start = {cylinder->Radius(), 0.0};
        return true;
    }
    if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface))
    {
        m_kind = Kind::Line;
        m_start = {cone->RefRadius(), 0.0};
        m_along = {std::sin(cone->SemiAngle()), std::cos(cone->SemiAngle())};
        return true;
    }
    m_kind = Kind::Circle;
    if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface))
    {
        m_radius = sphere->Radius();
        return true;
    }
    if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface))
    {
        m_start = {torus->MajorRadius(), 0.0};
        m_radius = torus->MinorRadius();
        m_two_sided = m_radius > m_start.x();
        return true;
    }
    return false;
}

bool AnalyticNearest::admissible()
{
    const double width_u = m_u.high - m_u.low;
    const double width_v = m_v.high - m_v.low;
    double reach = m_start.x() + m_radius;
    double size = m_radius * width_v;
    if (m_kind == Kind::Plane)
    {
        reach = std::max({std::abs(m_u.low), std::abs(m_u.high), std::abs(m_v.low), std::abs(m_v.high)});
        size = std::max(width_u, width_v);
        return reach <= most_reach * size;
    }
    if (m_kind == Kind::Line)
    {
        const double at_low = m_start.x() + m_v.low * m_along.x();
        const double at_high = m_start.x() + m_v.high * m_along.x();
        // a tip that oversteps the apex by rounding has no other side
        m_two_sided = std::min(at_low, at_high) < -rounding * std::max(std::abs(at_low), std::abs(at_high));
        reach = m_start.x() + std::max(std::abs(m_v.low), std::abs(m_v.high));
        size = std::max(width_v, std::max(std::abs(at_low), std::abs(at_high)) * std::min(width_u, 1.0));
    }
    const bool narrow =
        width_u <= whole_turn * (1.0 + rounding) && (m_kind == Kind::Line || width_v <= whole_turn * (1.0 + rounding));
    return narrow && reach <= most_reach * size;
}

AnalyticNearest::Turn AnalyticNearest::turned_to(const Range &range, const Eigen::Vector2d &direction)
{
    const double length = direction.norm();
    if (!(length > 0.0))
        return {range.low, range.at_low};
    double turn = std::atan2(direction.y(), direction.x()) - range.low;
    turn -= whole_turn * std::floor(turn / whole_turn);
    const double width = range.high - range.low;
    if (turn <= width)
        return {range.low + turn, direction / length};
    return turn - width < whole_turn - turn ? Turn{range.high, range.at_high} : Turn{range.low, range.at_low};
}

AnalyticNearest::InPlane AnalyticNearest::on_profile(const Eigen::Vector2d &point) const
{
    if (m_kind == Kind::Circle)
    {
        const Turn turn = turned_to(m_v, point - m_start);
        return {turn.angle, m_start + m_radius * turn.direction};
    }
    const double v = std::clamp((point - m_start).dot(m_along), m_v.low, m_v.high);
    return {v, m_start + v * m_along};
}

//! With the angle as near as it may be to a direction across the axis.
SurfaceFoot AnalyticNearest::turned(const Eigen::Vector3d &local, const Eigen::Vector2d &towards) const
{
    const Turn turn = turned_to(m_u, towards);
    const InPlane place = on_profile({local.x() * turn.direction.x() + local.y() * turn.direction.y(), local.z()});
    const Eigen::Vector3d foot(place.point.x() * turn.direction.x(), place.point.x() * turn.direction.y(),
                               place.point.y());
    return {{turn.angle, place.v}, foot, (foot - local).norm()};
}

SurfaceFoot AnalyticNearest::on_plane(const Eigen::Vector3d &local) const
{
    const Eigen::Vector3d foot(std::clamp(local.x(), m_u.low, m_u.high), std::clamp(local.y(), m_v.low, m_v.high), 0.0);
    return {foot.head<2>(), foot, (foot - local).norm()};
}

SurfaceFoot AnalyticNearest::nearest(const Eigen::Vector3d &point) const
{
    const Eigen::Vector3d local = m_frame.transpose() * (point - m_origin);
    SurfaceFoot best = m_kind == Kind::Plane ? on_plane(local) : turned(local, local.head<2>());
    if (m_two_sided)
    {
        const SurfaceFoot opposite = turned(local, -local.head<2>());
        if (opposite.distance < best.distance)
            best = opposite;
    }
    best.uv -= m_shift;
    best.point = m_origin + m_frame * best.point;
    return best;
}

} // namespace laminate_offset
