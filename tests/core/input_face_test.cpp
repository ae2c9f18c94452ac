// SPDX-License-Identifier: LGPL-2.1-or-later
// What is read from a face, what is refused and with which word, and that the face itself stays untouched.
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/input/input_face.h>
#include <laminate_offset/input/pcurve_pieces.h>
#include <laminate_offset/offset_face.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box2d.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

using namespace laminate_offset;
using namespace test_support;

namespace
{

//! The reader and the whole engine refuse the shape with the same status at the same stage.
Failure expect_refused(const TopoDS_Shape &shape, Status status, const std::string &word = {})
{
    const Result<InputFace> read = read_face(shape);
    EXPECT_FALSE(read.ok()) << "accepted";
    if (read.ok())
        return {};
    const Failure &failure = read.failure();
    EXPECT_EQ(name(failure.status), name(status)) << failure.message;
    EXPECT_EQ(name(failure.stage), name(Stage::Input));
    EXPECT_GT(failure.message.size(), 20u);
    EXPECT_NE(failure.message.find(word), std::string::npos) << failure.message << " does not name the " << word;
    OffsetOptions options;
    options.distance = 1.0;
    const Result<OffsetResult> offset = offset_face(shape, options);
    EXPECT_FALSE(offset.ok());
    if (!offset.ok())
    {
        EXPECT_EQ(name(offset.failure().status), name(status));
        EXPECT_EQ(name(offset.failure().stage), name(Stage::Input));
    }
    return failure;
}

//! A face on a surface whose only loop is made of the given edges.
TopoDS_Face bare_face(const Handle(Geom_Surface) & surface, const std::vector<TopoDS_Edge> &edges)
{
    const BRep_Builder builder;
    TopoDS_Face face;
    TopoDS_Wire wire;
    builder.MakeFace(face, surface, 1e-7);
    builder.MakeWire(wire);
    for (const TopoDS_Edge &edge : edges)
        builder.Add(wire, edge);
    builder.Add(face, wire);
    return face;
}

std::vector<TopoDS_Edge> edges_of(const TopoDS_Shape &shape)
{
    std::vector<TopoDS_Edge> edges;
    for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next())
        edges.push_back(TopoDS::Edge(it.Current()));
    return edges;
}

TopoDS_Wire square(double side)
{
    return BRepBuilderAPI_MakePolygon(gp_Pnt(0, 0, 0), gp_Pnt(side, 0, 0), gp_Pnt(side, side, 0), gp_Pnt(0, side, 0),
                                      true);
}

Handle(Geom_Plane) ground() { return new Geom_Plane(gp_Pln()); }

Handle(Geom_BSplineSurface) gentle_surface()
{
    return height_surface([](double x, double y) { return 1e-3 * (x * x - y * y); }, 100.0, 80.0, 5, 4);
}

std::string written(const TopoDS_Shape &shape)
{
    std::ostringstream text;
    BRepTools::Write(shape, text);
    return text.str();
}

TopoDS_Face scaled(const TopoDS_Face &face, double factor)
{
    gp_Trsf transformation;
    transformation.SetScale(gp_Pnt(1, 2, 3), factor);
    return TopoDS::Face(face.Moved(TopLoc_Location(transformation), false));
}

TopoDS_Face mirrored(const TopoDS_Face &face)
{
    gp_Trsf transformation;
    transformation.SetMirror(gp_Ax2(gp_Pnt(5, 0, 0), gp_Dir(1, 1, 0)));
    return TopoDS::Face(face.Moved(TopLoc_Location(transformation), false));
}

} // namespace

TEST(InputRefusal, NoShape) { expect_refused(TopoDS_Shape(), Status::NullShape); }

TEST(InputRefusal, EveryShapeThatIsNotAFaceIsNamed)
{
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Solid();
    TopoDS_Compound compound;
    BRep_Builder().MakeCompound(compound);
    BRep_Builder().Add(compound, TopExp_Explorer(box, TopAbs_FACE).Current());
    const std::pair<TopAbs_ShapeEnum, const char *> kinds[] = {
        {TopAbs_VERTEX, "vertex"}, {TopAbs_EDGE, "edge"}, {TopAbs_WIRE, "wire"}, {TopAbs_SHELL, "shell"}};
    for (const auto &[kind, word] : kinds)
        expect_refused(TopExp_Explorer(box, kind).Current(), Status::NotAFace, word);
    expect_refused(box, Status::NotAFace, "solid");
    expect_refused(compound, Status::NotAFace, "compound");
}

TEST(InputRefusal, ALoopWithAGapNamesThePlace)
{
    const auto edges = edges_of(square(10.0));
    ASSERT_EQ(edges.size(), 4u);
    const Failure failure = expect_refused(bare_face(ground(), {edges[0], edges[1], edges[2]}), Status::OpenLoop);
    ASSERT_TRUE(failure.where.has_value());
    const gp_Pnt end = BRep_Tool::Pnt(TopExp::LastVertex(edges[2], true));
    EXPECT_LT(failure.where->point.Distance(end), 1e-9);
    EXPECT_LT(gp_Pnt2d(end.X(), end.Y()).Distance(failure.where->uv), 1e-9);
}

TEST(InputRefusal, TheOrderOfTheEdgesInAWireIsFree)
{
    const auto edges = edges_of(square(10.0));
    EXPECT_TRUE(read_face(bare_face(ground(), {edges[2], edges[0], edges[3], edges[1]})).ok());
}

TEST(InputRefusal, CoordinatesThatAreNotNumbers)
{
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    {
        SCOPED_TRACE(bad);
        const TopoDS_Face spoiled = BRepBuilderAPI_MakeFace(gentle_surface(), 1e-7);
        const auto surface = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(spoiled));
        surface->SetPole(1, 2, gp_Pnt(0.0, 0.0, bad));
        expect_refused(spoiled, Status::NotFinite);
    }
}

TEST(InputRefusal, CoordinatesThatAreNotNumbersInTheMiddle)
{
    const TopoDS_Face spoiled =
        BRepBuilderAPI_MakeFace(height_surface([](double, double) { return 0.0; }, 100.0, 100.0, 12, 12), 1e-7);
    const auto surface = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(spoiled));
    surface->SetPole(6, 6, gp_Pnt(0.0, 0.0, std::numeric_limits<double>::quiet_NaN()));
    expect_refused(spoiled, Status::NotFinite);
}

TEST(InputRefusal, ATrimmingCurveThatIsNotANumber)
{
    const TopoDS_Face base = BRepBuilderAPI_MakeFace(gentle_surface(), 1e-7);
    const TopoDS_Face spoiled = TopoDS::Face(base.EmptyCopied());
    TColgp_Array1OfPnt2d poles(1, 2);
    poles(1) = gp_Pnt2d(0.0, 0.0);
    poles(2) = gp_Pnt2d(std::numeric_limits<double>::quiet_NaN(), 0.0);
    TColStd_Array1OfReal knots(1, 2);
    knots(1) = 0.0;
    knots(2) = 1.0;
    TColStd_Array1OfInteger multiplicities(1, 2);
    multiplicities.Init(2);
    const Handle(Geom2d_BSplineCurve) curve = new Geom2d_BSplineCurve(poles, knots, multiplicities, 1);
    TopoDS_Edge edge;
    const BRep_Builder builder;
    builder.MakeEdge(edge);
    builder.UpdateEdge(edge, curve, BRep_Tool::Surface(base), TopLoc_Location(), 1e-7);
    builder.Range(edge, 0.0, 1.0);
    expect_refused(bare_face(BRep_Tool::Surface(base), {edge}), Status::NotFinite);
}

TEST(InputRefusal, FacesWithoutAnEnd)
{
    expect_refused(BRepBuilderAPI_MakeFace(gp_Pln()).Face(), Status::UnboundedFace);
    expect_refused(BRepBuilderAPI_MakeFace(gp_Cylinder(gp_Ax3(), 5.0)).Face(), Status::UnboundedFace);
    TopoDS_Face naked;
    BRep_Builder().MakeFace(naked, gentle_surface(), 1e-7);
    expect_refused(naked, Status::UnboundedFace);
}

TEST(InputRefusal, LoopsThatEncloseNothing)
{
    const TopoDS_Edge there = BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(10, 5, 0));
    const TopoDS_Vertex a = TopExp::FirstVertex(there), b = TopExp::LastVertex(there);
    const TopoDS_Edge back = BRepBuilderAPI_MakeEdge(b, a);
    expect_refused(bare_face(ground(), {there, back}), Status::ZeroArea);
    expect_refused(bare_face(ground(), {there, TopoDS::Edge(there.Reversed())}), Status::ZeroArea);
    const TopoDS_Edge level = BRepBuilderAPI_MakeEdge(gp_Pnt(0, 3, 0), gp_Pnt(10, 3, 0));
    expect_refused(bare_face(ground(), {level, TopoDS::Edge(level.Reversed())}), Status::ZeroArea);
}

TEST(InputRefusal, ASliverIsNotNothing)
{
    const TopoDS_Wire sliver =
        BRepBuilderAPI_MakePolygon(gp_Pnt(0, 0, 0), gp_Pnt(500, 500, 0), gp_Pnt(500, 500.001, 0), true);
    EXPECT_TRUE(read_face(bare_face(ground(), edges_of(sliver))).ok());
}

TEST(InputRefusal, AnEdgeWithoutACurveOnTheSurface)
{
    const auto surface = gentle_surface();
    std::vector<TopoDS_Edge> edges;
    for (const auto &[iso, first, last] :
         {std::tuple(surface->VIso(0.0), 0.0, 1.0), {surface->UIso(1.0), 0.0, 1.0}, {surface->VIso(1.0), 0.0, 1.0}})
        edges.push_back(BRepBuilderAPI_MakeEdge(iso, first, last));
    expect_refused(bare_face(surface, edges), Status::InvalidFace, "edge");
}

TEST(InputRefusal, AFaceWithoutASurfaceOrWithAnEmptyLoop)
{
    TopoDS_Face nothing;
    BRep_Builder().MakeFace(nothing);
    expect_refused(nothing, Status::InvalidFace, "surface");
    expect_refused(bare_face(gentle_surface(), {}), Status::InvalidFace, "loop");
}

TEST(InputRefusal, AnEdgeWithoutLength)
{
    const TopoDS_Face base = BRepBuilderAPI_MakeFace(gentle_surface(), 1e-7);
    auto edges = edges_of(base);
    const TopoDS_Edge copy = TopoDS::Edge(edges[1].EmptyCopied());
    BRep_Builder().Range(copy, 0.5, 0.5);
    edges[1] = copy;
    expect_refused(bare_face(BRep_Tool::Surface(base), edges), Status::InvalidFace, "edge");
}

TEST(InputFace, KeepsLoopsAndEdgesInTheFacesOwnOrder)
{
    const TopoDS_Face face = panel_with_hole();
    const Result<InputFace> read = read_face(face);
    ASSERT_TRUE(read.ok());
    std::size_t loop = 0;
    for (TopoDS_Iterator wires(face); wires.More(); wires.Next(), ++loop)
    {
        ASSERT_LT(loop, read.value().loops.size());
        std::size_t k = 0;
        for (TopoDS_Iterator edges(wires.Value()); edges.More(); edges.Next(), ++k)
            EXPECT_TRUE(edges.Value().IsEqual(read.value().loops[loop].curves.at(k).edge));
        EXPECT_EQ(k, read.value().loops[loop].curves.size());
    }
    EXPECT_EQ(loop, 2u);
    EXPECT_EQ(read.value().edge_count(), 5);
}

TEST(InputFace, ItsBoxHoldsTheLoopsAndNothingMore)
{
    const InputFace input = read_face(panel_with_hole()).value();
    EXPECT_NEAR(input.box.umin, 0.0, 1e-9);
    EXPECT_NEAR(input.box.umax, 1.0, 1e-9);
    const TopoDS_Face patch = sphere_patch(50.0);
    const InputFace part = read_face(patch).value();
    EXPECT_NEAR(part.box.umin, 0.2, 1e-9);
    EXPECT_NEAR(part.box.umax, 1.4, 1e-9);
    EXPECT_NEAR(part.box.vmin, -0.6, 1e-9);
    EXPECT_NEAR(part.box.vmax, 0.7, 1e-9);
    EXPECT_GT(part.diagonal, 50.0);
    EXPECT_LT(part.diagonal, 150.0);
}

//! Samples of a trimming spline lie in the boxes of their pieces, which are hardly larger than they have to be.
TEST(PcurvePieces, BoxesHoldTheirPartsOfASpline)
{
    RandomCases random;
    int samples = 0;
    for (int i = 0; i < 60; ++i)
    {
        const KnotVector kv = random_knots(random, random.integer(1, 9), random.integer(2, 8), 3, -2.0, 5.0);
        const std::vector<Knot> knots = kv.distinct();
        TColStd_Array1OfReal parameters(1, static_cast<int>(knots.size())), weights(1, kv.pole_count());
        TColStd_Array1OfInteger multiplicities(1, static_cast<int>(knots.size()));
        for (int k = 1; k <= parameters.Length(); ++k)
        {
            parameters(k) = knots[static_cast<std::size_t>(k) - 1].parameter;
            multiplicities(k) = std::min(knots[static_cast<std::size_t>(k) - 1].multiplicity,
                                         k == 1 || k == parameters.Length() ? kv.degree + 1 : kv.degree);
        }
        int count = -kv.degree - 1;
        for (int k = 1; k <= parameters.Length(); ++k)
            count += multiplicities(k);
        TColgp_Array1OfPnt2d poles(1, count);
        weights.Resize(1, count, false);
        for (int k = 1; k <= count; ++k)
        {
            poles(k) = gp_Pnt2d(k + random.uniform(-2.0, 2.0), random.uniform(-30.0, 30.0));
            weights(k) = i % 2 == 0 ? 1.0 : random.magnitude(0.2, 5.0);
        }
        const Handle(Geom2d_BSplineCurve) curve =
            new Geom2d_BSplineCurve(poles, weights, parameters, multiplicities, kv.degree);
        const double first = i % 3 == 0 ? -2.0 : random.uniform(-1.9, 0.0);
        const double last = i % 3 == 0 ? 5.0 : random.uniform(1.0, 4.9);
        const std::vector<PcurvePiece> pieces = cut_up(curve, first, last);
        for (std::size_t p = 0; p < pieces.size(); ++p)
        {
            Bnd_Box2d seen;
            for (int k = 0; k <= 40; ++k, ++samples)
            {
                const double t =
                    first + (last - first) * (static_cast<double>(p) + k / 40.0) / static_cast<double>(pieces.size());
                const gp_Pnt2d uv = curve->Value(t);
                seen.Add(uv);
                EXPECT_GE(uv.X(), pieces[p].box.umin - 1e-10);
                EXPECT_LE(uv.X(), pieces[p].box.umax + 1e-10);
                EXPECT_GE(uv.Y(), pieces[p].box.vmin - 1e-10);
                EXPECT_LE(uv.Y(), pieces[p].box.vmax + 1e-10);
            }
            double umin, vmin, umax, vmax;
            seen.Get(umin, vmin, umax, vmax);
            EXPECT_LE(pieces[p].box.vmax - pieces[p].box.vmin, 3.0 * (vmax - vmin) + 1.0);
        }
    }
    EXPECT_GT(samples, 10000);
}

TEST(InputFace, SeesSeamsAndDegeneratedEdges)
{
    const TopoDS_Face ball = BRepBuilderAPI_MakeFace(gp_Sphere(gp_Ax3(), 10.0)).Face();
    const InputFace input = read_face(ball).value();
    ASSERT_EQ(input.loops.size(), 1u);
    int seams = 0, points = 0;
    for (const TrimmingCurve &curve : input.loops[0].curves)
    {
        seams += curve.seam ? 1 : 0;
        points += curve.degenerated ? 1 : 0;
    }
    EXPECT_EQ(seams, 2) << "a seam stands twice in its loop";
    EXPECT_EQ(points, 2) << "both poles";
    EXPECT_EQ(input.edge_count(), 3);
    const auto &curves = input.loops[0].curves;
    for (std::size_t i = 0; i < curves.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (curves[i].seam && curves[k].seam)
            {
                const double apart =
                    curves[i].pcurve->Value(curves[i].first).X() - curves[k].pcurve->Value(curves[k].first).X();
                EXPECT_NEAR(std::abs(apart), 2.0 * M_PI, 1e-9) << "each use has its own side";
            }
}

TEST(InputFace, UnwrapsTrimmedSurfaces)
{
    const Handle(Geom_Surface) twice = new Geom_RectangularTrimmedSurface(
        new Geom_RectangularTrimmedSurface(ground(), -50.0, 50.0, -50.0, 50.0), -9.0, 9.0, -9.0, 9.0);
    const InputFace input = read_face(BRepBuilderAPI_MakeFace(twice, 1e-7).Face()).value();
    EXPECT_FALSE(Handle(Geom_Plane)::DownCast(input.surface).IsNull()) << input.surface->DynamicType()->Name();
}

TEST(InputFace, TheSignFollowsOrientationAndMirrors)
{
    const TopoDS_Face panel = panel_with_hole();
    EXPECT_EQ(read_face(panel).value().normal_sign, 1.0);
    EXPECT_EQ(read_face(reversed(panel)).value().normal_sign, -1.0);
    EXPECT_EQ(read_face(located(panel)).value().normal_sign, 1.0);
    EXPECT_EQ(read_face(reversed(located(panel))).value().normal_sign, -1.0);
    EXPECT_TRUE(read_face(reversed(panel)).value().reversed);
    EXPECT_EQ(read_face(located(panel)).value().face.Orientation(), TopAbs_FORWARD);
    EXPECT_TRUE(read_face(located(panel)).value().face.Location().IsIdentity());
}

TEST(InputFace, AScaledLocationIsBakedIn)
{
    const TopoDS_Face panel = panel_with_hole();
    const double plain = read_face(panel).value().diagonal;
    const InputFace larger = read_face(scaled(panel, 2.5)).value();
    EXPECT_NEAR(larger.diagonal, 2.5 * plain, 1e-6 * plain);
    EXPECT_TRUE(larger.location.IsIdentity());
}

TEST(InputFace, ItsSignedNormalIsTheOutwardNormalOfTheFaceInSpace)
{
    int checked = 0;
    for (const TopoDS_Face &form : {panel_with_hole(), sphere_patch(50.0)})
        for (const TopoDS_Face &placed :
             {form, located(form), mirrored(form), located(mirrored(form)), scaled(form, 3.0), scaled(form, -0.5)})
            for (const TopoDS_Face &face : {placed, reversed(placed)})
            {
                const Result<InputFace> read = read_face(face);
                ASSERT_TRUE(read.ok()) << read.failure().message;
                const InputFace &input = read.value();
                const gp_Pnt2d uv(0.5 * (input.box.umin + input.box.umax), 0.5 * (input.box.vmin + input.box.vmax));
                gp_Pnt point;
                gp_Vec u, v;
                BRep_Tool::Surface(face)->D1(uv.X(), uv.Y(), point, u, v);
                const gp_Vec outward = (face.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0) * u.Crossed(v).Normalized();
                gp_Pnt local;
                input.surface->D1(uv.X(), uv.Y(), local, u, v);
                const gp_Vec ours = input.normal_sign * u.Crossed(v).Normalized();
                EXPECT_GT(outward.Dot(ours.Transformed(input.location.Transformation())), 0.999999);
                EXPECT_LT(point.Distance(local.Transformed(input.location.Transformation())), 1e-9);
                ++checked;
            }
    EXPECT_EQ(checked, 24);
}

TEST(InputFace, TheWholeOffsetLeavesTheBaseAsItWas)
{
    OffsetOptions options;
    options.distance = 4.0;
    int done = 0;
    for (const TopoDS_Face &face : {panel_with_hole(), reversed(panel_with_hole()), located(panel_with_hole()),
                                    sphere_patch(50.0), scaled(panel_with_hole(), 1.5)})
    {
        const std::string before = written(face);
        const TopoDS_Shape same = face;
        done += offset_face(face, options).ok() ? 1 : 0;
        EXPECT_EQ(written(face), before);
        EXPECT_TRUE(face.IsEqual(same));
    }
    EXPECT_EQ(done, 5);
}
