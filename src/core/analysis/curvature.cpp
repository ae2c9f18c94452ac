// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curvature.h"

#include "curvature_piece.h"
#include "strip_curvature.h"

#include "../spline/knot_choice.h"

#include <Eigen/Geometry>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <vector>

namespace laminate_offset
{
namespace
{

// Pieces this many halvings deep that have no bound or a collapsed side are sampled: what is left lies at a pole.
constexpr int deepest_singular_piece = 10;
// Part of the extent below which a piece's second derivatives are rounding: eps / this^2 is still small.
constexpr double smallest_piece = 1e-5;
constexpr int most_steps = 4000; // and so many more for every whole piece:
constexpr int steps_per_piece = 8;
// Looks at pieces once a distance is decided: these, and more up to the others as long as the limit is wider than this.
constexpr int steps_after_decision = 16;
constexpr int most_steps_after_decision = 50;
constexpr double wide_gap = 0.25;
// A limit that falls short of the true one by more than half says nothing to a user.
constexpr double useless_gap = 1.0;
constexpr int most_steps_while_useless = 400; // and so many more for every whole piece:
constexpr int useless_steps_per_piece = 4;
// Sine of the angle between S_u and S_v, and ratio of their lengths, below which a place is singular.
constexpr double singular_sine = 1e-8;
// Curvature times extent below which a limit is of no interest.
constexpr double irrelevant_curvature = 1e-2;
constexpr int samples_per_interval = 4;
constexpr int least_samples = 48;
constexpr std::size_t most_boundary_places = 128;

//! The side of the search: +1 for the highest curvature, -1 for the lowest. Internally everything is
//! turned so that the most extreme value is the largest.
double turned(double sign, const std::pair<double, double> &k) { return sign > 0.0 ? k.second : -k.first; }

//! A piece of the base, or a part of one. What is found out about it serves both sides' searches.
struct Node
{
    ParameterBox box;
    int depth = 0;
    std::size_t i = 0; //!< knot intervals of the piece
    std::size_t j = 0;
    std::pair<double, double> rough;
    std::optional<std::pair<double, double>> fine;
    std::optional<std::pair<double, double>> centre; //!< curvatures attained in the middle
    std::optional<RationalPiece> piece;              //!< of a whole piece only from its first closer look on
    bool split = false;
    std::array<int, 2> halves{-1, -1}; //!< -1: outside the loops
};

struct Best
{
    double value = 0.0; //!< turned; a flat surface's extreme is 0
    gp_Pnt2d uv;
};

struct SideGoal
{
    double sign = 1.0;
    double threshold = 0.0; //!< turned curvature that has to be decided, 0 for none
    double gap = 1e-3;
    double floor = 0.0;    //!< turned curvature below which nothing matters
    bool deciding = false; //!< the search serves one distance; its limits are a by-product
};

//! The pieces that the loops touch, halved where a search asks for it.
class PieceTree
{
public:
    PieceTree(const TensorSpline &base, const LoopRegion &region, double resolution)
        : m_us(base.u.breaks()), m_vs(base.v.breaks()), m_pieces(base, m_us, m_vs), m_region(region),
          m_bounder(resolution)
    {
        RationalPiece piece;
        for (std::size_t i = 0; i + 1 < m_us.size(); ++i)
            for (std::size_t j = 0; j + 1 < m_vs.size(); ++j)
            {
                const ParameterBox box{m_us[i], m_us[i + 1], m_vs[j], m_vs[j + 1]};
                if (!region.may_touch(box))
                    continue;
                m_pieces.cut(i, j, m_pieces.near_point(i, j), piece);
                Node &node = add(box, 0, piece);
                node.i = i;
                node.j = j;
            }
        m_roots = static_cast<int>(m_nodes.size());
    }

    [[nodiscard]] int roots() const { return m_roots; }
    [[nodiscard]] const Node &node(int index) const { return m_nodes[static_cast<std::size_t>(index)]; }

    const std::pair<double, double> &fine(int index)
    {
        Node &node = m_nodes[static_cast<std::size_t>(index)];
        if (!node.fine)
        {
            look_at(node);
            node.fine = m_bounder.fine();
        }
        return *node.fine;
    }

    //! Finds the fine bounds of many nodes at once.
    void look_closely(const std::vector<int> &indices)
    {
        for (const int index : indices)
            if (Node &node = m_nodes[static_cast<std::size_t>(index)]; !node.fine)
                cut_piece(node);
        tbb::enumerable_thread_specific<CurvaturePieceBounder> bounders(m_bounder);
        tbb::parallel_for(std::size_t{0}, indices.size(), [&](std::size_t k) {
            Node &node = m_nodes[static_cast<std::size_t>(indices[k])];
            if (node.fine)
                return;
            CurvaturePieceBounder &bounder = bounders.local();
            bounder.assign(*node.piece);
            node.fine = bounder.fine();
        });
    }

    //! The halves of a node; nothing where there is nothing to be learned from them. A node's fine bound is to be asked
    //! for before, or never.
    //! \param bounded is a bound of the node known to the search?
    std::optional<std::array<int, 2>> halves(int index, bool bounded)
    {
        Node &node = m_nodes[static_cast<std::size_t>(index)];
        if (node.split)
            return node.halves;
        look_at(node);
        if (!may_split(node, bounded))
            return std::nullopt;
        split(node);
        return node.halves;
    }

private:
    [[nodiscard]] bool may_split(const Node &node, bool bounded) const
    {
        const bool regular = bounded && !CurvaturePieceBounder::has_collapsed_side(*node.piece);
        return !m_bounder.below_resolution() && (regular || node.depth < deepest_singular_piece);
    }

    void cut_piece(Node &node)
    {
        if (!node.piece)
            m_pieces.cut(node.i, node.j, m_pieces.near_point(node.i, node.j), node.piece.emplace());
    }

    void look_at(Node &node)
    {
        cut_piece(node);
        m_bounder.assign(*node.piece);
    }

    Node &add(const ParameterBox &box, int depth, const RationalPiece &piece)
    {
        m_bounder.assign(piece);
        Node &node = m_nodes.emplace_back();
        node.box = box;
        node.depth = depth;
        node.centre = m_bounder.at_centre();
        node.rough = m_bounder.rough();
        return node;
    }

    //! The bounder looks at the node's piece.
    void split(Node &node)
    {
        const bool along_u = m_bounder.varies_more_along_u();
        RationalPiece lower = std::move(*node.piece);
        RationalPiece upper;
        lower.halve(along_u, upper);
        ParameterBox low = node.box;
        ParameterBox high = node.box;
        if (along_u)
            low.umax = high.umin = 0.5 * (low.umin + low.umax);
        else
            low.vmax = high.vmin = 0.5 * (low.vmin + low.vmax);
        node.split = true;
        node.piece.reset();
        node.halves = {add_half(low, node.depth + 1, lower), add_half(high, node.depth + 1, upper)};
    }

    int add_half(const ParameterBox &box, int depth, RationalPiece &piece)
    {
        if (!m_region.may_touch(box))
            return -1;
        add(box, depth, piece).piece = std::move(piece);
        return static_cast<int>(m_nodes.size()) - 1;
    }

    std::vector<double> m_us;
    std::vector<double> m_vs;
    SplinePieces m_pieces;
    const LoopRegion &m_region;
    CurvaturePieceBounder m_bounder;
    std::deque<Node> m_nodes; // nodes stay where they are
    int m_roots = 0;
};

//! Best-first search for one side's extreme.
class SideSearch
{
public:
    SideSearch(PieceTree &tree, const LoopRegion &region, const SideGoal &goal, const Best &start)
        : m_tree(tree), m_region(region), m_goal(goal), m_best(start)
    {
    }

    CurvatureBound run()
    {
        // all centres come first: the better the attained curvature, the fewer pieces stay open
        for (int root = 0; root < m_tree.roots(); ++root)
            offer(m_tree.node(root));
        int count = 0;
        for (int root = 0; root < m_tree.roots(); ++root)
            count += add_root(root);
        look_ahead();
        bool complete = true;
        for (; !m_open.empty() && count < budget() && !closed(m_open.front().bound); ++count)
        {
            const Open open = pop();
            if (!open.fine)
                push({std::min(open.bound, bound_of(m_tree.fine(open.node))), open.node, true});
            else if (const auto halves = m_tree.halves(open.node, std::isfinite(open.bound)))
                add_halves(*halves, open.bound);
            else
                complete = false; // its centre has been probed
        }
        if (!m_open.empty())
            settle(m_open.front().bound);
        const double sign = m_goal.sign;
        return {sign * m_best.value, sign * std::max(m_settled, m_best.value), m_best.uv, !complete};
    }

private:
    //! A node that may hold something more extreme than what was found.
    struct Open
    {
        double bound = 0.0; //!< turned
        int node = 0;
        bool fine = false; //!< the bound is the fine one

        friend bool operator<(const Open &a, const Open &b) { return a.bound < b.bound; }
    };

    [[nodiscard]] double bound_of(const std::pair<double, double> &k) const { return turned(m_goal.sign, k); }

    //! A curvature attained in the middle of a node.
    void offer(const Node &node)
    {
        if (!node.centre || !(turned(m_goal.sign, *node.centre) > m_best.value))
            return;
        const gp_Pnt2d middle(0.5 * (node.box.umin + node.box.umax), 0.5 * (node.box.vmin + node.box.vmax));
        if (m_region.contains(middle))
            m_best = {turned(m_goal.sign, *node.centre), middle};
    }

    //! \param known a bound of a piece that holds this one.
    void add(int index, double known) { push({std::min(known, bound_of(m_tree.node(index).rough)), index, false}); }

    //! Where a whole piece has no rough bound, a fine one would hardly be of use; halves cost far less.
    //! \return the steps taken.
    int add_root(int root)
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        const bool turns_far = std::isinf(m_tree.node(root).rough.first);
        if (const auto halves = turns_far ? m_tree.halves(root, false) : std::nullopt)
        {
            add_halves(*halves, infinity);
            return 1;
        }
        add(root, infinity);
        return 0;
    }

    //! As long as a distance is undecided, every piece that may hold its curvature needs its fine bound.
    void look_ahead()
    {
        std::vector<int> nodes;
        if (m_goal.threshold > m_best.value)
            for (const Open &open : m_open)
                if (open.bound >= m_goal.threshold)
                    nodes.push_back(open.node);
        m_tree.look_closely(nodes);
    }

    void add_halves(const std::array<int, 2> &halves, double known)
    {
        for (const int half : halves)
            if (half >= 0)
                offer(m_tree.node(half));
        for (const int half : halves)
            if (half >= 0)
                add(half, known);
    }

    void push(const Open &open)
    {
        if (closed(open.bound))
            return settle(open.bound);
        m_open.push_back(open);
        std::push_heap(m_open.begin(), m_open.end());
    }

    Open pop()
    {
        std::pop_heap(m_open.begin(), m_open.end());
        const Open open = m_open.back();
        m_open.pop_back();
        return open;
    }

    //! Is a bound good enough to stop at?
    [[nodiscard]] bool closed(double bound) const
    {
        const bool undecided = m_goal.threshold > m_best.value && m_goal.threshold <= bound;
        return !undecided && bound <= std::max(m_best.value * (1.0 + m_goal.gap), m_goal.floor);
    }

    //! A distance that is proven to be feasible waits no longer for a sharper limit than this.
    [[nodiscard]] int budget() const
    {
        const double threshold = m_goal.threshold;
        const bool decided = threshold == 0.0 || (m_best.value < threshold && m_open.front().bound < threshold);
        const double bound = m_open.front().bound;
        if (!m_goal.deciding || !decided || std::isinf(bound))
            return most_steps + steps_per_piece * m_tree.roots();
        if (bound > m_best.value * (1.0 + useless_gap))
            return most_steps_while_useless + useless_steps_per_piece * m_tree.roots();
        return bound > m_best.value * (1.0 + wide_gap) ? most_steps_after_decision : steps_after_decision;
    }

    void settle(double bound) { m_settled = std::max(m_settled, bound); }

    PieceTree &m_tree;
    const LoopRegion &m_region;
    const SideGoal &m_goal;
    Best m_best;
    double m_settled = 0.0;
    std::vector<Open> m_open; //!< a heap: the widest bound comes first
};

//! The best of the places on the loops, and for a base that is no spline of a grid inside them.
std::pair<Best, Best> sampled_extremes(const BaseSurface &base, const LoopRegion &region, bool grid)
{
    std::pair<Best, Best> best;
    const double wu = base.box().umax - base.box().umin;
    const double wv = base.box().vmax - base.box().vmin;
    const auto offer = [&](const SurfaceJet &jet, const gp_Pnt2d &uv) {
        const auto k = principal_curvatures(jet, wu, wv);
        if (k && -k->first > best.first.value)
            best.first = {-k->first, uv};
        if (k && k->second > best.second.value)
            best.second = {k->second, uv};
    };
    const std::vector<gp_Pnt2d> places = region.boundary_points();
    const std::size_t step = places.size() / most_boundary_places + 1;
    for (std::size_t i = 0; i < places.size(); i += step)
        offer(base.jets({places[i].X()}, {places[i].Y()}, 2).front(), places[i]);
    if (!grid)
        return best;
    const auto parameters = [](const std::vector<double> &ends) {
        const int intervals = static_cast<int>(ends.size()) - 1;
        return chebyshev_parameters(ends, std::max(samples_per_interval, least_samples / intervals));
    };
    const std::vector<double> us = parameters(base.interval_ends_u());
    const std::vector<double> vs = parameters(base.interval_ends_v());
    const std::vector<SurfaceJet> jets = base.jets(us, vs, 2);
    for (std::size_t i = 0; i < jets.size(); ++i)
        if (const gp_Pnt2d uv(us[i / vs.size()], vs[i % vs.size()]); region.contains(uv))
            offer(jets[i], uv);
    return best;
}

} // namespace

std::optional<std::pair<double, double>> principal_curvatures(const SurfaceJet &jet)
{
    const Eigen::Vector3d normal = jet.u.cross(jet.v);
    const double area = normal.norm();
    const double lu = jet.u.norm();
    const double shorter = std::min(lu, jet.v.norm());
    const double longer = std::max(lu, jet.v.norm());
    if (!(area > singular_sine * shorter * longer) || !(shorter > singular_sine * longer))
        return std::nullopt;
    const Eigen::Vector3d n = normal / area;
    // second fundamental form in the orthonormal frame (S_u, its normal in the tangent plane)
    const double shear = jet.u.dot(jet.v) / (lu * lu);
    const double lv = area / lu;
    const double l = jet.uu.dot(n) / (lu * lu);
    const double m = (jet.uv - shear * jet.uu).dot(n) / (lu * lv);
    const double k = (jet.vv - 2.0 * shear * jet.uv + shear * shear * jet.uu).dot(n) / (lv * lv);
    const double mean = 0.5 * (l + k);
    const double spread = std::hypot(0.5 * (l - k), m);
    return std::pair{mean - spread, mean + spread};
}

std::optional<std::pair<double, double>> principal_curvatures(const SurfaceJet &jet, double wu, double wv)
{
    return principal_curvatures({jet.s, wu * jet.u, wv * jet.v, wu * wu * jet.uu, wu * wv * jet.uv, wv * wv * jet.vv});
}

CurvatureExtremes curvature_extremes(const BaseSurface &base, const LoopRegion &region, const CurvatureSearch &search)
{
    if (base.strip())
        return strip_extremes(*base.strip(), region, search);
    const std::pair<Best, Best> start = sampled_extremes(base, region, !base.spline());
    if (!base.spline())
        return {{-start.first.value, -start.first.value, start.first.uv, true},
                {start.second.value, start.second.value, start.second.uv, true}};
    const double floor = irrelevant_curvature / search.extent;
    const bool deciding = search.distance != 0.0;
    const double threshold = deciding ? 1.0 / search.distance : 0.0;
    const SideGoal low{-1.0, std::max(0.0, -threshold), search.gap, floor, deciding};
    const SideGoal high{1.0, std::max(0.0, threshold), search.gap, floor, deciding};
    PieceTree tree(*base.spline(), region, smallest_piece * search.extent);
    SideSearch lowest(tree, region, low, start.first);
    SideSearch highest(tree, region, high, start.second);
    CurvatureExtremes extremes;
    // what is decided for one side, on all cores, serves the other
    if (search.distance > 0.0)
        extremes.highest = highest.run();
    extremes.lowest = lowest.run();
    if (!(search.distance > 0.0))
        extremes.highest = highest.run();
    return extremes;
}

} // namespace laminate_offset
