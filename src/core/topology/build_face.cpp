// SPDX-License-Identifier: LGPL-2.1-or-later
#include "build_face.h"

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

class FaceBuilder
{
public:
    FaceBuilder(const InputFace &input, const OffsetSurface &surface, const TrimLoops &loops)
        : m_input(input), m_surface(surface), m_loops(loops)
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
    struct Corner
    {
        gp_XYZ sum{0.0, 0.0, 0.0};
        std::vector<gp_Pnt> ends;
        double tolerance = Precision::Confusion();
    };

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

    //! A vertex stands in the middle of the edge ends that meet there, with a tolerance that holds them all.
    void make_vertices()
    {
        std::vector<Corner> corners;
        const auto note = [&](const TopoDS_Vertex &base, const gp_Pnt &end, double tolerance) {
            if (base.IsNull())
                return;
            const auto index = static_cast<std::size_t>(m_base_vertices.Add(base.Oriented(TopAbs_FORWARD))) - 1;
            corners.resize(std::max(corners.size(), index + 1));
            corners[index].sum += end.XYZ();
            corners[index].ends.push_back(end);
            corners[index].tolerance = std::max(corners[index].tolerance, tolerance);
        };
        for (std::size_t k = 0; k < m_loops.edges.size(); ++k)
        {
            const OffsetEdge &edge = m_loops.edges[k];
            note(TopExp::FirstVertex(base_edge(k)), end_of(edge, edge.first), edge_tolerance(edge));
            note(TopExp::LastVertex(base_edge(k)), end_of(edge, edge.last), edge_tolerance(edge));
        }
        for (const Corner &corner : corners)
        {
            const gp_Pnt middle(corner.sum / static_cast<double>(corner.ends.size()));
            double tolerance = corner.tolerance;
            for (const gp_Pnt &end : corner.ends)
                tolerance = std::max(tolerance, proven_margin * middle.Distance(end) + Precision::Confusion());
            TopoDS_Vertex vertex;
            m_builder.MakeVertex(vertex, middle, tolerance);
            m_vertices.push_back(vertex);
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
        add_vertices(edge, base_edge(k));
        return edge;
    }

    void add_vertices(TopoDS_Edge &edge, const TopoDS_Edge &base)
    {
        for (TopoDS_Iterator it(base, false, true); it.More(); it.Next())
        {
            const int index = m_base_vertices.FindIndex(it.Value());
            if (index > 0)
                m_builder.Add(edge, m_vertices[static_cast<std::size_t>(index) - 1].Oriented(it.Value().Orientation()));
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
    BRep_Builder m_builder;
    TopTools_IndexedMapOfShape m_base_vertices;
    std::vector<TopoDS_Vertex> m_vertices;
    std::vector<TopoDS_Edge> m_edges;
};

} // namespace

Result<TopoDS_Face> build_face(const InputFace &input, const OffsetSurface &surface, const TrimLoops &loops)
{
    const TopoDS_Face face = FaceBuilder(input, surface, loops).build();
    if (BRepCheck_Analyzer(face).IsValid())
        return face;
    const bool base_is_valid = BRepCheck_Analyzer(input.face).IsValid();
    return Failure{Status::InvalidResult, Stage::Topology,
                   base_is_valid
                       ? "The offset face did not pass its validity check; report this as a defect with the file."
                       : "The base face itself is not valid, and so its offset is not; repair the face first.",
                   std::nullopt, std::nullopt};
}

} // namespace laminate_offset
