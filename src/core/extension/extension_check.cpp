// SPDX-License-Identifier: LGPL-2.1-or-later
#include "extension_check.h"

#include "../analysis/meeting_step.h"
#include "../analysis/patch_tree.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

constexpr int fold_lines = 33;
constexpr int fold_steps = 64;
// Next to each other, normals of a smooth surface at this sampling turn by less than a right angle.
constexpr double smallest_sine = 1e-7;

constexpr int most_pairs = 60000;
constexpr int most_newton_starts = 400;
constexpr int newton_steps = 20;
// Patches of this part of the surface's size are as good as points.
constexpr double resolution_share = 1e-4;
// Two points this near, as a part of the size, are one.
constexpr double coincidence = 1e-10;
// Two places nearer than this part of the parameters' ranges are one.
constexpr double same_place = 1e-4;

bool along_u(Side side) { return side == Side::UMin || side == Side::UMax; }

struct Sample
{
    gp_Pnt point;
    gp_Vec normal;     //!< S_u x S_v
    double size = 0.0; //!< |S_u| |S_v|
};

Sample sample_at(const Geom_Surface &surface, double u, double v)
{
    Sample sample;
    gp_Vec du, dv;
    surface.D1(u, v, sample.point, du, dv);
    sample.normal = du.Crossed(dv);
    sample.size = du.Magnitude() * dv.Magnitude();
    return sample;
}

//! The first step of a line on which the normal turns over or vanishes.
std::optional<ExtensionFold> fold_on_line(const Geom_Surface &surface, const gp_Pnt2d &from, const gp_Pnt2d &to)
{
    Sample before = sample_at(surface, from.X(), from.Y());
    if (before.normal.Magnitude() <= smallest_sine * before.size || !(before.size > 0.0))
        return std::nullopt; // the line runs into a pole of the face itself
    double length = 0.0;
    for (int i = 1; i <= fold_steps; ++i)
    {
        const gp_XY uv = from.XY() + (to.XY() - from.XY()) * (static_cast<double>(i) / fold_steps);
        const Sample here = sample_at(surface, uv.X(), uv.Y());
        length += before.point.Distance(here.point);
        if (!(here.normal.Magnitude() > smallest_sine * here.size) || !(here.normal.Dot(before.normal) > 0.0))
            return ExtensionFold{gp_Pnt2d(uv), length};
        before = here;
    }
    return std::nullopt;
}

using Place = Eigen::Vector4d; //!< (u, v) of one place and of the other

bool inside(const ParameterBox &box, double u, double v, double margin_u, double margin_v)
{
    return u >= box.umin - margin_u && u <= box.umax + margin_u && v >= box.vmin - margin_v && v <= box.vmax + margin_v;
}

bool inside(const ParameterBox &outer, const ParameterBox &inner)
{
    return inside(outer, inner.umin, inner.vmin, 0.0, 0.0) && inside(outer, inner.umax, inner.vmax, 0.0, 0.0);
}

class MeetingSearch
{
public:
    MeetingSearch(const TensorSpline &surface, const ParameterBox &base)
        : m_surface(surface), m_base(base),
          m_tree(surface), m_whole{surface.u.front(), surface.u.back(), surface.v.front(), surface.v.back()},
          m_size(m_tree.node(PatchTree::root()).bounds.point.diagonal().norm())
    {
        m_closed_u = closed(true);
        m_closed_v = closed(false);
    }

    std::optional<ExtensionMeeting> run()
    {
        within(PatchTree::root());
        return m_meeting;
    }

private:
    [[nodiscard]] bool over() const { return m_meeting.has_value() || m_pairs >= most_pairs; }
    [[nodiscard]] double range_u() const { return m_whole.umax - m_whole.umin; }
    [[nodiscard]] double range_v() const { return m_whole.vmax - m_whole.vmin; }
    [[nodiscard]] SurfaceJet jet(double u, double v) const { return m_surface.jets({u}, {v}, 1).front(); }

    //! Do the two ends of one parameter show the same curve?
    [[nodiscard]] bool closed(bool in_u) const
    {
        constexpr int samples = 16;
        for (int i = 0; i <= samples; ++i)
        {
            const double u = m_whole.umin + range_u() * i / samples;
            const double v = m_whole.vmin + range_v() * i / samples;
            const Eigen::Vector3d gap = in_u ? jet(m_whole.umin, v).s - jet(m_whole.umax, v).s
                                             : jet(u, m_whole.vmin).s - jet(u, m_whole.vmax).s;
            if (gap.norm() > 1e-7 * m_size)
                return false;
        }
        return true;
    }

    //! Only what reaches past the base counts.
    [[nodiscard]] bool of_base(int index) const { return inside(m_base, m_tree.node(index).box); }

    void within(int index)
    {
        const PatchNode &node = m_tree.node(index);
        constexpr int deepest = 12;
        if (over() || of_base(index) || node.bounds.one_to_one() || node.halvings >= deepest ||
            node.bounds.point.diagonal().norm() < resolution_share * m_size)
            return;
        m_tree.split(index);
        const auto [lower, upper] = std::pair{m_tree.node(index).lower, m_tree.node(index).upper};
        within(lower);
        within(upper);
        between(lower, upper);
    }

    void between(int first, int second)
    {
        if (over())
            return;
        ++m_pairs;
        const PatchNode &a = m_tree.node(first);
        const PatchNode &b = m_tree.node(second);
        if ((of_base(first) && of_base(second)) || !a.bounds.point.intersects(b.bounds.point) || neighbours(a, b))
            return;
        const double size_a = a.bounds.point.diagonal().norm();
        const double size_b = b.bounds.point.diagonal().norm();
        if (a.is_piece() && b.is_piece() && try_newton(a, b))
            return;
        if (std::max(size_a, size_b) < resolution_share * m_size)
            return;
        const int larger = size_a >= size_b ? first : second;
        const int other = size_a >= size_b ? second : first;
        m_tree.split(larger);
        between(m_tree.node(larger).lower, other);
        between(m_tree.node(larger).upper, other);
    }

    //! One-to-one over the rectangle that holds both.
    bool neighbours(const PatchNode &a, const PatchNode &b)
    {
        const double gap_u = std::max(a.box.umin - b.box.umax, b.box.umin - a.box.umax);
        const double gap_v = std::max(a.box.vmin - b.box.vmax, b.box.vmin - a.box.vmax);
        if (gap_u > std::max(a.box.umax - a.box.umin, b.box.umax - b.box.umin) ||
            gap_v > std::max(a.box.vmax - a.box.vmin, b.box.vmax - b.box.vmin))
            return false;
        const ParameterBox both{std::min(a.box.umin, b.box.umin), std::max(a.box.umax, b.box.umax),
                                std::min(a.box.vmin, b.box.vmin), std::max(a.box.vmax, b.box.vmax)};
        return m_tree.bounds_over(both).one_to_one();
    }

    bool try_newton(const PatchNode &a, const PatchNode &b)
    {
        if (m_newton_starts >= most_newton_starts)
            return false;
        ++m_newton_starts;
        const std::optional<Place> place = solve({0.5 * (a.box.umin + a.box.umax), 0.5 * (a.box.vmin + a.box.vmax),
                                                  0.5 * (b.box.umin + b.box.umax), 0.5 * (b.box.vmin + b.box.vmax)});
        if (!place || same(*place) || at_seam(*place) || at_pole(*place))
            return false;
        const bool first_past = past_base(place->x(), place->y());
        if (!first_past && !past_base(place->z(), place->w()))
            return false;
        const gp_Pnt2d p(place->x(), place->y());
        const gp_Pnt2d q(place->z(), place->w());
        m_meeting = first_past ? ExtensionMeeting{p, q} : ExtensionMeeting{q, p};
        return true;
    }

    [[nodiscard]] bool past_base(double u, double v) const
    {
        return !inside(m_base, u, v, 1e-6 * range_u(), 1e-6 * range_v());
    }

    [[nodiscard]] bool same(const Place &p) const
    {
        return std::abs(p.x() - p.z()) < same_place * range_u() && std::abs(p.y() - p.w()) < same_place * range_v();
    }

    //! Both places at the seam of a closed direction, on its two sides.
    [[nodiscard]] bool at_seam(const Place &p) const
    {
        const double du = std::abs(p.x() - p.z());
        const double dv = std::abs(p.y() - p.w());
        const double near_u = same_place * range_u();
        const double near_v = same_place * range_v();
        return (m_closed_u && std::abs(du - range_u()) < near_u && dv < near_v) ||
               (m_closed_v && std::abs(dv - range_v()) < near_v && du < near_u);
    }

    //! Both places where the surface comes to a point.
    [[nodiscard]] bool at_pole(const Place &p) const
    {
        const SurfaceJet a = jet(p.x(), p.y());
        const SurfaceJet b = jet(p.z(), p.w());
        const double tiny = 1e-4 * m_size;
        return (a.u.norm() * range_u() < tiny && b.u.norm() * range_u() < tiny) ||
               (a.v.norm() * range_v() < tiny && b.v.norm() * range_v() < tiny);
    }

    //! Newton's method with shortest steps for S(p) = S(q).
    [[nodiscard]] std::optional<Place> solve(Place place) const
    {
        for (int step = 0; step < newton_steps; ++step)
        {
            const SurfaceJet a = jet(place.x(), place.y());
            const SurfaceJet b = jet(place.z(), place.w());
            if ((a.s - b.s).norm() <= coincidence * m_size)
                return place;
            step_together(a, b, m_whole, place);
        }
        return std::nullopt;
    }

    const TensorSpline &m_surface;
    ParameterBox m_base;
    PatchTree m_tree;
    ParameterBox m_whole;
    double m_size;
    bool m_closed_u = false;
    bool m_closed_v = false;
    int m_pairs = 0;
    int m_newton_starts = 0;
    std::optional<ExtensionMeeting> m_meeting;
};

} // namespace

std::optional<ExtensionFold> find_fold(const Geom_Surface &surface, const ParameterBox &before,
                                       const ParameterBox &after, Side side)
{
    for (int k = 0; k < fold_lines; ++k)
    {
        const double s = static_cast<double>(k) / (fold_lines - 1);
        const double u = before.umin + s * (before.umax - before.umin);
        const double v = before.vmin + s * (before.vmax - before.vmin);
        const bool end = side == Side::UMax || side == Side::VMax;
        const gp_Pnt2d from =
            along_u(side) ? gp_Pnt2d(end ? before.umax : before.umin, v) : gp_Pnt2d(u, end ? before.vmax : before.vmin);
        const gp_Pnt2d to =
            along_u(side) ? gp_Pnt2d(end ? after.umax : after.umin, v) : gp_Pnt2d(u, end ? after.vmax : after.vmin);
        if (const auto fold = fold_on_line(surface, from, to))
            return fold;
    }
    return std::nullopt;
}

std::optional<ExtensionMeeting> find_meeting(const TensorSpline &surface, const ParameterBox &base)
{
    if (whole_bounds(surface).one_to_one())
        return std::nullopt;
    return MeetingSearch(surface, base).run();
}

} // namespace laminate_offset
