// SPDX-License-Identifier: LGPL-2.1-or-later
#include "project_curve.h"

#include "analysis/base_surface.h"
#include "input/input_face.h"
#include "projection/image_wire.h"

#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

// A surface without ends is used as far as this many sizes of the face and the curve.
constexpr double far_enough = 2.0;

Failure refusal(Status status, const char *message)
{
    return {status, Stage::Trimming, message, std::nullopt, std::nullopt};
}

//! The edges in their order along the wire.
std::vector<TopoDS_Edge> edges_of(const TopoDS_Shape &shape)
{
    std::vector<TopoDS_Edge> edges;
    if (shape.ShapeType() == TopAbs_EDGE)
        return {TopoDS::Edge(shape)};
    for (BRepTools_WireExplorer it(TopoDS::Wire(shape)); it.More(); it.Next())
        edges.push_back(it.Current());
    std::size_t all = 0;
    for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next())
        ++all;
    if (all == edges.size())
        return edges;
    edges.clear(); // a wire that does not hang together: as it is stored
    for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next())
        edges.push_back(TopoDS::Edge(it.Current()));
    return edges;
}

//! The edge's curve in the face's local coordinates; null where there is none.
SpaceCurve local_curve(const TopoDS_Edge &edge, const InputFace &input)
{
    SpaceCurve result;
    TopLoc_Location location;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, location, result.first, result.last);
    if (curve.IsNull() || Precision::IsInfinite(result.first) || Precision::IsInfinite(result.last))
        return result;
    const gp_Trsf to_face = input.location.Transformation().Inverted() * location.Transformation();
    result.curve = Handle(Geom_Curve)::DownCast(curve->Transformed(to_face));
    return result;
}

//! The whole surface, as far as it can be of use where it has no end.
ParameterBox extended_box(const InputFace &input, const Handle(Geom_Surface) & surface, double reach)
{
    ParameterBox box = domain_box(input, surface);
    double u0, u1, v0, v1;
    surface->Bounds(u0, u1, v0, v1);
    gp_Pnt s;
    gp_Vec su, sv;
    surface->D1(0.5 * (box.umin + box.umax), 0.5 * (box.vmin + box.vmax), s, su, sv);
    const auto widen = [&](double &low, double &high, double first, double last, bool periodic, double speed) {
        if (periodic)
        {
            high = low + (last - first);
            return;
        }
        const double step = reach / std::max(speed, 1e-12 * reach);
        low = std::max(first, Precision::IsInfinite(first) ? low - step : first);
        high = std::min(last, Precision::IsInfinite(last) ? high + step : last);
    };
    widen(box.umin, box.umax, u0, u1, surface->IsUPeriodic(), su.Magnitude());
    widen(box.vmin, box.vmax, v0, v1, surface->IsVPeriodic(), sv.Magnitude());
    return box;
}

//! How far the curve goes from the face's size.
double reach_of(const InputFace &input, const std::vector<SpaceCurve> &curves)
{
    const gp_Pnt middle =
        input.point({0.5 * (input.box.umin + input.box.umax), 0.5 * (input.box.vmin + input.box.vmax)});
    double reach = input.diagonal;
    constexpr int probes = 16;
    for (const SpaceCurve &curve : curves)
        for (int i = 0; i <= probes; ++i)
            reach = std::max(
                reach, middle.Distance(curve.curve->Value(curve.first + (curve.last - curve.first) * i / probes)));
    return far_enough * reach;
}

struct Given
{
    std::vector<SpaceCurve> curves;
    std::vector<char> reversed;
};

Result<Given> given_curves(const TopoDS_Shape &shape, const InputFace &input)
{
    if (shape.IsNull() || (shape.ShapeType() != TopAbs_EDGE && shape.ShapeType() != TopAbs_WIRE))
        return refusal(Status::NotSupported, "Only an edge or a wire can be put onto a face; pass one of these.");
    Given given;
    for (const TopoDS_Edge &edge : edges_of(shape))
    {
        if (BRep_Tool::Degenerated(edge))
            continue;
        SpaceCurve curve = local_curve(edge, input);
        if (curve.curve.IsNull())
            return refusal(Status::NotSupported,
                           "An edge has no curve of finite length in space; rebuild it, or trim it first.");
        given.curves.push_back(std::move(curve));
        given.reversed.push_back(edge.Orientation() == TopAbs_REVERSED ? 1 : 0);
    }
    return given;
}

//! The surface as it is proven: itself where it is elementary, else the spline that it is or that stands for it.
struct Proof
{
    Handle(Geom_Surface) surface;
    std::optional<AnalyticSurface> form;
    double model_error = 0.0;

    Proof(const Handle(Geom_Surface) & given, const ParameterBox &box, double tolerance) : surface(given)
    {
        if (!given->IsKind(STANDARD_TYPE(Geom_ElementarySurface)))
        {
            const BaseSurface base(given, box, ModelDemand{0.0, tolerance});
            if (base.spline())
            {
                surface = to_geom(*base.spline());
                model_error = base.model_error().point;
            }
        }
        form = AnalyticSurface::make(surface);
    }
};

//! Of two bounds; none where one of them is missing.
std::optional<double> larger(const std::optional<double> &a, const std::optional<double> &b)
{
    return a && b ? std::optional<double>(std::max(*a, *b)) : std::nullopt;
}

CurveProjection summary(const std::vector<ImagePart> &parts, const InputFace &input, double tolerance)
{
    CurveProjection result;
    result.certified_error = 0.0;
    result.certified_distance = 0.0;
    for (const ImagePart &part : parts)
    {
        const ImagePiece &piece = part.piece;
        ProjectedEdge edge{
            piece.pcurve,          part.given,       piece.first,    piece.last,           std::nullopt,
            piece.deviation.bound, piece.on_surface, piece.distance, piece.distance_bound, piece.bridged};
        if (piece.deviation.proven)
            edge.certified_error = piece.deviation.bound;
        result.certified_error = larger(result.certified_error, edge.certified_error);
        result.certified_distance = larger(result.certified_distance, edge.certified_distance);
        result.distance = std::max(result.distance, edge.distance);
        result.edges.push_back(edge);
    }
    result.wire = image_wires(input, parts, tolerance);
    return result;
}

Result<CurveProjection> project_on(const InputFace &input, const TopoDS_Shape &shape, const ProjectionOptions &options)
{
    const Result<Handle(Geom_Surface)> surface = true_surface(input);
    if (!surface)
        return surface.failure();
    const Result<Given> given = given_curves(shape, input);
    if (!given)
        return given.failure();
    const ParameterBox box = options.outside == Outside::Clip
                                 ? domain_box(input, surface.value())
                                 : extended_box(input, surface.value(), reach_of(input, given.value().curves));
    std::optional<ExactSpline> spline = exact_spline(surface.value(), box);
    if (!spline)
        return refusal(Status::NotSupported, "Curves cannot be put onto a procedural surface; turn the face into a "
                                             "spline first, for instance by its offset at the distance 0.");
    const NearestSearch search(std::move(*spline));
    const Proof proof(surface.value(), box, options.tolerance);
    const ImageSurface on{
        search,        surface.value(), box, proof.surface, proof.form ? &*proof.form : nullptr, proof.model_error,
        input.diagonal};
    std::vector<ImagePart> parts;
    for (std::size_t i = 0; i < given.value().curves.size(); ++i)
    {
        const SpaceCurve &curve = given.value().curves[i];
        Result<std::vector<ImagePiece>> pieces = image_of(on, curve, options.tolerance);
        if (!pieces)
        {
            Failure failure = pieces.failure();
            if (failure.where)
                failure.where->point.Transform(input.location.Transformation());
            return failure;
        }
        const bool reversed = given.value().reversed[i] != 0;
        if (reversed)
            std::reverse(pieces.value().begin(), pieces.value().end());
        for (ImagePiece &piece : pieces.value())
        {
            const bool clipped = piece.first > curve.first || piece.last < curve.last;
            parts.push_back({std::move(piece), reversed, curve.curve, clipped});
        }
    }
    if (parts.empty())
        return refusal(Status::NotSupported,
                       "No part of the curve has its nearest point inside the face's surface; move the curve, or "
                       "extend the face.");
    return summary(without_slivers(parts, options.tolerance), input, options.tolerance);
}

} // namespace

Result<CurveProjection> project_curve(const TopoDS_Shape &face, const TopoDS_Shape &edge_or_wire,
                                      const ProjectionOptions &options)
{
    if (!(options.tolerance > 0.0 && std::isfinite(options.tolerance)))
        return Failure{Status::InvalidTolerance, Stage::Options,
                       "The tolerance must be a finite number above zero, in mm.", std::nullopt, std::nullopt};
    Stage stage = Stage::Input;
    try
    {
        const Result<InputFace> input = read_face(face);
        if (!input)
            return input.failure();
        stage = Stage::Trimming;
        return project_on(input.value(), edge_or_wire, options);
    }
    catch (const Standard_Failure &error)
    {
        return kernel_failure(error, stage);
    }
}

} // namespace laminate_offset
