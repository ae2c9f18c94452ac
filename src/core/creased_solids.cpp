// SPDX-License-Identifier: LGPL-2.1-or-later
#include "creased_solids.h"

#include "offset_stack.h"

#include "analysis/creases.h"
#include "input/input_face.h"
#include "surface/check_meetings.h"

#include <TopoDS.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace laminate_offset
{
namespace
{

//! A part of the face and what is known of its surface, which ends at the creases.
struct Part
{
    const InputFace &input;
    SurfaceAnalysis analysis;
};

Result<std::vector<Part>> analysed(const std::vector<InputFace> &inputs, double distance, double tolerance)
{
    std::vector<Part> parts;
    for (const InputFace &input : inputs)
    {
        Result<SurfaceAnalysis> analysis = read_base(input, distance, tolerance);
        if (!analysis)
            return analysis.failure();
        parts.push_back({input, std::move(analysis).value()});
    }
    return parts;
}

std::vector<CreaseEdge> edges_between(const std::vector<Part> &parts, double distance, double tolerance)
{
    std::vector<CreasedPart> creased;
    for (const Part &part : parts)
        creased.push_back({part.input, part.analysis.base});
    return crease_edges(creased, distance, tolerance);
}

//! The refusal of plies that cross at a crease; the other side helps only where no crease opens on this one.
std::optional<Failure> crossing(const std::vector<Part> &parts, const std::vector<CreaseEdge> &edges, double distance)
{
    const auto crosses = [](const CreaseEdge &edge) { return edge.crosses.has_value(); };
    const auto first = std::find_if(edges.begin(), edges.end(), crosses);
    if (first == edges.end())
        return std::nullopt;
    const bool other_side = std::none_of(edges.begin(), edges.end(), [](const CreaseEdge &e) { return e.opens; });
    const InputFace &input = parts[first->first].input;
    return Failure{Status::KinkedSurface, Stage::Topology,
                   fmt::format("At {:.4g} mm the plies on both sides of a crease cross each other, so they have no "
                               "solids; {}round the crease by a radius of more than that.",
                               std::abs(input.from_face(distance)),
                               other_side ? "stack on the face's other side, or " : ""),
                   input.place(*first->crosses), std::nullopt};
}

//! Refuses plies of different parts, from the face to the distance, that run into each other or that may.
std::optional<Failure> overlap(const std::vector<Part> &parts, double distance, double tolerance)
{
    std::vector<AnalysedPart> bodies;
    for (const Part &part : parts)
        bodies.push_back({part.input, part.analysis, nullptr});
    const Result<PartsApart> apart = check_part_meetings(bodies, edges_between(parts, distance, tolerance), distance,
                                                         tolerance, Between::Plies, fewer_plies);
    if (!apart)
        return apart.failure();
    if (apart.value().settled)
        return std::nullopt;
    return Failure{
        Status::NotSupported, Stage::Topology,
        "Whether plies of different parts of the creased face run into each other could not be settled; split the "
        "face at its creases and stack the parts.",
        apart.value().open, std::nullopt};
}

TopoDS_Face located(const InputFace &part)
{
    constexpr bool refuse_mirrors = false;
    TopoDS_Shape face = part.face.Oriented(part.reversed ? TopAbs_REVERSED : TopAbs_FORWARD);
    face.Location(part.location, refuse_mirrors);
    return TopoDS::Face(face);
}

Result<std::vector<TopoDS_Solid>> solids_of(const InputFace &part, const std::vector<double> &distances,
                                            const std::vector<SolidSpan> &spans, const OffsetOptions &options)
{
    const Result<StackResult> stack = offset_stack(located(part), distances, options);
    if (!stack)
        return stack.failure();
    std::vector<TopoDS_Face> faces;
    for (const OffsetResult &surface : stack.value().surfaces)
    {
        if (surface.shape.ShapeType() != TopAbs_FACE)
            return Failure{Status::KinkedSurface, Stage::Topology,
                           "A part of the creased face is torn once more; split the face at its creases first.",
                           part.place(part.loops.front().curves.front().pieces.front().start), std::nullopt};
        faces.push_back(surface.face());
    }
    return make_solids(faces, spans);
}

Result<std::vector<std::vector<TopoDS_Solid>>> all_solids(const TopoDS_Shape &face,
                                                          const std::vector<double> &distances,
                                                          const std::vector<SolidSpan> &spans,
                                                          const OffsetOptions &options)
{
    const Result<InputFace> input = read_face(face);
    if (!input)
        return input.failure();
    std::vector<double> ends{0.0, 0.0};
    for (const double distance : distances)
    {
        ends[0] = std::min(ends[0], input.value().from_surface(distance));
        ends[1] = std::max(ends[1], input.value().from_surface(distance));
    }
    const double farthest = std::abs(ends[0]) > std::abs(ends[1]) ? ends[0] : ends[1];
    const Result<std::vector<InputFace>> split = split_at_creases(input.value(), farthest, options.tolerance);
    if (!split)
        return split.failure();
    const Result<std::vector<Part>> parts = analysed(split.value(), farthest, options.tolerance);
    if (!parts)
        return parts.failure();
    for (const double end : ends)
        if (std::optional<Failure> crossed =
                crossing(parts.value(), edges_between(parts.value(), end, options.tolerance), end))
            return *std::move(crossed);
    std::vector<std::vector<TopoDS_Solid>> result(spans.size());
    for (const InputFace &part : split.value())
    {
        const Result<std::vector<TopoDS_Solid>> solids = solids_of(part, distances, spans, options);
        if (!solids)
            return solids.failure();
        for (std::size_t i = 0; i < spans.size(); ++i)
            result[i].push_back(solids.value()[i]);
    }
    for (const double end : ends)
        if (std::optional<Failure> met = overlap(parts.value(), end, options.tolerance))
            return *std::move(met);
    return result;
}

} // namespace

Result<std::vector<std::vector<TopoDS_Solid>>> creased_ply_solids(const TopoDS_Shape &face,
                                                                  const std::vector<double> &distances,
                                                                  const std::vector<SolidSpan> &spans,
                                                                  const OffsetOptions &options)
{
    try
    {
        return all_solids(face, distances, spans, options);
    }
    catch (const Standard_Failure &error)
    {
        return kernel_failure(error, Stage::Topology);
    }
}

} // namespace laminate_offset
