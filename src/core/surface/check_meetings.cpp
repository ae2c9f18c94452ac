// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check_meetings.h"

#include "../analysis/part_meetings.h"

#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopExp.hxx>
#include <TopoDS_Vertex.hxx>
#include <fmt/format.h>

#include <cmath>

namespace laminate_offset
{
namespace
{

std::vector<gp_Pnt> ends_of(const TopoDS_Edge &edge)
{
    std::vector<gp_Pnt> ends;
    for (const TopoDS_Vertex &vertex : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
        if (!vertex.IsNull())
            ends.push_back(BRep_Tool::Pnt(vertex));
    return ends;
}

bool has_corner(const InputFace &input, const gp_Pnt &point, double tolerance)
{
    for (const TrimmingLoop &loop : input.loops)
        for (const TrimmingCurve &curve : loop.curves)
            for (const gp_Pnt &end : ends_of(curve.edge))
                if (end.Distance(point) <= tolerance + 2.0 * input.tolerance)
                    return true;
    return false;
}

//! Do both parts lie at an edge, or at one end of an edge, at which parts cross?
bool known_to_cross(const InputFace &one, const InputFace &other, const std::vector<CreaseEdge> &edges,
                    double tolerance)
{
    for (const CreaseEdge &edge : edges)
        if (edge.crosses)
            for (const gp_Pnt &end : ends_of(edge.edge))
                if (has_corner(one, end, tolerance) && has_corner(other, end, tolerance))
                    return true;
    return false;
}

//! The offset as a spline in the base's parameters.
Result<TensorSpline> spline_offset(const AnalysedPart &part, double distance, double tolerance)
{
    if (distance == 0.0 && part.analysis.base.spline())
        return *part.analysis.base.spline();
    const Result<OffsetSurface> fitted = fit_offset(part.analysis, part.input, distance, tolerance, OffsetOptions());
    if (!fitted)
        return fitted.failure();
    return from_geom(Handle(Geom_BSplineSurface)::DownCast(fitted.value().geometry));
}

Result<MeetingPart> meeting_part(const AnalysedPart &part, double distance, double tolerance, Between between)
{
    const auto spline = Handle(Geom_BSplineSurface)::DownCast(part.offset);
    Result<TensorSpline> far =
        spline.IsNull() ? spline_offset(part, distance, tolerance) : Result<TensorSpline>(from_geom(spline));
    if (!far)
        return far.failure();
    MeetingPart made{part.input, part.analysis, std::move(far).value(), std::nullopt};
    if (between == Between::Plies)
    {
        Result<TensorSpline> near = spline_offset(part, part.input.base_distance, tolerance);
        if (!near)
            return near.failure();
        made.near = std::move(near).value();
    }
    return made;
}

//! What a search without a meeting has left open, if anything.
PartsApart unsettled(const std::vector<AnalysedPart> &parts, const std::vector<CreaseEdge> &edges,
                     const PartMeetingSearch &search)
{
    for (const CreaseEdge &edge : edges)
        if (edge.open)
            return {false, parts[edge.first].input.place(*edge.open)};
    if (search.open)
        return {false, parts[search.open->first_part].input.place(search.open->first)};
    return {search.settled, std::nullopt};
}

} // namespace

Result<bool> check_meetings(const SurfaceAnalysis &analysis, const InputFace &input, const OffsetSurface &surface,
                            double distance, double tolerance, std::string_view remedy)
{
    Handle(Geom_Surface) geometry = surface.geometry;
    if (surface.parameter_map) // the search runs in the base's parameters: on a fit that is as near to the exact offset
    {
        const Result<OffsetSurface> fitted = fit_offset(analysis, input, distance, tolerance, OffsetOptions());
        if (!fitted)
            return fitted.failure();
        geometry = fitted.value().geometry;
    }
    const auto spline = Handle(Geom_BSplineSurface)::DownCast(geometry);
    if (spline.IsNull())
        return true;
    return check_self_intersection({analysis, input, from_geom(spline), distance, tolerance, remedy});
}

Result<PartsApart> check_part_meetings(const std::vector<AnalysedPart> &parts, const std::vector<CreaseEdge> &edges,
                                       double distance, double tolerance, Between between, std::string_view remedy)
{
    if (std::abs(distance) <= 2.0 * tolerance)
        return PartsApart{};
    PartMeetingQuery query;
    for (const AnalysedPart &part : parts)
    {
        Result<MeetingPart> made = meeting_part(part, distance, tolerance, between);
        if (!made)
            return PartsApart{false, made.failure().where}; // without a spline nothing can be searched
        query.parts.push_back(std::move(made).value());
    }
    query.distance = distance;
    query.tolerance = tolerance;
    query.edges = edges;
    query.cross = [&](std::size_t i, std::size_t j) {
        return known_to_cross(parts[i].input, parts[j].input, edges, tolerance);
    };
    const PartMeetingSearch search = find_part_meeting(query);
    if (!search.meeting)
        return unsettled(parts, edges, search);
    const InputFace &input = parts[search.meeting->first_part].input;
    const Where here = input.place(search.meeting->first);
    const Where there = parts[search.meeting->second_part].input.place(search.meeting->second);
    return Failure{
        Status::SelfIntersection, Stage::Surface,
        fmt::format(
            "At the distance {:.6g} mm the {} of the reported place {} of the place u={:.6g}, v={:.6g} ({:.6g}, "
            "{:.6g}, {:.6g}) on another part of the creased face; {}, or split the face between the two.",
            input.from_face(distance), between == Between::Plies ? "plies" : "offset",
            between == Between::Plies ? "run into those" : "meets that", there.uv.X(), there.uv.Y(), there.point.X(),
            there.point.Y(), there.point.Z(), remedy),
        here, std::nullopt};
}

} // namespace laminate_offset
