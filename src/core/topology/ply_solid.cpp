// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ply_solid.h"

#include "side_surface.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_Line.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Wire.hxx>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace laminate_offset
{
namespace
{

// A ruling is compared with its side surface at so many places.
constexpr int ruling_probes = 4;
constexpr double sampled_margin = 1.1;

Failure refusal(Status status, std::string message, const TopoDS_Edge &edge = {})
{
    Failure failure{status, Stage::Topology, std::move(message), std::nullopt, std::nullopt};
    if (edge.IsNull() || BRep_Tool::Degenerated(edge))
        return failure;
    double first, last;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    failure.where = Where{gp_Pnt2d(), curve->Value(0.5 * (first + last))};
    return failure;
}

//! A use of an edge by a loop.
struct EdgeUse
{
    TopoDS_Edge edge;
    bool alone = true; //!< it stands in the face's loops only once: no seam
};

//! A copy of a face without its location, and its edges in the order of its loops.
struct Level
{
    TopoDS_Face face;
    std::vector<EdgeUse> uses;

    explicit Level(const TopoDS_Face &original)
    {
        constexpr bool copy_geometry = false;
        const TopoDS_Shape local = original.Located(TopLoc_Location());
        face = TopoDS::Face(BRepBuilderAPI_Copy(local.Oriented(TopAbs_FORWARD), copy_geometry).Shape());
        face.Orientation(original.Orientation());
        for (TopoDS_Iterator wires(face.Oriented(TopAbs_FORWARD)); wires.More(); wires.Next())
            for (TopoDS_Iterator edges(wires.Value()); edges.More(); edges.Next())
                if (edges.Value().ShapeType() == TopAbs_EDGE)
                    uses.push_back({TopoDS::Edge(edges.Value())});
        for (EdgeUse &a : uses)
            a.alone =
                std::count_if(uses.begin(), uses.end(), [&](const EdgeUse &b) { return a.edge.IsSame(b.edge); }) == 1;
    }
};

//! The side of one pair of edges.
struct Side
{
    TopoDS_Edge low; //!< as the lower face's loop uses it
    TopoDS_Edge high;
    double first = 0.0;
    double last = 0.0;
    SideSurface on;
};

TopoDS_Vertex end_of(const TopoDS_Edge &edge, bool last)
{
    const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    return last ? TopExp::LastVertex(forward) : TopExp::FirstVertex(forward);
}

//! The straight pcurve from one place to another over [0, length].
Handle(Geom2d_Curve) straight(const gp_Pnt2d &from, const gp_Pnt2d &to, double length)
{
    TColgp_Array1OfPnt2d poles(1, 2);
    poles(1) = from;
    poles(2) = to;
    TColStd_Array1OfReal knots(1, 2);
    knots(1) = 0.0;
    knots(2) = length;
    TColStd_Array1OfInteger multiplicities(1, 2);
    multiplicities.Init(2);
    return new Geom2d_BSplineCurve(poles, knots, multiplicities, 1);
}

bool belong_together(const TopoDS_Edge &low, const TopoDS_Edge &high)
{
    double a, b, c, d;
    BRep_Tool::Range(low, a, b);
    BRep_Tool::Range(high, c, d);
    return low.Orientation() == high.Orientation() && a == c && b == d;
}

//! The sides of a span, without touching its faces.
Result<std::vector<Side>> sides_between(const Level &low, const Level &high)
{
    if (low.uses.size() != high.uses.size())
        return refusal(Status::NotSupported,
                       "The faces have different numbers of edges, so no solid can be made between "
                       "them; use offsets of one face.");
    std::vector<Side> sides;
    for (std::size_t k = 0; k < low.uses.size(); ++k)
    {
        const TopoDS_Edge &a = low.uses[k].edge;
        const TopoDS_Edge &b = high.uses[k].edge;
        if (!belong_together(a, b))
            return refusal(
                Status::NotSupported,
                fmt::format("Edge {} of the faces does not have the same parameters on both, so no solid can "
                            "be made between them; use offsets of one face.",
                            k + 1),
                a);
        const bool bounds = a.Orientation() == TopAbs_FORWARD || a.Orientation() == TopAbs_REVERSED;
        const bool points = BRep_Tool::Degenerated(a) && BRep_Tool::Degenerated(b);
        if (!bounds || points || !low.uses[k].alone)
            continue;
        Side side{a, b, 0.0, 0.0, {}};
        const Handle(Geom_Curve) low_curve = BRep_Tool::Curve(a, side.first, side.last);
        const Handle(Geom_Curve) high_curve = BRep_Tool::Curve(b, side.first, side.last);
        const bool opens = low_curve.IsNull() || high_curve.IsNull();
        if (!opens && low_curve->Value(side.first).Distance(high_curve->Value(side.first)) <= Precision::Confusion())
            return refusal(
                Status::NotSupported,
                fmt::format("The faces meet at edge {}, so there is no solid between them; choose faces that "
                            "lie apart.",
                            k + 1),
                a);
        const std::optional<SideSurface> on =
            opens ? std::nullopt : side_surface(low_curve, high_curve, side.first, side.last);
        if (!on)
            return refusal(Status::NotSupported,
                           opens
                               ? fmt::format("Edge {} is a point on one face and a curve on the other, so its side has "
                                             "no surface here; trim the face short of the tip.",
                                             k + 1)
                               : fmt::format("The curves of edge {} are of kinds between which no exact side is known; "
                                             "convert the face to a B-spline face first.",
                                             k + 1),
                           opens ? TopoDS_Edge() : a);
        side.on = *on;
        sides.push_back(std::move(side));
    }
    return sides;
}

//! Puts a solid together. Adds pcurves to the edges of the two faces.
class SolidBuilder
{
public:
    SolidBuilder(const Level &low, const Level &high) : m_low(low), m_high(high) {}

    //! Faces that close by themselves make a shell each.
    TopoDS_Solid build(const std::vector<Side> &sides)
    {
        TopoDS_Solid solid;
        m_builder.MakeSolid(solid);
        TopoDS_Shell shell = shell_of(m_high.face);
        const TopoDS_Face low = TopoDS::Face(m_low.face.Reversed());
        if (sides.empty())
        {
            TopoDS_Shell other = shell_of(low);
            if (!looks_outwards(shell))
                std::swap(shell, other);
            close(solid, shell);
            close(solid, other);
            return solid;
        }
        m_builder.Add(shell, low);
        for (const Side &side : sides)
            m_builder.Add(shell, side_face(side));
        close(solid, shell);
        return solid;
    }

private:
    TopoDS_Shell shell_of(const TopoDS_Face &face)
    {
        TopoDS_Shell shell;
        m_builder.MakeShell(shell);
        m_builder.Add(shell, face);
        return shell;
    }

    void close(TopoDS_Solid &solid, TopoDS_Shell &shell)
    {
        shell.Closed(true);
        m_builder.Add(solid, shell);
    }

    //! Away from what the closed shell holds?
    static bool looks_outwards(const TopoDS_Shell &shell)
    {
        GProp_GProps properties;
        BRepGProp::VolumeProperties(shell, properties);
        return properties.Mass() > 0.0;
    }

    static double edge_tolerance(double error) { return std::max(Precision::Confusion(), error); }

    //! A side's face is bounded by the lower curve, the ruling at its end, the upper curve backwards and the ruling at
    //! its start, which runs round (along the curves) x (from low to high).
    TopoDS_Face side_face(const Side &side)
    {
        const TopLoc_Location here;
        TopoDS_Face face;
        m_builder.MakeFace(face, side.on.surface, here, Precision::Confusion());
        m_builder.UpdateEdge(side.low, side.on.low, side.on.surface, here, edge_tolerance(side.on.low_error));
        m_builder.UpdateEdge(side.high, side.on.high, side.on.surface, here, edge_tolerance(side.on.high_error));
        const TopAbs_Orientation turn = side.on.flipped ? TopAbs_REVERSED : TopAbs_FORWARD;
        const bool closed = end_of(side.low, false).IsSame(end_of(side.low, true));
        TopoDS_Wire wire = empty_wire();
        m_builder.Add(wire, side.low.Oriented(TopAbs_FORWARD));
        if (side.on.ring && closed)
        {
            close(wire, turn, face);
            wire = empty_wire();
            m_builder.Add(wire, side.high.Oriented(TopAbs_REVERSED));
        }
        else
        {
            const auto [start, end] = rulings(side, closed);
            m_builder.Add(wire, end.Oriented(TopAbs_FORWARD));
            m_builder.Add(wire, side.high.Oriented(TopAbs_REVERSED));
            m_builder.Add(wire, start.Oriented(TopAbs_REVERSED));
        }
        close(wire, turn, face);
        // the face must use the upper edge the other way round than the upper face does
        const bool upper_reversed =
            TopAbs::Compose(side.high.Orientation(), m_high.face.Orientation()) == TopAbs_REVERSED;
        face.Orientation(upper_reversed == side.on.flipped ? TopAbs_FORWARD : TopAbs_REVERSED);
        return face;
    }

    TopoDS_Wire empty_wire()
    {
        TopoDS_Wire wire;
        m_builder.MakeWire(wire);
        return wire;
    }

    void close(TopoDS_Wire &wire, TopAbs_Orientation turn, TopoDS_Face &face)
    {
        wire.Closed(true);
        m_builder.Add(face, wire.Oriented(turn));
    }

    //! The rulings at the start and the end of a side, with their pcurves; one and the same where the curves close.
    std::pair<TopoDS_Edge, TopoDS_Edge> rulings(const Side &side, bool closed)
    {
        const TopoDS_Edge start = ruling(end_of(side.low, false), end_of(side.high, false));
        const TopoDS_Edge end = ruling(end_of(side.low, true), end_of(side.high, true));
        const Handle(Geom2d_Curve) at_start = ruling_pcurve(side, side.first, start);
        const Handle(Geom2d_Curve) at_end = ruling_pcurve(side, side.last, end);
        const TopLoc_Location here;
        const double start_tolerance = deviation(start, at_start, side.on.surface);
        const double end_tolerance = deviation(end, at_end, side.on.surface);
        if (closed)
        {
            // in a face turned round, the edge at the end is the one that runs backwards
            m_builder.UpdateEdge(end, side.on.flipped ? at_start : at_end, side.on.flipped ? at_end : at_start,
                                 side.on.surface, here, std::max(start_tolerance, end_tolerance));
            return {start, end};
        }
        m_builder.UpdateEdge(start, at_start, side.on.surface, here, start_tolerance);
        m_builder.UpdateEdge(end, at_end, side.on.surface, here, end_tolerance);
        return {start, end};
    }

    //! The straight edge between two vertices; one for all sides that meet there.
    TopoDS_Edge ruling(const TopoDS_Vertex &low, const TopoDS_Vertex &high)
    {
        TopoDS_Edge &edge = m_rulings[{m_vertices.Add(low), m_vertices.Add(high)}];
        if (!edge.IsNull())
            return edge;
        const gp_Pnt from = BRep_Tool::Pnt(low);
        const gp_Vec step(from, BRep_Tool::Pnt(high));
        m_builder.MakeEdge(edge, new Geom_Line(from, gp_Dir(step)), Precision::Confusion());
        m_builder.Range(edge, 0.0, step.Magnitude());
        m_builder.Add(edge, low.Oriented(TopAbs_FORWARD));
        m_builder.Add(edge, high.Oriented(TopAbs_REVERSED));
        return edge;
    }

    static Handle(Geom2d_Curve) ruling_pcurve(const Side &side, double t, const TopoDS_Edge &ruling)
    {
        double first, length;
        BRep_Tool::Range(ruling, first, length);
        return straight(side.on.low->Value(t), side.on.high->Value(t), length);
    }

    //! How far a ruling keeps from a side surface: its ends stand in vertices where several curves meet.
    static double deviation(const TopoDS_Edge &edge, const Handle(Geom2d_Curve) & pcurve,
                            const Handle(Geom_Surface) & surface)
    {
        double first, last;
        const Handle(Geom_Curve) line = BRep_Tool::Curve(edge, first, last);
        double worst = 0.0;
        for (int i = 0; i <= ruling_probes; ++i)
        {
            const double t = first + (last - first) * i / ruling_probes;
            const gp_Pnt2d uv = pcurve->Value(t);
            worst = std::max(worst, line->Value(t).Distance(surface->Value(uv.X(), uv.Y())));
        }
        return std::max(Precision::Confusion(), sampled_margin * worst);
    }

    const Level &m_low;
    const Level &m_high;
    BRep_Builder m_builder;
    TopTools_IndexedMapOfShape m_vertices;
    std::map<std::pair<int, int>, TopoDS_Edge> m_rulings;
};

Result<bool> known(const std::vector<TopoDS_Face> &faces, const std::vector<SolidSpan> &spans)
{
    for (const TopoDS_Face &face : faces)
        if (face.IsNull() || !face.Location().IsEqual(faces.front().Location()) ||
            face.Orientation() != faces.front().Orientation())
            return refusal(Status::NotSupported,
                           "The faces do not stand at one place with one orientation, so no solid "
                           "can be made between them; use offsets of one face.");
    for (const SolidSpan &span : spans)
        if (span.low >= faces.size() || span.high >= faces.size() || span.low == span.high)
            return refusal(Status::InvalidOption,
                           "A solid needs two different faces; count them from 0 in the order given.");
    return true;
}

//! Nothing for a valid solid.
std::optional<Failure> defect(const TopoDS_Solid &solid)
{
    if (BRepCheck_Analyzer(solid).IsValid())
        return std::nullopt;
    return refusal(
        Status::InvalidResult,
        "A ply's solid did not pass its validity check; the faces alone may still serve. Check that the base "
        "face is valid and that its edges do not touch each other.");
}

//! Runs `make` for all indices in parallel; the first failure in their order counts.
template <class Make> Result<bool> for_all(std::size_t count, const Make &make)
{
    std::vector<std::optional<Failure>> failures(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        try
        {
            failures[i] = make(i);
        }
        catch (const Standard_Failure &error)
        {
            failures[i] = kernel_failure(error, Stage::Topology);
        }
    });
    for (const std::optional<Failure> &failure : failures)
        if (failure)
            return *failure;
    return true;
}

} // namespace

Result<std::vector<TopoDS_Solid>> make_solids(const std::vector<TopoDS_Face> &faces,
                                              const std::vector<SolidSpan> &spans)
{
    if (const Result<bool> usable = known(faces, spans); !usable)
        return usable.failure();
    const std::vector<Level> levels(faces.begin(), faces.end());
    std::vector<std::vector<Side>> sides(spans.size());
    const auto find_sides = [&](std::size_t i) -> std::optional<Failure> {
        Result<std::vector<Side>> found = sides_between(levels[spans[i].low], levels[spans[i].high]);
        if (!found)
            return found.failure();
        sides[i] = std::move(found).value();
        return std::nullopt;
    };
    if (const Result<bool> made = for_all(spans.size(), find_sides); !made)
        return made.failure();
    std::vector<TopoDS_Solid> solids;
    for (std::size_t i = 0; i < spans.size(); ++i) // one after the other: neighbours write to the edges that they share
        solids.push_back(SolidBuilder(levels[spans[i].low], levels[spans[i].high]).build(sides[i]));
    if (const Result<bool> valid = for_all(spans.size(), [&](std::size_t i) { return defect(solids[i]); }); !valid)
        return valid.failure();
    constexpr bool refuse_mirrors = false; // the base may stand under a mirror
    for (TopoDS_Solid &solid : solids)
        solid.Location(faces.front().Location(), refuse_mirrors);
    return solids;
}

} // namespace laminate_offset
