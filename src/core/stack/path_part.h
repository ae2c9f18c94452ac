// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Curves in the parameters of a surface, cut where they cross each other.
#pragma once

#include <Eigen/Dense>

#include <functional>
#include <optional>
#include <vector>

namespace laminate_offset
{

//! Steps of a curve in which it is looked at, and between which it counts as straight.
constexpr int polygon_points = 96;

//! A curve in the parameters over [0, 1].
using Path = std::function<Eigen::Vector2d(double)>;

//! A curve over a part of [0, 1].
struct PathPart
{
    Path path;
    double first = 0.0;
    double last = 1.0;

    //! \param part from 0 to 1.
    [[nodiscard]] Eigen::Vector2d at(double part) const { return path(first + part * (last - first)); }
};

//! Points along curves that go on from each other, both ends included.
std::vector<Eigen::Vector2d> traced(const std::vector<PathPart> &curves);

//! Lets two parts end and begin where their whole curves cross, which may leave nothing of a short one. False where they
//! do not cross.
bool cut_where_they_cross(PathPart &before, PathPart &after);

//! A place near which curves that go on from each other cross themselves; nothing where they do not.
std::optional<Eigen::Vector2d> own_crossing(const std::vector<PathPart> &curves, bool closed);

} // namespace laminate_offset
