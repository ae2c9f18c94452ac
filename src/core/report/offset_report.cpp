// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_report.h"

#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace laminate_offset
{
namespace
{

using Json = nlohmann::ordered_json;

Json number(const std::optional<double> &value)
{
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json limits_json(const std::optional<FeasibleRange> &limits)
{
    if (!limits)
        return nullptr;
    return {{"negative", number(limits->negative)}, {"positive", number(limits->positive)}};
}

} // namespace

SurfaceSummary summary_of(const Handle(Geom_Surface) & surface)
{
    SurfaceSummary result;
    switch (GeomAdaptor_Surface(surface).GetType())
    {
    case GeomAbs_Plane: result.type = "plane"; break;
    case GeomAbs_Cylinder: result.type = "cylinder"; break;
    case GeomAbs_Cone: result.type = "cone"; break;
    case GeomAbs_Sphere: result.type = "sphere"; break;
    case GeomAbs_Torus: result.type = "torus"; break;
    case GeomAbs_SurfaceOfRevolution: result.type = "revolution"; break;
    case GeomAbs_SurfaceOfExtrusion: result.type = "extrusion"; break;
    default: result.type = "bspline"; break;
    }
    if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface))
    {
        result.degree_u = spline->UDegree();
        result.degree_v = spline->VDegree();
        result.poles_u = spline->NbUPoles();
        result.poles_v = spline->NbVPoles();
        result.rational = spline->IsURational() || spline->IsVRational();
    }
    return result;
}

OffsetReport refusal_report(const Failure &failure, const OffsetOptions &options)
{
    OffsetReport report;
    report.status = failure.status;
    report.stage = failure.stage;
    report.message = failure.message;
    report.where = failure.where;
    report.method = options.method;
    report.distance = options.distance;
    report.tolerance = options.tolerance;
    report.limits = failure.feasible_range;
    return report;
}

Json to_json(const std::optional<Where> &where)
{
    if (!where)
        return nullptr;
    return {{"u", where->uv.X()},
            {"v", where->uv.Y()},
            {"x", where->point.X()},
            {"y", where->point.Y()},
            {"z", where->point.Z()}};
}

Json to_json(const std::optional<SurfaceSummary> &surface)
{
    if (!surface)
        return nullptr;
    return {{"type", surface->type},       {"degree_u", surface->degree_u}, {"degree_v", surface->degree_v},
            {"poles_u", surface->poles_u}, {"poles_v", surface->poles_v},   {"rational", surface->rational}};
}

Json to_json(const std::vector<ExtendedSide> &sides)
{
    Json list = Json::array();
    for (const ExtendedSide &side : sides)
        list.push_back({{"side", name(side.side)},
                        {"parameter", side.parameter},
                        {"mean_length", side.mean_length},
                        {"shortest", side.shortest},
                        {"longest", side.longest},
                        {"join_angle", side.join_angle},
                        {"moved_edges", side.moved_edges}});
    return list;
}

Json to_json(const OffsetReport &report)
{
    Json json;
    json["status"] = name(report.status);
    json["stage"] = name(report.stage);
    json["message"] = report.message;
    json["where"] = to_json(report.where);
    json["method"] = name(report.method);
    json["distance"] = number(report.distance);
    json["tolerance"] = number(report.tolerance);
    json["certified_error"] = number(report.certified_error);
    json["sampled_error"] = number(report.sampled_error);
    json["edge_error"] = number(report.edge_error);
    json["sampled_edge_error"] = number(report.sampled_edge_error);
    json["surface"] = to_json(report.surface);
    json["limits"] = limits_json(report.limits);
    json["limits_proven"] = report.limits ? Json(report.limits_proven) : Json(nullptr);
    json["self_intersection"] = report.status == Status::Ok ? Json(report.apart ? "none" : "undecided") : Json(nullptr);
    json["extension"] = report.extension
                            ? Json{{"length", report.extension->length}, {"sides", to_json(report.extension->sides)}}
                            : Json(nullptr);
    json["loops"] = report.loops;
    json["edges"] = report.edges;
    json["faces"] = report.faces;
    json["gap"] = number(report.gap);
    json["crease"] = report.crease ? Json(name(*report.crease)) : Json(nullptr);
    json["elapsed_ms"] = {{"total", report.elapsed.total}};
    for (const auto &[stage, milliseconds] : report.elapsed.stages)
        json["elapsed_ms"][std::string(name(stage))] = milliseconds;
    return json;
}

std::string to_json_text(const OffsetReport &report) { return to_json(report).dump(2); }

std::string to_text(const OffsetReport &report)
{
    if (report.status != Status::Ok)
        return fmt::format("refused ({}, stage {}): {}", name(report.status), name(report.stage), report.message);
    std::string text =
        fmt::format("offset by {:.6g} mm: {} loops, {} edges", report.distance, report.loops, report.edges);
    if (report.surface)
        text += fmt::format(", {}", report.surface->type);
    if (report.surface && report.surface->poles_u > 0)
        text += fmt::format(" {}x{} poles of degree {}x{}", report.surface->poles_u, report.surface->poles_v,
                            report.surface->degree_u, report.surface->degree_v);
    if (report.faces > 1)
        text += fmt::format(", {} faces torn along creases", report.faces);
    if (report.gap)
        text += fmt::format(" by up to {:.3g} mm", *report.gap);
    if (report.crease)
        text += fmt::format(" ({})", name(*report.crease));
    if (!report.apart)
        text += ", not settled whether it meets itself";
    if (report.certified_error)
        text += fmt::format(", proven error {:.3g} mm", *report.certified_error);
    if (report.sampled_error)
        text += fmt::format(", sampled error {:.3g} mm", *report.sampled_error);
    return text;
}

} // namespace laminate_offset
