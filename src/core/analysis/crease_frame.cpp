// SPDX-License-Identifier: LGPL-2.1-or-later
#include "crease_frame.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

Reach operator-(const Reach &a, const Reach &b) { return {a.low - b.high, a.high - b.low}; }

Reach operator*(const Reach &a, const Reach &b)
{
    const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    return {low, high};
}

double largest_length(const Eigen::AlignedBox3d &box)
{
    return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).norm();
}

//! How the surfaces' derivatives run across and along a crease, as rows that take the middle ones to unit vectors.
class CreaseFrame
{
public:
    explicit CreaseFrame(const CreaseNeighbours &pair)
        : m_constant_u(pair.constant_u), m_before(pair.lower.over(pair.before)), m_after(pair.upper.over(pair.after))
    {
    }

    //! False: the bounds are too wide to tell anything.
    bool make()
    {
        Eigen::Vector3d across = Eigen::Vector3d::Zero(), along = Eigen::Vector3d::Zero();
        for (const auto *side : {&m_before, &m_after})
            for (const PatchBounds &bounds : *side)
            {
                if (bounds.du.isEmpty() || bounds.dv.isEmpty())
                    return false;
                across += this->across(bounds).center().normalized();
                along += this->along(bounds).center().normalized();
            }
        row_across = across - across.dot(along) / std::max(along.squaredNorm(), 1e-300) * along;
        row_along = along - along.dot(across) / std::max(across.squaredNorm(), 1e-300) * across;
        for (const auto *side : {&m_before, &m_after})
            for (const PatchBounds &bounds : *side)
            {
                least_across = std::min(least_across, Reach::of(row_across, this->across(bounds)).low);
                least_along = std::min(least_along, Reach::of(row_along, this->along(bounds)).low);
                skew_across = std::max(skew_across, Reach::of(row_across, this->along(bounds)).largest());
                skew_along = std::max(skew_along, Reach::of(row_along, this->across(bounds)).largest());
            }
        return least_across > 0.0 && least_along > 0.0 && least_across * least_along > skew_across * skew_along;
    }

    //! The range of a row times the step from the lower part's surfaces to the upper part's, anywhere on the crease.
    [[nodiscard]] Reach step(const Eigen::Vector3d &row, const std::vector<Eigen::Vector3d> &before,
                             const std::vector<Eigen::Vector3d> &after, double half_length) const
    {
        Reach step;
        for (std::size_t i = 0; i < before.size(); ++i)
            for (std::size_t j = 0; j < after.size(); ++j)
            {
                const double here = row.dot(after[j] - before[i]);
                const Reach slope_after = Reach::of(row, along(m_after[j])),
                            slope_before = Reach::of(row, along(m_before[i]));
                const double change = half_length * std::max(std::abs(slope_after.high - slope_before.low),
                                                             std::abs(slope_after.low - slope_before.high));
                step.extend({here - change, here + change});
            }
        return step;
    }

    //! Do the slopes across the crease, at places equally far along it, differ all over the two patches in one sense? Then
    //! the surfaces come upon each other once at most for each place along.
    [[nodiscard]] bool slopes_apart() const
    {
        if (m_before.size() != 1 || m_after.size() != 1)
            return false;
        const Reach before = slope(m_before.front()), after = slope(m_after.front());
        return before.high < after.low || after.high < before.low;
    }

    Eigen::Vector3d row_across;
    Eigen::Vector3d row_along;
    double least_across = infinity;
    double least_along = infinity;
    double skew_across = 0.0;
    double skew_along = 0.0;

    [[nodiscard]] const Eigen::AlignedBox3d &across(const PatchBounds &bounds) const
    {
        return m_constant_u ? bounds.du : bounds.dv;
    }
    [[nodiscard]] const Eigen::AlignedBox3d &along(const PatchBounds &bounds) const
    {
        return m_constant_u ? bounds.dv : bounds.du;
    }

private:
    //! Height over way across, where the way along stays the same.
    [[nodiscard]] Reach slope(const PatchBounds &bounds) const
    {
        const Eigen::Vector3d height = row_across.cross(row_along).normalized();
        const auto of = [](const Eigen::Vector3d &row, const Eigen::AlignedBox3d &box) { return Reach::of(row, box); };
        const Eigen::AlignedBox3d &a = across(bounds), &l = along(bounds);
        const Reach rise = of(height, a) * of(row_along, l) - of(height, l) * of(row_along, a);
        const Reach way = of(row_across, a) * of(row_along, l) - of(row_across, l) * of(row_along, a);
        if (way.low <= 0.0)
            return {-infinity, infinity};
        return rise * Reach{1.0 / way.high, 1.0 / way.low};
    }

    bool m_constant_u;
    std::vector<PatchBounds> m_before;
    std::vector<PatchBounds> m_after;
};

} // namespace

double farthest_base_points(const CreaseNeighbours &pair)
{
    CreaseFrame frame(pair);
    if (!frame.make())
        return infinity;
    const bool of_u = pair.constant_u;
    const double along =
        of_u ? 0.5 * (pair.before.vmin + pair.before.vmax) : 0.5 * (pair.before.umin + pair.before.umax);
    const double half =
        of_u ? 0.5 * (pair.before.vmax - pair.before.vmin) : 0.5 * (pair.before.umax - pair.before.umin);
    const double after_along =
        of_u ? 0.5 * (pair.after.vmin + pair.after.vmax) : 0.5 * (pair.after.umin + pair.after.umax);
    const auto before = of_u ? pair.lower.points(pair.before.umax, along) : pair.lower.points(along, pair.before.vmax);
    const auto after =
        of_u ? pair.upper.points(pair.after.umin, after_along) : pair.upper.points(after_along, pair.after.vmin);
    const double opening = frame.step(frame.row_across, before, after, half).low;
    const double sideways = frame.step(frame.row_along, before, after, half).largest();
    const double room = frame.least_across - frame.skew_across * frame.skew_along / frame.least_along;
    const double x = (frame.skew_across * sideways / frame.least_along - opening) / room;
    if (x < 0.0)
        return 0.0;
    const double y = (x * frame.skew_along + sideways) / frame.least_along;
    PatchBounds base = pair.lower.base_over(pair.before);
    base.extend(pair.upper.base_over(pair.after));
    return x * largest_length(frame.across(base)) + y * largest_length(frame.along(base));
}

bool cross_once(const CreaseNeighbours &pair)
{
    CreaseFrame frame(pair);
    return frame.make() && frame.slopes_apart();
}

} // namespace laminate_offset
