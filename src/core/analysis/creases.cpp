// SPDX-License-Identifier: LGPL-2.1-or-later
#include "creases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

// A crease is judged from normals this far to both sides of the knot line (part of the box).
constexpr double crease_step = 1e-8;
// So far to both sides it has to be inside the loops: an edge along the knot line misses it by less.
constexpr double inside_step = 1e-6;
constexpr int probes_per_interval = 33;
// A loop that ends beside a knot line ends on it when it is as near as this part of the box.
constexpr double same_line = 1e-7;

//! Parameters along the line, all over each of its intervals inside the loops.
std::vector<double> probes_inside(const LoopRegion &region, bool constant_u, double parameter)
{
    const std::vector<double> ends = region.crossings(constant_u, parameter);
    std::vector<double> probes;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
        for (int k = 0; k < probes_per_interval; ++k)
            probes.push_back(ends[i] + (ends[i + 1] - ends[i]) * (k + 0.5) / probes_per_interval);
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
    const std::vector<double> along = probes_inside(region, constant_u, parameter);
    if (along.empty())
        return worst;
    const std::vector<double> across{parameter - crease_step * width, parameter + crease_step * width};
    const std::vector<SurfaceJet> jets = constant_u ? base.jets(across, along, 1) : base.jets(along, across, 1);
    for (std::size_t i = 0; i < along.size(); ++i)
    {
        const SurfaceJet &a = constant_u ? jets[i] : jets[2 * i];
        const SurfaceJet &b = constant_u ? jets[along.size() + i] : jets[2 * i + 1];
        const gp_Pnt2d uv = place(along[i], 0.0);
        const auto before = base.unit_normal(a, uv.X(), uv.Y());
        const auto after = base.unit_normal(b, uv.X(), uv.Y());
        if (!before || !after)
            continue;
        const double angle = std::atan2(before->cross(*after).norm(), before->dot(*after));
        if (angle > worst.angle && region.contains(place(along[i], -inside_step)) &&
            region.contains(place(along[i], inside_step)))
        {
            worst.angle = angle;
            worst.uv = uv;
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

std::vector<CreaseLine> find_creases(const BaseSurface &base, const LoopRegion &region, double distance,
                                     double tolerance)
{
    std::vector<CreaseLine> creases;
    const auto look = [&](const std::vector<SmoothnessBreak> &breaks, bool constant_u) {
        for (const SmoothnessBreak &b : breaks)
        {
            if (b.continuity > 0)
                continue;
            CreaseLine line = sharpest(base, region, constant_u, b.parameter);
            line.tear = 2.0 * std::abs(distance) * std::sin(0.5 * line.angle);
            if (line.tear > 0.5 * tolerance)
                creases.push_back(line);
        }
    };
    look(base.breaks_u(), true);
    look(base.breaks_v(), false);
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
