// SPDX-License-Identifier: LGPL-2.1-or-later
#include "trim_loops.h"

#include "reparametrised_edge.h"
#include "straight_pcurve.h"

#include "../spline/geom_values.h"

#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace laminate_offset
{
namespace
{

// The sampled error is for information only; what counts is proven.
constexpr int error_samples = 12;
// Part of an edge's tolerance that its pcurve may move by when it is written more simply.
constexpr double simpler_share = 0.05;

Failure refusal(const EdgeContext &context, Status status, const TrimmingCurve &curve, std::string message)
{
    const gp_Pnt2d uv = curve.pcurve->Value(0.5 * (curve.first + curve.last));
    return {status, Stage::Trimming, std::move(message), context.input.place(uv), std::nullopt};
}

Handle(Geom2d_Curve) shifted(const Handle(Geom2d_Curve) & pcurve, const gp_Vec2d &shift)
{
    Handle(Geom2d_Curve) copy = Handle(Geom2d_Curve)::DownCast(pcurve->Copy());
    if (shift.SquareMagnitude() > 0.0)
        copy->Translate(shift);
    return copy;
}

//! A pcurve on the offset surface, and how far it leads away from the base's pcurve there [mm].
struct CarriedPcurve
{
    Handle(Geom2d_Curve) curve;
    double moved = 0.0;
};

//! The base's pcurve, straight ones in their simplest form where that can be told to change nothing that counts.
CarriedPcurve carried(const EdgeContext &context, const TrimmingCurve &base, const AnalyticSurface *form)
{
    const Handle(Geom2d_Curve) same = shifted(base.pcurve, context.surface.parameter_shift);
    const auto straight = form ? straight_pcurve(same, base.first, base.last) : std::nullopt;
    if (!straight)
        return {same, 0.0};
    const double v = std::max(std::abs(same->Value(base.first).Y()), std::abs(same->Value(base.last).Y()));
    const double moved = straight->deviation * (form->speed(0, v + straight->deviation) + form->speed(1, v));
    return moved <= simpler_share * context.tolerance ? CarriedPcurve{straight->curve, moved}
                                                      : CarriedPcurve{same, 0.0};
}

//! S + d N at the places; empty where one of them has no normal.
std::vector<Eigen::Vector3d> exact_points(const EdgeContext &context, const std::vector<double> &us,
                                          const std::vector<double> &vs)
{
    std::optional<gp_Pnt2d> singular;
    if (!context.varying)
        return context.base.offset_grid(us, vs, context.distance, singular);
    std::vector<Eigen::Vector3d> points = context.base.offset_grid(us, vs, 0.0, singular);
    const std::vector<Eigen::Vector3d> raised = context.base.offset_grid(us, vs, 1.0, singular);
    const std::vector<double> distances = context.varying->values(us, vs);
    for (std::size_t i = 0; i < std::min(points.size(), raised.size()); ++i)
        points[i] += distances[i] * (raised[i] - points[i]);
    return raised.size() < points.size() ? raised : points;
}

//! On a plane the offset of an edge is its translate: no pcurve is involved and nothing is fitted.
Handle(Geom_Curve) translated(const EdgeContext &context, const TrimmingCurve &base)
{
    const auto plane = Handle(Geom_Plane)::DownCast(context.input.surface);
    double first = 0.0;
    double last = 0.0;
    if (plane.IsNull() || context.varying)
        return {};
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(base.edge, first, last);
    if (curve.IsNull() || first != base.first || last != base.last)
        return {};
    const gp_Vec normal = gp_Vec(plane->Position().XDirection()).Crossed(gp_Vec(plane->Position().YDirection()));
    const double from_face = context.distance - context.input.base_distance;
    return Handle(Geom_Curve)::DownCast(curve->Translated(from_face * normal));
}

//! The base edge's translate on a plane, where it is as near as it has to be, else a curve of the pcurve's own.
std::optional<EdgeCurve> curve_of(const EdgeContext &context, const TrimmingCurve &base, const EdgeTarget &target,
                                  double tolerance, const Handle(Geom_Curve) & like)
{
    if (const Handle(Geom_Curve) curve = translated(context, base); !curve.IsNull())
        if (const Deviation deviation = target.deviation(curve, tolerance); deviation.bound <= tolerance)
            return EdgeCurve{curve, deviation};
    return edge_curve(target, tolerance, like);
}

Result<OffsetEdge> offset_edge(const EdgeContext &context, const TrimmingCurve &base, const AnalyticSurface *form,
                               const Handle(Geom_Curve) & like)
{
    OffsetEdge edge;
    edge.first = base.first;
    edge.last = base.last;
    const auto [pcurve, moved] = carried(context, base, form);
    edge.pcurve = pcurve;
    edge.moved = moved;
    const CurveOnSurface on_surface{context.surface.geometry, edge.pcurve, base.first, base.last};
    const EdgeTarget target(on_surface, form);
    if (base.degenerated)
    {
        const double admissible = std::max(context.tolerance, Precision::Confusion());
        edge.deviation = target.deviation(on_surface.value(base.first), admissible);
        edge.deviation.bound += moved;
        if (edge.deviation.bound <= admissible)
            return edge;
    }
    // the other side of a seam may be moved as well
    const double left = context.tolerance - (base.seam ? simpler_share * context.tolerance : moved);
    const std::optional<EdgeCurve> made = curve_of(context, base, target, left, like);
    if (!made)
        return refusal(
            context, Status::EdgeToleranceNotReached, base,
            fmt::format("The edge curve at the reported place could not be brought within {:.3g} mm; loosen the "
                        "tolerance or repair the trimming curve.",
                        context.tolerance));
    edge.curve = made->curve;
    edge.deviation = made->deviation;
    edge.deviation.bound += moved;
    edge.sampled_error = sampled_edge_error(context, base, edge.curve);
    return edge;
}

//! The pcurve on the other side of a seam is carried over too, and the edge's deviation holds for both.
void add_second_side(const EdgeContext &context, const TrimmingCurve &curve, const AnalyticSurface *form,
                     OffsetEdge &edge)
{
    if (edge.curve.IsNull())
        return;
    const auto [pcurve, moved] = carried(context, curve, form);
    edge.second_pcurve = pcurve;
    edge.moved = std::max(edge.moved, moved);
    const EdgeTarget other({context.surface.geometry, edge.second_pcurve, edge.first, edge.last}, form);
    const Deviation deviation = other.deviation(edge.curve, context.tolerance);
    edge.deviation.bound = std::max(edge.deviation.bound, deviation.bound + moved);
    edge.deviation.proven = edge.deviation.proven && deviation.proven;
}

//! The first use of every edge, in the order of the map.
std::vector<const TrimmingCurve *> first_uses(const EdgeContext &context, TopTools_IndexedMapOfShape &bases)
{
    std::vector<const TrimmingCurve *> uses;
    for (const TrimmingLoop &loop : context.input.loops)
        for (const TrimmingCurve &curve : loop.curves)
            if (static_cast<std::size_t>(bases.Add(curve.edge)) > uses.size())
                uses.push_back(&curve);
    return uses;
}

} // namespace

double sampled_edge_error(const EdgeContext &context, const TrimmingCurve &base, const Handle(Geom_Curve) & curve)
{
    std::vector<double> us;
    std::vector<double> vs;
    std::vector<Eigen::Vector3d> points;
    const GeomAdaptor_Curve in_space(curve);
    const Geom2dAdaptor_Curve in_parameters(base.pcurve);
    for (int i = 0; i <= error_samples; ++i)
    {
        const double t = base.first + (base.last - base.first) * i / error_samples;
        const gp_Pnt2d uv = in_parameters.Value(t);
        us.push_back(uv.X());
        vs.push_back(uv.Y());
        points.push_back(vector(in_space.Value(t).XYZ()));
    }
    const auto constant = [](const std::vector<double> &x) {
        return std::adjacent_find(x.begin(), x.end(), std::not_equal_to<>()) == x.end();
    };
    // along an isoparametric line all places are one grid
    std::vector<Eigen::Vector3d> exact;
    if (constant(us))
        exact = exact_points(context, {us.front()}, vs);
    else if (constant(vs))
        exact = exact_points(context, us, {vs.front()});
    double worst = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const auto here = exact.empty() ? exact_points(context, {us[i]}, {vs[i]}) : std::vector{exact[i]};
        if (!here.empty())
            worst = std::max(worst, (here.front() - points[i]).squaredNorm());
    }
    return std::sqrt(worst) + context.base.model_error().of_offset(context.distance);
}

std::optional<double> TrimLoops::edge_error(const std::optional<double> &certified_error) const
{
    double worst = 0.0;
    for (const OffsetEdge &edge : edges)
    {
        if (edge.own_parameters ? !edge.offset_error : !edge.deviation.proven || !certified_error)
            return std::nullopt;
        worst = std::max(worst, edge.own_parameters ? *edge.offset_error : edge.deviation.bound + *certified_error);
    }
    return worst;
}

double TrimLoops::sampled_error() const
{
    double worst = 0.0;
    for (const OffsetEdge &edge : edges)
        worst = std::max(worst, edge.sampled_error);
    return worst;
}

Result<TrimLoops> offset_loops(const EdgeContext &context)
{
    TrimLoops loops;
    const std::vector<const TrimmingCurve *> uses = first_uses(context, loops.bases);
    const std::optional<AnalyticSurface> analytic = AnalyticSurface::make(context.surface.geometry);
    const AnalyticSurface *form = analytic ? &*analytic : nullptr;
    std::vector<std::optional<Result<OffsetEdge>>> made(uses.size());
    const std::optional<ReparametrisedEdges> reparametrised =
        context.surface.parameter_map ? std::optional<ReparametrisedEdges>(std::in_place, context, form) : std::nullopt;
    tbb::parallel_for(std::size_t{0}, uses.size(), [&](std::size_t k) {
        const Handle(Geom_Curve) like = context.like ? context.like->edges[k].curve : nullptr;
        made[k] = reparametrised ? reparametrised->make(*uses[k]) : offset_edge(context, *uses[k], form, like);
    });
    for (std::optional<Result<OffsetEdge>> &edge : made)
    {
        if (!edge->ok())
            return edge->failure();
        loops.edges.push_back(std::move(*edge).value());
    }
    for (const TrimmingLoop &loop : context.input.loops)
        for (const TrimmingCurve &curve : loop.curves)
        {
            const auto k = static_cast<std::size_t>(loops.bases.FindIndex(curve.edge)) - 1;
            if (!curve.seam || &curve == uses[k])
                continue;
            if (!reparametrised)
                add_second_side(context, curve, form, loops.edges[k]);
            else if (const Result<bool> added = reparametrised->add_second_side(curve, loops.edges[k]); !added)
                return added.failure();
        }
    return loops;
}

} // namespace laminate_offset
