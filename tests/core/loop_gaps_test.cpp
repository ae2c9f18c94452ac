// SPDX-License-Identifier: LGPL-2.1-or-later
// Which curve of a loop follows which, and what becomes of the gaps between them.
#include "support/random_cases.h"

#include <laminate_offset/analysis/loop_region.h>
#include <laminate_offset/evaluate_face.h>
#include <laminate_offset/extend_face.h>
#include <laminate_offset/face_integrals.h>
#include <laminate_offset/input/loop_gaps.h>
#include <laminate_offset/nearest_point.h>
#include <laminate_offset/offset_face.h>
#include <laminate_offset/offset_limits.h>
#include <laminate_offset/offset_stack.h>
#include <laminate_offset/ply_stack.h>
#include <laminate_offset/project_curve.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

using namespace laminate_offset;
using test_support::RandomCases;

namespace
{

//! A plane face inside a polygon.
TopoDS_Face polygon_face(const std::vector<gp_Pnt> &corners)
{
    BRepBuilderAPI_MakePolygon polygon;
    for (const gp_Pnt &corner : corners)
        polygon.Add(corner);
    polygon.Close();
    return BRepBuilderAPI_MakeFace(gp_Pln(), polygon.Wire());
}

std::vector<CurveEnds> ends_of(const TrimmingLoop &loop)
{
    std::vector<CurveEnds> ends;
    for (const TrimmingCurve &curve : loop.curves)
    {
        const bool reversed = curve.edge.Orientation() == TopAbs_REVERSED;
        ends.push_back({curve.pcurve->Value(reversed ? curve.last : curve.first),
                        curve.pcurve->Value(reversed ? curve.first : curve.last)});
    }
    return ends;
}

//! The same curves, as if none of them shared a vertex.
TrimmingLoop without_vertices(TrimmingLoop loop)
{
    for (TrimmingCurve &curve : loop.curves)
        curve.edge = BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0));
    return loop;
}

//! A curve of the surface over a line of its parameters, between two vertices.
TopoDS_Edge edge_on(const Handle(Geom_Surface) & surface, const gp_Pnt2d &from, const gp_Pnt2d &to,
                    const Handle(Geom_Curve) & curve, const TopoDS_Vertex &first, const TopoDS_Vertex &last)
{
    const gp_Vec2d way(from, to);
    const BRep_Builder builder;
    TopoDS_Edge edge;
    builder.MakeEdge(edge, curve, 1e-7);
    builder.UpdateEdge(edge, new Geom2d_Line(from, gp_Dir2d(way)), surface, TopLoc_Location(), 1e-7);
    builder.Add(edge, TopoDS::Vertex(first.Oriented(TopAbs_FORWARD)));
    builder.Add(edge, TopoDS::Vertex(last.Oriented(TopAbs_REVERSED)));
    builder.Range(edge, 0.0, way.Magnitude());
    return edge;
}

TopoDS_Face face_of(const Handle(Geom_Surface) & surface, const std::vector<std::vector<TopoDS_Edge>> &loops)
{
    const BRep_Builder builder;
    TopoDS_Face face;
    builder.MakeFace(face, surface, 1e-7);
    for (const std::vector<TopoDS_Edge> &loop : loops)
    {
        TopoDS_Wire wire;
        builder.MakeWire(wire);
        for (const TopoDS_Edge &edge : loop)
            builder.Add(wire, edge);
        builder.Add(face, wire);
    }
    return face;
}

TopoDS_Vertex vertex_at(const gp_Pnt &p)
{
    const BRep_Builder builder;
    TopoDS_Vertex vertex;
    builder.MakeVertex(vertex, p, 1e-7);
    return vertex;
}

//! A whole turn of a cylinder, bounded by two circles, and by its seam where there is one.
TopoDS_Face tube(const Handle(Geom_Surface) & cylinder, double radius, double u_end, bool with_seam)
{
    constexpr double height = 30.0;
    const TopoDS_Vertex ends[] = {vertex_at(gp_Pnt(radius, 0, 0)), vertex_at(gp_Pnt(radius, 0, height))};
    std::vector<TopoDS_Edge> circles;
    for (const int top : {0, 1})
    {
        const double v = top * height;
        const gp_Ax2 axes(gp_Pnt(0, 0, v), gp_Dir(0, 0, 1), gp_Dir(1, 0, 0));
        const TopoDS_Edge edge =
            edge_on(cylinder, {0, v}, {u_end, v}, new Geom_Circle(axes, radius), ends[top], ends[top]);
        circles.push_back(top == 1 ? TopoDS::Edge(edge.Reversed()) : edge);
    }
    if (!with_seam)
        return face_of(cylinder, {{circles[0]}, {circles[1]}});
    const Handle(Geom_Curve) line = new Geom_Line(gp_Pnt(radius, 0, 0), gp_Dir(0, 0, 1));
    TopoDS_Edge seam = edge_on(cylinder, {0, 0}, {0, height}, line, ends[0], ends[1]);
    BRep_Builder().UpdateEdge(seam, new Geom2d_Line({u_end, 0}, gp_Dir2d(0, 1)),
                              new Geom2d_Line({0, 0}, gp_Dir2d(0, 1)), cylinder, TopLoc_Location(), 1e-7);
    return face_of(cylinder, {{circles[0], seam, circles[1], TopoDS::Edge(seam.Reversed())}});
}

//! What every way into the engine says of a face, by name; no failure where it is taken.
std::map<std::string, std::optional<Failure>> answers(const TopoDS_Face &face)
{
    std::map<std::string, std::optional<Failure>> result;
    const auto note = [&](const char *name, const auto &answer) {
        result[name] = answer ? std::nullopt : std::optional<Failure>(answer.failure());
    };
    const std::vector<gp_Pnt> points{gp_Pnt(25, 1, 10)};
    const std::vector<gp_Pnt2d> places{gp_Pnt2d(1, 10)};
    OffsetOptions options;
    options.distance = 1.0;
    ExtensionOptions extension;
    extension.length = 5.0;
    extension.sides = {Side::VMin, Side::VMax};
    note("limits", offset_limits(face));
    note("nearest", nearest_points(face, points));
    note("nearest trimmed", nearest_points(face, points, true));
    note("evaluate", evaluate_face(face, places));
    note("curvatures", face_curvatures(face, places));
    note("project", project_curve(face, BRepBuilderAPI_MakeEdge(gp_Pnt(21, -3, 10), gp_Pnt(21, 3, 20)).Edge()));
    note("extend", extend_face(face, extension));
    note("integrals", face_integrals(face));
    note("offset", offset_face(face, options));
    options.method = Method::RaviKumar;
    note("offset by the paper", offset_face(face, options));
    options.method = Method::SameParameter;
    note("stack", offset_stack(face, {0.5, 1.0}, options));
    note("plies", stack_plies(face, {{0.25, {}}, {0.25, {}}}, {}, {}));
    return result;
}

//! An eighth of a sphere that runs into its pole without a degenerated edge.
TopoDS_Face octant_without_edge_at_pole(double radius, bool exchanged)
{
    const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(gp_Ax3(), radius);
    const Handle(Geom_BSplineSurface) part =
        GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(sphere, 0.0, M_PI_2, 0.0, M_PI_2));
    if (exchanged)
        part->ExchangeUV();
    double u0, u1, v0, v1;
    part->Bounds(u0, u1, v0, v1);
    const auto at = [&](double along, double up) { // `up` towards the pole
        return exchanged ? gp_Pnt2d(u0 + up * (u1 - u0), v0 + along * (v1 - v0))
                         : gp_Pnt2d(u0 + along * (u1 - u0), v0 + up * (v1 - v0));
    };
    const auto vertex = [&](const gp_Pnt2d &uv) { return vertex_at(part->Value(uv.X(), uv.Y())); };
    const auto meridian = [&](double along) {
        return exchanged ? part->VIso(at(along, 0).Y()) : part->UIso(at(along, 0).X());
    };
    const Handle(Geom_Curve) equator = exchanged ? part->UIso(u0) : part->VIso(v0);
    const TopoDS_Vertex a = vertex(at(0, 0)), b = vertex(at(1, 0)), pole = vertex(at(0, 1));
    std::vector<TopoDS_Edge> loop{edge_on(part, at(0, 0), at(1, 0), equator, a, b),
                                  edge_on(part, at(1, 0), at(1, 1), meridian(1), b, pole),
                                  TopoDS::Edge(edge_on(part, at(0, 0), at(0, 1), meridian(0), a, pole).Reversed())};
    for (TopoDS_Edge &edge : loop)
        if (exchanged) // anticlockwise again
            edge = TopoDS::Edge(edge.Reversed());
    return face_of(part, {loop});
}

} // namespace

//! Boxes from flat to slender, gaps up to half of what counts as a jump, in any order of the edges, with vertices and without.
TEST(LoopGaps, EveryCurveIsFollowedByItsNeighbour)
{
    RandomCases random;
    for (int round = 0; round < 60; ++round)
    {
        SCOPED_TRACE(round);
        const int count = random.integer(3, 12);
        std::vector<gp_Pnt> corners;
        for (int i = 0; i < count; ++i)
        {
            const double angle = 2.0 * M_PI * i / count;
            const double radius = random.uniform(0.6, 1.0);
            corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
        }
        InputFace input = read_face(polygon_face(corners)).value();
        TrimmingLoop loop = input.loops.front();
        std::vector<CurveEnds> ends = ends_of(loop);
        std::vector<std::size_t> next(ends.size());
        for (std::size_t i = 0; i < ends.size(); ++i)
            for (std::size_t k = 0; k < ends.size(); ++k)
                if (ends[i].end.Distance(ends[k].start) < 1e-9)
                    next[i] = k;
        const double stretch = random.magnitude(1e-6, 1e6);
        input.box.vmin *= stretch;
        input.box.vmax *= stretch;
        const auto moved = [&](const gp_Pnt2d &p) {
            const double width = 2.5e-4 * 1.2;
            return gp_Pnt2d(p.X() + random.uniform(-width, width), stretch * (p.Y() + random.uniform(-width, width)));
        };
        for (CurveEnds &pair : ends)
            pair = {moved(pair.start), moved(pair.end)};
        for (const TrimmingLoop &tried : {loop, without_vertices(loop)})
        {
            const std::vector<LoopGap> gaps = loop_gaps(input, tried, ends);
            ASSERT_EQ(gaps.size(), ends.size());
            for (std::size_t i = 0; i < gaps.size(); ++i)
            {
                EXPECT_EQ(gaps[i].from.Distance(ends[i].end), 0.0);
                EXPECT_EQ(gaps[i].to.Distance(ends[next[i]].start), 0.0) << i;
                EXPECT_FALSE(gaps[i].jump);
            }
        }
    }
}

//! Edges shorter than the gap beside them: the nearest start may be one's own.
TEST(LoopGaps, VerticesDecideBesideShortEdges)
{
    const InputFace input = read_face(polygon_face({{0, 0, 0}, {1, 0, 0}, {1, 1e-4, 0}, {1, 1, 0}, {0, 1, 0}})).value();
    const TrimmingLoop &loop = input.loops.front();
    std::vector<CurveEnds> ends = ends_of(loop);
    std::size_t checked = 0;
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (ends[i].start.Distance(ends[i].end) < 1e-3)
        {
            const CurveEnds whole = ends[i];
            ends[i].end.SetY(whole.end.Y() - 0.9e-4); // its own start is nearer than the next edge's
            const std::vector<LoopGap> gaps = loop_gaps(input, loop, ends);
            EXPECT_LT(gaps[i].to.Distance(whole.end), 1e-9);
            ++checked;
        }
    EXPECT_EQ(checked, 1u);
}

TEST(LoopGaps, SidesOfASeamStayApart)
{
    const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), 20.0);
    const InputFace input = read_face(BRepBuilderAPI_MakeFace(cylinder, 0, 2 * M_PI, 0, 30, 1e-7).Face()).value();
    RandomCases random;
    for (const TrimmingLoop &loop : input.loops)
    {
        std::vector<CurveEnds> ends = ends_of(loop);
        ASSERT_EQ(ends.size(), 4u);
        for (CurveEnds &pair : ends)
            for (gp_Pnt2d *p : {&pair.start, &pair.end})
                p->Translate(gp_Vec2d(random.uniform(-1e-4, 1e-4), random.uniform(-1e-3, 1e-3)));
        for (const LoopGap &gap : loop_gaps(input, loop, ends))
        {
            EXPECT_LE(gap.from.Distance(gap.to), 3e-3);
            EXPECT_FALSE(gap.jump);
        }
    }
}

TEST(LoopGaps, AMissingSeamIsAJump)
{
    const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), 20.0);
    const InputFace input = read_face(tube(cylinder, 20.0, 2 * M_PI, true)).value();
    const TrimmingLoop &loop = input.loops.front();
    ASSERT_EQ(loop.curves.size(), 4u);
    int checked = 0;
    for (const TrimmingCurve &curve : loop.curves)
    {
        const TrimmingLoop alone{loop.wire, {curve}};
        const std::vector<LoopGap> gaps = loop_gaps(input, alone, curve_ends(alone));
        ASSERT_EQ(gaps.size(), 1u);
        EXPECT_TRUE(gaps.front().jump);
        ++checked;
    }
    EXPECT_EQ(checked, 4);
}

//! The same text and place from every way in; with the seam, every one takes the face.
TEST(LoopGaps, AMissingSeamIsRefusedEverywhere)
{
    constexpr double radius = 20.0;
    const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), radius);
    for (const bool turned : {false, true})
    {
        SCOPED_TRACE(turned);
        const auto placed = [&](const TopoDS_Face &face) { return turned ? TopoDS::Face(face.Reversed()) : face; };
        for (const auto &[name, failure] : answers(placed(tube(cylinder, radius, 2 * M_PI, true))))
            EXPECT_FALSE(failure) << name << ": " << failure->message;
        const auto refused = answers(placed(tube(cylinder, radius, 2 * M_PI, false)));
        EXPECT_EQ(refused.size(), 12u);
        for (const auto &[name, failure] : refused)
        {
            ASSERT_TRUE(failure) << name;
            EXPECT_EQ(failure->status, Status::InvalidFace) << name;
            EXPECT_EQ(failure->stage, Stage::Input) << name;
            EXPECT_NE(failure->message.find("seam edge is missing"), std::string::npos) << name;
            ASSERT_TRUE(failure->where) << name;
            EXPECT_LT(failure->where->point.Distance(gp_Pnt(radius, 0, 0)), 1e-6) << name;
        }
    }
}

//! Widths that are no numbers leave every curve with a follower.
TEST(LoopGaps, WidthsThatAreNoNumbersAreJumps)
{
    InputFace input = read_face(polygon_face({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})).value();
    const TrimmingLoop &loop = input.loops.front();
    const std::vector<CurveEnds> ends = curve_ends(loop);
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 0.0})
    {
        input.box = {bad, bad, bad, bad};
        for (const bool by_vertex : {true, false})
        {
            const std::vector<LoopGap> gaps = loop_gaps(input, by_vertex ? loop : without_vertices(loop), ends);
            ASSERT_EQ(gaps.size(), ends.size());
            std::vector<gp_Pnt2d> starts;
            for (const LoopGap &gap : gaps)
            {
                for (const gp_Pnt2d &before : starts)
                    EXPECT_GT(before.Distance(gap.to), 0.5); // each start once
                starts.push_back(gap.to);
            }
            // vertices still find the right starts, which coincide; any other pair does not
            const bool jumps = std::any_of(gaps.begin(), gaps.end(), [](const LoopGap &gap) { return gap.jump; });
            EXPECT_EQ(jumps, !by_vertex);
        }
    }
}

//! The straight line along a pole closes a loop, however wide; integrals and the inside agree on it.
TEST(LoopGaps, APoleIsNoJump)
{
    constexpr double radius = 30.0;
    RandomCases random;
    for (const bool exchanged : {false, true})
    {
        SCOPED_TRACE(exchanged);
        const TopoDS_Face face = octant_without_edge_at_pole(radius, exchanged);
        const Result<InputFace> input = read_face(face);
        ASSERT_TRUE(input.ok()) << input.failure().message;
        const TrimmingLoop &loop = input.value().loops.front();
        int wide = 0;
        for (const LoopGap &gap : loop_gaps(input.value(), loop, ends_of(loop)))
        {
            EXPECT_FALSE(gap.jump);
            wide += gap.from.Distance(gap.to) > 0.5 ? 1 : 0;
        }
        EXPECT_EQ(wide, 1);
        const LoopRegion region(input.value());
        const ParameterBox &box = input.value().box;
        for (int i = 0; i < 200; ++i)
        {
            const double x = random.uniform(-0.5, 1.5);
            const double y = random.uniform(-0.5, 1.5);
            const bool inside = x > 0.0 && x < 1.0 && y > 0.0 && y < 1.0;
            EXPECT_EQ(region.contains({box.umin + x * (box.umax - box.umin), box.vmin + y * (box.vmax - box.vmin)}),
                      inside)
                << x << ' ' << y;
        }
        const auto integrals = face_integrals(face);
        ASSERT_TRUE(integrals.ok()) << integrals.failure().message;
        EXPECT_NEAR(integrals.value().area, M_PI_2 * radius * radius, 1e-6 * radius * radius);
    }
}
