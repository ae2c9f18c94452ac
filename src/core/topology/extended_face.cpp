// SPDX-License-Identifier: LGPL-2.1-or-later
#include "extended_face.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp_Lin2d.hxx>

#include <algorithm>
#include <cmath>
#include <optional>

namespace laminate_offset
{
namespace
{

//! A step of a loop: an edge of the base that stays, or one along an extended side.
struct LoopStep
{
    TopoDS_Edge edge;
    gp_Pnt2d start;
    gp_Pnt2d end;
    std::optional<std::size_t> side; //!< index of the extended side along which it lies
};

class ExtendedFaceBuilder
{
public:
    ExtendedFaceBuilder(const InputFace &input, ExtendedSurface &extended) : m_input(input), m_extended(extended) {}

    Result<TopoDS_Face> build()
    {
        m_builder.MakeFace(m_face, m_extended.geometry, TopLoc_Location(), Precision::Confusion());
        for (const TrimmingLoop &loop : m_input.loops)
        {
            const Result<TopoDS_Wire> wire = extended_loop(loop);
            if (!wire)
                return wire.failure();
            m_builder.Add(m_face, wire.value());
        }
        const bool any = std::any_of(m_extended.sides.begin(), m_extended.sides.end(),
                                     [](const ExtendedSide &side) { return side.moved_edges > 0; });
        if (!any)
            return Failure{
                Status::NotSupported, Stage::Extension,
                "No edge of the face lies along a side of its surface, so that an extension of the surface "
                "would leave the face as it is; trim the face along iso-curves, or move its trimming curves.",
                m_input.place(some_place()), std::nullopt};
        m_face.Orientation(m_input.reversed ? TopAbs_REVERSED : TopAbs_FORWARD);
        constexpr bool refuse_mirrors = false; // the base may stand under a mirror
        m_face.Location(m_input.location, refuse_mirrors);
        if (BRepCheck_Analyzer(m_face).IsValid())
            return m_face;
        return Failure{Status::InvalidResult, Stage::Topology,
                       BRepCheck_Analyzer(m_input.face).IsValid()
                           ? "The extended face did not pass its validity check; report this as a defect with the file."
                           : "The face itself is not valid, and so its extension is not; repair the face first.",
                       m_input.place(some_place()), std::nullopt};
    }

private:
    [[nodiscard]] gp_Pnt2d some_place() const { return m_input.loops.front().curves.front().pieces.front().start; }

    [[nodiscard]] static bool in_u(Side side) { return side == Side::UMin || side == Side::UMax; }

    [[nodiscard]] static double side_of(const ParameterBox &box, Side side)
    {
        switch (side)
        {
        case Side::UMin: return box.umin;
        case Side::UMax: return box.umax;
        case Side::VMin: return box.vmin;
        default: return box.vmax;
        }
    }

    [[nodiscard]] gp_Pnt point(const gp_Pnt2d &uv) const { return m_extended.geometry->Value(uv.X(), uv.Y()); }

    //! The extended side along which a curve of the base lies, within the edge's tolerance.
    [[nodiscard]] std::optional<std::size_t> side_along(const TrimmingCurve &curve) const
    {
        const double tolerance = std::max(BRep_Tool::Tolerance(curve.edge), Precision::Confusion());
        const gp_Pnt2d middle = curve.pcurve->Value(0.5 * (curve.first + curve.last));
        gp_Pnt ignored;
        gp_Vec du, dv;
        m_input.surface->D1(middle.X(), middle.Y(), ignored, du, dv);
        for (std::size_t k = 0; k < m_extended.sides.size(); ++k)
        {
            const Side side = m_extended.sides[k].side;
            const ParameterBox &box = m_input.box;
            const double range = in_u(side) ? box.umax - box.umin : box.vmax - box.vmin;
            const double speed = (in_u(side) ? du : dv).Magnitude();
            const double near = std::min(std::max(tolerance / std::max(speed, 1e-300), 1e-9 * range), 1e-3 * range);
            const auto off = [&](const gp_Pnt2d &uv) {
                return std::abs((in_u(side) ? uv.X() : uv.Y()) - side_of(box, side)) > near;
            };
            const bool along = std::none_of(curve.pieces.begin(), curve.pieces.end(), [&](const PcurvePiece &piece) {
                return off({piece.box.umin, piece.box.vmin}) || off({piece.box.umax, piece.box.vmax});
            });
            if (along)
                return k;
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<std::size_t> side_along(const TrimmingLoop &loop, const TopoDS_Edge &edge) const
    {
        for (const TrimmingCurve &curve : loop.curves)
            if (curve.edge.IsSame(edge) && curve.edge.Orientation() == edge.Orientation())
                return side_along(curve);
        return std::nullopt;
    }

    Result<TopoDS_Wire> extended_loop(const TrimmingLoop &loop)
    {
        TopoDS_Wire wire;
        m_builder.MakeWire(wire);
        const bool moves = std::any_of(loop.curves.begin(), loop.curves.end(), [&](const TrimmingCurve &curve) {
            return curve.bounds_face() && side_along(curve).has_value();
        });
        for (const TrimmingCurve &curve : loop.curves)
            if (!moves || !curve.bounds_face())
                m_builder.Add(wire, copy_of(curve.edge));
        if (moves)
            if (const Result<bool> added = add_moved(loop, wire); !added)
                return added.failure();
        wire.Closed(true);
        wire.Orientation(loop.wire.Orientation());
        return wire;
    }

    //! The steps of a loop from one to the next.
    [[nodiscard]] std::vector<LoopStep> steps_of(const TrimmingLoop &loop) const
    {
        std::vector<LoopStep> steps;
        const TopoDS_Wire forward = TopoDS::Wire(loop.wire.Oriented(TopAbs_FORWARD));
        for (BRepTools_WireExplorer it(forward, m_input.face); it.More(); it.Next())
        {
            const TopoDS_Edge edge = it.Current();
            double first = 0.0;
            double last = 0.0;
            const Handle(Geom2d_Curve) pcurve = BRep_Tool::CurveOnSurface(edge, m_input.face, first, last);
            const bool turned = edge.Orientation() == TopAbs_REVERSED;
            steps.push_back({edge, pcurve->Value(turned ? last : first), pcurve->Value(turned ? first : last),
                             side_along(loop, edge)});
        }
        // A run along a side must not begin in the middle of the list.
        const auto begins = [&](std::size_t k) {
            const LoopStep &before = steps[(k + steps.size() - 1) % steps.size()];
            return before.side != steps[k].side || !steps[k].side;
        };
        for (std::size_t k = 0; k < steps.size(); ++k)
            if (begins(k))
            {
                std::rotate(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(k), steps.end());
                break;
            }
        return steps;
    }

    //! Steps along one side as one.
    [[nodiscard]] std::vector<LoopStep> merged(const std::vector<LoopStep> &steps)
    {
        std::vector<LoopStep> runs;
        for (const LoopStep &step : steps)
        {
            if (step.side)
                ++m_extended.sides[*step.side].moved_edges;
            if (step.side && !runs.empty() && runs.back().side == step.side)
                runs.back().end = step.end;
            else
                runs.push_back(step);
        }
        return runs;
    }

    //! The place moved out past the side.
    [[nodiscard]] gp_Pnt2d outer(gp_Pnt2d uv, std::size_t side) const
    {
        const ExtendedSide &moved = m_extended.sides[side];
        in_u(moved.side) ? uv.SetX(moved.parameter) : uv.SetY(moved.parameter);
        return uv;
    }

    [[nodiscard]] gp_Pnt2d on_side(gp_Pnt2d uv, std::size_t side) const
    {
        const Side moved = m_extended.sides[side].side;
        in_u(moved) ? uv.SetX(side_of(m_input.box, moved)) : uv.SetY(side_of(m_input.box, moved));
        return uv;
    }

    Result<bool> add_moved(const TrimmingLoop &loop, TopoDS_Wire &wire)
    {
        const std::vector<LoopStep> steps = steps_of(loop);
        const auto bounding = std::count_if(loop.curves.begin(), loop.curves.end(),
                                            [](const TrimmingCurve &curve) { return curve.bounds_face(); });
        if (static_cast<std::ptrdiff_t>(steps.size()) != bounding)
            return Failure{Status::NotSupported, Stage::Extension,
                           "The edges of a loop cannot be brought into one order around the face; repair the loop.",
                           m_input.place(some_place()), std::nullopt};
        const std::vector<LoopStep> runs = merged(steps);
        for (std::size_t k = 0; k < runs.size(); ++k)
        {
            const LoopStep &run = runs[k];
            if (!run.side)
            {
                m_builder.Add(wire, copy_of(run.edge));
                continue;
            }
            const LoopStep &before = runs[(k + runs.size() - 1) % runs.size()];
            const LoopStep &after = runs[(k + 1) % runs.size()];
            gp_Pnt2d from = outer(run.start, *run.side);
            gp_Pnt2d to = outer(run.end, *run.side);
            if (corner(before, run))
                from = outer(from, *before.side);
            else
                add_line(wire, on_side(run.start, *run.side), from, first_vertex(run));
            if (corner(run, after))
                to = outer(to, *after.side);
            add_line(wire, from, to, {});
            if (!corner(run, after))
                add_line(wire, to, on_side(run.end, *run.side), first_vertex(after));
        }
        return true;
    }

    [[nodiscard]] bool corner(const LoopStep &before, const LoopStep &after) const
    {
        return before.side && after.side &&
               in_u(m_extended.sides[*before.side].side) != in_u(m_extended.sides[*after.side].side);
    }

    [[nodiscard]] static TopoDS_Vertex first_vertex(const LoopStep &step)
    {
        return TopExp::FirstVertex(step.edge, true);
    }

    //! The copy of a vertex of the base.
    TopoDS_Vertex copy_of(const TopoDS_Vertex &vertex)
    {
        const TopoDS_Shape key = vertex.Oriented(TopAbs_FORWARD);
        if (!m_vertex_copies.IsBound(key))
        {
            TopoDS_Vertex copy;
            m_builder.MakeVertex(copy, BRep_Tool::Pnt(vertex), BRep_Tool::Tolerance(vertex));
            m_vertex_copies.Bind(key, copy);
            m_vertices.push_back(copy);
        }
        return TopoDS::Vertex(m_vertex_copies.Find(key));
    }

    //! The copy of an edge of the base with its curves, on the extended surface.
    TopoDS_Edge copy_of(const TopoDS_Edge &edge)
    {
        const TopoDS_Shape key = edge.Oriented(TopAbs_FORWARD);
        if (!m_edge_copies.IsBound(key))
            m_edge_copies.Bind(key, made_copy(TopoDS::Edge(key)));
        return TopoDS::Edge(m_edge_copies.Find(key).Oriented(edge.Orientation()));
    }

    TopoDS_Edge made_copy(const TopoDS_Edge &edge)
    {
        TopoDS_Edge copy;
        double first = 0.0;
        double last = 0.0;
        const double tolerance = BRep_Tool::Tolerance(edge);
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
        if (curve.IsNull())
            m_builder.MakeEdge(copy);
        else
            m_builder.MakeEdge(copy, curve, tolerance);
        m_builder.Degenerated(copy, BRep_Tool::Degenerated(edge));
        const Handle(Geom2d_Curve) pcurve = BRep_Tool::CurveOnSurface(edge, m_input.face, first, last);
        if (BRep_Tool::IsClosed(edge, m_input.face))
        {
            const TopoDS_Edge reversed = TopoDS::Edge(edge.Reversed());
            const Handle(Geom2d_Curve) second = BRep_Tool::CurveOnSurface(reversed, m_input.face, first, last);
            m_builder.UpdateEdge(copy, pcurve, second, m_extended.geometry, TopLoc_Location(), tolerance);
        }
        else
            m_builder.UpdateEdge(copy, pcurve, m_extended.geometry, TopLoc_Location(), tolerance);
        m_builder.Range(copy, first, last);
        m_builder.SameRange(copy, BRep_Tool::SameRange(edge));
        m_builder.SameParameter(copy, BRep_Tool::SameParameter(edge));
        for (TopoDS_Iterator it(edge, false, true); it.More(); it.Next())
            m_builder.Add(copy, copy_of(TopoDS::Vertex(it.Value())).Oriented(it.Value().Orientation()));
        return copy;
    }

    //! The vertex at a point: that of the base if one is given, else one that was made there, else a new one.
    TopoDS_Vertex vertex_at(const gp_Pnt &point, const TopoDS_Vertex &base)
    {
        TopoDS_Vertex vertex;
        if (!base.IsNull())
            vertex = copy_of(base);
        else
            for (const TopoDS_Vertex &known : m_vertices)
                if (BRep_Tool::Pnt(known).Distance(point) <= Precision::Confusion())
                    vertex = known;
        if (vertex.IsNull())
        {
            m_builder.MakeVertex(vertex, point, Precision::Confusion());
            m_vertices.push_back(vertex);
        }
        const double gap = BRep_Tool::Pnt(vertex).Distance(point);
        m_builder.UpdateVertex(vertex, gap + Precision::Confusion());
        return vertex;
    }

    //! A straight step in the parameters along an iso-curve; `base` is the base's vertex at the end that lies on the
    //! old side, if any.
    void add_line(TopoDS_Wire &wire, const gp_Pnt2d &from, const gp_Pnt2d &to, const TopoDS_Vertex &base)
    {
        const bool constant_u = std::abs(to.X() - from.X()) < std::abs(to.Y() - from.Y());
        const bool forward = constant_u ? from.Y() < to.Y() : from.X() < to.X();
        const Line line{forward ? from : to, forward ? to : from, constant_u};
        const TopAbs_Orientation orientation = forward ? TopAbs_FORWARD : TopAbs_REVERSED;
        if (const auto seam = twin(line))
        {
            m_builder.Add(wire, close_seam(*seam, line, orientation));
            return;
        }
        const auto at_start = [&](const gp_Pnt2d &uv) { return in_box(uv) ? base : TopoDS_Vertex(); };
        m_lines.push_back({line, made_line(line, at_start(line.start), at_start(line.end)), orientation});
        m_builder.Add(wire, m_lines.back().edge.Oriented(orientation));
    }

    struct Line
    {
        gp_Pnt2d start; //!< with the smaller running parameter
        gp_Pnt2d end;
        bool constant_u = false;
    };

    struct MadeLine
    {
        Line line;
        TopoDS_Edge edge;
        TopAbs_Orientation orientation;
    };

    //! Is the place on the old face's rectangle?
    [[nodiscard]] bool in_box(const gp_Pnt2d &uv) const
    {
        const ParameterBox &box = m_input.box;
        return uv.X() >= box.umin && uv.X() <= box.umax && uv.Y() >= box.vmin && uv.Y() <= box.vmax;
    }

    [[nodiscard]] static Handle(Geom2d_Curve) pcurve_of(const Line &line)
    {
        const gp_Pnt2d origin = line.constant_u ? gp_Pnt2d(line.start.X(), 0.0) : gp_Pnt2d(0.0, line.start.Y());
        return new Geom2d_Line(origin, line.constant_u ? gp_Dir2d(0.0, 1.0) : gp_Dir2d(1.0, 0.0));
    }

    [[nodiscard]] static double running(const Line &line, const gp_Pnt2d &uv)
    {
        return line.constant_u ? uv.Y() : uv.X();
    }

    TopoDS_Edge made_line(const Line &line, const TopoDS_Vertex &base_start, const TopoDS_Vertex &base_end)
    {
        const Handle(Geom_Curve) curve =
            line.constant_u ? m_extended.geometry->UIso(line.start.X()) : m_extended.geometry->VIso(line.start.Y());
        TopoDS_Edge edge;
        m_builder.MakeEdge(edge, curve, Precision::Confusion());
        m_builder.UpdateEdge(edge, pcurve_of(line), m_extended.geometry, TopLoc_Location(), Precision::Confusion());
        m_builder.Range(edge, running(line, line.start), running(line, line.end));
        m_builder.SameRange(edge, true);
        m_builder.SameParameter(edge, true);
        m_builder.Add(edge, vertex_at(point(line.start), base_start).Oriented(TopAbs_FORWARD));
        m_builder.Add(edge, vertex_at(point(line.end), base_end).Oriented(TopAbs_REVERSED));
        return edge;
    }

    //! A line made before that shows the same curve from the other side of a closed surface.
    [[nodiscard]] std::optional<std::size_t> twin(const Line &line) const
    {
        for (std::size_t k = 0; k < m_lines.size(); ++k)
        {
            const Line &other = m_lines[k].line;
            if (other.constant_u == line.constant_u && near(other.start, line.start) && near(other.end, line.end) &&
                near(gp_Pnt2d(0.5 * (other.start.XY() + other.end.XY())),
                     gp_Pnt2d(0.5 * (line.start.XY() + line.end.XY()))))
                return k;
        }
        return std::nullopt;
    }

    [[nodiscard]] bool near(const gp_Pnt2d &a, const gp_Pnt2d &b) const
    {
        return point(a).Distance(point(b)) <= std::max(2.0 * m_input.tolerance, Precision::Confusion());
    }

    //! The seam edge with its second curve; the first is that of its FORWARD use.
    TopoDS_Edge close_seam(std::size_t index, const Line &line, TopAbs_Orientation orientation)
    {
        const MadeLine &made = m_lines[index];
        const bool first_forward = made.orientation == TopAbs_FORWARD;
        const Handle(Geom2d_Curve) own = pcurve_of(made.line);
        const Handle(Geom2d_Curve) second = pcurve_of(line);
        const double gap = std::max(point(made.line.start).Distance(point(line.start)),
                                    point(made.line.end).Distance(point(line.end)));
        m_builder.UpdateEdge(made.edge, first_forward ? own : second, first_forward ? second : own, m_extended.geometry,
                             TopLoc_Location(), gap + Precision::Confusion());
        return TopoDS::Edge(made.edge.Oriented(orientation));
    }

    const InputFace &m_input;
    ExtendedSurface &m_extended;
    BRep_Builder m_builder;
    TopoDS_Face m_face;
    TopTools_DataMapOfShapeShape m_vertex_copies;
    TopTools_DataMapOfShapeShape m_edge_copies;
    std::vector<TopoDS_Vertex> m_vertices;
    std::vector<MadeLine> m_lines;
};

} // namespace

Result<TopoDS_Face> build_extended_face(const InputFace &input, ExtendedSurface &extended)
{
    return ExtendedFaceBuilder(input, extended).build();
}

} // namespace laminate_offset
