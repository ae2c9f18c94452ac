// SPDX-License-Identifier: LGPL-2.1-or-later
#include "stack_surfaces.h"

#include "../surface/check_meetings.h"
#include "../surface/offset_family.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>

namespace laminate_offset
{
namespace
{

using Maker = std::function<std::optional<OffsetSurface>(double)>;

//! One surface for each distance, or none at all.
std::optional<std::vector<OffsetSurface>> all_of(const StackDistances &distances, const Maker &make)
{
    std::vector<OffsetSurface> surfaces;
    for (const double distance : distances.all)
    {
        std::optional<OffsetSurface> surface = make(distance);
        if (!surface)
            return std::nullopt;
        surfaces.push_back(*std::move(surface));
    }
    return surfaces;
}

std::vector<OffsetSurface> members(const OffsetFamily &family, const StackDistances &distances)
{
    std::vector<OffsetSurface> surfaces(distances.all.size());
    tbb::parallel_for(std::size_t{0}, surfaces.size(), [&](std::size_t i) {
        surfaces[i] = {to_geom(family.at(distances.all[i])), {0.0, 0.0}, family.certified_error, family.sampled_error};
    });
    return surfaces;
}

//! The ends decide: an offset nearer to the base, on the same side, folds and meets itself no sooner.
template <class Check> Result<bool> at_ends(const StackDistances &distances, const Check &check)
{
    for (const double end : {distances.low, distances.high})
        if (Result<bool> passed = check(end); !passed)
            return passed;
    return true;
}

Result<StackSurfaces> fitted(const SurfaceAnalysis &analysis, const InputFace &input, const StackDistances &distances,
                             double tolerance, const OffsetOptions &options)
{
    if (distances.low == distances.high)
    {
        const Result<OffsetSurface> single = offset_surface(analysis, input, distances.low, options);
        if (!single)
            return single.failure();
        return StackSurfaces{std::vector<OffsetSurface>(distances.all.size(), single.value()), false};
    }
    const Result<OffsetFamily> family =
        fit_offset_family(analysis, input, distances.low, distances.high, tolerance, options);
    if (!family)
        return family.failure();
    return StackSurfaces{members(family.value(), distances), true};
}

//! Every distance by itself, in parallel; the first refusal in their order counts.
Result<StackSurfaces> fitted_each(const SurfaceAnalysis &analysis, const InputFace &input,
                                  const StackDistances &distances, const OffsetOptions &options)
{
    OffsetOptions silent = options; // progress is told by distances, not within one
    silent.progress = nullptr;
    std::vector<std::optional<Result<OffsetSurface>>> made(distances.all.size());
    std::mutex guard;
    double done = 0.0;
    bool cancelled = false;
    tbb::parallel_for(std::size_t{0}, made.size(), [&](std::size_t i) {
        made[i] = offset_surface(analysis, input, distances.all[i], silent);
        const std::lock_guard lock(guard);
        done += 1.0 / static_cast<double>(made.size());
        if (!cancelled && options.progress && !options.progress(std::min(1.0, done)))
            cancelled = true;
    });
    if (cancelled)
        return Failure{Status::Cancelled, Stage::Surface,
                       "The computation was cancelled while the stack's surfaces were fitted.", std::nullopt,
                       std::nullopt};
    StackSurfaces surfaces;
    for (std::optional<Result<OffsetSurface>> &one : made)
    {
        if (!one->ok())
            return one->failure();
        surfaces.surfaces.push_back(std::move(*one).value());
    }
    return surfaces;
}

} // namespace

StackDistances::StackDistances(std::vector<double> distances) : all(std::move(distances))
{
    const auto [least, largest] = std::minmax_element(all.begin(), all.end());
    low = *least;
    high = *largest;
}

const OffsetSurface &StackSurfaces::at(const StackDistances &distances, double distance) const
{
    const auto i = std::find(distances.all.begin(), distances.all.end(), distance) - distances.all.begin();
    return surfaces[static_cast<std::size_t>(i)];
}

Result<StackSurfaces> stack_surfaces(const SurfaceAnalysis &analysis, const InputFace &input,
                                     const StackDistances &distances, const OffsetOptions &options, StackFit fit)
{
    if (Result<bool> feasible = at_ends(distances, [&](double d) { return check_distance(analysis, input, d); });
        !feasible)
        return feasible.failure();
    if (auto exact = all_of(distances, [&](double d) { return exact_offset(input, d, options.tolerance); }))
        return StackSurfaces{*std::move(exact), false};
    const double tolerance = surface_share * options.tolerance;
    if (auto hidden = all_of(distances, [&](double d) { return hidden_offset(analysis, d, tolerance); }))
        return StackSurfaces{*std::move(hidden), false};
    Result<StackSurfaces> made = fit == StackFit::Each ? fitted_each(analysis, input, distances, options)
                                                       : fitted(analysis, input, distances, tolerance, options);
    if (!made)
        return made;
    bool apart = true;
    const auto settled = [&](double distance) {
        Result<bool> end = check_meetings(analysis, input, made.value().at(distances, distance), distance,
                                          options.tolerance, fewer_plies);
        apart = apart && end && end.value();
        return end;
    };
    if (const Result<bool> passed = at_ends(distances, settled); !passed)
        return passed.failure();
    for (OffsetSurface &surface : made.value().surfaces)
        surface.apart = apart;
    return made;
}

} // namespace laminate_offset
