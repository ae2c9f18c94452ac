// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The nearest point of a surface (paper 3.3.2): Bezier patches in a binary tree of boxes, branch and bound, Newton on
//! eq. 3.14, and a proof that nothing nearer was missed.
//!
//! A patch whose box, or whose plane less its bulge, is farther than the best point so far is passed over. In any other one
//! (S - P).S_u = (S - P).S_v = 0 (eq. 3.14) is solved by damped Newton steps kept inside the patch, so that a nearest
//! point on a border is found as such. Where bounds of the Hessian show that |S - P|^2 is convex over the patch, that is
//! the patch's nearest point. Elsewhere h = |N - w P|^2 - m^2 w^2, with m the best distance so far, is taken in Bernstein form
//! (S = N / w): the patch is halved until no coefficient is below zero by more than the slack, or h is convex; for a rational
//! patch it has to be convex at the least possible distance too, which makes the sets |S - P| < r convex for all r between.
//!
//! All members are const and safe to share between threads.
#pragma once

#include "exact_spline.h"
#include "patch_leaf.h"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace laminate_offset
{

//! A point of the surface.
struct SurfaceFoot
{
    Eigen::Vector2d uv{0.0, 0.0}; //!< in the surface's own parameters
    Eigen::Vector3d point{0.0, 0.0, 0.0};
    double distance = 0.0; //!< to the point that was asked for [mm]
};

//! Points that are farther from a surface than so many times its size are brought nearer first. A point moved along its line
//! to the surface's middle, from the distance L to M sizes s, finds a foot that is farther than the nearest one by
//! s / (8 M) at most, which is less than the last bit of L.
inline constexpr double most_sizes = 1e8;

class NearestSearch
{
public:
    explicit NearestSearch(ExactSpline surface);

    //! The nearest point over the whole box, within slack() of the least distance.
    //! Precondition: the point is no farther away than most_sizes times the hull's diagonal; beyond that rounding
    //! decides.
    [[nodiscard]] SurfaceFoot nearest(const Eigen::Vector3d &point) const;

    //! The same, faster where the surface at `guess` is near.
    [[nodiscard]] SurfaceFoot nearest(const Eigen::Vector3d &point, const Eigen::Vector2d &guess) const;

    //! Downhill from `guess` to the next local minimum: for marching along a curve without jumps.
    [[nodiscard]] SurfaceFoot follow(const Eigen::Vector3d &point, const Eigen::Vector2d &guess) const;

    //! Which parts of the surface count.
    struct Region
    {
        std::function<bool(const ParameterBox &)> may_touch; //!< false: no point of the rectangle counts
        std::function<bool(const ParameterBox &)> touches;   //!< the same, sharper on small rectangles
        std::function<bool(const Eigen::Vector2d &)> contains;
    };
    //! Tells for every leaf whether it may touch the region; leaves() of them.
    [[nodiscard]] std::vector<char> touched(const Region &region) const;
    //! The nearest point inside a region that is nearer than `best`, the nearest point of its border.
    [[nodiscard]] SurfaceFoot nearest(const Eigen::Vector3d &point, const SurfaceFoot &best, const Region &region,
                                      const std::vector<char> &touched) const;

    //! Point and derivatives in the surface's own parameters' spline.
    [[nodiscard]] const ExactSpline &surface() const { return m_surface; }
    [[nodiscard]] std::size_t leaves() const { return m_leaves.size(); }
    //! What a distance may be too large by [mm].
    [[nodiscard]] double slack() const { return m_slack; }
    //! A box around the surface.
    [[nodiscard]] Eigen::AlignedBox3d hull() const;

private:
    friend class NearestQuery;
    struct Node
    {
        Eigen::AlignedBox3d hull;
        ParameterBox box;
        int lower = -1; //!< children; -1 for a leaf
        int upper = -1;
        int leaf = -1;
    };

    int build(SplinePieces &cutter, const std::vector<double> &us, const std::vector<double> &vs,
              const std::array<std::size_t, 4> &range);
    int add_leaf(PatchLeaf leaf, int depth);
    void join(int index, int lower, int upper);
    [[nodiscard]] int leaf_at(const Eigen::Vector2d &st) const;
    [[nodiscard]] Eigen::Vector2d to_surface(const PatchLeaf &leaf, double x, double y) const;
    [[nodiscard]] ParameterBox to_surface(const PatchLeaf &leaf, const UnitBox &box) const;

    ExactSpline m_surface;
    Eigen::Vector3d m_origin = Eigen::Vector3d::Zero();
    std::vector<Node> m_nodes;
    std::vector<PatchLeaf> m_leaves;
    double m_slack = 0.0;
};

} // namespace laminate_offset
