// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curvature.h"

#include "curvature_piece.h"
#include "strip_curvature.h"

#include "../spline/knot_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace laminate_offset
{
namespace
{

// Pieces this many halvings deep that have no bound or a collapsed side are sampled: what is left lies at a pole.
constexpr int deepest_singular_piece = 10;
// Part of the extent below which a piece's second derivatives are rounding: eps / this^2 is still small.
constexpr double smallest_piece = 1e-5;
constexpr int most_steps = 4000;
constexpr int steps_after_decision = 50;
// Sine of the angle between S_u and S_v, and ratio of their lengths, below which a place is singular.
constexpr double singular_sine = 1e-8;
// Curvature times extent below which a limit is of no interest.
constexpr double irrelevant_curvature = 1e-2;
constexpr int samples_per_interval = 4;
constexpr int least_samples = 48;

//! The side of the search: +1 for the highest curvature, -1 for the lowest. Internally everything is
//! turned so that the most extreme value is the largest.
double turned(double sign, const std::pair<double, double> &k) { return sign > 0.0 ? k.second : -k.first; }

struct Node
{
    double bound = 0.0; //!< turned
    int depth = 0;
    bool fine = false; //!< the bound is the fine one
    ParameterBox box;
    RationalPiece piece;

    friend bool operator<(const Node &a, const Node &b) { return a.bound < b.bound; }
};

//! A piece of the base before any halving.
struct RoughPiece
{
    std::pair<double, double> bounds;
    std::size_t i = 0; //!< its knot intervals
    std::size_t j = 0;
    ParameterBox box;
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
    double floor = 0.0;      //!< turned curvature below which nothing matters
    double resolution = 0.0; //!< length [mm] below which curvature is rounding
    bool deciding = false;   //!< the search serves one distance; its limits are a by-product
};

//! Best-first search for one side's extreme.
class SideSearch
{
public:
    SideSearch(const LoopRegion &region, const SideGoal &goal, const Best &start)
        : m_region(region), m_sign(goal.sign), m_threshold(goal.threshold), m_gap(goal.gap), m_floor(goal.floor),
          m_deciding(goal.deciding), m_best(start), m_bounder(goal.resolution)
    {
    }

    //! Do the rough bounds of a piece settle it? Then the piece itself is not needed.
    bool closes(const std::pair<double, double> &rough)
    {
        const double bound = m_sign > 0.0 ? rough.second : -rough.first;
        if (closed(bound))
            settle(bound);
        return closed(bound);
    }

    //! Takes a piece whose rough bounds are known; its centre has been probed.
    //! \param known a bound of a piece that holds this one.
    void add(const std::pair<double, double> &rough, const RationalPiece &piece, const ParameterBox &box, int depth,
             double known = std::numeric_limits<double>::infinity())
    {
        const double bound = std::min(known, m_sign > 0.0 ? rough.second : -rough.first);
        if (closed(bound))
            settle(bound);
        else
            m_queue.push({bound, depth, false, box, piece});
    }

    //! A curvature attained at a place.
    void offer(const std::pair<double, double> &k, const gp_Pnt2d &uv)
    {
        if (turned(m_sign, k) > m_best.value && m_region.contains(uv))
            m_best = {turned(m_sign, k), uv};
    }

    CurvatureBound run()
    {
        bool complete = true;
        for (int count = 0; !m_queue.empty() && count < budget() && !closed(m_queue.top().bound); ++count)
        {
            Node node = m_queue.top();
            m_queue.pop();
            m_bounder.assign(node.piece);
            if (!node.fine)
                refine(node);
            else if (may_split(node))
                split(node);
            else
                complete = false; // its centre has been probed
        }
        if (!m_queue.empty())
            settle(m_queue.top().bound);
        return {m_sign * m_best.value, m_sign * std::max(m_settled, m_best.value), m_best.uv, !complete};
    }

private:
    //! Is there anything to be learned from the halves of the piece that the bounder looks at?
    [[nodiscard]] bool may_split(const Node &node) const
    {
        const bool regular = std::isfinite(node.bound) && !CurvaturePieceBounder::has_collapsed_side(node.piece);
        return !m_bounder.below_resolution() && (regular || node.depth < deepest_singular_piece);
    }

    //! Is a bound good enough to stop at?
    [[nodiscard]] bool closed(double bound) const
    {
        const bool undecided = m_threshold > m_best.value && m_threshold <= bound;
        return !undecided && bound <= std::max(m_best.value * (1.0 + m_gap), m_floor);
    }

    //! A distance that is proven to be feasible waits no longer for a sharper limit than this.
    [[nodiscard]] int budget() const
    {
        const bool decided = m_threshold == 0.0 || (m_best.value < m_threshold && m_queue.top().bound < m_threshold);
        return m_deciding && decided ? steps_after_decision : most_steps;
    }

    void settle(double bound) { m_settled = std::max(m_settled, bound); }

    void refine(Node &node)
    {
        const std::pair<double, double> fine = m_bounder.fine();
        node.bound = std::min(node.bound, m_sign > 0.0 ? fine.second : -fine.first);
        node.fine = true;
        if (closed(node.bound))
            settle(node.bound);
        else
            m_queue.push(std::move(node));
    }

    void add_half(const RationalPiece &piece, const ParameterBox &box, int depth, double known)
    {
        if (!m_region.may_touch(box))
            return;
        m_bounder.assign(piece);
        const gp_Pnt2d middle(0.5 * (box.umin + box.umax), 0.5 * (box.vmin + box.vmax));
        if (const auto k = m_bounder.at_centre())
            offer(*k, middle);
        add(m_bounder.rough(), piece, box, depth, known);
    }

    //! The bounder looks at the node's piece.
    void split(Node &node)
    {
        const bool along_u = m_bounder.longer_in_u();
        RationalPiece upper = node.piece;
        node.piece.halve(along_u, upper);
        ParameterBox low = node.box;
        ParameterBox high = node.box;
        if (along_u)
            low.umax = high.umin = 0.5 * (low.umin + low.umax);
        else
            low.vmax = high.vmin = 0.5 * (low.vmin + low.vmax);
        add_half(node.piece, low, node.depth + 1, node.bound);
        add_half(upper, high, node.depth + 1, node.bound);
    }

    const LoopRegion &m_region;
    double m_sign;
    double m_threshold;
    double m_gap;
    double m_floor;
    bool m_deciding;
    Best m_best;
    double m_settled = 0.0;
    CurvaturePieceBounder m_bounder;
    std::priority_queue<Node> m_queue;
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
    for (const gp_Pnt2d &uv : region.boundary_points())
        offer(base.jets({uv.X()}, {uv.Y()}, 2).front(), uv);
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

//! Gives both searches the pieces that the loops touch. All centres come first: the better the attained
//! curvature, the fewer pieces stay open and are cut again.
void hand_out_pieces(const TensorSpline &base, const LoopRegion &region, double resolution, SideSearch &lowest,
                     SideSearch &highest)
{
    const std::vector<double> us = base.u.breaks();
    const std::vector<double> vs = base.v.breaks();
    SplinePieces pieces(base, us, vs);
    CurvaturePieceBounder bounder(resolution);
    RationalPiece piece;
    std::vector<RoughPiece> rough;
    for (std::size_t i = 0; i + 1 < us.size(); ++i)
        for (std::size_t j = 0; j + 1 < vs.size(); ++j)
        {
            const ParameterBox box{us[i], us[i + 1], vs[j], vs[j + 1]};
            if (!region.may_touch(box))
                continue;
            pieces.cut(i, j, pieces.near_point(i, j), piece);
            bounder.assign(piece);
            const gp_Pnt2d middle(0.5 * (box.umin + box.umax), 0.5 * (box.vmin + box.vmax));
            if (const auto k = bounder.at_centre())
            {
                lowest.offer(*k, middle);
                highest.offer(*k, middle);
            }
            rough.push_back({bounder.rough(), i, j, box});
        }
    for (const RoughPiece &r : rough)
    {
        const bool low_closes = lowest.closes(r.bounds);
        const bool high_closes = highest.closes(r.bounds);
        if (low_closes && high_closes)
            continue;
        pieces.cut(r.i, r.j, pieces.near_point(r.i, r.j), piece);
        if (!low_closes)
            lowest.add(r.bounds, piece, r.box, 0);
        if (!high_closes)
            highest.add(r.bounds, piece, r.box, 0);
    }
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
    const double resolution = smallest_piece * search.extent;
    const bool deciding = search.distance != 0.0;
    const double threshold = deciding ? 1.0 / search.distance : 0.0;
    SideSearch lowest(region, {-1.0, std::max(0.0, -threshold), search.gap, floor, resolution, deciding}, start.first);
    SideSearch highest(region, {1.0, std::max(0.0, threshold), search.gap, floor, resolution, deciding}, start.second);
    hand_out_pieces(*base.spline(), region, resolution, lowest, highest);
    return {lowest.run(), highest.run()};
}

} // namespace laminate_offset
