// SPDX-License-Identifier: LGPL-2.1-or-later
#include "image_wire.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>

namespace laminate_offset
{
namespace
{

TopoDS_Vertex vertex_at(const gp_Pnt &point, double tolerance)
{
    TopoDS_Vertex vertex;
    BRep_Builder().MakeVertex(vertex, point, tolerance);
    return vertex;
}

double edge_tolerance(const ImagePiece &piece) { return std::max(Precision::Confusion(), piece.deviation.bound); }

gp_Pnt end_of(const ImagePart &part, bool last)
{
    return part.piece.curve->Value(last != part.reversed ? part.piece.last : part.piece.first);
}

//! Makes the vertex reach a point.
void reach(const TopoDS_Vertex &vertex, const gp_Pnt &point, double tolerance)
{
    const double away = BRep_Tool::Pnt(vertex).Distance(point);
    BRep_Builder().UpdateVertex(vertex, std::max(tolerance, away + Precision::Confusion()));
}

TopoDS_Edge edge_of(const InputFace &input, const ImagePart &part, const TopoDS_Vertex &start, const TopoDS_Vertex &end)
{
    const ImagePiece &piece = part.piece;
    const double tolerance = edge_tolerance(piece);
    BRep_Builder builder;
    TopoDS_Edge edge;
    builder.MakeEdge(edge, piece.curve, tolerance);
    builder.UpdateEdge(edge, piece.pcurve, input.face, tolerance);
    reach(start, end_of(part, false), tolerance);
    reach(end, end_of(part, true), tolerance);
    builder.Add(edge, (part.reversed ? end : start).Oriented(TopAbs_FORWARD));
    builder.Add(edge, (part.reversed ? start : end).Oriented(TopAbs_REVERSED));
    builder.Range(edge, piece.first, piece.last);
    builder.SameParameter(edge, true);
    builder.SameRange(edge, true);
    return TopoDS::Edge(edge.Oriented(part.reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
}

double joining_distance(double tolerance) { return 2.0 * std::max(tolerance, Precision::Confusion()); }

//! Shorter than a length?
bool shorter(const ImagePart &part, double length)
{
    constexpr int steps = 8;
    const ImagePiece &piece = part.piece;
    double sum = 0.0;
    gp_Pnt before = piece.curve->Value(piece.first);
    for (int i = 1; i <= steps; ++i)
    {
        const gp_Pnt here = piece.curve->Value(piece.first + (piece.last - piece.first) * i / steps);
        sum += before.Distance(here);
        before = here;
    }
    return sum < length;
}

} // namespace

std::vector<ImagePart> without_slivers(const std::vector<ImagePart> &parts, double tolerance)
{
    const double near = joining_distance(tolerance);
    const auto joined = [&](const ImagePart &a, const ImagePart &b) {
        return end_of(a, true).Distance(end_of(b, false)) <= near;
    };
    std::vector<ImagePart> kept = parts;
    for (std::size_t i = 0; i < kept.size() && kept.size() > 1;)
    {
        const ImagePart &before = kept[(i + kept.size() - 1) % kept.size()];
        const ImagePart &after = kept[(i + 1) % kept.size()];
        const bool links = joined(before, kept[i]) && joined(kept[i], after);
        if (kept[i].clipped && shorter(kept[i], tolerance) && (!links || joined(before, after)))
            kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
        else
            ++i;
    }
    return kept;
}

TopoDS_Shape image_wires(const InputFace &input, const std::vector<ImagePart> &parts, double tolerance)
{
    const BRep_Builder builder;
    const double near = joining_distance(tolerance);
    std::vector<TopoDS_Wire> wires;
    std::size_t first = 0;
    while (first < parts.size())
    {
        std::size_t last = first;
        while (last + 1 < parts.size() && end_of(parts[last], true).Distance(end_of(parts[last + 1], false)) <= near)
            ++last;
        const bool closed = end_of(parts[last], true).Distance(end_of(parts[first], false)) <= near;
        TopoDS_Wire wire;
        builder.MakeWire(wire);
        const TopoDS_Vertex begin = vertex_at(end_of(parts[first], false), edge_tolerance(parts[first].piece));
        TopoDS_Vertex from = begin;
        for (std::size_t i = first; i <= last; ++i)
        {
            const TopoDS_Vertex to =
                i == last && closed ? begin : vertex_at(end_of(parts[i], true), Precision::Confusion());
            builder.Add(wire, edge_of(input, parts[i], from, to));
            from = to;
        }
        wire.Closed(closed);
        wires.push_back(wire);
        first = last + 1;
    }
    if (wires.size() == 1)
        return wires.front().Located(input.location);
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (const TopoDS_Wire &wire : wires)
        builder.Add(compound, wire);
    return compound.Located(input.location);
}

} // namespace laminate_offset
