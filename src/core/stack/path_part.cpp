// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path_part.h"

#include <algorithm>
#include <cstddef>

namespace laminate_offset
{
namespace
{

using Vector2 = Eigen::Vector2d;

//! Where two segments cross.
bool meet(const Vector2 &a, const Vector2 &b, const Vector2 &c, const Vector2 &d, double &s, double &t)
{
    const Vector2 x = b - a, y = d - c, z = c - a;
    const double turn = x.x() * y.y() - x.y() * y.x();
    if (turn == 0.0)
        return false;
    s = (z.x() * y.y() - z.y() * y.x()) / turn;
    t = (z.x() * x.y() - z.y() * x.x()) / turn;
    return s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0;
}

//! Newton's steps towards the place where both parts are one, by differences.
void refine(const PathPart &before, const PathPart &after, double &s, double &t)
{
    constexpr double step = 1e-5;
    for (int i = 0; i < 8; ++i)
    {
        const Vector2 gap = after.path(t) - before.path(s);
        const Vector2 x = (before.path(s + step) - before.path(s - step)) / (2.0 * step);
        const Vector2 y = (after.path(t + step) - after.path(t - step)) / (2.0 * step);
        const double turn = x.x() * y.y() - x.y() * y.x();
        if (turn == 0.0)
            return;
        s = std::clamp(s + (gap.x() * y.y() - gap.y() * y.x()) / turn, 0.0, 1.0);
        t = std::clamp(t + (gap.x() * x.y() - gap.y() * x.x()) / turn, 0.0, 1.0);
    }
}

} // namespace

std::vector<Vector2> traced(const std::vector<PathPart> &curves)
{
    std::vector<Vector2> points;
    for (const PathPart &curve : curves)
        for (int i = 0; i < polygon_points; ++i)
            points.push_back(curve.at(static_cast<double>(i) / polygon_points));
    points.push_back(curves.back().at(1.0));
    return points;
}

bool cut_where_they_cross(PathPart &before, PathPart &after)
{
    const auto places = [](const PathPart &part) {
        std::vector<Vector2> points;
        for (int i = 0; i <= polygon_points; ++i)
            points.push_back(part.path(static_cast<double>(i) / polygon_points));
        return points;
    };
    const std::vector<Vector2> a = places(before), b = places(after);
    for (int i = polygon_points - 1; i >= 0; --i)
        for (int j = 0; j < polygon_points; ++j)
        {
            double s = 0.0, t = 0.0;
            if (&before == &after && i <= j + 1)
                continue;
            if (!meet(a[static_cast<std::size_t>(i)], a[static_cast<std::size_t>(i) + 1],
                      b[static_cast<std::size_t>(j)], b[static_cast<std::size_t>(j) + 1], s, t))
                continue;
            s = (i + s) / polygon_points;
            t = (j + t) / polygon_points;
            refine(before, after, s, t);
            before.last = s;
            after.first = t;
            return true;
        }
    return false;
}

std::optional<Vector2> own_crossing(const std::vector<PathPart> &curves, bool closed)
{
    const std::vector<Vector2> points = traced(curves);
    const std::size_t count = points.size() - 1;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 2; j < count; ++j)
        {
            double s = 0.0, t = 0.0;
            if (closed && i == 0 && j + 1 == count)
                continue;
            if (meet(points[i], points[i + 1], points[j], points[j + 1], s, t))
                return points[i];
        }
    return std::nullopt;
}

} // namespace laminate_offset
