// SPDX-License-Identifier: LGPL-2.1-or-later
#include "trim_loops.h"

#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

// The sampled error is for information only; what counts is proven.
constexpr int error_samples = 24;

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

//! Largest distance seen of the curve from S + d N over the base's pcurve.
double error_of_edge(const EdgeContext &context, const TrimmingCurve &base, const Handle(Geom_Curve) & curve)
{
    double worst = 0.0;
    for (int i = 0; i <= error_samples; ++i)
    {
        const double t = base.first + (base.last - base.first) * i / error_samples;
        const gp_Pnt2d uv = base.pcurve->Value(t);
        std::optional<gp_Pnt2d> singular;
        const auto exact = context.base.offset_grid({uv.X()}, {uv.Y()}, context.distance, singular);
        if (singular)
            continue;
        const gp_Pnt p = curve->Value(t);
        worst = std::max(worst, (exact.front() - Eigen::Vector3d(p.X(), p.Y(), p.Z())).squaredNorm());
    }
    return std::sqrt(worst) + context.base.model_error().of_offset(context.distance);
}

//! On a plane the offset of an edge is its translate: no pcurve is involved and nothing is fitted.
Handle(Geom_Curve) translated(const EdgeContext &context, const TrimmingCurve &base)
{
    const auto plane = Handle(Geom_Plane)::DownCast(context.input.surface);
    double first = 0.0;
    double last = 0.0;
    const Handle(Geom_Curve) curve = plane.IsNull() ? nullptr : BRep_Tool::Curve(base.edge, first, last);
    if (curve.IsNull() || first != base.first || last != base.last)
        return {};
    const gp_Vec normal = gp_Vec(plane->Position().XDirection()).Crossed(gp_Vec(plane->Position().YDirection()));
    const double from_face = context.distance - context.input.base_distance;
    return Handle(Geom_Curve)::DownCast(curve->Translated(from_face * normal));
}

//! The base edge's translate on a plane, where it is as near as it has to be, else a curve of the pcurve's own.
std::optional<EdgeCurve> curve_of(const EdgeContext &context, const TrimmingCurve &base, const EdgeTarget &target)
{
    if (const Handle(Geom_Curve) curve = translated(context, base); !curve.IsNull())
        if (const Deviation deviation = target.deviation(curve, context.tolerance);
            deviation.bound <= context.tolerance)
            return EdgeCurve{curve, deviation};
    return edge_curve(target, context.tolerance);
}

Result<OffsetEdge> offset_edge(const EdgeContext &context, const TrimmingCurve &base, const AnalyticSurface *form)
{
    OffsetEdge edge;
    edge.first = base.first;
    edge.last = base.last;
    edge.pcurve = shifted(base.pcurve, context.surface.parameter_shift);
    const CurveOnSurface on_surface{context.surface.geometry, edge.pcurve, base.first, base.last};
    const EdgeTarget target(on_surface, form);
    if (base.degenerated)
    {
        const double admissible = std::max(context.tolerance, Precision::Confusion());
        edge.deviation = target.deviation(on_surface.value(base.first), admissible);
        if (edge.deviation.bound <= admissible)
            return edge;
    }
    const std::optional<EdgeCurve> made = curve_of(context, base, target);
    if (!made)
        return refusal(
            context, Status::EdgeToleranceNotReached, base,
            fmt::format("The edge curve at the reported place could not be brought within {:.3g} mm; loosen the "
                        "tolerance or repair the trimming curve.",
                        context.tolerance));
    edge.curve = made->curve;
    edge.deviation = made->deviation;
    edge.sampled_error = error_of_edge(context, base, edge.curve);
    return edge;
}

//! The pcurve on the other side of a seam is carried over too, and the edge's deviation holds for both.
void add_second_side(const EdgeContext &context, const TrimmingCurve &curve, const AnalyticSurface *form,
                     OffsetEdge &edge)
{
    if (edge.curve.IsNull())
        return;
    edge.second_pcurve = shifted(curve.pcurve, context.surface.parameter_shift);
    const EdgeTarget other({context.surface.geometry, edge.second_pcurve, edge.first, edge.last}, form);
    const Deviation deviation = other.deviation(edge.curve, context.tolerance);
    edge.deviation.bound = std::max(edge.deviation.bound, deviation.bound);
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

std::optional<double> TrimLoops::edge_error(const std::optional<double> &certified_error) const
{
    if (!certified_error)
        return std::nullopt;
    double worst = 0.0;
    for (const OffsetEdge &edge : edges)
    {
        if (!edge.deviation.proven)
            return std::nullopt;
        worst = std::max(worst, edge.deviation.bound);
    }
    return worst + *certified_error;
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
    tbb::parallel_for(std::size_t{0}, uses.size(),
                      [&](std::size_t k) { made[k] = offset_edge(context, *uses[k], form); });
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
            if (curve.seam && &curve != uses[k])
                add_second_side(context, curve, form, loops.edges[k]);
        }
    return loops;
}

} // namespace laminate_offset
