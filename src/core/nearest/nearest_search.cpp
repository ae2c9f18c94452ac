// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nearest_search.h"

#include "descent.h"
#include "distance_proof.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace laminate_offset
{
namespace
{

// What a distance may be too large by, against the size of the surface.
constexpr double slack_share = 1e-11;
constexpr int most_hops = 400;
constexpr int most_halvings = 8;
constexpr std::size_t deepest_stack = 128;
constexpr double infinity = std::numeric_limits<double>::infinity();

ParameterBox around(const ParameterBox &a, const ParameterBox &b)
{
    return {std::min(a.umin, b.umin), std::max(a.umax, b.umax), std::min(a.vmin, b.vmin), std::max(a.vmax, b.vmax)};
}

} // namespace

//! One search: the best point so far and the way down the tree.
class NearestQuery
{
public:
    NearestQuery(const NearestSearch &search, const Eigen::Vector3d &point)
        : m_search(search), m_point(point - search.m_origin)
    {
    }

    //! Only points of a region count.
    void restrict_to(const NearestSearch::Region &region, const std::vector<char> &touched)
    {
        m_region = &region;
        m_touched = &touched;
    }

    void start_from(const SurfaceFoot &best)
    {
        m_best = best;
        m_limit = best.distance;
    }

    void try_leaf(int index)
    {
        const PatchLeaf &leaf = m_search.m_leaves[static_cast<std::size_t>(index)];
        solve(leaf, leaf.nearest_on_plane(m_point));
    }

    //! Leaves that may hold the nearest point are gathered first, with what their planes say, then solved from the nearest
    //! one on: most of them are out of reach by then.
    void search()
    {
        static thread_local std::vector<Candidate> candidates;
        gather(candidates);
        std::sort(candidates.begin(), candidates.end(),
                  [](const Candidate &a, const Candidate &b) { return a.plane.distance < b.plane.distance; });
        for (const Candidate &candidate : candidates)
            solve(m_search.m_leaves[static_cast<std::size_t>(candidate.leaf)], candidate.plane);
    }

    [[nodiscard]] const SurfaceFoot &best() const { return m_best; }

    //! The same, moved on where the search ended between two leaves: a distance within the slack of the least one leaves
    //! room for a step along the surface.
    [[nodiscard]] SurfaceFoot settled() const
    {
        if (!m_between_leaves)
            return m_best;
        const SurfaceFoot further = m_search.follow(m_point + m_search.m_origin, m_best.uv);
        return further.distance < m_best.distance ? further : m_best;
    }

private:
    struct Candidate
    {
        int leaf = 0;
        PatchLeaf::Plane plane;
    };

    static double square(double x) { return x * x; }

    void gather(std::vector<Candidate> &candidates)
    {
        candidates.clear();
        double most = m_limit;
        std::array<std::pair<double, int>, deepest_stack> stack;
        std::size_t count = 0;
        stack[count++] = {0.0, 0};
        while (count > 0)
        {
            const auto [away, index] = stack[--count];
            if (away > square(most))
                continue;
            const NearestSearch::Node &node = m_search.m_nodes[static_cast<std::size_t>(index)];
            if (node.lower < 0)
            {
                add(node.leaf, most, candidates);
                continue;
            }
            std::pair<double, int> near{away_from(node.lower), node.lower};
            std::pair<double, int> far{away_from(node.upper), node.upper};
            if (near.first > far.first)
                std::swap(near, far);
            stack[count++] = far;
            stack[count++] = near;
        }
    }

    void add(int index, double &most, std::vector<Candidate> &candidates) const
    {
        if (m_touched && (*m_touched)[static_cast<std::size_t>(index)] == 0)
            return;
        const PatchLeaf::Plane plane = m_search.m_leaves[static_cast<std::size_t>(index)].nearest_on_plane(m_point);
        if (plane.least > most)
            return;
        candidates.push_back({index, plane});
        if (!m_touched) // with a region, the point in question may not count
            most = std::min(most, plane.most);
    }

    void solve(const PatchLeaf &leaf, const PatchLeaf::Plane &plane)
    {
        if (plane.least >= reachable())
            return;
        const PatchLeaf::Focus focus = leaf.focus(m_point);
        const LeafFoot foot = descend(leaf, m_point, focus.box, plane.x, plane.y, focus.convex, square(reachable()));
        offer(leaf, foot);
        if (reachable() == 0.0 || (focus.convex && (foot.least >= square(reachable()) || is_least(foot))))
            return;
        std::function<bool(const UnitBox &)> touches;
        if (m_region)
            touches = [&](const UnitBox &part) { return m_region->touches(m_search.to_surface(leaf, part)); };
        prove_distance(
            {leaf, m_point, plane.least, touches}, [&] { return reachable(); },
            [&](const LeafFoot &found) { offer(leaf, found); });
    }

    //! Only what is nearer than this is of interest.
    [[nodiscard]] double reachable() const { return std::max(0.0, m_limit - m_search.m_slack); }

    [[nodiscard]] bool is_least(const LeafFoot &foot) const
    {
        return foot.square - foot.least <= m_search.m_slack * (2.0 * std::sqrt(foot.square) + m_search.m_slack);
    }

    [[nodiscard]] double away_from(int node) const
    {
        return m_search.m_nodes[static_cast<std::size_t>(node)].hull.squaredExteriorDistance(m_point);
    }

    void offer(const PatchLeaf &leaf, const LeafFoot &foot)
    {
        if (!(foot.square < m_limit * m_limit))
            return;
        const Eigen::Vector2d uv = m_search.to_surface(leaf, foot.x, foot.y);
        if (m_region && !m_region->contains(uv))
            return;
        m_limit = std::sqrt(foot.square);
        m_best = {uv, foot.point + m_search.m_origin, m_limit};
        m_between_leaves = foot.x <= 0.0 || foot.x >= 1.0 || foot.y <= 0.0 || foot.y >= 1.0;
    }

    const NearestSearch &m_search;
    Eigen::Vector3d m_point;
    SurfaceFoot m_best;
    double m_limit = infinity;
    bool m_between_leaves = false;
    const NearestSearch::Region *m_region = nullptr;
    const std::vector<char> *m_touched = nullptr;
};

NearestSearch::NearestSearch(ExactSpline surface) : m_surface(std::move(surface))
{
    const TensorSpline &spline = m_surface.spline;
    const std::vector<double> us = spline.u.breaks();
    const std::vector<double> vs = spline.v.breaks();
    SplinePieces cutter(spline, us, vs);
    m_origin = cutter.near_point((us.size() - 1) / 2, (vs.size() - 1) / 2);
    build(cutter, us, vs, {0, us.size() - 1, 0, vs.size() - 1});
    m_slack = slack_share * m_nodes.front().hull.diagonal().norm();
}

int NearestSearch::build(SplinePieces &cutter, const std::vector<double> &us, const std::vector<double> &vs,
                         const std::array<std::size_t, 4> &range)
{
    const auto [i0, i1, j0, j1] = range;
    if (i1 - i0 == 1 && j1 - j0 == 1)
    {
        RationalPiece piece;
        cutter.cut(i0, j0, m_origin, piece);
        return add_leaf(make_leaf({us[i0], us[i1], vs[j0], vs[j1]}, std::move(piece)), 0);
    }
    const int index = static_cast<int>(m_nodes.size());
    m_nodes.emplace_back();
    const bool along_u = i1 - i0 >= j1 - j0;
    const std::size_t middle = along_u ? (i0 + i1) / 2 : (j0 + j1) / 2;
    std::array<std::size_t, 4> low = range;
    std::array<std::size_t, 4> high = range;
    low[along_u ? 1 : 3] = high[along_u ? 0 : 2] = middle;
    const int lower = build(cutter, us, vs, low);
    const int upper = build(cutter, us, vs, high);
    join(index, lower, upper);
    return index;
}

int NearestSearch::add_leaf(PatchLeaf leaf, int depth)
{
    const int index = static_cast<int>(m_nodes.size());
    const Bend bend = depth < most_halvings ? bend_of(leaf) : Bend::None;
    if (bend == Bend::None)
    {
        m_nodes.push_back({leaf.hull, leaf.box, -1, -1, static_cast<int>(m_leaves.size())});
        m_leaves.push_back(std::move(leaf));
        return index;
    }
    m_nodes.emplace_back();
    auto [low, high] = halves(leaf, bend == Bend::AlongU);
    const int lower = add_leaf(std::move(low), depth + 1);
    const int upper = add_leaf(std::move(high), depth + 1);
    join(index, lower, upper);
    return index;
}

void NearestSearch::join(int index, int lower, int upper)
{
    const Node &low = m_nodes[static_cast<std::size_t>(lower)];
    const Node &high = m_nodes[static_cast<std::size_t>(upper)];
    m_nodes[static_cast<std::size_t>(index)] = {low.hull.merged(high.hull), around(low.box, high.box), lower, upper,
                                                -1};
}

Eigen::Vector2d NearestSearch::to_surface(const PatchLeaf &leaf, double x, double y) const
{
    return {m_surface.u.to_surface(leaf.u_at(x)), m_surface.v.to_surface(leaf.v_at(y))};
}

ParameterBox NearestSearch::to_surface(const PatchLeaf &leaf, const UnitBox &box) const
{
    const Eigen::Vector2d low = to_surface(leaf, box.x0, box.y0);
    const Eigen::Vector2d high = to_surface(leaf, box.x1, box.y1);
    return {low.x(), high.x(), low.y(), high.y()};
}

int NearestSearch::leaf_at(const Eigen::Vector2d &st) const
{
    int index = 0;
    while (m_nodes[static_cast<std::size_t>(index)].lower >= 0)
    {
        const Node &node = m_nodes[static_cast<std::size_t>(index)];
        const ParameterBox &low = m_nodes[static_cast<std::size_t>(node.lower)].box;
        const bool in_lower = low.umax < node.box.umax ? st.x() < low.umax : st.y() < low.vmax;
        index = in_lower ? node.lower : node.upper;
    }
    return m_nodes[static_cast<std::size_t>(index)].leaf;
}

SurfaceFoot NearestSearch::nearest(const Eigen::Vector3d &point) const
{
    NearestQuery query(*this, point);
    query.search();
    return query.settled();
}

SurfaceFoot NearestSearch::nearest(const Eigen::Vector3d &point, const Eigen::Vector2d &guess) const
{
    NearestQuery query(*this, point);
    query.try_leaf(leaf_at({m_surface.u.to_spline(guess.x()), m_surface.v.to_spline(guess.y())}));
    query.search();
    return query.settled();
}

SurfaceFoot NearestSearch::follow(const Eigen::Vector3d &point, const Eigen::Vector2d &guess) const
{
    Eigen::Vector2d st(m_surface.u.to_spline(guess.x()), m_surface.v.to_spline(guess.y()));
    const Eigen::Vector3d p = point - m_origin;
    SurfaceFoot foot;
    double reached = infinity;
    for (int hop = 0; hop < most_hops; ++hop)
    {
        const PatchLeaf &leaf = m_leaves[static_cast<std::size_t>(leaf_at(st))];
        const ParameterBox &box = leaf.box;
        const LeafFoot local = descend(leaf, p, {}, (st.x() - box.umin) / (box.umax - box.umin),
                                       (st.y() - box.vmin) / (box.vmax - box.vmin), false, 0.0);
        if (!(local.square < reached))
            break;
        reached = local.square;
        foot = {to_surface(leaf, local.x, local.y), local.point + m_origin, std::sqrt(local.square)};
        const bool at_border = local.x <= 0.0 || local.x >= 1.0 || local.y <= 0.0 || local.y >= 1.0;
        if (!at_border)
            break;
        // the smallest step beyond the border finds the neighbour; on the surface's own border the leaf itself
        const auto beyond = [](double t, double low, double high) {
            return t <= 0.0 ? std::nextafter(low, low - 1.0) : t >= 1.0 ? high : low + t * (high - low);
        };
        st = {beyond(local.x, box.umin, box.umax), beyond(local.y, box.vmin, box.vmax)};
    }
    return foot;
}

Eigen::AlignedBox3d NearestSearch::hull() const
{
    return Eigen::AlignedBox3d(m_nodes.front().hull).translate(m_origin);
}

std::vector<char> NearestSearch::touched(const Region &region) const
{
    std::vector<char> result;
    for (const PatchLeaf &leaf : m_leaves)
        result.push_back(region.may_touch(to_surface(leaf, UnitBox{})) ? 1 : 0);
    return result;
}

SurfaceFoot NearestSearch::nearest(const Eigen::Vector3d &point, const SurfaceFoot &best, const Region &region,
                                   const std::vector<char> &touched) const
{
    NearestQuery query(*this, point);
    query.restrict_to(region, touched);
    query.start_from(best);
    query.search();
    return query.best();
}

} // namespace laminate_offset
