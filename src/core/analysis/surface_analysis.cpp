// SPDX-License-Identifier: LGPL-2.1-or-later
#include "surface_analysis.h"

#include "closed_limits.h"
#include "creases.h"
#include "curvature.h"
#include "light_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

// Curvature times the face's diagonal below which a face is flat: it is rounding, not shape.
constexpr double flat_curvature = 1e-9;
// A model that is flat is one of a flat base as long as its curvature is this many times as uncertain as rounding.
constexpr double model_flatness = 1e3;
// With more C0 knots than these, facets mostly, a model is made before creases are looked for: it has few of them left.
constexpr std::ptrdiff_t most_kinks_without_model = 8;
// Relative width between what is proven and what is attained that is good enough for a feasible distance.
constexpr double feasible_gap = 0.1;

Failure refusal_at(Status status, std::string message, const InputFace &input, const gp_Pnt2d &uv)
{
    return {status, Stage::Analysis, std::move(message), input.place(uv), std::nullopt};
}

//! A bound of the model's curvatures becomes one of the base's.
//! \param sign +1 for the highest curvature, -1 for the lowest.
//! \param flat curvature that is rounding, not shape.
void allow_for_model(const ModelError &error, double sign, double flat, CurvatureBound &k)
{
    const double factor = 1.0 + error.curvature_ratio;
    if (sign * k.proven > flat)
        k.proven *= factor;
    else if (error.curvature <= flat * model_flatness)
        return;
    k.proven += sign * error.curvature;
    k.attained = sign * std::max(0.0, sign * k.attained / factor - error.curvature);
}

//! Does the offset fold? The limits must have been searched for this distance.
bool folds(const SurfaceAnalysis &analysis, double distance)
{
    const std::optional<CurvatureLimit> &limit = distance < 0.0 ? analysis.negative : analysis.positive;
    return distance != 0.0 && limit && std::abs(distance) >= std::abs(limit->folds);
}

//! Could it not be decided whether the offset folds? Where curvature was only sampled nothing is ever proven, and the
//! face as it stands is taken as it is.
bool may_fold(const SurfaceAnalysis &analysis, const InputFace &input, double distance)
{
    const std::optional<CurvatureLimit> &limit = distance < 0.0 ? analysis.negative : analysis.positive;
    return distance != 0.0 && distance != input.base_distance && !analysis.sampled && limit &&
           std::abs(distance) >= std::abs(limit->distance);
}

//! Both limits as far as the search goes.
void search_limits(SurfaceAnalysis &analysis, const CurvatureSearch &search)
{
    CurvatureExtremes extremes = curvature_extremes(analysis.base, analysis.region, search);
    const double flat = flat_curvature / search.extent;
    allow_for_model(analysis.base.model_error(), -1.0, flat, extremes.lowest);
    allow_for_model(analysis.base.model_error(), 1.0, flat, extremes.highest);
    const auto limit = [flat](const CurvatureBound &k) -> std::optional<CurvatureLimit> {
        if (std::abs(k.proven) <= flat)
            return std::nullopt;
        const double infinity = std::copysign(std::numeric_limits<double>::infinity(), k.proven);
        return CurvatureLimit{1.0 / k.proven, k.attained == 0.0 ? infinity : 1.0 / k.attained, k.uv};
    };
    analysis.negative = limit(extremes.lowest);
    analysis.positive = limit(extremes.highest);
    analysis.sampled = extremes.lowest.sampled || extremes.highest.sampled;
}

//! A face on an offset surface that is folded itself has no normal to go along.
Result<bool> check_base_distance(SurfaceAnalysis &analysis, const InputFace &input)
{
    if (input.base_distance == 0.0)
        return true;
    find_limits(analysis, input, input.base_distance, refusal_gap);
    if (!folds(analysis, input.base_distance))
        return true;
    const CurvatureLimit &limit = input.base_distance < 0.0 ? *analysis.negative : *analysis.positive;
    return refusal_at(Status::CurvatureLimit,
                      fmt::format("The face is itself an offset, {:.6g} mm from a surface whose radius of curvature is "
                                  "{:.6g} mm at the reported place, and so it is folded; trim the tight region away "
                                  "or offset the original surface.",
                                  std::abs(input.base_distance), std::abs(limit.folds)),
                      input, limit.uv);
}

SurfaceAnalysis unchecked(const InputFace &input, double distance, double tolerance)
{
    return {base_beside_creases(input, {farther_distance(input, distance), tolerance}), LoopRegion(input), std::nullopt,
            std::nullopt};
}

//! Knots of both directions where the surface is only C0.
std::ptrdiff_t kinks(const BaseSurface &base)
{
    const auto is_kink = [](const SmoothnessBreak &b) { return b.continuity <= 0; };
    return std::count_if(base.breaks_u().begin(), base.breaks_u().end(), is_kink) +
           std::count_if(base.breaks_v().begin(), base.breaks_v().end(), is_kink);
}

//! The normals of a light model may stand for the base's: they differ by far less than a crease.
Result<bool> check_creases(const SurfaceAnalysis &analysis, const InputFace &input, double distance, double tolerance)
{
    const double farther = farther_distance(input, distance);
    const std::vector<CreaseLine> creases = find_creases(input, analysis.base, analysis.region, farther, tolerance);
    if (!creases.empty())
        return creased_refusal(input, creases);
    return true;
}

} // namespace

Result<SurfaceAnalysis> read_base(const InputFace &input, double distance, double tolerance)
{
    SurfaceAnalysis analysis = unchecked(input, distance, tolerance);
    if (const auto smooth = check_creases(analysis, input, distance, tolerance); !smooth)
        return smooth.failure();
    if (const auto regular = check_base_distance(analysis, input); !regular)
        return regular.failure();
    return analysis;
}

Result<SurfaceAnalysis> read_creased_base(const InputFace &input, double distance, double tolerance)
{
    SurfaceAnalysis analysis = unchecked(input, distance, tolerance);
    if (const auto regular = check_base_distance(analysis, input); !regular)
        return regular.failure();
    return analysis;
}

void find_limits(SurfaceAnalysis &analysis, const InputFace &input, double distance, double gap)
{
    if (const std::optional<ClosedLimits> closed = closed_limits(input))
    {
        analysis.negative = closed->negative;
        analysis.positive = closed->positive;
        return;
    }
    if (distance != 0.0)
        search_limits(analysis, {distance, std::max(gap, feasible_gap), input.diagonal});
    if (distance == 0.0 || folds(analysis, distance) || may_fold(analysis, input, distance))
        search_limits(analysis, {distance, gap, input.diagonal});
}

Result<SurfaceAnalysis> analyse(const InputFace &input, double distance, double tolerance)
{
    SurfaceAnalysis analysis = unchecked(input, distance, tolerance);
    BaseSurface &base = analysis.base;
    const bool few_kinks = kinks(base) <= most_kinks_without_model;
    if (few_kinks)
        if (const auto smooth = check_creases(analysis, input, distance, tolerance); !smooth)
            return smooth.failure(); // a model would have been in vain
    std::optional<LightModel> light;
    if (base.spline() && !base.strip()) // the models of swept surfaces are light
        light = light_model(*base.spline(), distance, tolerance, base.rounding());
    const bool has_curvature = light && std::isfinite(light->error.curvature);
    if (has_curvature)
        base.adopt_model(std::move(light->spline), light->error);
    if (!few_kinks)
        if (const auto smooth = check_creases(analysis, input, distance, tolerance); !smooth)
            return smooth.failure();
    if (const auto regular = check_base_distance(analysis, input); !regular)
        return regular.failure();
    find_limits(analysis, input, distance, refusal_gap);
    if (light && !has_curvature)
        base.adopt_model(std::move(light->spline), light->error);
    return analysis;
}

FeasibleRange feasible_range(const SurfaceAnalysis &analysis, const InputFace &input)
{
    FeasibleRange range;
    const bool turned = input.normal_sign < 0.0;
    // the face itself is feasible, though not proven to be when it stands within the search's gap of a limit
    if (analysis.negative)
        (turned ? range.positive : range.negative) =
            input.from_face(std::min(analysis.negative->distance, input.base_distance));
    if (analysis.positive)
        (turned ? range.negative : range.positive) =
            input.from_face(std::max(analysis.positive->distance, input.base_distance));
    return range;
}

Result<bool> check_distance(const SurfaceAnalysis &analysis, const InputFace &input, double distance)
{
    const bool certain = folds(analysis, distance);
    if (!certain && !may_fold(analysis, input, distance))
        return true;
    const std::optional<CurvatureLimit> &limit = distance < 0.0 ? analysis.negative : analysis.positive;
    Failure failure = refusal_at(Status::CurvatureLimit, "", input, limit->uv);
    failure.feasible_range = feasible_range(analysis, input);
    failure.message =
        certain
            ? fmt::format("The distance {:.6g} mm reaches the radius of curvature {:.6g} mm at the reported place, so "
                          "the offset would fold; stay below that distance or trim the tight region away.",
                          input.from_face(distance), std::abs(input.from_face(limit->folds)))
            : fmt::format("The distance {:.6g} mm could not be proven to stay below the radius of curvature near "
                          "the reported place; it is proven up to {:.6g} mm: stay below that distance or trim "
                          "the tight region away.",
                          input.from_face(distance), input.from_face(limit->distance));
    return failure;
}

} // namespace laminate_offset
