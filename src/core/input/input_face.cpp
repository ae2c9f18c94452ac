// SPDX-License-Identifier: LGPL-2.1-or-later
#include "input_face.h"

#include "loop_gaps.h"
#include "pcurve_pieces.h"

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

constexpr const char *not_finite =
    "The face holds coordinates that are not finite numbers; import the model again or rebuild the face.";

Failure refusal(Status status, std::string message)
{
    return {status, Stage::Input, std::move(message), std::nullopt, std::nullopt};
}

Failure refusal_at(Status status, std::string message, const InputFace &input, const gp_Pnt2d &uv)
{
    return {status, Stage::Input, std::move(message), input.place(uv), std::nullopt};
}

const char *kind_name(TopAbs_ShapeEnum kind)
{
    switch (kind)
    {
    case TopAbs_COMPOUND: return "compound";
    case TopAbs_COMPSOLID: return "compsolid";
    case TopAbs_SOLID: return "solid";
    case TopAbs_SHELL: return "shell";
    case TopAbs_WIRE: return "wire";
    case TopAbs_EDGE: return "edge";
    case TopAbs_VERTEX: return "vertex";
    default: return "shape";
    }
}

//! The face in local coordinates. A location that scales is baked in, because pcurves on analytic
//! surfaces do not survive scaling unchanged.
TopoDS_Face localised(const TopoDS_Face &face, InputFace &input)
{
    input.location = face.Location();
    const gp_Trsf transformation = input.location.Transformation();
    TopoDS_Face local = TopoDS::Face(face.Located(TopLoc_Location()));
    if (std::abs(std::abs(transformation.ScaleFactor()) - 1.0) > 1e-12)
    {
        input.location = TopLoc_Location();
        local = TopoDS::Face(BRepBuilderAPI_Transform(local, transformation, true).Shape());
    }
    return local;
}

//! An offset of an offset stands off the same basis, by the sum of both distances.
void unwrap(InputFace &input)
{
    while (true)
        if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(input.surface))
            input.surface = trimmed->BasisSurface();
        else if (const auto offset = Handle(Geom_OffsetSurface)::DownCast(input.surface))
        {
            input.base_distance += offset->Offset();
            input.surface = offset->BasisSurface();
        }
        else
            return;
}

//! S_u x S_v scaled to length 1; nothing at a singular place.
std::optional<gp_Vec> normal_at(const InputFace &input, const gp_Pnt2d &uv)
{
    gp_Pnt s;
    gp_Vec du, dv;
    input.surface->D1(uv.X(), uv.Y(), s, du, dv);
    const gp_Vec normal = du.Crossed(dv);
    constexpr double smallest_sine = 1e-9;
    if (!(normal.Magnitude() > smallest_sine * du.Magnitude() * dv.Magnitude()))
        return std::nullopt;
    return normal / normal.Magnitude();
}

bool finite(const gp_Pnt2d &p) { return std::isfinite(p.X()) && std::isfinite(p.Y()); }
bool finite(const gp_Pnt &p) { return std::isfinite(p.X()) && std::isfinite(p.Y()) && std::isfinite(p.Z()); }

bool finite(const TColgp_Array2OfPnt &poles)
{
    for (int i = poles.LowerRow(); i <= poles.UpperRow(); ++i)
        for (int j = poles.LowerCol(); j <= poles.UpperCol(); ++j)
            if (!finite(poles(i, j)))
                return false;
    return true;
}

//! Are all poles of a spline numbers? One of them spoils only the part around it, which probes may miss.
bool finite_poles(const Handle(Geom_Surface) & surface)
{
    if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface))
        return finite(spline->Poles());
    if (const auto bezier = Handle(Geom_BezierSurface)::DownCast(surface))
        return finite(bezier->Poles());
    return true;
}

Result<TrimmingCurve> read_curve(const TopoDS_Edge &edge, const InputFace &input)
{
    TrimmingCurve curve;
    curve.edge = edge;
    curve.pcurve = BRep_Tool::CurveOnSurface(edge, input.face, curve.first, curve.last);
    if (curve.pcurve.IsNull())
        return refusal(Status::InvalidFace, "An edge of the face has no curve in the surface's parameters; "
                                            "repair the face so that every edge lies on it.");
    if (Precision::IsInfinite(curve.first) || Precision::IsInfinite(curve.last))
        return refusal(Status::UnboundedFace,
                       "An edge of the face has no end; trim the surface to a finite face first.");
    if (!(curve.first < curve.last))
        return refusal(Status::InvalidFace, "An edge of the face has an empty parameter range; repair the face.");
    curve.degenerated = BRep_Tool::Degenerated(edge);
    curve.seam = BRep_Tool::IsClosed(edge, input.face);
    constexpr int probes = 8;
    for (int i = 0; i <= probes; ++i)
    {
        const gp_Pnt2d uv = curve.pcurve->Value(curve.first + (curve.last - curve.first) * i / probes);
        if (!finite(uv) || !finite(input.point(uv)))
            return refusal(Status::NotFinite, not_finite);
    }
    return curve;
}

gp_Pnt2d end_point(const TrimmingCurve &curve, bool at_end)
{
    const bool forward = curve.edge.Orientation() != TopAbs_REVERSED;
    return curve.pcurve->Value(at_end == forward ? curve.last : curve.first);
}

//! Do two curves meet in a vertex of both?
bool share_vertex(const TrimmingCurve &before, const TrimmingCurve &after)
{
    const TopoDS_Vertex end = TopExp::LastVertex(before.edge, true);
    const TopoDS_Vertex start = TopExp::FirstVertex(after.edge, true);
    return !end.IsNull() && !start.IsNull() && end.IsSame(start);
}

//! Do two ends meet within the vertices' tolerances? Costs two points of the surface.
bool ends_meet(const TrimmingCurve &before, const TrimmingCurve &after, const InputFace &input)
{
    const gp_Pnt2d a = end_point(before, true);
    const gp_Pnt2d b = end_point(after, false);
    const double tolerance = std::max(input.tolerance, Precision::Confusion());
    return input.point(a).Distance(input.point(b)) <= 2.0 * tolerance;
}

//! Every vertex of a closed wire ends as many curves as it starts, whatever the order of its edges.
Result<bool> check_closed(const TrimmingLoop &loop, const InputFace &input)
{
    const auto starts_here = [&](const TrimmingCurve &before) {
        const auto any = [&](const auto &joined) {
            return std::any_of(loop.curves.begin(), loop.curves.end(), joined);
        };
        return any([&](const TrimmingCurve &after) { return share_vertex(before, after); }) ||
               any([&](const TrimmingCurve &after) { return ends_meet(before, after, input); });
    };
    for (const TrimmingCurve &curve : loop.curves)
        if (curve.bounds_face() && !starts_here(curve))
            return refusal_at(Status::OpenLoop,
                              "A trimming loop does not close: a gap follows the edge that ends at the reported place. "
                              "Close the loop or heal the face.",
                              input, end_point(curve, true));
    return true;
}

Result<TrimmingLoop> read_loop(const TopoDS_Wire &wire, const InputFace &input)
{
    TrimmingLoop loop;
    loop.wire = wire;
    for (TopoDS_Iterator it(wire); it.More(); it.Next())
    {
        Result<TrimmingCurve> curve = read_curve(TopoDS::Edge(it.Value()), input);
        if (!curve)
            return curve.failure();
        loop.curves.push_back(std::move(curve).value());
    }
    if (loop.curves.empty())
        return refusal(Status::InvalidFace, "A trimming loop of the face has no edge; repair the face.");
    if (const Result<bool> closed = check_closed(loop, input); !closed)
        return closed.failure();
    return loop;
}

ParameterBox box_of(const std::vector<PcurvePiece> &pieces)
{
    ParameterBox box = pieces.front().box;
    for (const PcurvePiece &piece : pieces)
        box = {std::min(box.umin, piece.box.umin), std::max(box.umax, piece.box.umax),
               std::min(box.vmin, piece.box.vmin), std::max(box.vmax, piece.box.vmax)};
    return box;
}

double signed_area(const std::vector<TrimmingLoop> &loops)
{
    double area = 0.0;
    for (const TrimmingLoop &loop : loops)
        for (const TrimmingCurve &curve : loop.curves)
        {
            if (!curve.bounds_face())
                continue;
            double part = 0.0;
            for (const PcurvePiece &piece : curve.pieces)
                part += 0.5 * piece.start.XY().Crossed(piece.end.XY());
            area += curve.edge.Orientation() == TopAbs_REVERSED ? -part : part;
        }
    return area;
}

double largest_tolerance(const TopoDS_Face &face)
{
    double tolerance = 0.0;
    TopTools_IndexedMapOfShape shapes;
    TopExp::MapShapes(face, TopAbs_EDGE, shapes);
    for (int i = 1; i <= shapes.Extent(); ++i)
        tolerance = std::max(tolerance, BRep_Tool::Tolerance(TopoDS::Edge(shapes(i))));
    shapes.Clear();
    TopExp::MapShapes(face, TopAbs_VERTEX, shapes);
    for (int i = 1; i <= shapes.Extent(); ++i)
        tolerance = std::max(tolerance, BRep_Tool::Tolerance(TopoDS::Vertex(shapes(i))));
    return tolerance;
}

//! Diagonal of the box of points on the loops and on a grid between them.
double extent_of(const InputFace &input, const std::vector<PcurvePiece> &pieces)
{
    constexpr std::size_t enough_pieces = 200;
    Bnd_Box space;
    for (std::size_t i = 0; i < pieces.size(); i += 1 + pieces.size() / enough_pieces)
    {
        const PcurvePiece &piece = pieces[i];
        space.Add(input.point(piece.start));
        space.Add(input.point(gp_Pnt2d(0.5 * (piece.start.XY() + piece.end.XY()))));
    }
    constexpr int grid = 4;
    const ParameterBox &box = input.box;
    for (int i = 1; i < grid; ++i)
        for (int j = 1; j < grid; ++j)
            space.Add(input.point(
                {box.umin + (box.umax - box.umin) * i / grid, box.vmin + (box.vmax - box.vmin) * j / grid}));
    return std::sqrt(space.SquareExtent());
}

Result<bool> measure(InputFace &input)
{
    std::vector<PcurvePiece> pieces;
    for (TrimmingLoop &loop : input.loops)
        for (TrimmingCurve &curve : loop.curves)
        {
            curve.pieces = cut_up(curve.pcurve, curve.first, curve.last);
            pieces.insert(pieces.end(), curve.pieces.begin(), curve.pieces.end());
        }
    input.box = box_of(pieces);
    input.diagonal = extent_of(input, pieces);
    if (!std::isfinite(input.diagonal))
        return refusal(Status::NotFinite, "The face's extent is not a finite number; import the model again.");
    const double rectangle = (input.box.umax - input.box.umin) * (input.box.vmax - input.box.vmin);
    // A loop that runs along a line and back encloses nothing; a sliver of a real face encloses far more than this.
    if (!(rectangle > 0.0) || std::abs(signed_area(input.loops)) <= 1e-9 * rectangle)
        return refusal(Status::ZeroArea,
                       "The trimming loops enclose no area; remove the degenerate face or repair its loops.");
    return true;
}

//! A loop may hang together in space and yet not enclose anything in the parameters.
Result<bool> check_closed_in_parameters(const InputFace &input)
{
    for (const TrimmingLoop &loop : input.loops)
        for (const LoopGap &gap : loop_gaps(input, loop, curve_ends(loop)))
            if (gap.jump)
                return refusal_at(Status::InvalidFace,
                                  "A trimming loop does not close in the surface's parameters, as when a seam edge is "
                                  "missing; repair the face.",
                                  input, gap.from);
    return true;
}

//! One direction of the loops' box on a periodic spline. The box holds control points: where it is wider than a period, the
//! loops themselves need not be. They may overlap by what their ends miss each other.
//! \return false where they go round more than once.
bool limit_to_one_turn(const std::vector<TrimmingLoop> &loops, bool in_u, double period, double &low, double &high)
{
    constexpr double most_overlap = 1e-5; // part of a period
    if (high - low <= period)
        return true;
    double least = high, most = low;
    for (const TrimmingLoop &loop : loops)
        for (const TrimmingCurve &curve : loop.curves)
            for (const PcurvePiece &piece : curve.pieces)
            {
                const double at = in_u ? piece.start.X() : piece.start.Y();
                least = std::min(least, at);
                most = std::max(most, at);
            }
    low = least;
    high = most;
    return high - low <= period * (1.0 + most_overlap);
}

Result<bool> check_turns(InputFace &input)
{
    const auto spline = Handle(Geom_BSplineSurface)::DownCast(input.surface);
    if (spline.IsNull())
        return true;
    double u0, u1, v0, v1;
    spline->Bounds(u0, u1, v0, v1);
    ParameterBox &box = input.box;
    if ((!spline->IsUPeriodic() || limit_to_one_turn(input.loops, true, u1 - u0, box.umin, box.umax)) &&
        (!spline->IsVPeriodic() || limit_to_one_turn(input.loops, false, v1 - v0, box.vmin, box.vmax)))
        return true;
    return refusal_at(Status::InvalidFace,
                      "The trimming loops go round the closed surface more than once; repair the face, or split it.",
                      input, {box.umin, box.vmin});
}

//! A swept arc whose loops run beside its ends, as those of an arc over its circle's zero may do by a whole turn: the curve that
//! the arc is a part of has the same parameters, and room for the loops.
void untrim_profile(InputFace &input)
{
    const auto swept = Handle(Geom_SweptSurface)::DownCast(input.surface);
    if (swept.IsNull())
        return;
    double u0, u1, v0, v1;
    swept->Bounds(u0, u1, v0, v1);
    const ParameterBox &box = input.box;
    const bool beside = box.umin < u0 - Precision::PConfusion() || box.umax > u1 + Precision::PConfusion() ||
                        box.vmin < v0 - Precision::PConfusion() || box.vmax > v1 + Precision::PConfusion();
    Handle(Geom_Curve) profile = swept->BasisCurve();
    while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(profile))
        profile = trimmed->BasisCurve();
    if (!beside || profile == swept->BasisCurve())
        return;
    const Handle(Geom_Geometry) whole = swept->Copy();
    if (const auto revolution = Handle(Geom_SurfaceOfRevolution)::DownCast(whole))
        revolution->SetBasisCurve(profile);
    else
        Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(whole)->SetBasisCurve(profile);
    input.surface = Handle(Geom_Surface)::DownCast(whole);
}

Result<InputFace> read_checked(const TopoDS_Face &face)
{
    InputFace input;
    input.reversed = face.Orientation() == TopAbs_REVERSED;
    input.face = TopoDS::Face(localised(face, input).Oriented(TopAbs_FORWARD));
    const bool mirrored = input.location.Transformation().IsNegative();
    input.normal_sign = (input.reversed != mirrored) ? -1.0 : 1.0;
    input.surface = BRep_Tool::Surface(input.face);
    if (input.surface.IsNull())
        return refusal(Status::InvalidFace,
                       "The face has no surface (it may be a mesh); use a face with exact geometry.");
    unwrap(input);
    if (!finite_poles(input.surface) || !std::isfinite(input.base_distance))
        return refusal(Status::NotFinite, not_finite);
    input.tolerance = largest_tolerance(input.face);
    for (TopoDS_Iterator it(input.face); it.More(); it.Next())
    {
        if (it.Value().ShapeType() != TopAbs_WIRE)
            continue;
        Result<TrimmingLoop> loop = read_loop(TopoDS::Wire(it.Value()), input);
        if (!loop)
            return loop.failure();
        input.loops.push_back(std::move(loop).value());
    }
    if (input.loops.empty())
        return refusal(Status::UnboundedFace,
                       "The face has no trimming loop; trim the surface to a finite face first.");
    if (const Result<bool> measured = measure(input); !measured)
        return measured.failure();
    if (const Result<bool> closed = check_closed_in_parameters(input); !closed)
        return closed.failure();
    if (const Result<bool> once = check_turns(input); !once)
        return once.failure();
    untrim_profile(input);
    return input;
}

} // namespace

bool TrimmingCurve::bounds_face() const
{
    return edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED;
}

int InputFace::edge_count() const
{
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(face, TopAbs_EDGE, edges);
    return edges.Extent();
}

gp_Pnt InputFace::point(const gp_Pnt2d &uv) const
{
    const gp_Pnt on_surface = surface->Value(uv.X(), uv.Y());
    if (base_distance == 0.0)
        return on_surface;
    std::optional<gp_Vec> normal = normal_at(*this, uv);
    if (!normal) // a pole: the normal is read beside it, on the side where the face is
    {
        constexpr double step = 1e-6;
        const gp_XY middle(0.5 * (box.umin + box.umax), 0.5 * (box.vmin + box.vmax));
        normal = normal_at(*this, gp_Pnt2d(uv.XY() + step * (middle - uv.XY())));
    }
    return normal ? on_surface.Translated(base_distance * *normal) : on_surface;
}

Where InputFace::place(const gp_Pnt2d &uv) const { return {uv, point(uv).Transformed(location.Transformation())}; }

Result<InputFace> read_face(const TopoDS_Shape &shape)
{
    if (shape.IsNull())
        return refusal(Status::NullShape, "No shape was given; select a face of a recomputed object.");
    if (shape.ShapeType() != TopAbs_FACE)
        return refusal(Status::NotAFace,
                       fmt::format("The shape is a {}, not a face; select one face, or pass its faces "
                                   "one by one.",
                                   kind_name(shape.ShapeType())));
    return read_checked(TopoDS::Face(shape));
}

} // namespace laminate_offset
