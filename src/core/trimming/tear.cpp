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

//! An edge of the base in two of its parts.
struct SharedEdge
{
    const OffsetEdge &edge;
    const OffsetPart &other_part;
    const OffsetEdge &other;
};

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
                    shared.push_back({edge, parts[j], other});
            }
    return shared;
}

} // namespace

std::optional<double> tear_width(const std::vector<OffsetPart> &parts, double tolerance)
{
    std::optional<double> widest = 0.0;
    for (const SharedEdge &shared : shared_edges(parts))
    {
        std::optional<double> width = distance_bound(shared.edge, shared.other);
        if (!width)
            width = bound_through_surface(shared.edge, shared.other_part, shared.other, tolerance);
        widest = width && widest ? std::optional<double>(std::max(*width, *widest)) : std::nullopt;
    }
    return widest;
}

} // namespace laminate_offset
