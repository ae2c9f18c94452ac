// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! How far places are from a ply's cut edges.
#pragma once

#include "edge_walk.h"

#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace laminate_offset
{

//! Distances in space from the samples of an edge, up to a little more than the ramp's length.
class EdgeDistance
{
public:
    EdgeDistance(const EdgeWalk &walk, double length);

    //! [mm]; infinite where no edge is near.
    [[nodiscard]] double operator()(const Eigen::Vector3d &point) const;

private:
    [[nodiscard]] std::size_t key(const Eigen::Vector3d &point, const std::array<int, 3> &step) const;

    double m_cell;
    std::unordered_map<std::size_t, std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>> m_cells;
};

} // namespace laminate_offset
