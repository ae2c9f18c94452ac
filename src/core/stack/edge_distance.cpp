// SPDX-License-Identifier: LGPL-2.1-or-later
#include "edge_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

double to_segment(const Eigen::Vector3d &point, const Eigen::Vector3d &a, const Eigen::Vector3d &b)
{
    const double square = (b - a).squaredNorm();
    const double t = square > 0.0 ? std::clamp((point - a).dot(b - a) / square, 0.0, 1.0) : 0.0;
    return (point - a - t * (b - a)).norm();
}

} // namespace

EdgeDistance::EdgeDistance(const EdgeWalk &walk, double length) : m_cell(1.3 * length)
{
    for (const std::vector<EdgeSample> &run : walk.runs())
        for (std::size_t i = 0; i < run.size(); ++i)
            m_cells[key(run[i].point, {0, 0, 0})].emplace_back(run[i].point, run[i + 1 < run.size() ? i + 1 : i].point);
}

double EdgeDistance::operator()(const Eigen::Vector3d &point) const
{
    double least = std::numeric_limits<double>::infinity();
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j)
            for (int k = -1; k <= 1; ++k)
                if (const auto cell = m_cells.find(key(point, {i, j, k})); cell != m_cells.end())
                    for (const auto &[a, b] : cell->second)
                        least = std::min(least, to_segment(point, a, b));
    return least;
}

std::size_t EdgeDistance::key(const Eigen::Vector3d &point, const std::array<int, 3> &step) const
{
    std::size_t hash = 0;
    for (int e = 0; e < 3; ++e)
        hash = hash * 0x9E3779B97F4A7C15ULL +
               static_cast<std::size_t>(static_cast<long long>(std::floor(point[e] / m_cell)) +
                                        step[static_cast<std::size_t>(e)]);
    return hash;
}

} // namespace laminate_offset
