// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tear.h"

#include "analytic_curve.h"

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

// A polynomial of degree n is nowhere larger than 1 / cos(pi n / (2 N)) times its largest value at N Chebyshev points
// (edge_certificate.h): 1.005 here.
constexpr int points_per_degree = 16;
constexpr int kind_samples = 64;

//! The polynomial difference of two curves between their knots.
std::optional<double> largest_difference(const CurvePiece &a, const CurvePiece &b)
{
    int degree = 0;
    for (const CurvePiece *piece : {&a, &b})
        for (int coordinate = 0; coordinate < 3; ++coordinate)
        {
            const std::optional<int> own = piece->degree(coordinate, 0.0);
            if (!own)
                return std::nullopt;
            degree = std::max(degree, *own);
        }
    const int points = points_per_degree * degree + 1;
    const double middle = 0.5 * (a.a() + a.b());
    const double half = 0.5 * (a.b() - a.a());
    double largest = 0.0;
    for (int k = 0; k < points; ++k)
    {
        const double t = middle + half * std::cos(M_PI * (k + 0.5) / points);
        largest = std::max(largest, (a.value(t) - b.value(t)).norm());
    }
    const double factor = (1.0 + 1e-9) / std::cos(M_PI * degree / (2.0 * points));
    const double rounding = a.rounding().norm() + b.rounding().norm();
    return factor * (largest + rounding) + rounding;
}

//! Proven bound of the distance between two curves at equal parameters.
std::optional<double> distance_bound(const OffsetEdge &one, const OffsetEdge &other)
{
    const double first = one.first;
    const double last = one.last;
    const auto a = AnalyticCurve::make(one.curve, first, last);
    const auto b = AnalyticCurve::make(other.curve, first, last);
    if (!a || !b)
        return std::nullopt;
    const std::vector<double> ends = analytic_ends(*a, *b, first, last);
    double worst = 0.0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    {
        const auto here =
            largest_difference(CurvePiece(*a, ends[i], ends[i + 1]), CurvePiece(*b, ends[i], ends[i + 1]));
        if (!here)
            return std::nullopt;
        worst = std::max(worst, *here);
    }
    return worst;
}

//! The same through the other part's surface, for curves that are no polynomials: circles and rational curves.
std::optional<double> bound_through_surface(const OffsetEdge &one, const OffsetPart &other_part,
                                            const OffsetEdge &other, double tolerance)
{
    const std::optional<AnalyticSurface> form = AnalyticSurface::make(other_part.surface.geometry);
    const EdgeTarget target({other_part.surface.geometry, other.pcurve, other.first, other.last},
                            form ? &*form : nullptr);
    const Deviation deviation = target.deviation(one.curve, tolerance);
    if (!deviation.proven || !other.deviation.proven)
        return std::nullopt;
    return deviation.bound + other.deviation.bound;
}

//! The direction in the surface that leads out of the face across an edge, of length 1 or zero.
gp_Vec outwards(const OffsetPart &part, const OffsetEdge &edge, bool reversed, double t)
{
    gp_Pnt2d uv;
    gp_Vec2d along;
    edge.pcurve->D1(t, uv, along);
    gp_Pnt point;
    gp_Vec du, dv;
    part.surface.geometry->D1(uv.X(), uv.Y(), point, du, dv);
    gp_Vec out = (along.X() * du + along.Y() * dv).Crossed(du.Crossed(dv));
    if (out.Magnitude() > 0.0)
        out.Normalize();
    return reversed ? -out : out;
}

//! An edge of the base in two of its parts.
struct SharedEdge
{
    const OffsetPart &part;
    const OffsetEdge &edge;
    bool reversed = false;
    const OffsetPart &other_part;
    const OffsetEdge &other;
    bool other_reversed = false;
};

struct Kinds
{
    bool gap = false;
    bool overlap = false;
};

//! The sides of a gap have moved outwards, those of an overlap inwards.
void note_kinds(const SharedEdge &shared, double tolerance, Kinds &kinds)
{
    for (int i = 0; i <= kind_samples; ++i)
    {
        const double t = shared.edge.first + (shared.edge.last - shared.edge.first) * i / kind_samples;
        const gp_Vec across(shared.edge.curve->Value(t), shared.other.curve->Value(t));
        if (across.Magnitude() <= 0.5 * tolerance)
            continue;
        const gp_Vec apart = outwards(shared.part, shared.edge, shared.reversed, t) -
                             outwards(shared.other_part, shared.other, shared.other_reversed, t);
        (across.Dot(apart) > 0.0 ? kinds.gap : kinds.overlap) = true;
    }
}

std::vector<SharedEdge> shared_edges(const std::vector<OffsetPart> &parts)
{
    std::vector<SharedEdge> shared;
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = i + 1; j < parts.size(); ++j)
            for (int k = 1; k <= parts[i].loops.bases.Extent(); ++k)
            {
                const int l = parts[j].loops.bases.FindIndex(parts[i].loops.bases(k));
                if (l == 0)
                    continue;
                const OffsetEdge &edge = parts[i].loops.edges[static_cast<std::size_t>(k) - 1];
                const OffsetEdge &other = parts[j].loops.edges[static_cast<std::size_t>(l) - 1];
                if (!edge.curve.IsNull() && !other.curve.IsNull())
                    shared.push_back({parts[i], edge, parts[i].loops.bases(k).Orientation() == TopAbs_REVERSED,
                                      parts[j], other, parts[j].loops.bases(l).Orientation() == TopAbs_REVERSED});
            }
    return shared;
}

} // namespace

Tear measure_tear(const std::vector<OffsetPart> &parts, double tolerance)
{
    Tear tear;
    tear.width = 0.0;
    Kinds kinds;
    for (const SharedEdge &shared : shared_edges(parts))
    {
        std::optional<double> width = distance_bound(shared.edge, shared.other);
        if (!width)
            width = bound_through_surface(shared.edge, shared.other_part, shared.other, tolerance);
        tear.width = width && tear.width ? std::optional<double>(std::max(*width, *tear.width)) : std::nullopt;
        note_kinds(shared, tolerance, kinds);
    }
    if (kinds.gap || kinds.overlap)
        tear.kind = !kinds.overlap ? CreaseKind::Gap : !kinds.gap ? CreaseKind::Overlap : CreaseKind::Both;
    return tear;
}

} // namespace laminate_offset
