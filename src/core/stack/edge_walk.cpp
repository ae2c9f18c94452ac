// SPDX-License-Identifier: LGPL-2.1-or-later
#include "edge_walk.h"

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

// Spans of the share across a ramp that runs along a parameter direction: three poles stand between the level ones.
constexpr double spans_per_ramp = 6.0;
constexpr double samples_per_ramp = 6.0;
constexpr int least_samples = 32;
constexpr double most_samples = 2e4;
constexpr int fan = 8; // directions around a corner
constexpr int most_stretches = 8;
constexpr double far_enough = 0.98;

//! The sample for one direction away from the ply, in the tangent plane.
EdgeSample sample_towards(const Eigen::Vector2d &uv, const SurfaceJet &jet, const Eigen::Vector3d &outward,
                          double length)
{
    const double e = jet.u.squaredNorm();
    const double f = jet.u.dot(jet.v);
    const double g = jet.v.squaredNorm();
    const Eigen::Vector2d slope(outward.dot(jet.u), outward.dot(jet.v)); // of the distance
    const Eigen::Vector2d step(g * slope.x() - f * slope.y(), e * slope.y() - f * slope.x());
    EdgeSample sample{uv, jet.s, step * (length / (e * g - f * f)), {0.0, 0.0}};
    // the span's extent along the slope, shared out so that few knots suffice
    const Eigen::Vector2d part = (slope.array().abs() / Eigen::Array2d(std::sqrt(e), std::sqrt(g))).sqrt();
    for (int k = 0; k < 2; ++k)
        if (part[k] > 0.0)
            sample.density[k] = spans_per_ramp / length * std::abs(slope[k]) * part.sum() / part[k];
    return sample;
}

} // namespace

EdgeWalk::EdgeWalk(const BaseSurface &base, const PlyRegion &region, double length) : m_base(base), m_length(length)
{
    for (std::size_t k = 0; k < region.cuts.size(); ++k)
        walk(region.cut(k));
    for (const auto &[first, last] : m_ends)
        for (const auto &[next, other] : m_ends)
            turn(last, next);
}

//! The side of the edge away from the ply; nothing where the edge or the surface has no direction.
std::optional<EdgeWalk::End> EdgeWalk::at(const TrimmingCurve &curve, double t) const
{
    gp_Pnt2d p;
    gp_Vec2d d;
    curve.pcurve->D1(t, p, d);
    const SurfaceJet jet = m_base.jets({p.X()}, {p.Y()}, 1).front();
    const double sense = curve.edge.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
    const Eigen::Vector3d along = sense * (d.X() * jet.u + d.Y() * jet.v);
    const Eigen::Vector3d outward = along.cross(jet.u.cross(jet.v));
    const double size = outward.norm();
    if (!(size > 0.0) || !std::isfinite(size))
        return std::nullopt;
    return End{{p.X(), p.Y()}, jet, outward / size};
}

//! Where the surface's parameters narrow away from the edge, as towards a sphere's pole, the tangent plane reaches less
//! far than the ramp.
void EdgeWalk::stretch(EdgeSample &sample) const
{
    const ParameterBox &box = m_base.box();
    for (int i = 0; i < most_stretches; ++i)
    {
        const double u = std::clamp(sample.uv.x() + sample.reach.x(), box.umin, box.umax);
        const double v = std::clamp(sample.uv.y() + sample.reach.y(), box.vmin, box.vmax);
        const double reached = (m_base.jets({u}, {v}, 0).front().s - sample.point).norm();
        const bool inside = u == sample.uv.x() + sample.reach.x() && v == sample.uv.y() + sample.reach.y();
        if (!inside || !(reached > 0.0) || reached >= far_enough * m_length)
            return;
        sample.reach *= std::min(2.0, m_length / reached);
    }
}

void EdgeWalk::walk(const TrimmingCurve &curve)
{
    std::vector<EdgeSample> run;
    std::optional<End> first;
    std::optional<End> last;
    const int count = sample_count(curve);
    for (int i = 0; i <= count; ++i)
    {
        const std::optional<End> here = at(curve, curve.first + (curve.last - curve.first) * i / count);
        if (!here)
            continue;
        if (!first)
            first = here;
        last = here;
        run.push_back(sample_towards(here->uv, here->jet, here->outward, m_length));
        stretch(run.back());
    }
    if (!first)
        return;
    if (curve.edge.Orientation() == TopAbs_REVERSED)
        std::swap(first, last);
    m_runs.push_back(std::move(run));
    m_ends.emplace_back(*first, *last);
}

int EdgeWalk::sample_count(const TrimmingCurve &curve) const
{
    return static_cast<int>(std::clamp(length_on(m_base, curve) / m_length * samples_per_ramp,
                                       static_cast<double>(least_samples), most_samples));
}

//! Where one edge ends and the next begins, the ramp goes round the corner.
void EdgeWalk::turn(const End &from, const End &to)
{
    if ((from.jet.s - to.jet.s).norm() > 0.01 * m_length || from.outward.dot(to.outward) > 0.999)
        return;
    std::vector<EdgeSample> run;
    for (int i = 0; i <= fan; ++i)
    {
        const double part = static_cast<double>(i) / fan;
        const Eigen::Vector3d between = (1.0 - part) * from.outward + part * to.outward;
        if (between.norm() > 1e-3)
        {
            run.push_back(sample_towards(to.uv, to.jet, between.normalized(), m_length));
            stretch(run.back());
        }
    }
    m_runs.push_back(std::move(run));
}

double length_on(const BaseSurface &base, const TrimmingCurve &curve)
{
    double size = 0.0;
    Eigen::Vector3d before = Eigen::Vector3d::Zero();
    for (int i = 0; i <= least_samples; ++i)
    {
        const gp_Pnt2d p = curve.pcurve->Value(curve.first + (curve.last - curve.first) * i / least_samples);
        const Eigen::Vector3d here = base.jets({p.X()}, {p.Y()}, 0).front().s;
        if (i > 0)
            size += (here - before).norm();
        before = here;
    }
    return size;
}

} // namespace laminate_offset
