// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_stack.h"

#include "analysis/self_intersection.h"
#include "analysis/surface_analysis.h"
#include "input/input_face.h"
#include "report/face_report.h"
#include "stack/stack_surfaces.h"
#include "topology/build_face.h"
#include "trimming/check_edges.h"
#include "trimming/loop_family.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <numeric>
#include <utility>

namespace laminate_offset
{
namespace
{

// Parts of the progress: the fit, then the faces.
constexpr double fit_share = 0.3;

class StackPipeline
{
public:
    StackPipeline(const TopoDS_Shape &shape, const std::vector<double> &distances, const OffsetOptions &options,
                  StackFit fit)
        : m_shape(shape), m_distances(distances), m_options(options), m_fit(fit)
    {
    }

    Result<StackResult> run()
    {
        const auto start = std::chrono::steady_clock::now();
        Result<StackResult> result = checked();
        if (result)
            result.value().elapsed.total =
                std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
        return result;
    }

private:
    Result<StackResult> checked()
    {
        if (m_distances.empty())
            return Failure{Status::InvalidOption, Stage::Options,
                           "A stack needs one distance at least; give the distances of its surfaces in millimetres.",
                           std::nullopt, std::nullopt};
        for (const double distance : m_distances)
            if (const Result<bool> ok = check(options_at(distance)); !ok)
                return ok.failure();
        try
        {
            return from_one_fit();
        }
        catch (const Standard_Failure &error)
        {
            return kernel_failure(error, Stage::Surface);
        }
    }

    [[nodiscard]] OffsetOptions options_at(double distance) const
    {
        OffsetOptions options = m_options;
        options.distance = distance;
        return options;
    }

    Result<StackResult> from_one_fit()
    {
        const Result<InputFace> input = read_face(m_shape);
        if (!input)
            return input.failure();
        std::vector<double> from_surface;
        for (const double distance : m_distances)
            from_surface.push_back(input.value().from_surface(distance));
        const StackDistances distances(std::move(from_surface));
        const double farthest = std::abs(distances.low) > std::abs(distances.high) ? distances.low : distances.high;
        const Result<SurfaceAnalysis> analysis = analyse(input.value(), farthest, m_options.tolerance);
        if (!analysis)
            return analysis.failure().status == Status::KinkedSurface ? one_by_one() : analysis.failure();
        const Result<StackSurfaces> surfaces =
            stack_surfaces(analysis.value(), input.value(), distances, options_for_fit(), m_fit);
        if (!surfaces)
            return surfaces.failure();
        const StackSurfaces &made = surfaces.value();
        if (!made.one_family)
            return own_edges(input.value(), analysis.value(), distances, made);
        const FamilyEnds ends{made.at(distances, distances.low), made.at(distances, distances.high), distances.low,
                              distances.high};
        const auto loops = loop_family(input.value(), analysis.value().base, ends, edge_share * m_options.tolerance);
        if (!loops)
            return loops.failure();
        if (!loops.value())
            return own_edges(input.value(), analysis.value(), distances, made);
        const LoopFamily &family = *loops.value();
        // members share their loops in parameters: where both ends are valid, so is every one between them
        const auto check = [&](std::size_t i) {
            const bool end = distances.all[i] == distances.low || distances.all[i] == distances.high;
            return end ? FaceCheck::Whole : FaceCheck::None;
        };
        return all_faces(
            input.value(), analysis.value(), made,
            [&](std::size_t i) { return Result<TrimLoops>(family.at(distances.all[i])); }, check);
    }

    [[nodiscard]] OffsetOptions options_for_fit() const
    {
        OffsetOptions options = m_options;
        if (m_options.progress)
            options.progress = [outer = m_options.progress](double fraction) { return outer(fit_share * fraction); };
        return options;
    }

    //! Every surface gets edges of its own.
    Result<StackResult> own_edges(const InputFace &input, const SurfaceAnalysis &analysis,
                                  const StackDistances &distances, const StackSurfaces &made)
    {
        const auto loops = [&](std::size_t i) {
            return offset_loops(
                {input, analysis.base, made.surfaces[i], distances.all[i], edge_share * m_options.tolerance});
        };
        return all_faces(input, analysis, made, loops, [](std::size_t) { return FaceCheck::Whole; });
    }

    //! The faces over the loops that `loops_of` gives, in parallel.
    template <class LoopsOf, class CheckOf>
    Result<StackResult> all_faces(const InputFace &input, const SurfaceAnalysis &analysis, const StackSurfaces &made,
                                  const LoopsOf &loops_of, const CheckOf &check_of)
    {
        StackResult result;
        result.one_fit = made.one_family;
        const auto make = [&](std::size_t i) -> Result<OffsetResult> {
            const OffsetSurface &surface = made.surfaces[i];
            const Result<TrimLoops> loops = loops_of(i);
            if (!loops)
                return loops.failure();
            if (const Result<bool> close = check_edges(input, surface, loops.value(), m_options.tolerance); !close)
                return close.failure();
            const Result<TopoDS_Face> face = build_face(input, surface, loops.value(), check_of(i));
            if (!face)
                return face.failure();
            return OffsetResult{face.value(),
                                face_report(input, analysis, surface, loops.value(), options_at(m_distances[i]))};
        };
        return in_parallel(fit_share, make, std::move(result));
    }

    //! For a base that is torn at creases: every distance by itself.
    Result<StackResult> one_by_one()
    {
        return in_parallel(
            0.0,
            [&](std::size_t i) {
                OffsetOptions options = options_at(m_distances[i]);
                options.progress = nullptr;
                return offset_face(m_shape, options, fewer_plies);
            },
            StackResult{});
    }

    //! Runs `make` for every distance; the first failure in the order of the distances is what counts.
    template <class Make> Result<StackResult> in_parallel(double done_before, const Make &make, StackResult result)
    {
        std::vector<std::optional<Result<OffsetResult>>> made(m_distances.size());
        std::atomic<std::size_t> done{0};
        std::atomic<bool> cancelled{false};
        std::mutex guard;
        tbb::parallel_for(std::size_t{0}, made.size(), [&](std::size_t i) {
            if (cancelled)
                return;
            made[i] = caught(make, i);
            const double fraction =
                done_before + (1.0 - done_before) * static_cast<double>(++done) / static_cast<double>(made.size());
            const std::lock_guard lock(guard);
            if (m_options.progress && !m_options.progress(fraction))
                cancelled = true;
        });
        if (cancelled)
            return Failure{Status::Cancelled, Stage::Topology,
                           "The computation was cancelled while the stack's faces were made.", std::nullopt,
                           std::nullopt};
        for (std::optional<Result<OffsetResult>> &one : made)
        {
            if (!one->ok())
                return one->failure();
            result.surfaces.push_back(std::move(*one).value());
        }
        return result;
    }

    template <class Make> static Result<OffsetResult> caught(const Make &make, std::size_t i)
    {
        try
        {
            return make(i);
        }
        catch (const Standard_Failure &error)
        {
            return kernel_failure(error, Stage::Topology);
        }
    }

    const TopoDS_Shape &m_shape;
    const std::vector<double> &m_distances;
    const OffsetOptions &m_options;
    StackFit m_fit;
};

} // namespace

Result<StackResult> offset_stack(const TopoDS_Shape &shape, const std::vector<double> &distances,
                                 const OffsetOptions &options, StackFit fit)
{
    return StackPipeline(shape, distances, options, fit).run();
}

} // namespace laminate_offset
