// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_limits.h"

#include "analysis/surface_analysis.h"
#include "base/options.h"
#include "input/input_face.h"
#include "report/offset_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace laminate_offset
{
namespace
{

using Json = nlohmann::ordered_json;

// Relative width between what is proven and what is attained. The work grows
// like its inverse on round faces, where every piece ties.
constexpr double limit_gap = 1e-3;
// A crease is judged at this part of the face's diagonal.
constexpr double crease_distance = 1e-2;

std::optional<OffsetLimit> with_place(const InputFace &input, const std::optional<double> &distance,
                                      const std::optional<CurvatureLimit> &limit)
{
    if (!distance || !limit)
        return std::nullopt;
    return OffsetLimit{*distance, input.place(limit->uv)};
}

//! Of a creased face, whose offset is torn into parts, what all of them permit.
Result<OffsetLimits> limits_of(const InputFace &input)
{
    Result<SurfaceAnalysis> analysis =
        read_creased_base(input, crease_distance * input.diagonal, OffsetOptions{}.tolerance);
    if (!analysis)
        return analysis.failure();
    find_limits(analysis.value(), input, 0.0, limit_gap);
    const FeasibleRange range = feasible_range(analysis.value(), input);
    const bool turned = input.normal_sign < 0.0;
    OffsetLimits limits;
    limits.negative = with_place(input, range.negative, turned ? analysis.value().positive : analysis.value().negative);
    limits.positive = with_place(input, range.positive, turned ? analysis.value().negative : analysis.value().positive);
    limits.proven = !analysis.value().sampled;
    return limits;
}

Json side(const std::optional<OffsetLimit> &limit)
{
    if (!limit)
        return nullptr;
    return {{"distance", limit->distance}, {"where", to_json(std::optional<Where>(limit->where))}};
}

Json refusal(const Failure &failure)
{
    return {{"status", name(failure.status)},
            {"stage", name(failure.stage)},
            {"message", failure.message},
            {"where", to_json(failure.where)},
            {"proven", nullptr},
            {"negative", nullptr},
            {"positive", nullptr}};
}

} // namespace

Result<OffsetLimits> offset_limits(const TopoDS_Shape &shape)
{
    Stage stage = Stage::Input;
    try
    {
        const Result<InputFace> input = read_face(shape);
        if (!input)
            return input.failure();
        stage = Stage::Analysis;
        return limits_of(input.value());
    }
    catch (const Standard_Failure &error)
    {
        return kernel_failure(error, stage);
    }
}

Json to_json(const Result<OffsetLimits> &limits)
{
    if (!limits)
        return refusal(limits.failure());
    return {{"status", name(Status::Ok)},
            {"stage", name(Stage::Analysis)},
            {"message", "The limits were found."},
            {"where", nullptr},
            {"proven", limits.value().proven},
            {"negative", side(limits.value().negative)},
            {"positive", side(limits.value().positive)}};
}

} // namespace laminate_offset
