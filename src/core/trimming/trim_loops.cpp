// SPDX-License-Identifier: LGPL-2.1-or-later
#include "trim_loops.h"

#include "edge_curve.h"

#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

constexpr int error_samples = 200;

Failure refusal(const EdgeContext &context, Status status, const TrimmingCurve &curve, std::string message)
{
    const gp_Pnt2d uv = curve.pcurve->Value(0.5 * (curve.first + curve.last));
    const gp_Pnt point = context.input.surface->Value(uv.X(), uv.Y());
    return {status, Stage::Trimming, std::move(message),
            Where{uv, point.Transformed(context.input.location.Transformation())}, std::nullopt};
}

Handle(Geom2d_Curve) shifted(const Handle(Geom2d_Curve) & pcurve, const gp_Vec2d &shift)
{
    Handle(Geom2d_Curve) copy = Handle(Geom2d_Curve)::DownCast(pcurve->Copy());
    if (shift.SquareMagnitude() > 0.0)
        copy->Translate(shift);
    return copy;
}

//! Largest distance of the curve from S + d N over the base's pcurve.
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
    return std::sqrt(worst);
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
    return Handle(Geom_Curve)::DownCast(curve->Translated(context.distance * normal));
}

double spread(const CurveOnSurface &c)
{
    constexpr int probes = 16;
    double widest = 0.0;
    for (int i = 1; i <= probes; ++i)
        widest = std::max(widest, c.value(c.first).Distance(c.value(c.first + (c.last - c.first) * i / probes)));
    return widest;
}

Result<OffsetEdge> offset_edge(const EdgeContext &context, const TrimmingCurve &base)
{
    OffsetEdge edge;
    edge.first = base.first;
    edge.last = base.last;
    edge.pcurve = shifted(base.pcurve, context.surface.parameter_shift);
    const CurveOnSurface on_surface{context.surface.geometry, edge.pcurve, base.first, base.last};
    if (base.degenerated && spread(on_surface) <= std::max(context.tolerance, Precision::Confusion()))
        return edge;
    if (base.degenerated && on_surface.value(base.first).Distance(on_surface.value(base.last)) > Precision::Confusion())
        return refusal(context, Status::SingularNormal, base,
                       "The surface comes to a point at the reported place with different normals from different "
                       "sides, so the offset opens up there; trim the face clear of it.");
    edge.curve = translated(context, base);
    if (!edge.curve.IsNull())
        edge.surface_deviation = std::max(largest_distance(edge.curve, on_surface), Precision::Confusion());
    else if (const std::optional<EdgeCurve> fitted = edge_curve(on_surface, context.tolerance))
    {
        edge.curve = fitted->curve;
        edge.surface_deviation = fitted->deviation;
    }
    else
        return refusal(
            context, Status::EdgeToleranceNotReached, base,
            fmt::format("The edge curve at the reported place could not be brought within {:.3g} mm; loosen the "
                        "tolerance or repair the trimming curve.",
                        context.tolerance));
    edge.sampled_error = error_of_edge(context, base, edge.curve);
    return edge;
}

} // namespace

Result<TrimLoops> offset_loops(const EdgeContext &context)
{
    TrimLoops loops;
    for (const TrimmingLoop &loop : context.input.loops)
        for (const TrimmingCurve &curve : loop.curves)
        {
            const int known = loops.bases.FindIndex(curve.edge);
            if (known > 0)
            {
                OffsetEdge &edge = loops.edges[static_cast<std::size_t>(known) - 1];
                if (!curve.seam || edge.curve.IsNull())
                    continue;
                edge.second_pcurve = shifted(curve.pcurve, context.surface.parameter_shift);
                const CurveOnSurface other{context.surface.geometry, edge.second_pcurve, edge.first, edge.last};
                edge.surface_deviation = std::max(edge.surface_deviation, largest_distance(edge.curve, other));
                continue;
            }
            Result<OffsetEdge> edge = offset_edge(context, curve);
            if (!edge)
                return edge.failure();
            loops.bases.Add(curve.edge);
            loops.edges.push_back(std::move(edge).value());
        }
    return loops;
}

} // namespace laminate_offset
