// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ply_ramp.h"

#include "../input/pcurve_pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <unordered_map>

namespace laminate_offset
{
namespace
{

constexpr int degree = 3;
// Spans of the share across a ramp that runs along a parameter direction: three poles stand between the level ones.
constexpr double spans_per_ramp = 6.0;
// The first knot stands a little outside of the ply, so that an edge that strays from its parameter line touches no
// further span.
constexpr double clearance = 0.02;
constexpr double samples_per_ramp = 6.0;
constexpr double pieces_per_ramp = 24.0;
constexpr int least_samples = 32;
constexpr double most_samples = 2e4;
constexpr int fan = 8;           // directions around a corner
constexpr int slope_samples = 6; // steps of a span in which slopes are looked at
// Densities of knots within this factor are made one; parameters within this part of the finest step are one.
constexpr double same_density = 1.5;
constexpr double same_place = 0.05;

//! A place on a ply's edge, and where the ramp goes from there.
struct EdgeSample
{
    Eigen::Vector2d uv;
    Eigen::Vector3d point;
    Eigen::Vector2d reach;   //!< the ramp's end less uv
    Eigen::Vector2d density; //!< knots per unit of u and of v that the ramp needs here
};

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

//! The curve's length on the surface, roughly.
double length_of(const BaseSurface &base, const TrimmingCurve &curve)
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

//! Walks along a ply's cut edges.
class EdgeWalk
{
public:
    EdgeWalk(const BaseSurface &base, const PlyRegion &region, double length) : m_base(base), m_length(length)
    {
        for (std::size_t k = 0; k < region.cuts.size(); ++k)
            walk(region.cut(k));
        for (const auto &[first, last] : m_ends)
            for (const auto &[next, other] : m_ends)
                turn(last, next);
    }

    //! Samples that follow each other; corners are runs of their own.
    [[nodiscard]] const std::vector<std::vector<EdgeSample>> &runs() const { return m_runs; }

private:
    struct End
    {
        Eigen::Vector2d uv;
        SurfaceJet jet;
        Eigen::Vector3d outward;
    };

    //! The side of the edge away from the ply; nothing where the edge or the surface has no direction.
    [[nodiscard]] std::optional<End> at(const TrimmingCurve &curve, double t) const
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

    void walk(const TrimmingCurve &curve)
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
        }
        if (!first)
            return;
        if (curve.edge.Orientation() == TopAbs_REVERSED)
            std::swap(first, last);
        m_runs.push_back(std::move(run));
        m_ends.emplace_back(*first, *last);
    }

    [[nodiscard]] int sample_count(const TrimmingCurve &curve) const
    {
        return static_cast<int>(std::clamp(length_of(m_base, curve) / m_length * samples_per_ramp,
                                           static_cast<double>(least_samples), most_samples));
    }

    //! Where one edge ends and the next begins, the ramp goes round the corner.
    void turn(const End &from, const End &to)
    {
        if ((from.jet.s - to.jet.s).norm() > 0.01 * m_length || from.outward.dot(to.outward) > 0.999)
            return;
        std::vector<EdgeSample> run;
        for (int i = 0; i <= fan; ++i)
        {
            const double part = static_cast<double>(i) / fan;
            const Eigen::Vector3d between = (1.0 - part) * from.outward + part * to.outward;
            if (between.norm() > 1e-3)
                run.push_back(sample_towards(to.uv, to.jet, between.normalized(), m_length));
        }
        m_runs.push_back(std::move(run));
    }

    const BaseSurface &m_base;
    double m_length;
    std::vector<std::vector<EdgeSample>> m_runs;
    std::vector<std::pair<End, End>> m_ends; //!< of each edge, in the loop's direction
};

//! An interval of one parameter in which knots must stand so densely.
struct Zone
{
    double low = 0.0;
    double high = 0.0;
    double density = 0.0;
};

std::vector<Zone> zones_of(const EdgeWalk &walk, int direction)
{
    std::vector<Zone> zones;
    for (const std::vector<EdgeSample> &run : walk.runs())
        for (std::size_t i = 0; i + 1 < run.size(); ++i)
        {
            Zone zone{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest(), 0.0};
            for (const EdgeSample *sample : {&run[i], &run[i + 1]})
            {
                for (const double part : {clearance, 1.0})
                {
                    const double place = sample->uv[direction] + part * sample->reach[direction];
                    zone.low = std::min(zone.low, place);
                    zone.high = std::max(zone.high, place);
                }
                zone.density = std::max(zone.density, sample->density[direction]);
            }
            if (zone.density > 0.0 && zone.high > zone.low)
                zones.push_back(zone);
        }
    return zones;
}

//! The largest density wanted between each two neighbours of the zones' ends.
std::vector<Zone> layered(std::vector<Zone> zones, double low, double high)
{
    std::vector<double> ends{low, high};
    double densest = 0.0;
    for (const Zone &zone : zones)
    {
        ends.insert(ends.end(), {std::clamp(zone.low, low, high), std::clamp(zone.high, low, high)});
        densest = std::max(densest, zone.density);
    }
    std::sort(ends.begin(), ends.end());
    std::vector<double> places;
    for (const double end : ends)
        if (places.empty() || (end - places.back()) * densest > same_place)
            places.push_back(end);
    const auto index = [&](double x) {
        const auto next = std::lower_bound(places.begin(), places.end(), x);
        if (next == places.end())
            return places.size() - 1;
        const bool before = next != places.begin() && x - *(next - 1) < *next - x;
        return static_cast<std::size_t>(next - places.begin()) - (before ? 1 : 0);
    };
    std::vector<std::vector<double>> opened(places.size());
    std::vector<std::vector<double>> closed(places.size());
    for (const Zone &zone : zones)
    {
        opened[index(zone.low)].push_back(zone.density);
        closed[index(zone.high)].push_back(zone.density);
    }
    std::multiset<double> active;
    std::vector<Zone> layers;
    for (std::size_t k = 0; k + 1 < places.size(); ++k)
    {
        active.insert(opened[k].begin(), opened[k].end());
        for (const double density : closed[k])
            active.erase(active.find(density));
        layers.push_back({places[k], places[k + 1], active.empty() ? 0.0 : *active.rbegin()});
    }
    return layers;
}

//! Knots as dense as the zones want, at the ends of zones where the density jumps.
std::vector<double> knots_for(const EdgeWalk &walk, int direction, double low, double high)
{
    std::vector<Zone> merged;
    for (const Zone &layer : layered(zones_of(walk, direction), low, high))
        if (!merged.empty() && layer.density <= same_density * merged.back().density &&
            merged.back().density <= same_density * layer.density)
        {
            merged.back().high = layer.high;
            merged.back().density = std::max(merged.back().density, layer.density);
        }
        else
            merged.push_back(layer);
    std::vector<double> knots;
    double missing = 0.0;
    for (const Zone &zone : merged)
    {
        const double wanted = (zone.high - zone.low) * zone.density;
        missing = zone.density > 0.0 ? missing + wanted : 0.0;
        if (missing < 0.5)
            continue;
        missing = 0.0;
        const int spans = std::max(1, static_cast<int>(std::ceil(wanted - 0.2)));
        for (int i = 0; i <= spans; ++i)
            knots.push_back(zone.low + (zone.high - zone.low) * i / spans);
    }
    std::sort(knots.begin(), knots.end());
    const double closest = 1e-6 * (high - low);
    std::vector<double> interior;
    for (const double knot : knots)
        if (knot - (interior.empty() ? low : interior.back()) > closest && high - knot > closest)
            interior.push_back(knot);
    return interior;
}

//! Distances from the samples of an edge, up to a little more than the ramp's length.
class EdgeDistance
{
public:
    EdgeDistance(const EdgeWalk &walk, double length) : m_cell(1.3 * length)
    {
        for (const std::vector<EdgeSample> &run : walk.runs())
            for (std::size_t i = 0; i < run.size(); ++i)
                m_cells[key(run[i].point, {0, 0, 0})].emplace_back(run[i].point,
                                                                   run[i + 1 < run.size() ? i + 1 : i].point);
    }

    //! Infinite where no edge is near.
    [[nodiscard]] double operator()(const Eigen::Vector3d &point) const
    {
        double least = std::numeric_limits<double>::infinity();
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j)
                for (int k = -1; k <= 1; ++k)
                    if (const auto cell = m_cells.find(key(point, {i, j, k})); cell != m_cells.end())
                        for (const auto &[a, b] : cell->second)
                            least = std::min(least, to_segment(point, a, b));
        return least;
    }

private:
    static double to_segment(const Eigen::Vector3d &point, const Eigen::Vector3d &a, const Eigen::Vector3d &b)
    {
        const double square = (b - a).squaredNorm();
        const double t = square > 0.0 ? std::clamp((point - a).dot(b - a) / square, 0.0, 1.0) : 0.0;
        return (point - a - t * (b - a)).norm();
    }

    [[nodiscard]] std::size_t key(const Eigen::Vector3d &point, const std::array<int, 3> &step) const
    {
        std::size_t hash = 0;
        for (int e = 0; e < 3; ++e)
            hash = hash * 0x9E3779B97F4A7C15ULL +
                   static_cast<std::size_t>(static_cast<long long>(std::floor(point[e] / m_cell)) +
                                            step[static_cast<std::size_t>(e)]);
        return hash;
    }

    double m_cell;
    std::unordered_map<std::size_t, std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>> m_cells;
};

//! Poles from distances at the knots.
class ShareMaker
{
public:
    ShareMaker(const BaseSurface &base, const PlyRegion &region, const EdgeWalk &walk, double length,
               ScalarSpline &share)
        : m_length(length), m_share(share), m_us(share.u.breaks()), m_vs(share.v.breaks())
    {
        const LoopRegion fine = fine_region(base, region, length);
        const EdgeDistance distance(walk, length);
        const std::vector<SurfaceJet> jets = base.jets(m_us, m_vs, 0);
        for (std::size_t i = 0; i < jets.size(); ++i)
        {
            const bool inside = fine.contains(gp_Pnt2d(m_us[i / m_vs.size()], m_vs[i % m_vs.size()]));
            m_distances.push_back(inside ? 0.0 : std::min(distance(jets[i].s), 2.0 * length));
        }
        fill();
        settle(fine);
    }

private:
    [[nodiscard]] double at(std::size_t k, std::size_t l) const { return m_distances[k * m_vs.size() + l]; }

    //! Between which of the distinct knots the middle part of a pole's support lies.
    static std::pair<std::size_t, std::size_t> core(const KnotVector &kv, const std::vector<double> &breaks, int pole)
    {
        const auto place = [&](int knot) {
            return static_cast<std::size_t>(
                std::lower_bound(breaks.begin(), breaks.end(), kv.knots[static_cast<std::size_t>(knot)]) -
                breaks.begin());
        };
        return {place(pole + 1), place(pole + kv.degree)};
    }

    //! From the least and the largest distance in the middle of each pole's support: 1 where the ply reaches into it, 0
    //! where the ramp ends in it, linear between across a straight edge. The basis functions make it an S.
    void fill()
    {
        for (int i = 0; i < m_share.u.pole_count(); ++i)
            for (int j = 0; j < m_share.v.pole_count(); ++j)
            {
                const auto [k0, k1] = core(m_share.u, m_us, i);
                const auto [l0, l1] = core(m_share.v, m_vs, j);
                double least = std::numeric_limits<double>::max();
                double largest = 0.0;
                for (std::size_t k = k0; k <= k1; ++k)
                    for (std::size_t l = l0; l <= l1; ++l)
                    {
                        least = std::min(least, at(k, l));
                        largest = std::max(largest, at(k, l));
                    }
                const double above = std::max(0.0, m_length - largest);
                const bool nothing = above + least <= 0.0; // the ply reaches in, and so does the ramp's end
                m_share.poles.push_back(nothing ? 0.5 : above / (above + least));
            }
    }

    //! Exactly 0 past the ramp, and, which counts more, exactly 1 on the ply.
    void settle(const LoopRegion &fine)
    {
        std::vector<std::pair<std::size_t, std::size_t>> ply;
        for (std::size_t k = 0; k + 1 < m_us.size(); ++k)
            for (std::size_t l = 0; l + 1 < m_vs.size(); ++l)
                if (fine.may_touch({m_us[k], m_us[k + 1], m_vs[l], m_vs[l + 1]}))
                    ply.emplace_back(k, l);
                else if (std::min({at(k, l), at(k + 1, l), at(k, l + 1), at(k + 1, l + 1)}) >= m_length)
                    set(k, l, 0.0);
        for (const auto &[k, l] : ply)
            set(k, l, 1.0);
    }

    //! All poles that act on one span.
    void set(std::size_t k, std::size_t l, double value)
    {
        const int first_u = m_share.u.span(m_us[k]) - degree;
        const int first_v = m_share.v.span(m_vs[l]) - degree;
        for (int i = first_u; i <= first_u + degree; ++i)
            for (int j = first_v; j <= first_v + degree; ++j)
                m_share.poles[static_cast<std::size_t>(i * m_share.v.pole_count() + j)] = value;
    }

    double m_length;
    ScalarSpline &m_share;
    std::vector<double> m_us;
    std::vector<double> m_vs;
    std::vector<double> m_distances;
};

//! Is the surface one and the same at both ends of a direction of the box?
bool closed(const Geom_Surface &surface, const ParameterBox &box, bool along_u, double size)
{
    constexpr int probes = 4;
    constexpr double same = 1e-6;
    for (int i = 0; i <= probes; ++i)
    {
        const double u = box.umin + (box.umax - box.umin) * i / probes;
        const double v = box.vmin + (box.vmax - box.vmin) * i / probes;
        const gp_Pnt low = along_u ? surface.Value(box.umin, v) : surface.Value(u, box.vmin);
        const gp_Pnt high = along_u ? surface.Value(box.umax, v) : surface.Value(u, box.vmax);
        if (low.Distance(high) > same * size)
            return false;
    }
    return true;
}

//! Does the share run on smoothly across a seam? Its knots know nothing of what lies on the other side.
bool torn_at_seam(const ScalarSpline &share, const InputFace &input, const ParameterBox &box)
{
    constexpr double same = 1e-9;
    const int rows = share.u.pole_count();
    const int columns = share.v.pole_count();
    const auto differ = [](double a, double b) { return std::abs(a - b) > same; };
    bool torn = false;
    if (closed(*input.surface, box, true, input.diagonal))
        for (int j = 0; j < columns; ++j)
            for (int i = 0; i < degree; ++i)
                torn = torn || differ(share.pole(i, j), share.pole(rows - 1, j)) ||
                       differ(share.pole(rows - 1 - i, j), share.pole(0, j));
    if (closed(*input.surface, box, false, input.diagonal))
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < degree; ++j)
                torn = torn || differ(share.pole(i, j), share.pole(i, columns - 1)) ||
                       differ(share.pole(i, columns - 1 - j), share.pole(i, 0));
    return torn;
}

//! Is the share one number on the span that begins at a place?
bool level_on(const ScalarSpline &share, double u, double v)
{
    const int first_u = share.u.span(u) - degree;
    const int first_v = share.v.span(v) - degree;
    for (int i = first_u; i <= first_u + degree; ++i)
        for (int j = first_v; j <= first_v + degree; ++j)
            if (share.pole(i, j) != share.pole(first_u, first_v))
                return false;
    return true;
}

//! The largest slope of a share at the places of a grid in one of its spans that are inside [1/mm].
double steepest_in(const BaseSurface &base, const TensorSpline &share, const LoopRegion &inside,
                   const ParameterBox &span)
{
    std::vector<double> us, vs;
    for (int i = 0; i <= slope_samples; ++i)
    {
        us.push_back(span.umin + (span.umax - span.umin) * i / slope_samples);
        vs.push_back(span.vmin + (span.vmax - span.vmin) * i / slope_samples);
    }
    const std::vector<SurfaceJet> places = base.jets(us, vs, 1);
    const std::vector<SurfaceJet> values = share.jets(us, vs, 1);
    double steepest = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        const SurfaceJet &s = places[i];
        const double e = s.u.squaredNorm(), f = s.u.dot(s.v), g = s.v.squaredNorm();
        const double a = values[i].u.x(), b = values[i].v.x();
        const double square = (g * a * a - 2.0 * f * a * b + e * b * b) / (e * g - f * f);
        if (square > steepest * steepest && inside.contains({us[i / vs.size()], vs[i % vs.size()]}))
            steepest = std::sqrt(square);
    }
    return steepest;
}

} // namespace

LoopRegion fine_region(const BaseSurface &base, const PlyRegion &region, double length)
{
    InputFace fine = region.input;
    for (const auto &[loop, place] : region.cuts)
    {
        TrimmingCurve &curve = fine.loops[loop].curves[place];
        const double wanted = pieces_per_ramp * length_of(base, curve) / length;
        const double parts =
            std::clamp(std::ceil(wanted / static_cast<double>(curve.pieces.size())), 1.0, most_samples);
        const double width = (curve.last - curve.first) / parts;
        curve.pieces.clear();
        for (int i = 0; i < static_cast<int>(parts); ++i)
        {
            const double to = i + 1 == static_cast<int>(parts) ? curve.last : curve.first + width * (i + 1);
            const std::vector<PcurvePiece> cut = cut_up(curve.pcurve, curve.first + width * i, to);
            curve.pieces.insert(curve.pieces.end(), cut.begin(), cut.end());
        }
    }
    return LoopRegion(fine);
}

double steepest_slope(const BaseSurface &base, const ScalarSpline &share, const LoopRegion &inside)
{
    const std::vector<double> us = share.u.breaks();
    const std::vector<double> vs = share.v.breaks();
    const TensorSpline values = share.as_surface();
    double steepest = 0.0;
    for (std::size_t k = 0; k + 1 < us.size(); ++k)
        for (std::size_t l = 0; l + 1 < vs.size(); ++l)
        {
            const ParameterBox span{us[k], us[k + 1], vs[l], vs[l + 1]};
            if (!level_on(share, us[k], vs[l]) && inside.may_touch(span))
                steepest = std::max(steepest, steepest_in(base, values, inside, span));
        }
    return steepest;
}

Result<ScalarSpline> ply_share(const BaseSurface &base, const PlyRegion &region, double length, int most_poles)
{
    const EdgeWalk walk(base, region, length);
    const ParameterBox &box = base.box();
    ScalarSpline share{clamped_knots(degree, box.umin, box.umax, knots_for(walk, 0, box.umin, box.umax)),
                       clamped_knots(degree, box.vmin, box.vmax, knots_for(walk, 1, box.vmin, box.vmax)),
                       {}};
    const double poles = static_cast<double>(share.u.pole_count()) * static_cast<double>(share.v.pole_count());
    if (poles > most_poles)
        return Failure{
            Status::NotSupported, Stage::Surface,
            fmt::format(
                "A ramp of {:.3g} mm beside the boundary '{}' would take some {:.0f} poles, more than {}; make it "
                "{:.2g} mm or longer, or lead the boundary along parameter lines.",
                length, region.name, poles, most_poles, 1.05 * length * std::sqrt(poles / most_poles)),
            std::nullopt, std::nullopt};
    share.poles.reserve(static_cast<std::size_t>(poles));
    ShareMaker(base, region, walk, length, share);
    if (torn_at_seam(share, region.input, box))
        return Failure{
            Status::NotSupported, Stage::Surface,
            fmt::format("The ramp of {:.3g} mm beside the boundary '{}' reaches the seam of the closed face; "
                        "move the boundary or the seam away from it, or make the ramp shorter.",
                        length, region.name),
            std::nullopt, std::nullopt};
    return share;
}

} // namespace laminate_offset
