// SPDX-License-Identifier: LGPL-2.1-or-later
#include "part_meetings.h"

#include "crease_frame.h"
#include "meeting_search.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

namespace laminate_offset
{
namespace
{

constexpr int most_newton_starts = 2000;
constexpr int newton_steps = 16;
// Patches are judged beside a crease from which they lie no farther away than so many times their width.
constexpr double nearest_widths = 8.0;
// Parts that cross at a crease: beside it pairs may be narrower, and fewer are looked at, since along a crossing that is not
// settled there all others stay open.
constexpr double nearest_widths_of_crossing = 32.0;
constexpr int most_pairs_of_crossing = 12000;
// Parts end at one crease when their loops do within this part of their width.
constexpr double same_line = 1e-6;
// A meeting is followed to this part of the distance, in steps that take a fifth of what is left off at most. A step is
// halved where its end is off by more than a quarter of its length from where its start points, and doubled again after.
constexpr double least_part = 1e-3;
constexpr double longest_step = 0.2;
constexpr double shortest_step = longest_step / 4096.0;
constexpr double most_bend = 0.25;
constexpr int most_steps = 120;
// So many meetings of two parts are followed.
constexpr int most_followed = 100;

//! Places of two parts: (u, v, height) of one and of the other; the height is 0 on the near surface and 1 on the far one.
using Places = Eigen::Matrix<double, 6, 1>;

//! Two parts, by their numbers, and what they have in common.
struct Neighbourhood
{
    std::size_t first = 0;
    std::size_t second = 0;
    //! Shifts of the second part's parameters that may continue those of the first one: across an edge of both, and by
    //! periods.
    std::vector<gp_Vec2d> shifts;
    bool crosses = false; //!< at such an edge, or at an end of one, they are known to cross
};

//! The search through the patches of two parts.
class PairOfParts
{
public:
    PairOfParts(MeetingBody &one, MeetingBody &other, const PartMeetingQuery &query, const Neighbourhood &around)
        : m_one(one), m_other(other), m_query(query), m_shifts(around.shifts), m_crosses(around.crosses),
          m_least_apart(least_apart(query.distance, query.tolerance)), m_resolution(resolution_share * query.tolerance),
          m_first(around.first), m_second(around.second)
    {
        const ParameterBox &a = one.part().input.box, &b = other.part().input.box;
        m_low << a.umin, a.vmin, 0.0, b.umin, b.vmin, 0.0;
        m_high << a.umax, a.vmax, 1.0, b.umax, b.vmax, 1.0;
    }

    void run(PartMeetingSearch &result)
    {
        std::deque<std::pair<int, int>> open{{PatchTree::root(), PatchTree::root()}};
        int pairs = 0;
        for (; !open.empty() && !m_meeting; open.pop_front())
        {
            const auto [a, b] = open.front();
            if (++pairs > (m_crosses ? most_pairs_of_crossing : most_pairs))
            {
                leave_open(a, b);
                break;
            }
            examine(a, b, open);
        }
        result.settled = result.settled && !m_open;
        result.meeting = m_meeting;
        if (!result.open)
            result.open = m_open;
    }

private:
    void examine(int a, int b, std::deque<std::pair<int, int>> &open)
    {
        if (!m_one.touches(a) || !m_other.touches(b) || apart(a, b) || share_base(a, b) ||
            beside_crease(m_one.box(a), m_other.box(b)))
            return;
        if (m_one.tree().node(a).is_piece() && m_other.tree().node(b).is_piece() && meets(a, b))
            return;
        const double size_a = size(m_one, a), size_b = size(m_other, b);
        if (std::max(size_a, size_b) < m_resolution)
            return leave_open(a, b);
        const bool first_is_larger = size_a >= size_b;
        PatchTree &tree = first_is_larger ? m_one.tree() : m_other.tree();
        const int larger = first_is_larger ? a : b;
        tree.split(larger);
        for (const int half : {tree.node(larger).lower, tree.node(larger).upper})
            open.push_back(first_is_larger ? std::pair{half, b} : std::pair{a, half});
    }

    void leave_open(int a, int b)
    {
        const ParameterBox &one = m_one.box(a), &other = m_other.box(b);
        m_open = PartMeeting{m_first,
                             {0.5 * (one.umin + one.umax), 0.5 * (one.vmin + one.vmax)},
                             m_second,
                             {0.5 * (other.umin + other.umax), 0.5 * (other.vmin + other.vmax)}};
    }

    [[nodiscard]] static double size(MeetingBody &body, int index)
    {
        return body.tree().node(index).bounds.point.diagonal().norm();
    }

    [[nodiscard]] bool apart(int a, int b)
    {
        const std::vector<SheetBounds> &one = m_one.patch(a), &other = m_other.patch(b);
        Eigen::AlignedBox3d box_one, box_other;
        for (const SheetBounds &sheet : one)
            box_one.extend(sheet.bounds.point);
        for (const SheetBounds &sheet : other)
            box_other.extend(sheet.bounds.point);
        if (!box_one.intersects(box_other))
            return true;
        const auto separates = [&](const Eigen::Vector3d &axis) {
            Reach reach_one, reach_other;
            for (const SheetBounds &sheet : one)
                reach_one.extend(sheet.along(axis, m_one.box(a)));
            for (const SheetBounds &sheet : other)
                reach_other.extend(sheet.along(axis, m_other.box(b)));
            return reach_one.low > reach_other.high || reach_other.low > reach_one.high;
        };
        for (const auto *patch : {&one, &other})
        {
            const Eigen::Vector3d u = patch->front().bounds.du.center(), v = patch->front().bounds.dv.center();
            for (const Eigen::Vector3d &axis : {Eigen::Vector3d(u.cross(v)), u, v})
                if (separates(axis.normalized()))
                    return true;
        }
        return false;
    }

    //! Do all base points of both patches lie as near to each other as those of one place?
    [[nodiscard]] bool share_base(int a, int b)
    {
        if (!m_one.tree().node(a).is_piece() || !m_other.tree().node(b).is_piece())
            return false;
        Eigen::AlignedBox3d points = m_one.base_over(m_one.box(a)).point;
        points.extend(m_other.base_over(m_other.box(b)).point);
        return points.diagonal().norm() < m_least_apart;
    }

    //! Are the patches beside a crease or seam that both parts end at, and apart but for base points that are as good as one?
    [[nodiscard]] bool beside_crease(const ParameterBox &a, const ParameterBox &b)
    {
        for (const gp_Vec2d &shift : m_shifts)
            for (const bool constant_u : {true, false})
                if (settled_there(a, b, shift, constant_u))
                    return true;
        return false;
    }

    //! The same with the other part's parameters shifted, at a crease of constant u or v.
    [[nodiscard]] bool settled_there(const ParameterBox &a, const ParameterBox &b, const gp_Vec2d &shift,
                                     bool constant_u)
    {
        const ParameterBox &one = m_one.part().input.box;
        const ParameterBox other = shifted(m_other.part().input.box, shift.X(), shift.Y());
        const double near = same_line * (constant_u ? one.umax - one.umin : one.vmax - one.vmin);
        const auto meet = [&](double end, double start) { return std::abs(end - start) < near; };
        const bool one_first = constant_u ? meet(one.umax, other.umin) : meet(one.vmax, other.vmin);
        const bool other_first = constant_u ? meet(other.umax, one.umin) : meet(other.vmax, one.vmin);
        if ((!one_first && !other_first) || !side_by_side(a, shifted(b, shift.X(), shift.Y()), constant_u))
            return false;
        ParameterBox before = hull(a, shifted(b, shift.X(), shift.Y())), after = before;
        if (constant_u)
            before.umax = after.umin = one_first ? one.umax : one.umin;
        else
            before.vmax = after.vmin = one_first ? one.vmax : one.vmin;
        if (before.umin >= before.umax || before.vmin >= before.vmax || after.umin >= after.umax ||
            after.vmin >= after.vmax)
            return false;
        ParameterBox &of_other = one_first ? after : before;
        of_other = shifted(of_other, -shift.X(), -shift.Y());
        if (!covered(m_one, one_first ? before : after, constant_u) || !covered(m_other, of_other, constant_u))
            return false;
        const CreaseNeighbours pair{one_first ? m_one : m_other, one_first ? m_other : m_one, before, after,
                                    constant_u};
        return farthest_base_points(pair) < m_least_apart || (m_crosses && cross_once(pair));
    }

    //! False: the patches are far from each other along a crease between them, or from the crease.
    [[nodiscard]] bool side_by_side(const ParameterBox &a, const ParameterBox &b, bool constant_u) const
    {
        constexpr double farthest_along = 3.0;
        const double widths = m_crosses ? nearest_widths_of_crossing : nearest_widths;
        const ParameterBox both = hull(a, b);
        const double widest_u = std::max(a.umax - a.umin, b.umax - b.umin);
        const double widest_v = std::max(a.vmax - a.vmin, b.vmax - b.vmin);
        return both.umax - both.umin <= (constant_u ? widths : farthest_along) * widest_u &&
               both.vmax - both.vmin <= (constant_u ? farthest_along : widths) * widest_v;
    }

    //! Has the part a surface along the whole rectangle?
    [[nodiscard]] static bool covered(const MeetingBody &body, const ParameterBox &box, bool constant_u)
    {
        const ParameterBox &own = body.part().analysis.base.box();
        const double slack = same_line * (constant_u ? own.vmax - own.vmin : own.umax - own.umin);
        if (constant_u)
            return body.periods().v > 0.0 || (box.vmin >= own.vmin - slack && box.vmax <= own.vmax + slack);
        return body.periods().u > 0.0 || (box.umin >= own.umin - slack && box.umax <= own.umax + slack);
    }

    bool meets(int a, int b)
    {
        const PatchNode &one = m_one.tree().node(a), &other = m_other.tree().node(b);
        if ((one.halvings + other.halvings) % newton_interval != 0 || m_newton_starts >= most_newton_starts ||
            m_followed >= most_followed || size(m_one, a) + size(m_other, b) > 4.0 * std::abs(m_query.distance))
            return false;
        ++m_newton_starts;
        Places start;
        start << 0.5 * (one.box.umin + one.box.umax), 0.5 * (one.box.vmin + one.box.vmax), 0.5,
            0.5 * (other.box.umin + other.box.umax), 0.5 * (other.box.vmin + other.box.vmax), 0.5;
        const auto on = [this](const Places &p) {
            return std::pair{m_one.jet(p[0], p[1], p[2]), m_other.jet(p[3], p[4], p[5])};
        };
        const std::optional<Places> place = solve(on, start);
        if (!place || !inside(*place) || base_gap(*place) < m_least_apart || base_meets(*place) ||
            (m_crosses && comes_from_crease(*place)))
            return false;
        m_meeting = PartMeeting{m_first, {(*place)[0], (*place)[1]}, m_second, {(*place)[3], (*place)[4]}};
        return true;
    }

    //! Newton's method with shortest steps, inside the boxes of the loops.
    template <typename Jets> [[nodiscard]] std::optional<Places> solve(const Jets &jets, Places place) const
    {
        const Places scale = m_high - m_low;
        place = place.cwiseMax(m_low).cwiseMin(m_high);
        const double close = coincidence * std::max(m_one.part().input.diagonal, m_other.part().input.diagonal);
        for (int step = 0; step < newton_steps; ++step)
        {
            const auto [one, other] = jets(place);
            const Eigen::Vector3d residual = one[0] - other[0];
            if (residual.norm() <= close)
                return place;
            Eigen::Matrix<double, 3, 6> jacobian;
            jacobian << one[1], one[2], one[3], -other[1], -other[2], -other[3];
            jacobian *= scale.asDiagonal();
            const Places move = jacobian.completeOrthogonalDecomposition().solve(residual);
            place = (place - scale.cwiseProduct(move)).cwiseMax(m_low).cwiseMin(m_high).eval();
        }
        return std::nullopt;
    }

    [[nodiscard]] bool inside(const Places &place) const
    {
        return m_one.part().analysis.region.contains({place[0], place[1]}) &&
               m_other.part().analysis.region.contains({place[3], place[4]});
    }

    [[nodiscard]] double base_gap(const Places &place) const
    {
        return (m_one.base(place[0], place[1]).s - m_other.base(place[3], place[4]).s).norm();
    }

    //! Does a meeting of surfaces go on from one of the bases with each other, which is theirs? That of slabs counts always.
    [[nodiscard]] bool base_meets(const Places &start) const
    {
        if (m_one.is_slab())
            return false;
        const auto on = [this](const Places &p) {
            const SurfaceJet a = m_one.base(p[0], p[1]), b = m_other.base(p[3], p[4]);
            const Eigen::Vector3d nothing = Eigen::Vector3d::Zero();
            return std::pair{std::array<Eigen::Vector3d, 4>{a.s, a.u, a.v, nothing},
                             std::array<Eigen::Vector3d, 4>{b.s, b.u, b.v, nothing}};
        };
        const std::optional<Places> place = solve(on, start);
        if (!place || !inside(*place) || on_border(m_one, (*place)[0], (*place)[1]) ||
            on_border(m_other, (*place)[3], (*place)[4]))
            return false;
        const SurfaceJet a = m_one.base((*place)[0], (*place)[1]), b = m_other.base((*place)[3], (*place)[4]);
        return a.u.cross(a.v).normalized().cross(b.u.cross(b.v).normalized()).norm() > 1e-3;
    }

    //! Does a meeting come from where the parts cross at a crease? With the distance that goes to zero, and its places with
    //! it run together; any other meeting ends on the way. This excuses a meeting, but settles nothing.
    [[nodiscard]] bool comes_from_crease(Places place)
    {
        ++m_followed;
        double part = 1.0, step = longest_step;
        for (int steps = 0; part > least_part && steps < most_steps; ++steps)
        {
            const std::optional<Places> moved = followed(place, part, part * (1.0 - step));
            if (moved)
            {
                place = *moved;
                part *= 1.0 - step;
                step = std::min(longest_step, 2.0 * step);
            }
            else if ((step *= 0.5) < shortest_step)
                return false;
        }
        return true;
    }

    //! The meeting at another part of the distance, as far as it lies where this one moves to.
    [[nodiscard]] std::optional<Places> followed(const Places &place, double part, double next) const
    {
        const auto one = m_one.jet_at(place[0], place[1], part), other = m_other.jet_at(place[3], place[4], part);
        Eigen::Matrix<double, 3, 4> jacobian;
        jacobian << one[1], one[2], -other[1], -other[2];
        const Places start = moved(place, jacobian, (next - part) * (other[3] - one[3]));
        const auto on = [this, next](const Places &p) {
            return std::pair{m_one.still_at(p[0], p[1], next), m_other.still_at(p[3], p[4], next)};
        };
        const std::optional<Places> found = solve(on, start);
        if (!found ||
            farthest_moved(start.cwiseMax(m_low).cwiseMin(m_high), *found) > most_bend * farthest_moved(place, *found))
            return std::nullopt;
        return found;
    }

    //! Where the linear equations for a change of the four parameters lead, the shortest way inside the parts' boxes: what comes
    //! upon an end of a parameter goes on along that border.
    [[nodiscard]] Places moved(const Places &place, Eigen::Matrix<double, 3, 4> jacobian, Eigen::Vector3d change) const
    {
        const std::array parameters{0, 1, 3, 4};
        const Eigen::Vector4d here = place(parameters), low = m_low(parameters), high = m_high(parameters);
        const Eigen::Vector4d widths = high - low;
        jacobian *= widths.asDiagonal();
        Eigen::Vector4d move = Eigen::Vector4d::Zero();
        std::array<bool, 4> at_end{};
        for (bool changed = true; changed;)
        {
            changed = false;
            const Eigen::Vector4d free = jacobian.completeOrthogonalDecomposition().solve(change);
            for (int k = 0; k < 4; ++k)
            {
                if (at_end[static_cast<std::size_t>(k)])
                    continue;
                move[k] = std::clamp(widths[k] * free[k], low[k] - here[k], high[k] - here[k]);
                if (move[k] == widths[k] * free[k])
                    continue;
                at_end[static_cast<std::size_t>(k)] = changed = true;
                change -= jacobian.col(k) * (move[k] / widths[k]);
                jacobian.col(k).setZero();
            }
        }
        Places end = place;
        end(parameters) += move;
        return end;
    }

    //! Of the two base points.
    [[nodiscard]] double farthest_moved(const Places &from, const Places &to) const
    {
        return std::max((m_one.base(from[0], from[1]).s - m_one.base(to[0], to[1]).s).norm(),
                        (m_other.base(from[3], from[4]).s - m_other.base(to[3], to[4]).s).norm());
    }

    [[nodiscard]] static bool on_border(const MeetingBody &body, double u, double v)
    {
        const ParameterBox &box = body.part().input.box;
        const double du = same_line * (box.umax - box.umin), dv = same_line * (box.vmax - box.vmin);
        return u < box.umin + du || u > box.umax - du || v < box.vmin + dv || v > box.vmax - dv;
    }

    MeetingBody &m_one;
    MeetingBody &m_other;
    const PartMeetingQuery &m_query;
    std::vector<gp_Vec2d> m_shifts;
    bool m_crosses;
    Places m_low, m_high; //!< the boxes of the loops
    double m_least_apart;
    double m_resolution;
    int m_newton_starts = 0;
    int m_followed = 0;
    std::size_t m_first, m_second; //!< the parts' numbers
    std::optional<PartMeeting> m_open;
    std::optional<PartMeeting> m_meeting;
};

Neighbourhood neighbourhood(const PartMeetingQuery &query, std::size_t one, std::size_t other, const Periods &periods)
{
    Neighbourhood around{one, other, {}, query.cross && query.cross(one, other)};
    const auto add = [&](const gp_Vec2d &shift) {
        if (std::none_of(around.shifts.begin(), around.shifts.end(),
                         [&](const gp_Vec2d &known) { return (shift - known).Magnitude() < same_line; }))
            around.shifts.push_back(shift);
    };
    for (const CreaseEdge &edge : query.edges)
        if (edge.first == one && edge.second == other)
            add(edge.shift);
    for (const double u : period_shifts(periods.u))
        for (const double v : period_shifts(periods.v))
            add({u, v});
    return around;
}

} // namespace

PartMeetingSearch find_part_meeting(const PartMeetingQuery &query)
{
    PartMeetingSearch result;
    if (query.parts.size() < 2 || std::abs(query.distance) <= 2.0 * query.tolerance)
        return result;
    const auto has_spline = [](const MeetingPart &part) { return part.analysis.base.spline().has_value(); };
    if (!std::all_of(query.parts.begin(), query.parts.end(), has_spline))
    {
        result.settled = false;
        return result;
    }
    const Eigen::Vector4d &pole = query.parts.front().far.poles.front();
    std::deque<MeetingBody> bodies;
    for (const MeetingPart &part : query.parts)
        bodies.emplace_back(part, query.tolerance, pole.head<3>() / pole.w());
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t j = i + 1; j < bodies.size(); ++j)
        {
            PairOfParts(bodies[i], bodies[j], query, neighbourhood(query, i, j, bodies[i].periods())).run(result);
            if (result.meeting)
                return result;
        }
    return result;
}

} // namespace laminate_offset
