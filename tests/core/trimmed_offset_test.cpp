// SPDX-License-Identifier: LGPL-2.1-or-later
// Edge curves, loops and the finished face: exact where they can be, honest where they are not.
#include "support/offset_oracle.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/offset_face.h>
#include <laminate_offset/trimming/edge_curve.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Line.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>

#include <gtest/gtest.h>

#include <cmath>

using namespace laminate_offset;
using namespace test_support;

namespace
{

constexpr double tolerance = 1e-3;

TopoDS_Face face_on(const Handle(Geom_Surface) & surface) { return BRepBuilderAPI_MakeFace(surface, 1e-7); }

//! The face with a round hole cut into it.
TopoDS_Face with_hole(const TopoDS_Face &face, const gp_Pnt2d &centre, double radius)
{
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    const Handle(Geom2d_Curve) circle = new Geom2d_Circle(gp_Ax22d(centre, gp_Dir2d(1, 0), gp_Dir2d(0, -1)), radius);
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(circle, surface);
    BRepLib::BuildCurve3d(edge);
    BRepBuilderAPI_MakeFace maker(face, BRepBuilderAPI_MakeWire(edge).Wire());
    return maker.Face();
}

std::vector<TopoDS_Edge> distinct_edges(const TopoDS_Face &face)
{
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(face, TopAbs_EDGE, map);
    std::vector<TopoDS_Edge> edges;
    for (int i = 1; i <= map.Extent(); ++i)
        edges.push_back(TopoDS::Edge(map(i)));
    return edges;
}

//! Orientations of the face, its wires and their edges as stored.
std::vector<TopAbs_Orientation> orientations(const TopoDS_Face &face)
{
    std::vector<TopAbs_Orientation> all{face.Orientation()};
    for (TopoDS_Iterator wires(face, false); wires.More(); wires.Next())
    {
        all.push_back(wires.Value().Orientation());
        for (TopoDS_Iterator edges(wires.Value(), false); edges.More(); edges.Next())
            all.push_back(edges.Value().Orientation());
    }
    return all;
}

//! How the uses of edges repeat: 0, 1, 0, 2 says that the first and third use are the same edge.
std::vector<int> sharing(const TopoDS_Face &face)
{
    TopTools_IndexedMapOfShape known;
    std::vector<int> uses;
    for (TopoDS_Iterator wires(face); wires.More(); wires.Next())
        for (TopoDS_Iterator edges(wires.Value()); edges.More(); edges.Next())
            uses.push_back(known.Add(edges.Value()));
    return uses;
}

std::vector<int> vertex_sharing(const TopoDS_Face &face)
{
    TopTools_IndexedMapOfShape known;
    std::vector<int> uses;
    for (const TopoDS_Edge &edge : distinct_edges(face))
        for (TopoDS_Iterator ends(edge); ends.More(); ends.Next())
            uses.push_back(known.Add(ends.Value()));
    return uses;
}

//! Every edge keeps to its pcurves and ends in its vertices within the tolerances that are told.
void expect_honest_tolerances(const TopoDS_Face &face)
{
    for (const TopoDS_Edge &edge : distinct_edges(face))
    {
        double first = 0.0, last = 0.0;
        EXPECT_TRUE(BRep_Tool::SameParameter(edge));
        EXPECT_TRUE(BRep_Tool::SameRange(edge));
        EXPECT_LE(BRep_Tool::Tolerance(edge), tolerance);
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
        if (curve.IsNull())
        {
            EXPECT_TRUE(BRep_Tool::Degenerated(edge));
            continue;
        }
        for (const TopoDS_Vertex &end : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
        {
            const double t = BRep_Tool::Parameter(end, edge);
            EXPECT_LE(BRep_Tool::Pnt(end).Distance(curve->Value(t)), BRep_Tool::Tolerance(end));
            EXPECT_LE(BRep_Tool::Tolerance(end), tolerance);
            EXPECT_GE(BRep_Tool::Tolerance(end), BRep_Tool::Tolerance(edge)) << "a vertex covers its edges' ends";
        }
    }
}

//! The whole face is right, and it is the mirror of the base in its topology.
void expect_mirrored(const TopoDS_Face &base, double distance)
{
    SCOPED_TRACE(testing::Message() << "distance " << distance);
    OffsetOptions options;
    options.distance = distance;
    options.tolerance = tolerance;
    const Result<OffsetResult> result = offset_face(base, options);
    ASSERT_TRUE(result.ok()) << name(result.failure().status) << ": " << result.failure().message;
    const TopoDS_Face made = result.value().face();
    const OracleReport report = measure_offset(base, made, distance, {35, 60});
    EXPECT_TRUE(confirms(report, tolerance)) << to_text(report);
    EXPECT_TRUE(BRepCheck_Analyzer(made).IsValid());
    EXPECT_EQ(orientations(made), orientations(base));
    EXPECT_EQ(sharing(made), sharing(base));
    EXPECT_EQ(vertex_sharing(made), vertex_sharing(base));
    EXPECT_TRUE(made.Location().IsEqual(base.Location()));
    EXPECT_FALSE(made.TShape() == base.TShape());
    EXPECT_EQ(result.value().report.loops, report.base_loops);
    EXPECT_EQ(result.value().report.edges, static_cast<int>(distinct_edges(base).size()));
    expect_honest_tolerances(made);
}

CurveOnSurface line_on(const Handle(Geom_Surface) & surface, const gp_Pnt2d &from, const gp_Pnt2d &to)
{
    const gp_Vec2d way(from, to);
    return {surface, new Geom2d_Line(from, gp_Dir2d(way)), 0.0, way.Magnitude()};
}

std::optional<EdgeCurve> curve_on(const CurveOnSurface &c, double accuracy)
{
    const std::optional<AnalyticSurface> form = AnalyticSurface::make(c.surface);
    return edge_curve(EdgeTarget(c, form ? &*form : nullptr), accuracy);
}

int degree_of(const Handle(Geom_Curve) & curve)
{
    const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve);
    return spline.IsNull() ? 0 : spline->Degree();
}

} // namespace

TEST(EdgeCurve, OfAnIsoLineIsTheSurfacesOwnIsoCurve)
{
    RandomCases random;
    for (const bool rational : {false, true})
    {
        const auto surface = random_surface(random, {.degree_u = 4, .degree_v = 3, .rational = rational});
        const std::tuple<gp_Pnt2d, gp_Pnt2d, int> lines[] = {{{0.3, 0.0}, {0.3, 1.0}, 3},
                                                             {{0.0, 0.7}, {1.0, 0.7}, 4},
                                                             {{0.3, 0.9}, {0.3, 0.15}, 3},
                                                             {{0.8, 1.0}, {0.1, 1.0}, 4}};
        for (const auto &[from, to, degree] : lines)
        {
            const CurveOnSurface c = line_on(surface, from, to);
            const auto edge = curve_on(c, 1e-3);
            ASSERT_TRUE(edge.has_value());
            EXPECT_EQ(degree_of(edge->curve), degree) << "taken from the surface, not fitted";
            EXPECT_LE(edge->deviation.bound, rational ? 1e-6 : 1e-9) << "rounding, and a remainder where rational";
            EXPECT_TRUE(edge->deviation.proven);
            EXPECT_NEAR(edge->curve->FirstParameter(), c.first, 1e-12);
            EXPECT_NEAR(edge->curve->LastParameter(), c.last, 1e-12);
            EXPECT_LE(largest_distance(edge->curve, c), 1e-11) << "same parameters";
        }
    }
}

TEST(EdgeCurve, OnAnalyticSurfacesIsALineOrACircle)
{
    const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), 10.0);
    const auto straight = curve_on(line_on(cylinder, {0.5, -3.0}, {0.5, 8.0}), 1e-3);
    ASSERT_TRUE(straight.has_value());
    EXPECT_FALSE(Handle(Geom_Line)::DownCast(straight->curve).IsNull()) << straight->curve->DynamicType()->Name();
    const auto round = curve_on(line_on(cylinder, {0.5, 2.0}, {2.5, 2.0}), 1e-3);
    ASSERT_TRUE(round.has_value());
    EXPECT_FALSE(Handle(Geom_Circle)::DownCast(round->curve).IsNull()) << round->curve->DynamicType()->Name();
    EXPECT_LE(straight->deviation.bound + round->deviation.bound, 1e-6);
    EXPECT_TRUE(straight->deviation.proven && round->deviation.proven);
}

TEST(EdgeCurve, AcrossTheKnotsIsFittedWithinTheTolerance)
{
    RandomCases random;
    int fitted = 0;
    for (const double fine : {1e-2, 1e-4, 1e-6})
        for (int i = 0; i < 8; ++i)
        {
            const auto surface = random_surface(random, {.spans_u = 4, .spans_v = 3, .most_repeated = 2});
            const CurveOnSurface slanted =
                line_on(surface, {random.uniform(0, 0.3), 0.05}, {random.uniform(0.6, 1), 0.93});
            const Handle(Geom2d_Curve) circle =
                new Geom2d_Circle(gp_Ax22d(gp_Pnt2d(0.5, 0.5), gp_Dir2d(1, 0), gp_Dir2d(0, 1)), 0.35);
            for (const CurveOnSurface &c : {slanted, CurveOnSurface{slanted.surface, circle, 0.0, 2.0 * M_PI}})
            {
                const auto edge = curve_on(c, fine);
                ASSERT_TRUE(edge.has_value());
                double worst = 0.0;
                for (int k = 0; k <= 3001; ++k)
                {
                    const double t = c.first + (c.last - c.first) * k / 3001;
                    worst = std::max(worst, edge->curve->Value(t).Distance(c.value(t)));
                }
                EXPECT_LE(worst, edge->deviation.bound) << "the deviation that is told is not the true one";
                // what a proof leaves open is told as part of what it had to reach
                EXPECT_GE(worst + 0.05 * fine, 0.5 * edge->deviation.bound) << "the bound is loose";
                EXPECT_LE(edge->deviation.bound, fine);
                EXPECT_TRUE(edge->deviation.proven);
                ++fitted;
            }
        }
    EXPECT_EQ(fitted, 48);
}

TEST(EdgeCurve, StartsAndEndsOnTheSurface)
{
    RandomCases random;
    const auto surface = random_surface(random, {});
    const CurveOnSurface c = line_on(surface, {0.1, 0.2}, {0.8, 0.9});
    const auto edge = curve_on(c, 1e-2);
    ASSERT_TRUE(edge.has_value());
    EXPECT_LE(edge->curve->Value(c.first).Distance(c.value(c.first)), 1e-11);
    EXPECT_LE(edge->curve->Value(c.last).Distance(c.value(c.last)), 1e-11);
}

TEST(TrimmedOffset, OfPanelsWithHoles)
{
    const TopoDS_Face panel = panel_with_hole();
    const TopoDS_Face two = with_hole(panel, gp_Pnt2d(0.2, 0.7), 0.08);
    ASSERT_EQ(sharing(two).size(), 6u);
    for (const TopoDS_Face &face : {two, reversed(two), located(two)})
        for (const double distance : {6.0, -6.0})
            expect_mirrored(face, distance);
}

TEST(TrimmedOffset, OfRandomFacesWithAHole)
{
    RandomCases random;
    for (int i = 0; i < 4; ++i)
    {
        const auto surface =
            random_surface(random, {.spans_u = 2, .spans_v = 2, .height = 4.0, .rational = i % 2 == 1});
        const TopoDS_Face face = with_hole(face_on(surface), gp_Pnt2d(0.45, 0.55), random.uniform(0.1, 0.3));
        expect_mirrored(face, i % 2 == 0 ? 1.5 : -1.5);
    }
}

TEST(TrimmedOffset, OfClosedFacesWithSeams)
{
    const TopoDS_Face tube = BRepBuilderAPI_MakeFace(gp_Cylinder(gp_Ax3(), 20.0), 0.0, 2.0 * M_PI, -10.0, 15.0);
    const TopoDS_Face ball = BRepBuilderAPI_MakeFace(gp_Sphere(gp_Ax3(), 20.0)).Face();
    const TopoDS_Face funnel = BRepBuilderAPI_MakeFace(gp_Cone(gp_Ax3(), 0.3, 20.0), 0.0, 2.0 * M_PI, -10.0, 15.0);
    const TopoDS_Face ring = BRepPrimAPI_MakeTorus(40.0, 12.0).Face();
    for (const TopoDS_Face &face : {tube, ball, funnel, ring})
        for (const double distance : {5.0, -5.0})
        {
            expect_mirrored(face, distance);
            expect_mirrored(reversed(face), distance);
        }
}

TEST(TrimmedOffset, OfASplineTubeWithASeam)
{
    const Handle(Geom_Surface) tube =
        new Geom_RectangularTrimmedSurface(new Geom_CylindricalSurface(gp_Ax3(), 20.0), 0.0, 2.0 * M_PI, -10.0, 15.0);
    const TopoDS_Face face = face_on(GeomConvert::SurfaceToBSplineSurface(tube));
    ASSERT_EQ(sharing(face).size(), 4u);
    ASSERT_EQ(distinct_edges(face).size(), 3u) << "the seam is used twice";
    for (const double distance : {5.0, -5.0})
        expect_mirrored(face, distance);
}

TEST(TrimmedOffset, OfAFlatFaceKeepsItsCurvesAsTheyAre)
{
    const TopoDS_Face plate =
        with_hole(BRepBuilderAPI_MakeFace(gp_Pln(), -20.0, 20.0, -10.0, 10.0), gp_Pnt2d(3, 2), 4.0);
    expect_mirrored(plate, 7.0);
    OffsetOptions options;
    options.distance = 7.0;
    const TopoDS_Face made = offset_face(plate, options).value().face();
    const auto before = distinct_edges(plate), after = distinct_edges(made);
    ASSERT_EQ(before.size(), 5u);
    for (std::size_t i = 0; i < before.size(); ++i)
    {
        double first, last;
        EXPECT_EQ(BRep_Tool::Curve(before[i], first, last)->DynamicType(),
                  BRep_Tool::Curve(after[i], first, last)->DynamicType());
    }
}

TEST(TrimmedOffset, OfAFaceUnderAScaledOrMirroredLocation)
{
    const TopoDS_Face panel = panel_with_hole();
    gp_Trsf scale, mirror;
    scale.SetScale(gp_Pnt(1, 2, 3), 0.5);
    mirror.SetMirror(gp_Ax2(gp_Pnt(5, 0, 0), gp_Dir(1, 1, 0)));
    for (const gp_Trsf &placing : {scale, mirror})
    {
        const TopoDS_Face face = TopoDS::Face(panel.Moved(TopLoc_Location(placing), false));
        for (const double distance : {3.0, -3.0})
        {
            OffsetOptions options;
            options.distance = distance;
            const Result<OffsetResult> result = offset_face(face, options);
            ASSERT_TRUE(result.ok()) << result.failure().message;
            const OracleReport report = measure_offset(face, result.value().face(), distance, {35, 40});
            EXPECT_LE(std::max(report.surface_error, report.edge_error), tolerance) << to_text(report);
            EXPECT_GT(report.least_cosine, 0.999) << "the side is wrong";
            EXPECT_TRUE(report.valid);
            EXPECT_EQ(report.loops, 2);
            EXPECT_EQ(report.edges, 5);
        }
    }
}

TEST(TrimmedOffset, ThereAndBackIsTheBaseWithinTwoTolerances)
{
    RandomCases random;
    for (int i = 0; i < 4; ++i)
    {
        const auto surface = random_surface(random, {.spans_u = 2, .spans_v = 2, .height = 3.0});
        const TopoDS_Face base = with_hole(face_on(surface), gp_Pnt2d(0.5, 0.5), 0.2);
        OffsetOptions options;
        options.distance = random.sign() * random.uniform(0.5, 2.5);
        const auto there = offset_face(base, options);
        ASSERT_TRUE(there.ok()) << there.failure().message;
        options.distance = -options.distance;
        const auto back = offset_face(there.value().face(), options);
        ASSERT_TRUE(back.ok()) << back.failure().message;
        const OracleReport report = measure_offset(base, back.value().face(), 0.0, {40, 60});
        // as a set of points; along the surface, the ripple of the first result's normal may move a point a little more
        EXPECT_LE(report.surface_error, 2.0 * tolerance) << to_text(report);
        EXPECT_LE(report.converse_error, 2.0 * tolerance) << to_text(report);
        EXPECT_GT(report.points, 500);
        EXPECT_TRUE(report.valid);
    }
}
