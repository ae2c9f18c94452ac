// SPDX-License-Identifier: LGPL-2.1-or-later
#include "image_marcher.h"

#include "../spline/geom_values.h"

#include <Eigen/LU>
#include <GeomAdaptor_Curve.hxx>
#include <TColStd_Array1OfReal.hxx>

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

constexpr int parts_between_corners = 8;
constexpr int probes = 8;
constexpr int most_halvings = 60;
// Parameters this near to the end of a closed direction may belong to the other end [part of the width].
constexpr double seam_share = 1e-7;
// A parameter is free where the surface is this much slower than elsewhere.
constexpr double pole_share = 1e-6;
constexpr double inward_step = 1e-5;
// The end of the surface is reached within this part of the width.
constexpr double border_share = 1e-12;
constexpr double closed_share = 1e-9;
// A curve that leaves over the border may slide along it for so many tolerances before it counts as outside; that is no
// part of its image. What goes on along the border for longer is meant.
constexpr double longest_slide = 64.0;
// Parameters nearer to each other than this part of the range count as one.
constexpr double same_share = 1e-9;

} // namespace

ImageMarcher::ImageMarcher(const ImageSurface &on, const SpaceCurve &curve, double tolerance)
    : m_on(on), m_curve(curve), m_tolerance(tolerance), m_low(on.box.umin, on.box.vmin),
      m_high(on.box.umax, on.box.vmax)
{
    double gap[2] = {0.0, 0.0};
    for (int i = 0; i <= probes; ++i)
    {
        const Eigen::Vector2d at = m_low + (m_high - m_low) * i / probes;
        gap[0] = std::max(gap[0], on.surface->Value(m_low.x(), at.y()).Distance(on.surface->Value(m_high.x(), at.y())));
        gap[1] = std::max(gap[1], on.surface->Value(at.x(), m_low.y()).Distance(on.surface->Value(at.x(), m_high.y())));
        for (int j = 0; j <= probes; ++j)
        {
            gp_Pnt s;
            gp_Vec su, sv;
            on.surface->D1(at.x(), m_low.y() + (m_high.y() - m_low.y()) * j / probes, s, su, sv);
            m_speeds[0] = std::max(m_speeds[0], su.Magnitude());
            m_speeds[1] = std::max(m_speeds[1], sv.Magnitude());
        }
    }
    for (int k = 0; k < 2; ++k)
        m_closed[k] = gap[k] <= closed_share * on.size && m_speeds[k] > 0.0;
    m_speed = std::max({m_speeds[0], m_speeds[1], 1e-300});
    const GeomAdaptor_Curve adaptor(curve.curve, curve.first, curve.last);
    TColStd_Array1OfReal ends(1, adaptor.NbIntervals(GeomAbs_C1) + 1);
    adaptor.Intervals(ends, GeomAbs_C1);
    for (int i = 1; i <= ends.Upper(); ++i)
        m_corners.push_back(i == 1 ? curve.first : i == ends.Upper() ? curve.last : ends(i));
}

Eigen::Vector3d ImageMarcher::given(double t) const { return vector(m_curve.curve->Value(t).XYZ()); }

bool ImageMarcher::on_seam(const ImageFoot &foot, int direction) const
{
    const double width = m_high[direction] - m_low[direction];
    return m_closed[direction] && std::min(foot.uv[direction] - m_low[direction],
                                           m_high[direction] - foot.uv[direction]) <= seam_share * width;
}

bool ImageMarcher::at_pole(const ImageFoot &foot, int direction) const
{
    gp_Pnt s;
    gp_Vec su, sv;
    m_on.surface->D1(foot.uv.x(), foot.uv.y(), s, su, sv);
    return (direction == 0 ? su : sv).Magnitude() <= pole_share * m_speeds[direction];
}

//! The side of a seam, and a parameter that is free at a pole, follow the hint.
void ImageMarcher::settle(ImageFoot &foot, const Eigen::Vector2d &hint) const
{
    for (int k = 0; k < 2; ++k)
    {
        if (at_pole(foot, k))
            foot.uv[k] = hint[k];
        else if (on_seam(foot, k))
            foot.uv[k] = std::abs(hint[k] - m_low[k]) <= std::abs(hint[k] - m_high[k]) ? m_low[k] : m_high[k];
    }
}

ImageFoot ImageMarcher::foot(double t, const Eigen::Vector2d &hint) const
{
    gp_Pnt c;
    gp_Vec along;
    m_curve.curve->D1(t, c, along);
    const Eigen::Vector3d given = vector(c.XYZ());
    const SurfaceFoot nearest = m_on.search.nearest(given, hint);
    ImageFoot result{t, nearest.uv, {0.0, 0.0}, nearest.point, nearest.distance, false};
    settle(result, hint);
    gp_Pnt s;
    gp_Vec u, v, uu, vv, uv;
    m_on.surface->D2(result.uv.x(), result.uv.y(), s, u, v, uu, vv, uv);
    const gp_Vec r(c, s);
    // tangent dropping: (S - C).S_u = (S - C).S_v = 0 (eq. 3.14) differentiated along the curve; on the surface S = C
    // and the matrix is that of the first fundamental form
    Eigen::Matrix2d first_form;
    first_form << u.Dot(u), u.Dot(v), u.Dot(v), v.Dot(v);
    Eigen::Matrix2d matrix;
    matrix << u.Dot(u) + r.Dot(uu), u.Dot(v) + r.Dot(uv), u.Dot(v) + r.Dot(uv), v.Dot(v) + r.Dot(vv);
    const Eigen::Vector2d right(u.Dot(along), v.Dot(along));
    if (!(matrix(0, 0) > 0.0 && matrix.determinant() > 1e-6 * first_form(0, 0) * first_form(1, 1)))
        matrix = first_form;
    if (matrix.determinant() > 1e-12 * matrix(0, 0) * matrix(1, 1))
        result.slope = matrix.inverse() * right;
    bool held[2] = {false, false};
    for (int k = 0; k < 2; ++k)
    {
        const double width = m_high[k] - m_low[k];
        const bool low = result.uv[k] - m_low[k] <= border_share * width;
        const bool high = m_high[k] - result.uv[k] <= border_share * width;
        const gp_Vec &side = k == 0 ? u : v;
        const double beyond = -r.Dot(side) / std::max(side.Magnitude(), 1e-300); // how far C lies past the side
        result.on_border = result.on_border || (!m_closed[k] && (low || high));
        held[k] = !m_closed[k] && ((low && beyond < -m_tolerance) || (high && beyond > m_tolerance));
    }
    result.outside = held[0] || held[1];
    // a foot that the end of the surface holds back moves along that end only
    for (int k = 0; k < 2; ++k)
        if (held[k])
            result.slope[1 - k] =
                held[1 - k] || !(matrix(1 - k, 1 - k) > 0.0) ? 0.0 : right[1 - k] / matrix(1 - k, 1 - k);
    for (int k = 0; k < 2; ++k)
        if (held[k])
            result.slope[k] = 0.0;
    return result;
}

std::vector<double> ImageMarcher::parameters() const
{
    std::vector<double> result;
    for (std::size_t i = 0; i + 1 < m_corners.size(); ++i)
        for (int k = 0; k < parts_between_corners; ++k)
            result.push_back(m_corners[i] + (m_corners[i + 1] - m_corners[i]) * k / parts_between_corners);
    result.push_back(m_corners.back());
    return result;
}

//! Feet all along the curve; what is settled by a hint only takes it from the nearest foot that needs none.
std::vector<ImageFoot> ImageMarcher::feet() const
{
    const std::vector<double> ts = parameters();
    std::vector<Eigen::Vector2d> free;
    std::vector<char> sure;
    for (std::size_t i = 0; i < ts.size(); ++i)
    {
        const SurfaceFoot nearest = m_on.search.nearest(given(ts[i]));
        const ImageFoot plain{ts[i], nearest.uv, {}, nearest.point, nearest.distance, false};
        free.push_back(nearest.uv);
        sure.push_back(on_seam(plain, 0) || on_seam(plain, 1) || at_pole(plain, 0) || at_pole(plain, 1) ? 0 : 1);
    }
    std::vector<ImageFoot> result;
    for (std::size_t i = 0; i < ts.size(); ++i)
    {
        Eigen::Vector2d hint = sure[i] != 0 ? free[i] : Eigen::Vector2d(m_low);
        // the next foot that needs no hint, looked for forwards at first: a run begins on its own side of a seam
        for (std::size_t step = 1; sure[i] == 0 && step < ts.size(); ++step)
        {
            const bool ahead = i + step < ts.size() && sure[i + step] != 0;
            const bool behind = i >= step && sure[i - step] != 0;
            if (!ahead && !behind)
                continue;
            hint = free[ahead ? i + step : i - step];
            break;
        }
        if (sure[i] == 0) // a step inwards tells more than the neighbour's parameters
        {
            const double towards = i + 1 < ts.size() ? ts[i + 1] : ts[i - 1];
            const ImageFoot beside = foot(ts[i] + inward_step * (towards - ts[i]), hint);
            hint = beside.uv;
        }
        result.push_back(foot(ts[i], hint));
    }
    return result;
}

bool ImageMarcher::jumps(const ImageFoot &a, const ImageFoot &b) const
{
    for (int k = 0; k < 2; ++k)
        if (m_closed[k] && std::abs(a.uv[k] - b.uv[k]) > 0.5 * (m_high[k] - m_low[k]))
            return true;
    return false;
}

template <typename Differ>
std::pair<ImageFoot, ImageFoot> ImageMarcher::transition(ImageFoot a, ImageFoot b, const Differ &differ) const
{
    for (int step = 0; step < most_halvings; ++step)
    {
        const double middle = 0.5 * (a.t + b.t);
        if (!(middle > a.t && middle < b.t))
            break;
        const ImageFoot between = foot(middle, a.uv);
        (differ(a, between) ? b : a) = between;
    }
    return {a, b};
}

ImageFoot ImageMarcher::border_crossing(const ImageFoot &inner, const ImageFoot &last) const
{
    if (!last.on_border)
        return last;
    const auto differ = [](const ImageFoot &x, const ImageFoot &y) { return x.on_border != y.on_border; };
    const ImageFoot crossing = inner.on_border    ? inner
                               : inner.t < last.t ? transition(inner, last, differ).second
                                                  : transition(last, inner, differ).first;
    return (crossing.point - last.point).norm() <= longest_slide * m_tolerance ? crossing : last;
}

namespace
{

//! Feet that all but coincide become one; the ends of the run stay.
void thin_out(std::vector<ImageFoot> &feet, double same)
{
    std::vector<ImageFoot> kept{feet.front()};
    for (std::size_t i = 1; i + 1 < feet.size(); ++i)
        if (feet[i].t - kept.back().t > same && feet.back().t - feet[i].t > same)
            kept.push_back(feet[i]);
    kept.push_back(feet.back());
    feet = std::move(kept);
}

} // namespace

std::vector<ImageRun> ImageMarcher::runs(bool clip) const
{
    const std::vector<ImageFoot> all = feet();
    std::vector<ImageRun> runs(1);
    const auto add = [&](const ImageFoot &foot) {
        if (!clip || !foot.outside)
            runs.back().feet.push_back(foot);
    };
    add(all.front());
    for (std::size_t i = 1; i < all.size(); ++i)
    {
        const ImageFoot &before = all[i - 1];
        const ImageFoot &here = all[i];
        if (clip && before.outside != here.outside)
        {
            const auto [a, b] =
                transition(before, here, [](const ImageFoot &x, const ImageFoot &y) { return x.outside != y.outside; });
            add(before.outside ? border_crossing(here, b) : border_crossing(before, a));
            if (here.outside)
                runs.emplace_back();
        }
        else if (jumps(before, here))
        {
            auto [a, b] =
                transition(before, here, [this](const ImageFoot &x, const ImageFoot &y) { return jumps(x, y); });
            b = foot(a.t, here.uv); // both runs end at the same place, each on its own side
            a = foot(a.t, before.uv);
            add(a);
            runs.emplace_back();
            add(b);
        }
        add(here);
    }
    const double same = same_share * (m_curve.last - m_curve.first);
    std::erase_if(runs, [same](const ImageRun &run) {
        return run.feet.size() < 2 || !(run.feet.back().t - run.feet.front().t > same);
    });
    for (ImageRun &run : runs)
    {
        run.corners = m_corners;
        thin_out(run.feet, same);
    }
    return runs;
}

} // namespace laminate_offset
