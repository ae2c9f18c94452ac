// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reparametrised_edge.h"

#include "mapped_pcurve.h"
#include "offset_trimming_curve.h"

#include <Precision.hxx>
#include <fmt/format.h>

#include <algorithm>

namespace laminate_offset
{
namespace
{

// Of the edges' part of the tolerance.
constexpr double curve_share = 0.5;
constexpr double image_share = 0.4;

//! The whole tolerance: an edge lies apart from the surface by the errors of both.
double whole_tolerance(const EdgeContext &context) { return context.tolerance / edge_share; }

} // namespace

ReparametrisedEdges::ReparametrisedEdges(const EdgeContext &context, const AnalyticSurface *form)
    : m_context(context), m_form(form), m_base(context.input.surface)
{
    if (!context.base.spline())
        return;
    m_base = to_geom(*context.base.spline());
    m_base_form = AnalyticSurface::make(m_base);
}

CurveOnSurface ReparametrisedEdges::on_base(const TrimmingCurve &base) const
{
    return {m_base, base.pcurve, base.first, base.last};
}

Handle(Geom2d_Curve) ReparametrisedEdges::image(const TrimmingCurve &base) const
{
    return mapped_pcurve(on_base(base), *m_context.surface.parameter_map, image_share * m_context.tolerance);
}

Failure ReparametrisedEdges::refusal(const TrimmingCurve &base) const
{
    const gp_Pnt2d uv = base.pcurve->Value(0.5 * (base.first + base.last));
    return {Status::EdgeToleranceNotReached, Stage::Trimming,
            fmt::format("The offset of the trimming curve at the reported place could not be brought within {:.3g} mm; "
                        "loosen the tolerance, repair the trimming curve or use the method same-parameter.",
                        m_context.tolerance),
            m_context.input.place(uv), std::nullopt};
}

Result<OffsetEdge> ReparametrisedEdges::make_degenerated(const TrimmingCurve &base, OffsetEdge edge) const
{
    edge.pcurve = image(base);
    if (edge.pcurve.IsNull())
        return refusal(base);
    const CurveOnSurface on_offset{m_context.surface.geometry, edge.pcurve, edge.first, edge.last};
    const EdgeTarget target(on_offset, m_form);
    const double admissible = std::max(m_context.tolerance, Precision::Confusion());
    edge.deviation = target.deviation(on_offset.value(edge.first), admissible);
    if (edge.deviation.bound <= admissible)
    {
        // every point of the surface's border keeps within the surface's error of the exact one
        if (edge.deviation.proven && m_context.surface.certified_error)
            edge.offset_error = edge.deviation.bound + *m_context.surface.certified_error;
        return edge;
    }
    const std::optional<EdgeCurve> opened = edge_curve(target, m_context.tolerance);
    if (!opened)
        return refusal(base);
    edge.curve = opened->curve;
    edge.deviation = opened->deviation;
    edge.sampled_error = sampled_edge_error(m_context, base, edge.curve);
    return edge;
}

Result<OffsetEdge> ReparametrisedEdges::make(const TrimmingCurve &base) const
{
    OffsetEdge edge;
    edge.own_parameters = true;
    edge.first = base.first;
    edge.last = base.last;
    if (base.degenerated)
        return make_degenerated(base, std::move(edge));
    const EdgeTarget on_spline(on_base(base), m_base_form ? &*m_base_form : nullptr);
    const std::optional<EdgeCurve> made =
        offset_trimming_curve({on_spline, m_context.base, m_context.distance}, curve_share * m_context.tolerance);
    if (!made)
        return refusal(base);
    edge.curve = made->curve;
    if (made->deviation.proven)
        edge.offset_error = made->deviation.bound;
    edge.pcurve = m_context.image
                      ? m_context.image(edge.curve, edge.first, edge.last, image_share * m_context.tolerance)
                      : image(base);
    if (edge.pcurve.IsNull())
        return refusal(base);
    const EdgeTarget target({m_context.surface.geometry, edge.pcurve, edge.first, edge.last}, m_form);
    edge.deviation = target.deviation(edge.curve, whole_tolerance(m_context));
    if (edge.deviation.bound > whole_tolerance(m_context))
        return refusal(base);
    edge.sampled_error = sampled_edge_error(m_context, base, edge.curve);
    return edge;
}

Result<bool> ReparametrisedEdges::add_second_side(const TrimmingCurve &base, OffsetEdge &edge) const
{
    if (edge.curve.IsNull())
        return true;
    edge.second_pcurve = image(base);
    if (edge.second_pcurve.IsNull())
        return refusal(base);
    const EdgeTarget other({m_context.surface.geometry, edge.second_pcurve, edge.first, edge.last}, m_form);
    const Deviation deviation = other.deviation(edge.curve, whole_tolerance(m_context));
    edge.deviation.bound = std::max(edge.deviation.bound, deviation.bound);
    edge.deviation.proven = edge.deviation.proven && deviation.proven;
    if (edge.deviation.bound > whole_tolerance(m_context))
        return refusal(base);
    const EdgeTarget on_spline(on_base(base), m_base_form ? &*m_base_form : nullptr);
    const Deviation from_exact =
        offset_deviation({on_spline, m_context.base, m_context.distance}, edge.curve, m_context.tolerance);
    if (edge.offset_error && from_exact.proven)
        edge.offset_error = std::max(*edge.offset_error, from_exact.bound);
    else
        edge.offset_error.reset();
    return true;
}

} // namespace laminate_offset
