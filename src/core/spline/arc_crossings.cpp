// SPDX-License-Identifier: LGPL-2.1-or-later
#include "arc_crossings.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace laminate_offset
{
namespace
{

constexpr int deepest = 60;
// Part of the tolerance within which a chord stands for its arc.
constexpr double flat_share = 0.1;

//! Distance of a point from a chord in units of the tolerance.
double from_chord(const Eigen::Vector2d &start, const Eigen::Vector2d &end, const Eigen::Vector2d &point,
                  const Eigen::Vector2d &tolerance)
{
    const Eigen::Vector2d from = (start - point).cwiseQuotient(tolerance);
    const Eigen::Vector2d along = (end - start).cwiseQuotient(tolerance);
    const double square = along.squaredNorm();
    const double s = square > 0.0 ? std::clamp(-from.dot(along) / square, 0.0, 1.0) : 0.0;
    return (from + s * along).norm();
}

bool is_flat(const ControlPoints &arc, const Eigen::Vector2d &tolerance)
{
    if (arc.size() == 2)
        return true;
    const Eigen::Vector2d start = arc.front().hnormalized();
    const Eigen::Vector2d end = arc.back().hnormalized();
    return std::all_of(arc.begin() + 1, arc.end() - 1, [&](const Eigen::Vector3d &p) {
        return from_chord(start, end, p.hnormalized(), tolerance) <= flat_share;
    });
}

//! Where the chord reaches `value` in one coordinate, its other coordinate.
double place_on_chord(const Eigen::Vector2d &start, const Eigen::Vector2d &end, int axis, double value)
{
    const double from = start[axis] - value;
    const double to = end[axis] - value;
    return start[1 - axis] + from / (from - to) * (end[1 - axis] - start[1 - axis]);
}

RayMeeting parity(bool odd) { return odd ? RayMeeting::Odd : RayMeeting::Even; }

RayMeeting meet(const ControlPoints &arc, const Eigen::Vector2d &point, const Eigen::Vector2d &tolerance, int depth)
{
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector3d &p : arc)
        box.extend(Eigen::Vector2d(p.hnormalized()));
    if (point.y() < box.min().y() - tolerance.y() || point.y() > box.max().y() + tolerance.y() ||
        point.x() > box.max().x() + tolerance.x())
        return RayMeeting::Even;
    const Eigen::Vector2d start = arc.front().hnormalized();
    const Eigen::Vector2d end = arc.back().hnormalized();
    const bool sides_differ = (start.y() > point.y()) != (end.y() > point.y());
    if (point.x() < box.min().x() - tolerance.x())
        return parity(sides_differ);
    if (depth >= deepest || is_flat(arc, tolerance))
    {
        if (from_chord(start, end, point, tolerance) <= 1.0)
            return RayMeeting::OnArc;
        return parity(sides_differ && place_on_chord(start, end, 1, point.y()) > point.x());
    }
    ControlPoints rest = arc;
    const RayMeeting first = meet(cut_off(rest, 0.5), point, tolerance, depth + 1);
    if (first == RayMeeting::OnArc)
        return first;
    const RayMeeting second = meet(rest, point, tolerance, depth + 1);
    return second == RayMeeting::OnArc ? second : parity(first != second);
}

void cross(const ControlPoints &arc, int axis, double value, const Eigen::Vector2d &tolerance, int depth,
           std::vector<double> &places)
{
    const auto beyond = [&](const Eigen::Vector3d &p) -> bool { return p[axis] / p.z() > value; };
    const bool starts_beyond = beyond(arc.front());
    if (std::all_of(arc.begin(), arc.end(), [&](const Eigen::Vector3d &p) { return beyond(p) == starts_beyond; }))
        return;
    if (depth >= deepest || is_flat(arc, tolerance))
    {
        if (beyond(arc.back()) != starts_beyond)
            places.push_back(place_on_chord(arc.front().hnormalized(), arc.back().hnormalized(), axis, value));
        return;
    }
    ControlPoints rest = arc;
    cross(cut_off(rest, 0.5), axis, value, tolerance, depth + 1, places);
    cross(rest, axis, value, tolerance, depth + 1, places);
}

} // namespace

RayMeeting meet_ray(const ControlPoints &arc, const Eigen::Vector2d &point, const Eigen::Vector2d &tolerance)
{
    return meet(arc, point, tolerance, 0);
}

void add_crossings(const ControlPoints &arc, int axis, double value, const Eigen::Vector2d &tolerance,
                   std::vector<double> &places)
{
    cross(arc, axis, value, tolerance, 0, places);
}

} // namespace laminate_offset
