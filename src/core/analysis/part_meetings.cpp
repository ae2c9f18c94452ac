// SPDX-License-Identifier: LGPL-2.1-or-later
#include "part_meetings.h"

#include "meeting_search.h"
#include "parameter_periods.h"
#include "patch_tree.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>

namespace laminate_offset
{
namespace
{

constexpr int most_newton_starts = 2000;
constexpr int newton_steps = 16;
// Patches are judged beside a crease from which they lie no farther away than so many times their width.
constexpr double nearest_widths = 8.0;
// Parts end at one crease when their loops do within this part of their width.
constexpr double same_line = 1e-6;
// A meeting is followed to this part of the distance, in steps that take a fifth of what is left off at most. A step is
// halved where its end is off by more than a quarter of its length from where its start points, and doubled again after.
constexpr double least_part = 1e-3;
constexpr double longest_step = 0.2;
constexpr double shortest_step = longest_step / 4096.0;
constexpr double most_bend = 0.25;
constexpr int most_steps = 500;

constexpr double infinity = std::numeric_limits<double>::infinity();

//! Places of two parts: (u, v, height) of one and of the other; the height is 0 on the near surface and 1 on the far one.
using Places = Eigen::Matrix<double, 6, 1>;

//! The range of a linear form over a box.
struct Reach
{
    double low = infinity;
    double high = -infinity;

    static Reach of(const Eigen::Vector3d &axis, const Eigen::AlignedBox3d &box)
    {
        const double middle = axis.dot(box.center());
        const double half = 0.5 * axis.cwiseAbs().dot(box.sizes());
        return {middle - half, middle + half};
    }
    void extend(const Reach &other)
    {
        low = std::min(low, other.low);
        high = std::max(high, other.high);
    }
    [[nodiscard]] double largest() const { return std::max(std::abs(low), std::abs(high)); }
};

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

//! The shifts of a parameter to look at.
std::vector<double> shifts(double period)
{
    return period > 0.0 ? std::vector<double>{0.0, -period, period} : std::vector<double>{0.0};
}

//! A surface of one part.
struct Sheet
{
    Sheet(const TensorSpline &own, const Eigen::Vector3d &from) : spline(&own), tree(own, from), origin(from) {}

    [[nodiscard]] Eigen::Vector3d at(double u, double v) const { return spline->jets({u}, {v}, 0).front().s - origin; }

    const TensorSpline *spline;
    PatchTree tree;
    Eigen::Vector3d origin;
};

//! A surface over a patch: its middle point and bounds.
struct SheetBounds
{
    Eigen::Vector3d middle;
    PatchBounds bounds;

    [[nodiscard]] Reach along(const Eigen::Vector3d &axis, const ParameterBox &box) const
    {
        const double half = 0.5 * (box.umax - box.umin) * Reach::of(axis, bounds.du).largest() +
                            0.5 * (box.vmax - box.vmin) * Reach::of(axis, bounds.dv).largest();
        const double at = axis.dot(middle);
        const Reach by_box = Reach::of(axis, bounds.point);
        return {std::max(at - half, by_box.low), std::min(at + half, by_box.high)};
    }
};

//! One part: its surfaces and what is known of their patches, numbered as in the search's tree. That one is a tree of the
//! far surface of its own: bounds over narrow rectangles halve theirs into narrow patches.
class Body
{
public:
    Body(const MeetingPart &part, const PartMeetingQuery &query, const Eigen::Vector3d &origin)
        : m_part(part), m_periods(periods_of(part.input, query.tolerance)),
          m_base(*part.analysis.base.spline(), origin), m_tree(part.far, origin)
    {
        m_sheets.push_back(std::make_unique<Sheet>(part.far, origin));
        if (part.near)
            m_sheets.push_back(std::make_unique<Sheet>(*part.near, origin));
    }

    [[nodiscard]] const MeetingPart &part() const { return m_part; }
    [[nodiscard]] const Periods &periods() const { return m_periods; }
    [[nodiscard]] PatchTree &tree() { return m_tree; }
    [[nodiscard]] bool is_slab() const { return m_sheets.size() > 1; }
    [[nodiscard]] const ParameterBox &box(int index) { return tree().node(index).box; }

    const std::vector<SheetBounds> &patch(int index)
    {
        if (m_patches.size() <= static_cast<std::size_t>(index))
            m_patches.resize(static_cast<std::size_t>(2 * index + 16));
        std::vector<SheetBounds> &known = m_patches[static_cast<std::size_t>(index)];
        if (known.empty())
        {
            const ParameterBox box = tree().node(index).box;
            const double u = 0.5 * (box.umin + box.umax), v = 0.5 * (box.vmin + box.vmax);
            for (const auto &sheet : m_sheets)
                known.push_back({sheet->at(u, v), sheet->tree.bounds_over(box)});
        }
        return known;
    }

    //! Is any part of the patch inside the loops?
    bool touches(int index)
    {
        if (m_touches.size() <= static_cast<std::size_t>(index))
            m_touches.resize(static_cast<std::size_t>(2 * index + 16), -1);
        signed char &known = m_touches[static_cast<std::size_t>(index)];
        if (known < 0)
            known = m_part.analysis.region.may_touch(tree().node(index).box) ? 1 : 0;
        return known == 1;
    }

    //! Bounds of every surface over a rectangle, whose parameters may go on across a seam.
    std::vector<PatchBounds> over(const ParameterBox &box)
    {
        std::vector<PatchBounds> bounds;
        for (const auto &sheet : m_sheets)
            bounds.push_back(wrapped(sheet->tree, box));
        return bounds;
    }

    PatchBounds base_over(const ParameterBox &box) { return wrapped(m_base.tree, box); }

    //! The points of all surfaces at one place, whose parameters may go on across a seam.
    [[nodiscard]] std::vector<Eigen::Vector3d> points(double u, double v) const
    {
        const ParameterBox &box = m_part.analysis.base.box();
        const auto inside = [](double x, double low, double high, double period) {
            while (period > 0.0 && x < low - 1e-9 * period)
                x += period;
            while (period > 0.0 && x > high + 1e-9 * period)
                x -= period;
            return std::clamp(x, low, high);
        };
        std::vector<Eigen::Vector3d> result;
        for (const auto &sheet : m_sheets)
            result.push_back(
                sheet->at(inside(u, box.umin, box.umax, m_periods.u), inside(v, box.vmin, box.vmax, m_periods.v)));
        return result;
    }

    //! Point and derivatives at a height, the last one with respect to the height.
    [[nodiscard]] std::array<Eigen::Vector3d, 4> jet(double u, double v, double height) const
    {
        const SurfaceJet far = m_part.far.jets({u}, {v}, 1).front();
        if (!is_slab())
            return {far.s, far.u, far.v, Eigen::Vector3d::Zero()};
        const SurfaceJet near = m_part.near->jets({u}, {v}, 1).front();
        return {near.s + height * (far.s - near.s), near.u + height * (far.u - near.u),
                near.v + height * (far.v - near.v), far.s - near.s};
    }

    //! The same at a part of the far surface's distance, with respect to which the last one is.
    [[nodiscard]] std::array<Eigen::Vector3d, 4> jet_at(double u, double v, double part) const
    {
        const SurfaceJet far = m_part.far.jets({u}, {v}, 1).front(), own = base(u, v);
        return {own.s + part * (far.s - own.s), own.u + part * (far.u - own.u), own.v + part * (far.v - own.v),
                far.s - own.s};
    }

    //! The same where the part does not change.
    [[nodiscard]] std::array<Eigen::Vector3d, 4> still_at(double u, double v, double part) const
    {
        auto jet = jet_at(u, v, part);
        jet[3].setZero();
        return jet;
    }

    [[nodiscard]] SurfaceJet base(double u, double v) const { return m_part.analysis.base.jets({u}, {v}, 1).front(); }

private:
    [[nodiscard]] PatchBounds wrapped(PatchTree &tree, const ParameterBox &box) const
    {
        PatchBounds bounds;
        for (const double u : shifts(m_periods.u))
            for (const double v : shifts(m_periods.v))
                bounds.extend(tree.bounds_over(shifted(box, u, v)));
        return bounds;
    }

    const MeetingPart &m_part;
    Periods m_periods;
    Sheet m_base;
    PatchTree m_tree;
    std::vector<std::unique_ptr<Sheet>> m_sheets; //!< the far one first
    std::vector<std::vector<SheetBounds>> m_patches;
    std::vector<signed char> m_touches;
};

//! Two patches beside a crease, in coordinates in which the part with the lower parameters comes first.
struct CreaseNeighbours
{
    Body &lower;
    Body &upper;
    ParameterBox before; //!< the patch of the lower part, continued to the crease and along the other one
    ParameterBox after;  //!< the same of the upper part, in the upper part's parameters
    bool constant_u = false;
};

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

//! Of places of two patches beside a crease that come to one point, no more than this lies between the base points.
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

//! Do two patches beside a crease at which the surfaces cross come upon each other along one line at most, which is the
//! crossing at the crease?
bool cross_once(const CreaseNeighbours &pair)
{
    CreaseFrame frame(pair);
    return frame.make() && frame.slopes_apart();
}

//! Two parts, by their numbers, and what they have in common.
struct Neighbourhood
{
    std::size_t first = 0;
    std::size_t second = 0;
    //! Shifts of the second part's parameters that continue those of the first one across an edge of both.
    std::vector<gp_Vec2d> shifts;
    bool crosses = false; //!< at such an edge, or at an end of one, they are known to cross
};

//! The search through the patches of two parts.
class PairOfParts
{
public:
    PairOfParts(Body &one, Body &other, const PartMeetingQuery &query, const Neighbourhood &around)
        : m_one(one), m_other(other), m_query(query), m_shifts(around.shifts), m_crosses(around.crosses),
          m_least_apart(least_apart(query.distance, query.tolerance)), m_resolution(resolution_share * query.tolerance),
          m_first(around.first), m_second(around.second)
    {
        const auto known = [this](const gp_Vec2d &shift) {
            return std::any_of(m_shifts.begin(), m_shifts.end(),
                               [&](const gp_Vec2d &one_known) { return (shift - one_known).Magnitude() < same_line; });
        };
        for (const double u : shifts(one.periods().u))
            for (const double v : shifts(one.periods().v))
                if (!known({u, v}))
                    m_shifts.emplace_back(u, v);
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
            if (++pairs > most_pairs)
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

    [[nodiscard]] static double size(Body &body, int index)
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
        if (!one_first && !other_first)
            return false;
        const ParameterBox there = shifted(b, shift.X(), shift.Y()), both = hull(a, there);
        const double widest_u = std::max(a.umax - a.umin, b.umax - b.umin);
        const double widest_v = std::max(a.vmax - a.vmin, b.vmax - b.vmin);
        const double length = constant_u ? both.vmax - both.vmin : both.umax - both.umin;
        const double width = constant_u ? both.umax - both.umin : both.vmax - both.vmin;
        if (length > 3.0 * (constant_u ? widest_v : widest_u) ||
            width > nearest_widths * (constant_u ? widest_u : widest_v))
            return false; // far from each other along the crease, or from the crease
        ParameterBox before = both, after = both;
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

    //! Has the part a surface along the whole rectangle?
    [[nodiscard]] static bool covered(const Body &body, const ParameterBox &box, bool constant_u)
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
            size(m_one, a) + size(m_other, b) > 4.0 * std::abs(m_query.distance))
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
    [[nodiscard]] bool comes_from_crease(Places place) const
    {
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
        const Eigen::Vector4d widths = (m_high - m_low)(std::array{0, 1, 3, 4});
        jacobian *= widths.asDiagonal();
        const Eigen::Vector4d move =
            widths.cwiseProduct(jacobian.completeOrthogonalDecomposition().solve((next - part) * (other[3] - one[3])));
        Places start = place;
        start(std::array{0, 1, 3, 4}) += move;
        const auto on = [this, next](const Places &p) {
            return std::pair{m_one.still_at(p[0], p[1], next), m_other.still_at(p[3], p[4], next)};
        };
        const std::optional<Places> found = solve(on, start);
        if (!found ||
            farthest_moved(start.cwiseMax(m_low).cwiseMin(m_high), *found) > most_bend * farthest_moved(place, *found))
            return std::nullopt;
        return found;
    }

    //! Of the two base points.
    [[nodiscard]] double farthest_moved(const Places &from, const Places &to) const
    {
        return std::max((m_one.base(from[0], from[1]).s - m_one.base(to[0], to[1]).s).norm(),
                        (m_other.base(from[3], from[4]).s - m_other.base(to[3], to[4]).s).norm());
    }

    [[nodiscard]] static bool on_border(const Body &body, double u, double v)
    {
        const ParameterBox &box = body.part().input.box;
        const double du = same_line * (box.umax - box.umin), dv = same_line * (box.vmax - box.vmin);
        return u < box.umin + du || u > box.umax - du || v < box.vmin + dv || v > box.vmax - dv;
    }

    Body &m_one;
    Body &m_other;
    const PartMeetingQuery &m_query;
    std::vector<gp_Vec2d> m_shifts;
    bool m_crosses;
    Places m_low, m_high; //!< the boxes of the loops
    double m_least_apart;
    double m_resolution;
    int m_newton_starts = 0;
    std::size_t m_first, m_second; //!< the parts' numbers
    std::optional<PartMeeting> m_open;
    std::optional<PartMeeting> m_meeting;
};

Neighbourhood neighbourhood(const PartMeetingQuery &query, std::size_t one, std::size_t other)
{
    Neighbourhood around{one, other, {}, false};
    for (const CreaseEdge &edge : query.edges)
        if (edge.first == one && edge.second == other)
            around.shifts.push_back(edge.shift);
    around.crosses = query.cross && query.cross(one, other);
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
    std::deque<Body> bodies;
    for (const MeetingPart &part : query.parts)
        bodies.emplace_back(part, query, pole.head<3>() / pole.w());
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t j = i + 1; j < bodies.size(); ++j)
        {
            PairOfParts(bodies[i], bodies[j], query, neighbourhood(query, i, j)).run(result);
            if (result.meeting)
                return result;
        }
    return result;
}

} // namespace laminate_offset
