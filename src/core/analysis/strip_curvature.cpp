// SPDX-License-Identifier: LGPL-2.1-or-later
#include "strip_curvature.h"

#include "curvature_piece.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

constexpr int deepest_singular_piece = 10;
constexpr int deepest = 40;
constexpr std::size_t most_leaves = 4000;
// Places tried on a line of the other parameter for one inside the loops.
constexpr int places_across = 256;
// Part of the extent below which lengths along the strip are rounding (as in curvature.cpp).
constexpr double smallest_piece = 1e-5;
// Curvature times extent below which a limit is of no interest.
constexpr double irrelevant_curvature = 1e-2;

struct Leaf
{
    std::pair<double, double> bounds;
    double low = 0.0; //!< of the parameter
    double high = 0.0;
    int depth = 0;
    bool singular = false; //!< cannot be bounded: at a pole
    RationalPiece piece;
};

struct Best
{
    double value = 0.0; //!< times the side's sign; a flat surface's extreme is 0
    gp_Pnt2d uv;
};

class StripSearch
{
public:
    StripSearch(const CurvatureStrip &strip, const LoopRegion &region, const CurvatureSearch &search)
        : m_strip(strip), m_region(region), m_search(search), m_range(region.bounds()),
          m_bounder(smallest_piece * search.extent * strip.fineness)
    {
    }

    CurvatureExtremes run()
    {
        offer_loops();
        cut();
        const CurvatureBound lowest = side(-1.0, m_lowest);
        return {lowest, side(1.0, m_highest)};
    }

private:
    [[nodiscard]] const KnotVector &knots() const { return m_strip.along_u ? m_strip.spline.u : m_strip.spline.v; }

    [[nodiscard]] double parameter(const gp_Pnt2d &uv) const { return m_strip.along_u ? uv.X() : uv.Y(); }

    void offer(const std::pair<double, double> &k, const gp_Pnt2d &uv)
    {
        if (-k.first > m_lowest.value)
            m_lowest = {-k.first, uv};
        if (k.second > m_highest.value)
            m_highest = {k.second, uv};
    }

    //! All ends of the loops' pieces at once.
    void offer_loops()
    {
        const std::vector<gp_Pnt2d> points = m_region.boundary_points();
        std::vector<double> along;
        for (const gp_Pnt2d &uv : points)
            along.push_back(std::clamp(parameter(uv), knots().front(), knots().back()));
        const std::vector<double> middle{m_strip.middle};
        const std::vector<SurfaceJet> jets =
            m_strip.along_u ? m_strip.spline.jets(along, middle, 2) : m_strip.spline.jets(middle, along, 2);
        const double wu = m_strip.along_u ? m_range.umax - m_range.umin : m_strip.width;
        const double wv = m_strip.along_u ? m_strip.width : m_range.vmax - m_range.vmin;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (const auto k = principal_curvatures(jets[i], wu, wv))
                offer(*k, points[i]);
    }

    //! The pieces between the knots and the ends of the loops' range.
    void cut()
    {
        const double first = std::max(knots().front(), m_strip.along_u ? m_range.umin : m_range.vmin);
        const double last = std::min(knots().back(), m_strip.along_u ? m_range.umax : m_range.vmax);
        const std::vector<double> ends = merged_breaks(knots().breaks(), {first, last});
        const std::vector<double> across = (m_strip.along_u ? m_strip.spline.v : m_strip.spline.u).breaks();
        SplinePieces pieces =
            m_strip.along_u ? SplinePieces(m_strip.spline, ends, across) : SplinePieces(m_strip.spline, across, ends);
        const double slack = 1e-12 * (last - first);
        for (std::size_t k = 0; k + 1 < ends.size(); ++k)
        {
            if (ends[k + 1] <= first + slack || ends[k] >= last - slack)
                continue;
            Leaf leaf;
            leaf.low = ends[k];
            leaf.high = ends[k + 1];
            const std::size_t i = m_strip.along_u ? k : 0;
            const std::size_t j = m_strip.along_u ? 0 : k;
            pieces.cut(i, j, pieces.near_point(i, j), leaf.piece);
            add(std::move(leaf));
        }
    }

    void add(Leaf leaf)
    {
        m_bounder.assign(leaf.piece);
        leaf.bounds = m_bounder.fine();
        const bool bounded = std::isfinite(leaf.bounds.first) && std::isfinite(leaf.bounds.second);
        const bool at_pole = !bounded || CurvaturePieceBounder::has_collapsed_side(leaf.piece);
        leaf.singular =
            m_bounder.below_resolution() || leaf.depth >= deepest || (at_pole && leaf.depth >= deepest_singular_piece);
        if (const auto k = m_bounder.at_centre())
            if (-k->first > m_lowest.value || k->second > m_highest.value)
                if (const auto uv = place(0.5 * (leaf.low + leaf.high)))
                    offer(*k, *uv);
        m_leaves.push_back(std::move(leaf));
    }

    //! A place inside the loops, near the middle of the other parameter.
    [[nodiscard]] std::optional<gp_Pnt2d> place(double t) const
    {
        const double low = m_strip.along_u ? m_range.vmin : m_range.umin;
        const double high = m_strip.along_u ? m_range.vmax : m_range.umax;
        for (int i = 0; i < places_across; ++i)
        {
            // 1/2, then alternately farther out
            const double step = (i + 1) / 2 * (i % 2 == 0 ? 1.0 : -1.0) / places_across;
            const double s = low + (0.5 + 0.999 * step) * (high - low);
            const gp_Pnt2d uv = m_strip.along_u ? gp_Pnt2d(t, s) : gp_Pnt2d(s, t);
            if (m_region.contains(uv))
                return uv;
        }
        return std::nullopt;
    }

    //! Halves the worst piece until it is good enough.
    CurvatureBound side(double sign, const Best &best)
    {
        const double threshold = m_search.distance * sign > 0.0 ? 1.0 / std::abs(m_search.distance) : 0.0;
        const double floor = irrelevant_curvature / m_search.extent;
        const auto bound = [sign](const Leaf &leaf) {
            return leaf.singular ? 0.0 : sign > 0.0 ? leaf.bounds.second : -leaf.bounds.first;
        };
        const auto closed = [&](double x) {
            const bool undecided = threshold > best.value && threshold <= x;
            return !undecided && x <= std::max(best.value * (1.0 + m_search.gap), floor);
        };
        const auto worst = [&] {
            return std::max_element(m_leaves.begin(), m_leaves.end(),
                                    [&](const Leaf &a, const Leaf &b) { return bound(a) < bound(b); });
        };
        while (m_leaves.size() < most_leaves && !closed(bound(*worst())))
            split(static_cast<std::size_t>(worst() - m_leaves.begin()));
        const bool sampled = std::any_of(m_leaves.begin(), m_leaves.end(), [&](const Leaf &leaf) {
            return leaf.singular && !closed(sign > 0.0 ? leaf.bounds.second : -leaf.bounds.first);
        });
        return {sign * best.value, sign * std::max(bound(*worst()), best.value), best.uv, sampled};
    }

    void split(std::size_t index)
    {
        Leaf lower = std::move(m_leaves[index]);
        m_leaves.erase(m_leaves.begin() + static_cast<std::ptrdiff_t>(index));
        ++lower.depth;
        Leaf upper = lower;
        lower.piece.halve(m_strip.along_u, upper.piece);
        lower.high = upper.low = 0.5 * (lower.low + lower.high);
        add(std::move(lower));
        add(std::move(upper));
    }

    const CurvatureStrip &m_strip;
    const LoopRegion &m_region;
    const CurvatureSearch &m_search;
    ParameterBox m_range;
    CurvaturePieceBounder m_bounder;
    std::vector<Leaf> m_leaves;
    Best m_lowest;
    Best m_highest;
};

} // namespace

CurvatureExtremes strip_extremes(const CurvatureStrip &strip, const LoopRegion &region, const CurvatureSearch &search)
{
    return StripSearch(strip, region, search).run();
}

} // namespace laminate_offset
