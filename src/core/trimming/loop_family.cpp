// SPDX-License-Identifier: LGPL-2.1-or-later
#include "loop_family.h"

#include "same_knots.h"

#include <Geom_BSplineCurve.hxx>
#include <Precision.hxx>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();
// Roundings of the combination of two poles, with a margin.
constexpr double rounding_operations = 8.0;

//! A curve over the knots of both, which can follow whatever either of them follows; nothing for rational curves.
Handle(Geom_BSplineCurve) over_both(const Geom_BSplineCurve &a, const Geom_BSplineCurve &b)
{
    if (a.IsRational() || b.IsRational())
        return {};
    const auto curve = Handle(Geom_BSplineCurve)::DownCast(a.Copy());
    const auto other = Handle(Geom_BSplineCurve)::DownCast(b.Copy());
    const int degree = std::max(a.Degree(), b.Degree());
    curve->IncreaseDegree(degree);
    other->IncreaseDegree(degree);
    for (int i = 2; i < other->NbKnots(); ++i)
        curve->InsertKnot(other->Knot(i), other->Multiplicity(i), Precision::PConfusion());
    return curve;
}

//! The worst of the deviations from both sides of a seam, or from the only one there is.
Deviation deviation_of(const OffsetEdge &edge, const Handle(Geom_Curve) & curve, const OffsetSurface &surface,
                       const AnalyticSurface *form, double tolerance)
{
    Deviation worst{0.0, true};
    for (const Handle(Geom2d_Curve) & pcurve : {edge.pcurve, edge.second_pcurve})
    {
        if (pcurve.IsNull())
            continue;
        const EdgeTarget target({surface.geometry, pcurve, edge.first, edge.last}, form);
        const Deviation here = target.deviation(curve, tolerance);
        worst = {std::max(worst.bound, here.bound), worst.proven && here.proven};
    }
    return worst;
}

//! The edge with its curve on the knots of `pattern`; nothing where that is not near enough.
std::optional<OffsetEdge> recast(const OffsetEdge &edge, const Handle(Geom_BSplineCurve) & pattern,
                                 const OffsetSurface &surface, const AnalyticSurface *form, double tolerance)
{
    if (pattern.IsNull())
        return std::nullopt;
    OffsetEdge result = edge;
    const EdgeTarget target({surface.geometry, edge.pcurve, edge.first, edge.last}, form);
    const Handle(Geom_BSplineCurve) curve = through_samples(*pattern, target);
    if (curve.IsNull())
        return std::nullopt;
    result.curve = curve;
    result.deviation = deviation_of(edge, curve, surface, form, tolerance);
    result.deviation.bound += edge.moved;
    return result.deviation.bound <= tolerance ? std::optional<OffsetEdge>(result) : std::nullopt;
}

gp_Pnt between(const gp_Pnt &a, const gp_Pnt &b, double part) { return a.Translated(part * gp_Vec(a, b)); }

//! The curve a part of the way from one to another on the same knots and weights.
Handle(Geom_Curve) between(const Handle(Geom_Curve) & low, const Handle(Geom_Curve) & high, double part)
{
    if (low.IsNull())
        return {};
    const auto curve = Handle(Geom_BSplineCurve)::DownCast(low->Copy());
    const auto other = Handle(Geom_BSplineCurve)::DownCast(high);
    for (int i = 1; i <= curve->NbPoles(); ++i)
        curve->SetPole(i, between(curve->Pole(i), other->Pole(i), part));
    return Handle(Geom_Curve)(curve);
}

double size_of(const Handle(Geom_Curve) & curve)
{
    const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve);
    double size = 0.0;
    for (int i = 1; !spline.IsNull() && i <= spline->NbPoles(); ++i)
        size = std::max(size, spline->Pole(i).XYZ().Modulus());
    return size;
}

//! One end of the family, prepared for proofs.
struct End
{
    const OffsetSurface &surface;
    std::optional<AnalyticSurface> form;
    double tolerance = 0.0;

    [[nodiscard]] std::optional<OffsetEdge> recast(const OffsetEdge &edge,
                                                   const Handle(Geom_BSplineCurve) & pattern) const
    {
        return laminate_offset::recast(edge, pattern, surface, form ? &*form : nullptr, tolerance);
    }
};

//! Both ends' edges on the same knots: those of either end, else those of both. False where nothing serves.
bool match(OffsetEdge &low, OffsetEdge &high, const End &at_low, const End &at_high)
{
    if (low.curve.IsNull() && high.curve.IsNull())
        return true;
    const auto low_curve = Handle(Geom_BSplineCurve)::DownCast(low.curve);
    const auto high_curve = Handle(Geom_BSplineCurve)::DownCast(high.curve);
    if (low_curve.IsNull() || high_curve.IsNull() || !clamped(*low_curve) || !clamped(*high_curve))
        return false;
    if (on_same_knots(*low_curve, *high_curve))
        return true;
    if (auto recast_low = at_low.recast(low, high_curve))
    {
        low = *std::move(recast_low);
        return true;
    }
    if (auto recast_high = at_high.recast(high, low_curve))
    {
        high = *std::move(recast_high);
        return true;
    }
    const Handle(Geom_BSplineCurve) pattern = over_both(*low_curve, *high_curve);
    auto both_low = at_low.recast(low, pattern);
    auto both_high = at_high.recast(high, pattern);
    if (!both_low || !both_high)
        return false;
    low = *std::move(both_low);
    high = *std::move(both_high);
    return true;
}

} // namespace

TrimLoops LoopFamily::at(double distance) const
{
    const double part = (distance - low) / (high - low);
    TrimLoops loops = at_low;
    for (std::size_t k = 0; k < loops.edges.size(); ++k)
    {
        OffsetEdge &edge = loops.edges[k];
        const OffsetEdge &other = at_high.edges[k];
        const double size = std::max(size_of(edge.curve), size_of(other.curve));
        if (other.moved < edge.moved) // the bounds hold for the base's pcurve too
        {
            edge.pcurve = other.pcurve;
            edge.second_pcurve = other.second_pcurve;
            edge.moved = other.moved;
        }
        edge.curve = between(at_low.edges[k].curve, other.curve, part);
        edge.deviation.bound =
            std::max(edge.deviation.bound, other.deviation.bound) + rounding_operations * epsilon * size;
        edge.deviation.proven = edge.deviation.proven && other.deviation.proven;
        edge.sampled_error = std::max(edge.sampled_error, other.sampled_error);
    }
    return loops;
}

Result<std::optional<LoopFamily>> loop_family(const InputFace &input, const BaseSurface &base, const FamilyEnds &ends,
                                              double tolerance)
{
    // the farther end needs the more knots: what serves there serves the other end as a rule
    const bool high_first = std::abs(ends.high) >= std::abs(ends.low);
    const auto loops_at = [&](bool at_high, const TrimLoops *like) {
        EdgeContext context{input, base, at_high ? ends.at_high : ends.at_low, at_high ? ends.high : ends.low,
                            tolerance};
        context.like = like;
        return offset_loops(context);
    };
    Result<TrimLoops> first = loops_at(high_first, nullptr);
    if (!first)
        return first.failure();
    Result<TrimLoops> second = loops_at(!high_first, &first.value());
    if (!second)
        return second.failure();
    Result<TrimLoops> &low = high_first ? second : first;
    Result<TrimLoops> &high = high_first ? first : second;
    const End at_low{ends.at_low, AnalyticSurface::make(ends.at_low.geometry), tolerance};
    const End at_high{ends.at_high, AnalyticSurface::make(ends.at_high.geometry), tolerance};
    LoopFamily family{std::move(low).value(), std::move(high).value(), ends.low, ends.high};
    std::atomic<bool> matched{true};
    tbb::parallel_for(std::size_t{0}, family.at_low.edges.size(), [&](std::size_t k) {
        if (!match(family.at_low.edges[k], family.at_high.edges[k], at_low, at_high))
            matched = false;
    });
    return matched ? std::optional<LoopFamily>(std::move(family)) : std::nullopt;
}

} // namespace laminate_offset
