// SPDX-License-Identifier: LGPL-2.1-or-later
#include "creases.h"

#include <Eigen/Geometry>
#include <Geom_ElementarySurface.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

// A crease is judged from normals this far to both sides of the line, and twice as far (part of the box).
constexpr double crease_step = 1e-8;
// So far to both sides it has to be inside the loops: an edge along the knot line misses it by less.
constexpr double inside_step = 1e-6;
constexpr int probes_per_stretch = 33;
// Between two knots the normals' sine is a polynomial over weights and lengths: what is not zero shows in one of these.
constexpr int probes_per_span = 7;
// A loop that ends beside a knot line ends on it when it is as near as this part of the box.
constexpr double same_line = 1e-7;

using Normal = std::optional<Eigen::Vector3d>;

//! The normal at a line, from those one step and two steps beside it: between them it turns, however smooth the surface is.
Normal at_line(const Normal &beside, const Normal &farther)
{
    if (!beside || !farther)
        return std::nullopt;
    return Eigen::Vector3d(2.0 * *beside - *farther).normalized();
}

double angle_between(const Eigen::Vector3d &a, const Eigen::Vector3d &b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

//! Parameters all over one stretch of a line, some between each two of the knots that it crosses.
std::vector<double> probes_between(double low, double high, const std::vector<double> &knots)
{
    std::vector<double> ends{low};
    for (const double knot : knots)
        if (knot > low && knot < high)
            ends.push_back(knot);
    ends.push_back(high);
    const int spans = static_cast<int>(ends.size()) - 1;
    const int each = std::max(probes_per_span, (probes_per_stretch + spans - 1) / spans);
    std::vector<double> probes;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        for (int k = 0; k < each; ++k)
            probes.push_back(ends[i] + (ends[i + 1] - ends[i]) * (k + 0.5) / each);
    return probes;
}

//! Parameters along the line, all over each of its stretches inside the loops.
std::vector<double> probes_inside(const BaseSurface &base, const LoopRegion &region, bool constant_u, double parameter)
{
    const std::vector<double> knots = constant_u ? base.interval_ends_v() : base.interval_ends_u();
    const std::vector<double> ends = region.crossings(constant_u, parameter);
    std::vector<double> probes;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
        for (const double along : probes_between(ends[i], ends[i + 1], knots))
            probes.push_back(along);
    return probes;
}

//! The largest jump of the normal across one knot line, inside the loops.
CreaseLine sharpest(const BaseSurface &base, const LoopRegion &region, bool constant_u, double parameter)
{
    CreaseLine worst{constant_u, parameter, 0.0, 0.0, {}};
    const ParameterBox &box = base.box();
    const double width = constant_u ? box.umax - box.umin : box.vmax - box.vmin;
    const auto place = [&](double along, double side) {
        return constant_u ? gp_Pnt2d(parameter + side * width, along) : gp_Pnt2d(along, parameter + side * width);
    };
    const std::vector<double> along = probes_inside(base, region, constant_u, parameter);
    if (along.empty())
        return worst;
    const double step = crease_step * width;
    const std::vector<double> across{parameter - 2.0 * step, parameter - step, parameter + step,
                                     parameter + 2.0 * step};
    const std::vector<SurfaceJet> jets = constant_u ? base.jets(across, along, 1) : base.jets(along, across, 1);
    for (std::size_t i = 0; i < along.size(); ++i)
    {
        const gp_Pnt2d uv = place(along[i], 0.0);
        const auto normal = [&](std::size_t k) {
            const SurfaceJet &jet = constant_u ? jets[k * along.size() + i] : jets[across.size() * i + k];
            return base.unit_normal(jet, uv.X(), uv.Y());
        };
        const Normal before = at_line(normal(1), normal(0));
        const Normal after = at_line(normal(2), normal(3));
        if (!before || !after)
            continue;
        const double angle = angle_between(*before, *after);
        if (angle > worst.angle && region.contains(place(along[i], -inside_step)) &&
            region.contains(place(along[i], inside_step)))
        {
            worst.angle = angle;
            worst.uv = uv;
        }
    }
    return worst;
}

//! One seam edge, on both sides of a closed base.
struct Seam
{
    const TrimmingCurve *one = nullptr;
    const TrimmingCurve *other = nullptr;
};

std::vector<Seam> seams_of(const InputFace &input)
{
    std::vector<Seam> seams;
    if (input.surface->IsKind(STANDARD_TYPE(Geom_ElementarySurface)))
        return seams;
    for (const TrimmingLoop &loop : input.loops)
        for (const TrimmingCurve &curve : loop.curves)
        {
            if (!curve.seam || curve.degenerated)
                continue;
            const auto known = std::find_if(seams.begin(), seams.end(), [&](const Seam &seam) {
                return !seam.other && seam.one->edge.IsSame(curve.edge);
            });
            if (known == seams.end())
                seams.push_back({&curve, nullptr});
            else
                known->other = &curve;
        }
    seams.erase(std::remove_if(seams.begin(), seams.end(), [](const Seam &seam) { return !seam.other; }), seams.end());
    return seams;
}

//! Where to cut a tube opposite its seam: at a knot line, if there is one near the middle.
double opposite(const std::vector<double> &knots, double low, double high)
{
    constexpr double near = 0.25; // of the way round
    const double middle = 0.5 * (low + high);
    double best = middle;
    double least = near * (high - low);
    for (const double knot : knots)
        if (std::abs(knot - middle) < least)
        {
            least = std::abs(knot - middle);
            best = knot;
        }
    return best;
}

//! Parameters of a seam's curve all over it, some between each two of the knots that it crosses.
std::vector<double> probes_on(const TrimmingCurve &curve, bool constant_u, const std::vector<double> &knots)
{
    const int along = constant_u ? 2 : 1;
    const double start = curve.pcurve->Value(curve.first).Coord(along),
                 end = curve.pcurve->Value(curve.last).Coord(along);
    std::vector<double> probes = probes_between(std::min(start, end), std::max(start, end), knots);
    for (double &probe : probes) // seams run along parameter lines
        probe = curve.first + (curve.last - curve.first) * (probe - start) / (end - start);
    return probes;
}

//! The largest jump of the normal across a seam.
CreaseLine sharpest(const BaseSurface &base, const Seam &seam)
{
    CreaseLine worst;
    const double middle = 0.5 * (seam.one->first + seam.one->last);
    const gp_Pnt2d a = seam.one->pcurve->Value(middle);
    const gp_Pnt2d b = seam.other->pcurve->Value(middle);
    worst.constant_u = std::abs(a.X() - b.X()) > std::abs(a.Y() - b.Y());
    const int across = worst.constant_u ? 1 : 2;
    const double low = std::min(a.Coord(across), b.Coord(across));
    const double high = std::max(a.Coord(across), b.Coord(across));
    worst.parameter = opposite(worst.constant_u ? base.interval_ends_u() : base.interval_ends_v(), low, high);
    const auto normal = [&](const TrimmingCurve &side, double t, double steps) {
        gp_Pnt2d uv = side.pcurve->Value(t);
        const double inwards = uv.Coord(across) > worst.parameter ? -crease_step : crease_step;
        uv.SetCoord(across, uv.Coord(across) + steps * inwards * (high - low));
        return base.unit_normal(base.jets({uv.X()}, {uv.Y()}, 1).front(), uv.X(), uv.Y());
    };
    const std::vector<double> knots = worst.constant_u ? base.interval_ends_v() : base.interval_ends_u();
    for (const double t : probes_on(*seam.one, worst.constant_u, knots))
    {
        const Normal before = at_line(normal(*seam.one, t, 1.0), normal(*seam.one, t, 2.0));
        const Normal after = at_line(normal(*seam.other, t, 1.0), normal(*seam.other, t, 2.0));
        if (!before || !after)
            continue;
        const double angle = angle_between(*before, *after);
        if (angle > worst.angle)
        {
            worst.angle = angle;
            worst.uv = seam.one->pcurve->Value(t);
        }
    }
    return worst;
}

void cut_margin(double &low, double &high, double first, double last, const std::vector<SmoothnessBreak> &breaks)
{
    const double near = same_line * (last - first);
    for (const SmoothnessBreak &b : breaks)
    {
        if (b.continuity == 0 && b.parameter <= first + near)
            low = std::max(low, b.parameter);
        if (b.continuity == 0 && b.parameter >= last - near)
            high = std::min(high, b.parameter);
    }
}

} // namespace

std::vector<CreaseLine> find_creases(const InputFace &input, const BaseSurface &base, const LoopRegion &region,
                                     double distance, double tolerance)
{
    std::vector<CreaseLine> creases;
    const auto add_torn = [&](CreaseLine line) {
        line.tear = 2.0 * std::abs(distance) * std::sin(0.5 * line.angle);
        if (line.tear > 0.5 * tolerance)
            creases.push_back(line);
    };
    const auto look = [&](const std::vector<SmoothnessBreak> &breaks, bool constant_u) {
        for (const SmoothnessBreak &b : breaks)
            if (b.continuity <= 0)
                add_torn(sharpest(base, region, constant_u, b.parameter));
    };
    look(base.breaks_u(), true);
    look(base.breaks_v(), false);
    for (const Seam &seam : seams_of(input))
    {
        const CreaseLine line = sharpest(base, seam);
        // a tube that is cut anywhere along it is open at its seam, too
        if (std::none_of(creases.begin(), creases.end(),
                         [&](const CreaseLine &known) { return known.constant_u == line.constant_u; }))
            add_torn(line);
    }
    return creases;
}

double farther_distance(const InputFace &input, double distance)
{
    return std::max(std::abs(distance), std::abs(input.base_distance));
}

Failure creased_refusal(const InputFace &input, const std::vector<CreaseLine> &creases)
{
    const CreaseLine &worst = *std::max_element(
        creases.begin(), creases.end(), [](const CreaseLine &a, const CreaseLine &b) { return a.tear < b.tear; });
    return {Status::KinkedSurface, Stage::Analysis,
            fmt::format("The surface has a crease of {:.4g} degrees, which tears the offset by {:.4g} mm; split "
                        "the face along the crease and offset the parts.",
                        worst.angle * 180.0 / M_PI, worst.tear),
            input.place(worst.uv), std::nullopt};
}

BaseSurface base_beside_creases(const InputFace &input, const ModelDemand &demand)
{
    const ParameterBox whole = fit_box(input);
    BaseSurface base(input.surface, whole, demand);
    ParameterBox box = whole;
    cut_margin(box.umin, box.umax, input.box.umin, input.box.umax, base.breaks_u());
    cut_margin(box.vmin, box.vmax, input.box.vmin, input.box.vmax, base.breaks_v());
    const bool is_cut =
        box.umin != whole.umin || box.umax != whole.umax || box.vmin != whole.vmin || box.vmax != whole.vmax;
    return is_cut ? BaseSurface(input.surface, box, demand) : base;
}

} // namespace laminate_offset
