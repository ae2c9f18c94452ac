// SPDX-License-Identifier: LGPL-2.1-or-later
#include "self_intersection.h"

#include "meeting_search.h"
#include "meeting_step.h"
#include "parameter_periods.h"
#include "patch_tree.h"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

constexpr int most_newton_starts = 400;
constexpr int newton_steps = 12;
// After these steps the residual has to halve at every further one.
constexpr int free_newton_steps = 3;
constexpr int deepest_self = 14;
// Normals at a pole that differ less than this (cosine) belong to one cap.
constexpr double cap_cosine = 0.5;

using Place = Eigen::Vector4d; //!< (u, v) of one place and of the other

//! The shift of b, a multiple 0 or +-1 of the period, that brings it nearest to a; and the gap left.
std::pair<double, double> nearest_shift(double a0, double a1, double b0, double b1, double period)
{
    std::pair<double, double> best{0.0, std::max(b0 - a1, a0 - b1)};
    if (period > 0.0)
        for (const double shift : {-period, period})
            if (const double gap = std::max(b0 + shift - a1, a0 - b1 - shift); gap < best.second)
                best = {shift, gap};
    return best;
}

//! Newton's method with shortest steps for f(p) = f(q), on the offset or on the base.
class MeetingSolver
{
public:
    explicit MeetingSolver(const SelfIntersectionQuery &query)
        : m_query(query), m_box(query.analysis.base.box()),
          m_least_apart(laminate_offset::least_apart(query.distance, query.tolerance))
    {
    }

    [[nodiscard]] double least_apart() const { return m_least_apart; }

    [[nodiscard]] double apart(const Place &place) const
    {
        return (base(place.x(), place.y()).s - base(place.z(), place.w()).s).norm();
    }

    //! A meeting of the offset that is none of the base, from a start close to it.
    [[nodiscard]] std::optional<SelfMeeting> meeting(const Place &start) const
    {
        const auto offset = [this](double u, double v) { return m_query.offset.jets({u}, {v}, 1).front(); };
        const std::optional<Place> place = solve(offset, start);
        if (!place || !inside(*place))
            return std::nullopt;
        if (apart(*place) < m_least_apart || base_meets(*place))
            return std::nullopt;
        return SelfMeeting{{place->x(), place->y()}, {place->z(), place->w()}};
    }

private:
    [[nodiscard]] SurfaceJet base(double u, double v) const { return m_query.analysis.base.jets({u}, {v}, 1).front(); }

    [[nodiscard]] bool inside(const Place &place) const
    {
        return m_query.analysis.region.contains({place.x(), place.y()}) &&
               m_query.analysis.region.contains({place.z(), place.w()});
    }

    //! The base crosses itself close by, transversally and inside its loops.
    [[nodiscard]] bool base_meets(const Place &start) const
    {
        const auto own = [this](double u, double v) { return base(u, v); };
        const std::optional<Place> place = solve(own, start);
        if (!place || !inside(*place) || same(*place))
            return false;
        const SurfaceJet a = base(place->x(), place->y());
        const SurfaceJet b = base(place->z(), place->w());
        const Eigen::Vector3d na = a.u.cross(a.v).normalized();
        const Eigen::Vector3d nb = b.u.cross(b.v).normalized();
        return na.cross(nb).norm() > 1e-3 && clear_of_ends(*place);
    }

    [[nodiscard]] bool same(const Place &place) const
    {
        return std::abs(place.x() - place.z()) < 1e-6 * (m_box.umax - m_box.umin) &&
               std::abs(place.y() - place.w()) < 1e-6 * (m_box.vmax - m_box.vmin);
    }

    //! A closed base meets itself at its seam, which is no crossing.
    [[nodiscard]] bool clear_of_ends(const Place &place) const
    {
        const ParameterBox &box = m_query.input.box;
        const double du = 1e-6 * (box.umax - box.umin);
        const double dv = 1e-6 * (box.vmax - box.vmin);
        for (const int k : {0, 2})
            if (place[k] < box.umin + du || place[k] > box.umax - du || place[k + 1] < box.vmin + dv ||
                place[k + 1] > box.vmax - dv)
                return false;
        return true;
    }

    template <typename Surface>
    [[nodiscard]] std::optional<Place> solve(const Surface &surface, const Place &start) const
    {
        Place place = start;
        double before = std::numeric_limits<double>::infinity();
        for (int step = 0; step < newton_steps; ++step)
        {
            const SurfaceJet a = surface(place.x(), place.y());
            const SurfaceJet b = surface(place.z(), place.w());
            const Eigen::Vector3d residual = a.s - b.s;
            if (residual.norm() <= coincidence * m_query.input.diagonal)
                return place;
            if (residual.norm() > before)
                return std::nullopt;
            before = step < free_newton_steps ? before : 0.5 * residual.norm();
            step_together(a, b, m_box, place);
        }
        return std::nullopt;
    }

    const SelfIntersectionQuery &m_query;
    ParameterBox m_box;
    double m_least_apart;
};

class PairSearch
{
public:
    explicit PairSearch(const SelfIntersectionQuery &query)
        : m_query(query), m_tree(query.offset), m_solver(query), m_periods(periods_of(query.input, query.tolerance)),
          m_resolution(resolution_share * query.tolerance), m_points(base_points())
    {
    }

    SelfIntersectionSearch run()
    {
        within(PatchTree::root());
        return m_result;
    }

private:
    [[nodiscard]] bool over() const { return m_result.meeting.has_value() || m_result.pairs >= most_pairs; }

    //! Meetings of a rectangle with itself.
    void within(int index)
    {
        const PatchNode &node = m_tree.node(index);
        if (over() || node.bounds.one_to_one() || !touches(index) || same_cap(index, index))
            return;
        if (node.halvings >= deepest_self || node.bounds.point.diagonal().norm() < m_resolution)
        {
            m_result.settled = false;
            return;
        }
        m_tree.split_where_it_bends(index);
        const auto [lower, upper] = std::pair{m_tree.node(index).lower, m_tree.node(index).upper};
        within(lower);
        within(upper);
        between(lower, upper);
    }

    //! Meetings of two rectangles that share no inner points.
    void between(int first, int second)
    {
        if (over())
        {
            m_result.settled = false;
            return;
        }
        ++m_result.pairs;
        const PatchNode &a = m_tree.node(first);
        const PatchNode &b = m_tree.node(second);
        if (!a.bounds.point.intersects(b.bounds.point) || !touches(first) || !touches(second) ||
            neighbours(a.box, b.box) || same_cap(first, second) || apart_along_normals(a, b))
            return;
        if (a.is_piece() && b.is_piece() && try_newton(a, b))
            return;
        const double size_a = a.bounds.point.diagonal().norm();
        const double size_b = b.bounds.point.diagonal().norm();
        if (std::max(size_a, size_b) < m_resolution)
        {
            m_result.settled = false;
            return;
        }
        const bool first_is_larger = size_a >= size_b;
        const int larger = first_is_larger ? first : second;
        const int other = first_is_larger ? second : first;
        m_tree.split(larger);
        between(m_tree.node(larger).lower, other);
        between(m_tree.node(larger).upper, other);
    }

    //! Is any part of the rectangle inside the loops? Asked for pieces only, and once.
    bool touches(int index)
    {
        if (!m_tree.node(index).is_piece())
            return true;
        if (m_touches.size() <= static_cast<std::size_t>(index))
            m_touches.resize(static_cast<std::size_t>(2 * index + 16), -1);
        signed char &known = m_touches[static_cast<std::size_t>(index)];
        if (known < 0)
            known = m_query.analysis.region.may_touch(m_tree.node(index).box) ? 1 : 0;
        return known == 1;
    }

    //! One-to-one over the rectangle that holds both, parameters continued across seams.
    [[nodiscard]] bool neighbours(const ParameterBox &a, const ParameterBox &b)
    {
        const auto [du, gap_u] = nearest_shift(a.umin, a.umax, b.umin, b.umax, m_periods.u);
        const auto [dv, gap_v] = nearest_shift(a.vmin, a.vmax, b.vmin, b.vmax, m_periods.v);
        if (gap_u > std::max(a.umax - a.umin, b.umax - b.umin) || gap_v > std::max(a.vmax - a.vmin, b.vmax - b.vmin))
            return false;
        const ParameterBox both = hull(a, shifted(b, du, dv));
        PatchBounds bounds = m_tree.bounds_over(both);
        for (const double u : {0.0, -du})
            for (const double v : {0.0, -dv})
                if (u != 0.0 || v != 0.0)
                    bounds.extend(m_tree.bounds_over(shifted(both, u, v)));
        return bounds.one_to_one();
    }

    //! The sides of the whole base that are points, as bits: the poles show it, of any other base samples.
    [[nodiscard]] unsigned base_points() const
    {
        return (is_point(true, false) ? low_u : 0U) | (is_point(true, true) ? high_u : 0U) |
               (is_point(false, false) ? low_v : 0U) | (is_point(false, true) ? high_v : 0U);
    }

    [[nodiscard]] bool is_point(bool constant_u, bool at_end) const
    {
        const BaseSurface &base = m_query.analysis.base;
        const ParameterBox &box = m_tree.node(PatchTree::root()).box;
        const std::optional<TensorSpline> &spline = base.spline();
        constexpr int samples = 33;
        const int count = !spline ? samples : (constant_u ? spline->v : spline->u).pole_count();
        const auto at = [&](int k) -> Eigen::Vector3d {
            if (spline)
            {
                const int last = (constant_u ? spline->u : spline->v).pole_count() - 1;
                const int row = at_end ? last : 0;
                const Eigen::Vector4d &pole = constant_u ? spline->pole(row, k) : spline->pole(k, row);
                return pole.head<3>() / pole.w();
            }
            const double t = static_cast<double>(k) / (samples - 1);
            const double u = constant_u ? (at_end ? box.umax : box.umin) : box.umin + t * (box.umax - box.umin);
            const double v = constant_u ? box.vmin + t * (box.vmax - box.vmin) : (at_end ? box.vmax : box.vmin);
            return base.jets({u}, {v}, 0).front().s;
        };
        for (int k = 1; k < count; ++k)
            if ((at(k) - at(0)).norm() >= 1e-2 * m_resolution)
                return false;
        return true;
    }

    //! Those of them that a rectangle touches.
    [[nodiscard]] unsigned points_of(const ParameterBox &box) const
    {
        const ParameterBox &whole = m_tree.node(PatchTree::root()).box;
        return m_points & ((box.umin == whole.umin ? low_u : 0U) | (box.umax == whole.umax ? high_u : 0U) |
                           (box.vmin == whole.vmin ? low_v : 0U) | (box.vmax == whole.vmax ? high_v : 0U));
    }

    //! Places of a piece, drawn in a little, off the side that is a point.
    [[nodiscard]] static std::array<gp_Pnt2d, 5> places(const ParameterBox &box)
    {
        constexpr double in = 0.02;
        const auto at = [&](double x, double y) {
            return gp_Pnt2d(box.umin + x * (box.umax - box.umin), box.vmin + y * (box.vmax - box.vmin));
        };
        return {at(in, in), at(in, 1.0 - in), at(1.0 - in, in), at(1.0 - in, 1.0 - in), at(0.5, 0.5)};
    }

    //! What is seen of a piece at a point of the base.
    struct Sight
    {
        std::array<SurfaceJet, 5> offset;
        std::array<Eigen::Vector3d, 5> base;
        std::array<Eigen::Vector3d, 5> tip; //!< of the offset, on the side that is a point of the base
    };

    [[nodiscard]] Sight sight(const ParameterBox &box, unsigned point) const
    {
        Sight seen;
        std::size_t k = 0;
        for (const gp_Pnt2d &uv : places(box))
        {
            const double u = point == low_u ? box.umin : (point == high_u ? box.umax : uv.X());
            const double v = point == low_v ? box.vmin : (point == high_v ? box.vmax : uv.Y());
            seen.offset[k] = m_query.offset.jets({uv.X()}, {uv.Y()}, 1).front();
            seen.base[k] = m_query.analysis.base.jets({uv.X()}, {uv.Y()}, 0).front().s;
            seen.tip[k] = m_query.offset.jets({u}, {v}, 0).front().s;
            ++k;
        }
        return seen;
    }

    //! Both lie at the same point of the base, with normals in one cap, and the offset of the point has opened: it has
    //! not run through it and out on the other side, by more than the tolerance.
    [[nodiscard]] bool same_cap(int first, int second) const
    {
        const PatchNode &one = m_tree.node(first), &other = m_tree.node(second);
        const unsigned point = one.is_piece() && other.is_piece() ? points_of(one.box) & points_of(other.box) : 0U;
        if (!std::has_single_bit(point))
            return false;
        const Sight a = sight(one.box, point), b = sight(other.box, point);
        const double error = 2.0 * m_query.tolerance; // by which places of one tip may miss each other
        for (std::size_t i = 0; i < a.base.size(); ++i)
            for (std::size_t j = 0; j < b.base.size(); ++j)
            {
                const Eigen::Vector3d way = a.base[i] - b.base[j];
                const Eigen::Vector3d across = a.tip[i] - b.tip[j];
                const Eigen::Vector3d na = unit_normal(a.offset[i]), nb = unit_normal(b.offset[j]);
                const bool turned = across.dot(way) < -error * way.norm() &&
                                    std::max(std::abs(across.dot(na)), std::abs(across.dot(nb))) > error;
                if (turned || !(na.dot(nb) > cap_cosine) || (a.offset[i].s - b.offset[j].s).dot(way) < 0.0)
                    return false;
            }
        return true;
    }

    [[nodiscard]] static Eigen::Vector3d unit_normal(const SurfaceJet &jet) { return jet.u.cross(jet.v).normalized(); }

    //! The range of a piece's control points along an axis.
    [[nodiscard]] std::pair<double, double> extent_along(const Eigen::Vector3d &axis, const PatchNode &piece) const
    {
        double low = infinity;
        double high = -infinity;
        for (int i = 0; i <= m_tree.degree_u(); ++i)
            for (int j = 0; j <= m_tree.degree_v(); ++j)
            {
                const double along = axis.dot(m_tree.point(piece, i, j));
                low = std::min(low, along);
                high = std::max(high, along);
            }
        return {low, high};
    }

    //! Do the control points lie apart along the normal of one of the pieces?
    [[nodiscard]] bool apart_along_normals(const PatchNode &a, const PatchNode &b) const
    {
        if (!a.is_piece() || !b.is_piece())
            return false;
        for (const PatchNode *node : {&a, &b})
        {
            const Eigen::Vector3d axis = node->bounds.du.center().cross(node->bounds.dv.center()).normalized();
            const auto [low_a, high_a] = extent_along(axis, a);
            const auto [low_b, high_b] = extent_along(axis, b);
            if (low_a > high_b || low_b > high_a)
                return true;
        }
        return false;
    }

    bool try_newton(const PatchNode &a, const PatchNode &b)
    {
        if ((a.halvings + b.halvings) % newton_interval != 0 || m_newton_starts >= most_newton_starts)
            return false;
        const Place start(0.5 * (a.box.umin + a.box.umax), 0.5 * (a.box.vmin + a.box.vmax),
                          0.5 * (b.box.umin + b.box.umax), 0.5 * (b.box.vmin + b.box.vmax));
        // pieces far larger than the distance start too far off; neighbours, seams and poles have their base points
        // together
        const double size = a.bounds.point.diagonal().norm() + b.bounds.point.diagonal().norm();
        if (size > 4.0 * std::abs(m_query.distance) || m_solver.apart(start) + 2.0 * size < m_solver.least_apart())
            return false;
        ++m_newton_starts;
        m_result.meeting = m_solver.meeting(start);
        return m_result.meeting.has_value();
    }

    static constexpr double infinity = std::numeric_limits<double>::infinity();
    static constexpr unsigned low_u = 1, high_u = 2, low_v = 4, high_v = 8;

    const SelfIntersectionQuery &m_query;
    PatchTree m_tree;
    MeetingSolver m_solver;
    Periods m_periods;
    double m_resolution;
    unsigned m_points;
    int m_newton_starts = 0;
    std::vector<signed char> m_touches;
    SelfIntersectionSearch m_result;
};

} // namespace

SelfIntersectionSearch find_self_intersection(const SelfIntersectionQuery &query)
{
    if (std::abs(query.distance) <= 2.0 * query.tolerance)
        return {};
    if (one_to_one_whole(query.offset))
        return {};
    return PairSearch(query).run();
}

Result<bool> check_self_intersection(const SelfIntersectionQuery &query)
{
    const SelfIntersectionSearch search = find_self_intersection(query);
    const std::optional<SelfMeeting> &meeting = search.meeting;
    if (!meeting)
        return search.settled;
    const Where here = query.input.place(meeting->first);
    const Where there = query.input.place(meeting->second);
    return Failure{
        Status::SelfIntersection, Stage::Surface,
        fmt::format("At the distance {:.6g} mm the offset of the reported place meets that of the place u={:.6g}, "
                    "v={:.6g} ({:.6g}, {:.6g}, {:.6g}); {}, or split the face between the two.",
                    query.input.from_face(query.distance), meeting->second.X(), meeting->second.Y(), there.point.X(),
                    there.point.Y(), there.point.Z(), query.remedy),
        here, std::nullopt};
}

} // namespace laminate_offset
