// SPDX-License-Identifier: LGPL-2.1-or-later
#include "build_face.h"

#include "simple_loops.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include <algorithm>
#include <vector>

namespace laminate_offset
{
namespace
{

// Tolerances stand above proven bounds by rounding only, and well above what was merely seen at samples.
constexpr double proven_margin = 1.0 + 1e-12;
constexpr double sampled_margin = 1.1;
// Edges of a rough base may cross beside a vertex, inside its tolerance. Then the offset's vertices get as much of that
// tolerance as its validity needs: this [mm], and so many times more at each attempt.
constexpr double first_allowance = 1e-6;
constexpr double allowance_growth = 10.0;

class FaceBuilder
{
public:
    //! \param allowance vertices may have the tolerance of the base's up to this, though their edges need less [mm].
    FaceBuilder(const InputFace &input, const OffsetSurface &surface, const TrimLoops &loops, double allowance = 0.0)
        : m_input(input), m_surface(surface), m_loops(loops), m_allowance(allowance)
    {
    }

    TopoDS_Face build()
    {
        make_vertices();
        for (std::size_t k = 0; k < m_loops.edges.size(); ++k)
            m_edges.push_back(make_edge(k));
        TopoDS_Face face;
        m_builder.MakeFace(face, m_surface.geometry, TopLoc_Location(), Precision::Confusion());
        for (TopoDS_Iterator it(m_input.face, false, false); it.More(); it.Next())
            if (it.Value().ShapeType() == TopAbs_WIRE)
                m_builder.Add(face, make_wire(TopoDS::Wire(it.Value())));
        face.Orientation(m_input.reversed ? TopAbs_REVERSED : TopAbs_FORWARD);
        constexpr bool refuse_mirrors = false; // the base may stand under a mirror, and so may its offset
        face.Location(m_input.location, refuse_mirrors);
        return face;
    }

private:
    //! One end of an offset edge.
    struct EdgeEnd
    {
        std::size_t edge = 0;
        bool last = false; //!< at the edge's last parameter
        gp_Pnt point;
        double tolerance = 0.0;
        bool opened = false; //!< of an edge that is a point on the base
    };
    using EdgeEnds = std::vector<EdgeEnd>;

    [[nodiscard]] TopoDS_Edge base_edge(std::size_t k) const
    {
        return TopoDS::Edge(m_loops.bases(static_cast<int>(k) + 1).Oriented(TopAbs_FORWARD));
    }

    [[nodiscard]] gp_Pnt end_of(const OffsetEdge &edge, double t) const
    {
        if (!edge.curve.IsNull())
            return edge.curve->Value(t);
        const gp_Pnt2d uv = edge.pcurve->Value(t);
        return m_surface.geometry->Value(uv.X(), uv.Y());
    }

    //! The ends of all edges, those at one vertex of the base together.
    std::vector<EdgeEnds> ends_at_base_vertices()
    {
        std::vector<EdgeEnds> all;
        const auto note = [&](const TopoDS_Vertex &base, const EdgeEnd &end) {
            if (base.IsNull())
                return;
            const auto index = static_cast<std::size_t>(m_base_vertices.Add(base.Oriented(TopAbs_FORWARD))) - 1;
            all.resize(std::max(all.size(), index + 1));
            all[index].push_back(end);
        };
        for (std::size_t k = 0; k < m_loops.edges.size(); ++k)
        {
            const OffsetEdge &edge = m_loops.edges[k];
            const bool opened = !edge.curve.IsNull() && BRep_Tool::Degenerated(base_edge(k));
            const double tolerance = edge_tolerance(edge);
            note(TopExp::FirstVertex(base_edge(k)), {k, false, end_of(edge, edge.first), tolerance, opened});
            note(TopExp::LastVertex(base_edge(k)), {k, true, end_of(edge, edge.last), tolerance, opened});
        }
        return all;
    }

    //! The ends at one vertex of the base, parted where an edge opens up between them: its own two ends are
    //! apart unless it closes, and every other end joins the one that it meets.
    static std::vector<EdgeEnds> meeting_ends(const EdgeEnds &ends)
    {
        std::vector<EdgeEnds> groups;
        const auto nearest = [&](const EdgeEnd &end) {
            return std::min_element(groups.begin(), groups.end(), [&](const EdgeEnds &a, const EdgeEnds &b) {
                return a.front().point.SquareDistance(end.point) < b.front().point.SquareDistance(end.point);
            });
        };
        for (const EdgeEnd &end : ends)
        {
            if (!end.opened)
                continue;
            const auto group = nearest(end);
            const bool same = group != groups.end() &&
                              group->front().point.Distance(end.point) <= group->front().tolerance + end.tolerance;
            if (same)
                group->push_back(end);
            else
                groups.push_back({end});
        }
        if (groups.empty())
            return {ends};
        for (const EdgeEnd &end : ends)
            if (!end.opened)
                nearest(end)->push_back(end);
        return groups;
    }

    //! In the middle of the edge ends that meet there, with a tolerance that holds them all.
    TopoDS_Vertex make_vertex(const EdgeEnds &ends, const TopoDS_Vertex &base)
    {
        gp_XYZ sum(0.0, 0.0, 0.0);
        for (const EdgeEnd &end : ends)
            sum += end.point.XYZ();
        const gp_Pnt middle(sum / static_cast<double>(ends.size()));
        double tolerance = std::max(Precision::Confusion(), std::min(m_allowance, BRep_Tool::Tolerance(base)));
        for (const EdgeEnd &end : ends)
            tolerance = std::max(
                {tolerance, end.tolerance, proven_margin * middle.Distance(end.point) + Precision::Confusion()});
        TopoDS_Vertex vertex;
        m_builder.MakeVertex(vertex, middle, tolerance);
        return vertex;
    }

    void make_vertices()
    {
        m_vertices.resize(m_loops.edges.size());
        int index = 0;
        for (const EdgeEnds &at_base_vertex : ends_at_base_vertices())
        {
            const TopoDS_Vertex base = TopoDS::Vertex(m_base_vertices(++index));
            for (const EdgeEnds &meeting : meeting_ends(at_base_vertex))
            {
                const TopoDS_Vertex vertex = make_vertex(meeting, base);
                for (const EdgeEnd &end : meeting)
                    (end.last ? m_vertices[end.edge].last : m_vertices[end.edge].first) = vertex;
            }
            const EdgeEnd &any = at_base_vertex.front();
            m_any_vertices.push_back(any.last ? m_vertices[any.edge].last : m_vertices[any.edge].first);
        }
    }

    [[nodiscard]] static double edge_tolerance(const OffsetEdge &edge)
    {
        return std::max(Precision::Confusion(),
                        (edge.deviation.proven ? proven_margin : sampled_margin) * edge.deviation.bound);
    }

    TopoDS_Edge make_edge(std::size_t k)
    {
        const OffsetEdge &source = m_loops.edges[k];
        const double tolerance = edge_tolerance(source);
        TopoDS_Edge edge;
        if (source.curve.IsNull())
        {
            m_builder.MakeEdge(edge);
            m_builder.Degenerated(edge, true);
        }
        else
            m_builder.MakeEdge(edge, source.curve, tolerance);
        const bool reversed = m_loops.bases(static_cast<int>(k) + 1).Orientation() == TopAbs_REVERSED;
        if (source.second_pcurve.IsNull())
            m_builder.UpdateEdge(edge, source.pcurve, m_surface.geometry, TopLoc_Location(), tolerance);
        else
            m_builder.UpdateEdge(edge, reversed ? source.second_pcurve : source.pcurve,
                                 reversed ? source.pcurve : source.second_pcurve, m_surface.geometry, TopLoc_Location(),
                                 tolerance);
        m_builder.Range(edge, source.first, source.last);
        m_builder.SameRange(edge, true);
        m_builder.SameParameter(edge, true);
        add_vertices(edge, k);
        return edge;
    }

    void add_vertices(TopoDS_Edge &edge, std::size_t k)
    {
        for (TopoDS_Iterator it(base_edge(k), false, true); it.More(); it.Next())
        {
            const int index = m_base_vertices.FindIndex(it.Value());
            if (index == 0)
                continue;
            const TopAbs_Orientation orientation = it.Value().Orientation();
            const TopoDS_Vertex &vertex = orientation == TopAbs_FORWARD ? m_vertices[k].first
                                          : orientation == TopAbs_REVERSED
                                              ? m_vertices[k].last
                                              : m_any_vertices[static_cast<std::size_t>(index) - 1];
            m_builder.Add(edge, vertex.Oriented(orientation));
        }
    }

    TopoDS_Wire make_wire(const TopoDS_Wire &base)
    {
        TopoDS_Wire wire;
        m_builder.MakeWire(wire);
        for (TopoDS_Iterator it(base, false, true); it.More(); it.Next())
        {
            const auto index = static_cast<std::size_t>(m_loops.bases.FindIndex(it.Value())) - 1;
            m_builder.Add(wire, m_edges[index].Oriented(it.Value().Orientation()));
        }
        wire.Closed(true);
        wire.Orientation(base.Orientation());
        return wire;
    }

    const InputFace &m_input;
    const OffsetSurface &m_surface;
    const TrimLoops &m_loops;
    double m_allowance;
    BRep_Builder m_builder;
    struct EndVertices
    {
        TopoDS_Vertex first;
        TopoDS_Vertex last;
    };

    TopTools_IndexedMapOfShape m_base_vertices;
    std::vector<TopoDS_Vertex> m_any_vertices; //!< one of those made for each vertex of the base
    std::vector<EndVertices> m_vertices;       //!< of each edge
    std::vector<TopoDS_Edge> m_edges;
};

//! BRepCheck_Analyzer's verdict. Where the edges are proven to be near the surface and the loops to bound a region, the
//! wires by themselves are all that is left to judge.
bool valid(const TopoDS_Face &face, const TrimLoops &loops)
{
    const bool edges_proven = std::all_of(loops.edges.begin(), loops.edges.end(),
                                          [](const OffsetEdge &edge) { return edge.deviation.proven; });
    if (!edges_proven || !loops_proven_simple(face))
        return BRepCheck_Analyzer(face).IsValid();
    for (TopoDS_Iterator it(face); it.More(); it.Next())
        if (!BRepCheck_Analyzer(it.Value()).IsValid())
            return false;
    return true;
}

gp_Pnt2d start_of(const TrimmingCurve &curve)
{
    return curve.pcurve->Value(curve.edge.Orientation() == TopAbs_REVERSED ? curve.last : curve.first);
}

//! Where two curves of the loops start from the same place: a loop touches itself there, or another one.
std::optional<Where> touching_place(const InputFace &input)
{
    constexpr double near = 1e-9;
    const double reach_u = near * (input.box.umax - input.box.umin);
    const double reach_v = near * (input.box.vmax - input.box.vmin);
    const auto tiny = [&](const TrimmingCurve &curve) { // its neighbours all but meet, and touch nothing
        return std::all_of(curve.pieces.begin(), curve.pieces.end(), [&](const PcurvePiece &piece) {
            const gp_Pnt2d start = curve.pieces.front().start;
            return piece.box.umax - start.X() <= reach_u && start.X() - piece.box.umin <= reach_u &&
                   piece.box.vmax - start.Y() <= reach_v && start.Y() - piece.box.vmin <= reach_v;
        });
    };
    std::vector<gp_Pnt2d> starts;
    for (const TrimmingLoop &loop : input.loops)
        for (const TrimmingCurve &curve : loop.curves)
        {
            if (!curve.bounds_face() || tiny(curve))
                continue;
            const gp_Pnt2d start = start_of(curve);
            for (const gp_Pnt2d &other : starts)
                if (std::abs(start.X() - other.X()) <= reach_u && std::abs(start.Y() - other.Y()) <= reach_v)
                    return input.place(start);
            starts.push_back(start);
        }
    return std::nullopt;
}

Failure not_valid(const InputFace &input)
{
    Failure failure{Status::InvalidResult, Stage::Topology,
                    "The offset face did not pass its validity check; report this as a defect with the file.",
                    std::nullopt, std::nullopt};
    if (BRepCheck_Analyzer(input.face).IsValid())
        return failure;
    failure.message = "The base face itself is not valid, and so its offset is not; repair the face first.";
    failure.where = touching_place(input);
    if (failure.where)
        failure.message =
            "The base face itself is not valid, and so its offset is not: its trimming loops touch at the "
            "reported place. Split the face there into faces that do not touch themselves.";
    return failure;
}

} // namespace

Result<TopoDS_Face> build_face(const InputFace &input, const OffsetSurface &surface, const TrimLoops &loops,
                               FaceCheck check)
{
    const TopoDS_Face face = FaceBuilder(input, surface, loops).build();
    if ((check == FaceCheck::None && input.tolerance < first_allowance) || valid(face, loops))
        return face;
    const double enough = allowance_growth * input.tolerance;
    for (double allowance = first_allowance; allowance < enough; allowance *= allowance_growth)
        if (const TopoDS_Face tolerant = FaceBuilder(input, surface, loops, allowance).build(); valid(tolerant, loops))
            return tolerant;
    return not_valid(input);
}

TopoDS_Shell build_shell(const InputFace &input, const std::vector<TopoDS_Face> &parts)
{
    BRep_Builder builder;
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    for (const TopoDS_Face &part : parts)
        builder.Add(shell, part.Located(TopLoc_Location()));
    constexpr bool refuse_mirrors = false; // the base may stand under a mirror, and so may its offset
    shell.Location(input.location, refuse_mirrors);
    return shell;
}

} // namespace laminate_offset
