// SPDX-License-Identifier: LGPL-2.1-or-later
// Images of curves: the proven bound against dense samples, seams, poles, borders, and what is refused.
#include "support/data_files.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/nearest_point.h>
#include <laminate_offset/project_curve.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

using namespace laminate_offset;

namespace
{

constexpr double tolerance = 1e-3;

//! Largest distance at dense samples between the wire's curves and the surface along their pcurves.
double sampled(const TopoDS_Shape &wire, const TopoDS_Face &face)
{
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(wire, TopAbs_EDGE, edges);
    EXPECT_GT(edges.Extent(), 0);
    double worst = 0.0;
    for (int i = 1; i <= edges.Extent(); ++i)
    {
        double first, last;
        const TopoDS_Edge edge = TopoDS::Edge(edges(i));
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
        const Handle(Geom2d_Curve) pcurve = BRep_Tool::CurveOnSurface(edge, face, first, last);
        const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
        for (int k = 0; k <= 500; ++k)
        {
            const double t = first + (last - first) * k / 500;
            const gp_Pnt2d uv = pcurve->Value(t);
            worst = std::max(worst, curve->Value(t).Distance(surface->Value(uv.X(), uv.Y())));
        }
    }
    return worst;
}

//! How much farther from the given curve than the surface is its image lies, at dense samples [mm].
double excess_seen(const CurveProjection &image, const TopoDS_Face &face)
{
    double worst = 0.0;
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    for (const ProjectedEdge &edge : image.edges)
    {
        std::vector<gp_Pnt> given;
        std::vector<double> away;
        const gp_Trsf place = face.Location().Transformation();
        for (int k = 0; k <= 3000; ++k)
        {
            const double t = edge.first + (edge.last - edge.first) * k / 3000;
            const gp_Pnt2d uv = edge.pcurve->Value(t);
            given.push_back(edge.given->Value(t).Transformed(place));
            away.push_back(given.back().Distance(surface->Value(uv.X(), uv.Y())));
        }
        const auto nearest = nearest_points(face, given);
        EXPECT_TRUE(nearest.ok());
        for (std::size_t k = 0; k < away.size(); ++k)
            worst = std::max(worst, away[k] - nearest.value()[k].distance);
    }
    return worst;
}

//! The tolerance that a refusal names.
double tolerance_told(const Failure &failure)
{
    const std::string before = "a tolerance of ";
    const std::size_t at = failure.message.find(before);
    EXPECT_NE(at, std::string::npos) << failure.message;
    return at == std::string::npos ? 0.0 : std::stod(failure.message.substr(at + before.size()));
}

TopoDS_Face cylinder(double radius, double height)
{
    return BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(), radius), 0, 2 * M_PI, 0, height, 1e-7);
}

} // namespace

TEST(ProjectCurve, EdgesGoBackOntoTheirOwnFace)
{
    const TopoDS_Face bare[] = {test_support::panel_with_hole(),
                                test_support::located(test_support::panel_with_hole()),
                                test_support::sphere_patch(50.0),
                                TopoDS::Face(BRepPrimAPI_MakeSphere(30.0).Face()),
                                cylinder(20.0, 30.0),
                                BRepBuilderAPI_MakeFace(test_support::wavy_tube(50.0), 1e-7)};
    int edges_seen = 0;
    for (const TopoDS_Face &face : bare)
    {
        TopTools_IndexedMapOfShape edges;
        TopExp::MapShapes(face, TopAbs_EDGE, edges);
        for (int i = 1; i <= edges.Extent(); ++i)
        {
            const TopoDS_Edge edge = TopoDS::Edge(edges(i));
            if (BRep_Tool::Degenerated(edge))
                continue;
            ++edges_seen;
            const auto image = project_curve(face, edge);
            ASSERT_TRUE(image.ok()) << image.failure().message;
            ASSERT_TRUE(image.value().certified_error.has_value());
            EXPECT_LE(*image.value().certified_error, tolerance);
            EXPECT_LE(sampled(image.value().wire, face), *image.value().certified_error + 1e-12);
            for (const ProjectedEdge &part : image.value().edges)
                EXPECT_TRUE(part.on_surface);
            EXPECT_TRUE(BRepCheck_Analyzer(image.value().wire).IsValid());
        }
    }
    EXPECT_GT(edges_seen, 15);
}

TEST(ProjectCurve, TolerancesAreKept)
{
    const TopoDS_Face face = test_support::panel_with_hole();
    const Handle(Geom_Curve) circle = new Geom_Circle(gp_Ax2(gp_Pnt(100, 50, 80), gp_Dir(0.1, 0.2, 1)), 120.0);
    for (const double wanted : {1.0, 1e-2, 1e-4, 1e-6})
    {
        const auto image = project_curve(face, BRepBuilderAPI_MakeEdge(circle).Edge(), {wanted, Outside::Clip});
        ASSERT_TRUE(image.ok()) << image.failure().message;
        EXPECT_FALSE(image.value().edges.front().on_surface);
        ASSERT_TRUE(image.value().certified_error.has_value());
        EXPECT_LE(*image.value().certified_error, wanted);
        EXPECT_LE(sampled(image.value().wire, face), *image.value().certified_error + 1e-12);
        EXPECT_TRUE(image.value().wire.Closed());
    }
}

TEST(ProjectCurve, ASeamSplitsTheCurve)
{
    const TopoDS_Face face = cylinder(20.0, 30.0);
    const TopoDS_Edge line = BRepBuilderAPI_MakeEdge(gp_Pnt(25, -9, 5), gp_Pnt(25, 9, 20));
    const auto image = project_curve(face, line);
    ASSERT_TRUE(image.ok()) << image.failure().message;
    ASSERT_EQ(image.value().edges.size(), 2U);
    EXPECT_EQ(image.value().wire.ShapeType(), TopAbs_WIRE);
    const ProjectedEdge &before = image.value().edges[0];
    const ProjectedEdge &after = image.value().edges[1];
    EXPECT_DOUBLE_EQ(before.last, after.first);
    EXPECT_NEAR(before.pcurve->Value(before.last).X(), 2 * M_PI, 1e-12);
    EXPECT_NEAR(after.pcurve->Value(after.first).X(), 0.0, 1e-12);
    EXPECT_LE(sampled(image.value().wire, face), *image.value().certified_error + 1e-12);
}

TEST(ProjectCurve, PartsOutsideAreClippedOrTheSurfaceGoesOn)
{
    const TopoDS_Face face = cylinder(20.0, 30.0);
    const TopoDS_Edge line = BRepBuilderAPI_MakeEdge(gp_Pnt(-25, 1, -10), gp_Pnt(-25, 2, 50));
    const auto clipped = project_curve(face, line);
    const auto extended = project_curve(face, line, {tolerance, Outside::Extend});
    ASSERT_TRUE(clipped.ok() && extended.ok());
    EXPECT_NEAR(clipped.value().edges.front().first, 10.0, 0.1);
    EXPECT_LT(clipped.value().edges.front().last, 40.1);
    EXPECT_NEAR(extended.value().edges.front().first, 0.0, 1e-9);
    EXPECT_GT(extended.value().edges.front().last, 60.0);
}

//! A line that goes on past the border does not slide along it as long as it is within the tolerance.
TEST(ProjectCurve, AnImageEndsWhereTheCurveCrossesTheBorder)
{
    const TopoDS_Face plane =
        BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), -200.0, 200.0, -150.0, 150.0);
    const auto flat = test_support::height_surface([](double, double) { return 0.0; }, 400.0, 300.0, 6, 5);
    const TopoDS_Face spline = BRepBuilderAPI_MakeFace(flat, 1e-7);
    for (const TopoDS_Face &face : {plane, spline})
        for (const double wanted : {1e-5, 1e-3, 0.1})
            for (const double above : {0.0, 0.5})
                for (const gp_Pnt &end : {gp_Pnt(100, 300, 0), gp_Pnt(1, 300, 0), gp_Pnt(500, 100, 0),
                                          gp_Pnt(-300, 20, 0), gp_Pnt(0, -151, 0), gp_Pnt(100, 280, 0)})
                {
                    const gp_Vec lift(0.0, 0.0, above);
                    const gp_Pnt start(10.0, 20.0, 0.0);
                    const auto image = project_curve(
                        face, BRepBuilderAPI_MakeEdge(start.Translated(lift), end.Translated(lift)).Edge(),
                        {wanted, Outside::Clip});
                    ASSERT_TRUE(image.ok()) << image.failure().message;
                    ASSERT_EQ(image.value().edges.size(), 1U); // the last line has a sample on the border
                    const BRepAdaptor_Curve curve(
                        TopoDS::Edge(TopExp_Explorer(image.value().wire, TopAbs_EDGE).Current()));
                    const gp_Vec along(start, end);
                    double last = 1.0;
                    for (const auto &[from, step, half] :
                         {std::tuple(start.X(), along.X(), 200.0), {start.Y(), along.Y(), 150.0}})
                        if (step != 0.0)
                            last = std::min(last, ((step > 0.0 ? half : -half) - from) / step);
                    const gp_Pnt crossing = start.Translated(last * along);
                    const gp_Pnt seen = curve.Value(curve.LastParameter());
                    EXPECT_LE(seen.Distance(crossing), above == 0.0 ? 1e-9 : wanted) << wanted << " to " << end.X();
                }
}

TEST(ProjectCurve, NoSliverIsLeftWhereACurveComesBackToTheBorder)
{
    const double radius = 100.0, sector = 2.0 * M_PI / 3.0;
    const TopoDS_Face face =
        BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(), radius), 0.0, sector, 0.0, 300.0, 1e-7);
    int in_two = 0;
    for (const double off : {0.0, 0.5, -1.0})
        for (const double turn : {0.0, 1e-9, -1e-9, 1e-7, 0.3, 2.0, sector, 3.0, 5.0})
            for (const double tolerance : {1e-2, 1e-3, 1e-5})
            {
                const gp_Dir x(std::cos(turn), std::sin(turn), 0.0);
                const TopoDS_Edge round = BRepBuilderAPI_MakeEdge(
                    gp_Circ(gp_Ax2(gp_Pnt(0.0, 0.0, 150.0), gp_Dir(0.0, 0.0, 1.0), x), radius + off));
                const auto image = project_curve(face, round, {tolerance, Outside::Clip});
                ASSERT_TRUE(image) << image.failure().message;
                double length = 0.0;
                for (TopExp_Explorer it(image.value().wire, TopAbs_EDGE); it.More(); it.Next())
                {
                    const BRepAdaptor_Curve curve(TopoDS::Edge(it.Current()));
                    const double part = GCPnts_AbscissaPoint::Length(curve);
                    EXPECT_GE(part, tolerance) << off << " " << turn;
                    length += part;
                }
                EXPECT_NEAR(length, sector * radius, 4.0 * tolerance) << off << " " << turn;
                in_two += image.value().edges.size() == 2 ? 1 : 0;
            }
    EXPECT_GE(in_two, 9); // the circle begins inside
}

//! Curves that stray over a border by less than the tolerance: their images stay inside, or nothing could be proven.
TEST(ProjectCurve, ImagesAlongABorderAreProven)
{
    const auto surface = test_support::height_surface(
        [](double x, double y) { return 10.0 * std::sin(0.02 * x) * std::cos(0.03 * y); }, 100.0, 80.0, 6, 5);
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, 1e-7);
    test_support::RandomCases random;
    int simplified = 0;
    for (const bool along_u : {true, false})
        for (const double at : {0.0, 1.0})
            for (int round = 0; round < 5; ++round)
            {
                const Handle(Geom_Curve) side = along_u ? surface->VIso(at) : surface->UIso(at);
                const auto curve = Handle(Geom_BSplineCurve)::DownCast(side);
                for (int i = 1; i <= curve->NbPoles(); ++i)
                    curve->SetPole(i, curve->Pole(i).Translated(
                                          gp_Vec(random.uniform(-1e-5, 1e-5), random.uniform(-1e-5, 1e-5), 0.0)));
                const auto image = project_curve(face, BRepBuilderAPI_MakeEdge(curve).Edge());
                ASSERT_TRUE(image.ok()) << image.failure().message;
                ASSERT_TRUE(image.value().certified_error.has_value());
                EXPECT_LE(*image.value().certified_error, tolerance);
                EXPECT_LE(sampled(image.value().wire, face), *image.value().certified_error + 1e-12);
                const auto pcurve = Handle(Geom2d_BSplineCurve)::DownCast(image.value().edges.front().pcurve);
                simplified += pcurve->NbPoles() < 12 ? 1 : 0;
                for (int i = 1; i <= pcurve->NbPoles(); ++i)
                    EXPECT_TRUE(pcurve->Pole(i).X() >= 0.0 && pcurve->Pole(i).X() <= 1.0 &&
                                pcurve->Pole(i).Y() >= 0.0 && pcurve->Pole(i).Y() <= 1.0);
            }
    EXPECT_GT(simplified, 10);
}

//! A cap whose circle misses the axis by a little is no sphere, yet its edges are proven up to its tip.
TEST(ProjectCurve, EdgesOfATurnedCircleAreProven)
{
    for (const double off : {0.0, 1e-6, 0.3})
    {
        const Handle(Geom_Curve) circle =
            new Geom_Circle(gp_Ax2(gp_Pnt(off, 0.5 * off, 0), gp_Dir(off, -1, 0), gp_Dir(1, off, 0)), 25.0);
        const Handle(Geom_Surface) cap = new Geom_SurfaceOfRevolution(circle, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)));
        const TopoDS_Face face = BRepBuilderAPI_MakeFace(cap, 0.3, 2.5, 0.2, M_PI_2 - 1e-8, 1e-7);
        int edges_seen = 0;
        for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
        {
            if (BRep_Tool::Degenerated(TopoDS::Edge(it.Current())))
                continue;
            const auto image = project_curve(face, it.Current());
            ASSERT_TRUE(image.ok()) << image.failure().message;
            ASSERT_TRUE(image.value().certified_error.has_value()) << off;
            EXPECT_LE(*image.value().certified_error, tolerance);
            EXPECT_LE(sampled(image.value().wire, face), *image.value().certified_error + 1e-12);
            ++edges_seen;
        }
        EXPECT_GE(edges_seen, 3);
    }
}

//! A curve above a hollow crease has no continuous image.
TEST(ProjectCurve, AJumpOverACreaseIsRefusedWithItsPlace)
{
    TColgp_Array2OfPnt poles(1, 3, 1, 2);
    for (int j = 1; j <= 2; ++j)
        for (int i = 1; i <= 3; ++i)
            poles(i, j) = gp_Pnt(20.0 * (i - 2), 50.0 * (j - 1), 10.0 * std::abs(i - 2));
    TColStd_Array1OfReal us(1, 3), vs(1, 2);
    TColStd_Array1OfInteger mu(1, 3), mv(1, 2);
    for (int i = 1; i <= 3; ++i)
    {
        us(i) = i;
        mu(i) = i == 2 ? 1 : 2;
    }
    vs(1) = 0.0;
    vs(2) = 1.0;
    mv.Init(2);
    const Handle(Geom_Surface) valley = new Geom_BSplineSurface(poles, us, vs, mu, mv, 1, 1);
    const TopoDS_Face face = test_support::located(BRepBuilderAPI_MakeFace(valley, 1e-7));
    const TopoDS_Shape line =
        BRepBuilderAPI_MakeEdge(gp_Pnt(-10, 20, 5.1), gp_Pnt(11, 30, 5.1)).Shape().Moved(face.Location());
    const auto image = project_curve(face, line);
    ASSERT_FALSE(image.ok());
    EXPECT_EQ(image.failure().status, Status::EdgeToleranceNotReached);
    EXPECT_NE(image.failure().message.find("jumps"), std::string::npos) << image.failure().message;
    ASSERT_TRUE(image.failure().where.has_value());
    const gp_Pnt at = image.failure().where->point.Transformed(face.Location().Transformation().Inverted());
    EXPECT_NEAR(at.X(), 0.0, 3.0);
    EXPECT_NEAR(at.Y(), 25.0, 3.0);
    // 5.1 mm above the crease, whose sides rise by one half
    const double across = 5.1 * (1.0 - 2.0 / std::sqrt(5.0));
    const double told = tolerance_told(image.failure());
    EXPECT_GT(told, across);
    EXPECT_LT(told, 1.5 * across);
    EXPECT_FALSE(project_curve(face, line, {0.9 * across, Outside::Clip}).ok());
    const auto bridged = project_curve(face, line, {told, Outside::Clip});
    ASSERT_TRUE(bridged.ok()) << bridged.failure().message;
    EXPECT_TRUE(bridged.value().edges.front().bridged);
    ASSERT_TRUE(bridged.value().certified_error && bridged.value().certified_distance);
    EXPECT_LE(*bridged.value().certified_error, told);
    const double excess = excess_seen(bridged.value(), face);
    EXPECT_GT(excess, 0.9 * across);
    EXPECT_LE(excess, told);
    EXPECT_GE(*bridged.value().certified_distance, 5.1);
}

//! Of curves that keep away from the surface by 1e-4 to 30 mm, proven against dense samples.
TEST(ProjectCurve, TheDistanceOfTheGivenCurveIsProven)
{
    test_support::RandomCases random;
    const TopoDS_Face faces[] = {test_support::panel_with_hole(), test_support::sphere_patch(300.0),
                                 test_support::located(cylinder(400.0, 500.0))};
    int off = 0, on = 0;
    for (const TopoDS_Face &face : faces)
        for (int round = 0; round < 8; ++round)
        {
            const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
            double u0, u1, v0, v1;
            BRepTools::UVBounds(face, u0, u1, v0, v1);
            const auto above = [&](double height) {
                const double u = u0 + (u1 - u0) * random.uniform(0.2, 0.4);
                const double v = v0 + (v1 - v0) * random.uniform(0.2, 0.8);
                gp_Pnt s;
                gp_Vec du, dv;
                surface->D1(u, v, s, du, dv);
                return s.Translated(height * du.Crossed(dv).Normalized());
            };
            const double height = round == 0 ? 0.0 : random.sign() * random.magnitude(1e-4, 30.0);
            TColgp_Array1OfPnt poles(1, 4);
            for (int i = 1; i <= 4; ++i)
                poles(i) = above(height);
            const auto image = project_curve(face, BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles)).Edge());
            SCOPED_TRACE(testing::Message() << round << " at " << height);
            ASSERT_TRUE(image.ok()) << image.failure().message;
            ASSERT_TRUE(image.value().certified_distance);
            double largest = 0.0;
            for (const ProjectedEdge &edge : image.value().edges)
            {
                ASSERT_TRUE(edge.certified_distance);
                EXPECT_LE(*edge.certified_distance, *image.value().certified_distance);
                EXPECT_FALSE(edge.bridged);
                const gp_Trsf place = face.Location().Transformation();
                for (int k = 0; k <= 500; ++k)
                {
                    const double t = edge.first + (edge.last - edge.first) * k / 500;
                    const gp_Pnt2d uv = edge.pcurve->Value(t);
                    const double distance =
                        edge.given->Value(t).Transformed(place).Distance(surface->Value(uv.X(), uv.Y()));
                    EXPECT_LE(distance, *edge.certified_distance + 1e-12);
                    largest = std::max(largest, distance);
                }
                if (edge.on_surface)
                    EXPECT_EQ(edge.certified_distance, edge.certified_error);
                ++(edge.on_surface ? on : off);
            }
            EXPECT_LE(*image.value().certified_distance, 1.2 * largest + tolerance) << "not much above the truth";
        }
    EXPECT_GT(off, 15);
}

//! Edges of real models that once were left without a proof.
TEST(ProjectCurve, RealEdgesAlongBordersAndTurnedCirclesAreProven)
{
    const std::pair<const char *, std::vector<int>> models[] = {{"psas_nose_mold.igs", {3, 4, 23, 27, 43, 46}},
                                                                {"nist_MBE_PMI_5.stp", {34, 37}}};
    for (const auto &[name, numbers] : models)
    {
        const auto path = test_support::find_data_file(name);
        if (!path)
            GTEST_SKIP() << test_support::missing_data_message(name);
        const std::vector<TopoDS_Face> all = test_support::read_faces(*path);
        for (const int number : numbers)
        {
            const TopoDS_Face &face = all.at(static_cast<std::size_t>(number) - 1);
            for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
            {
                if (BRep_Tool::Degenerated(TopoDS::Edge(it.Current())))
                    continue;
                const auto image = project_curve(face, it.Current());
                ASSERT_TRUE(image.ok()) << name << number << image.failure().message;
                ASSERT_TRUE(image.value().certified_error.has_value()) << name << number;
                EXPECT_LE(*image.value().certified_error, tolerance);
            }
        }
    }
}

//! An edge that leaves its own face by more than the file admits, beside a hollow crease: its image is proven within the
//! tolerance, and apart from that how far the edge is off.
TEST(ProjectCurve, ARealEdgeOffItsFaceGetsAnImageAndItsDistance)
{
    const char *name = "dealii_DTMB5415_bulbous_bow.iges";
    const auto path = test_support::find_data_file(name);
    if (!path)
        GTEST_SKIP() << test_support::missing_data_message(name);
    const TopoDS_Face face = test_support::read_faces(*path).front();
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(face, TopAbs_EDGE, edges);
    const TopoDS_Edge edge = TopoDS::Edge(edges(1));
    const auto image = project_curve(face, edge);
    ASSERT_TRUE(image.ok()) << image.failure().message;
    ASSERT_TRUE(image.value().certified_error && image.value().certified_distance);
    EXPECT_LE(*image.value().certified_error, tolerance);
    EXPECT_LE(sampled(image.value().wire, face), *image.value().certified_error + 1e-12);
    EXPECT_GT(image.value().distance, 2.0 * BRep_Tool::Tolerance(edge)) << "the edge is farther off than it says";
    EXPECT_GE(*image.value().certified_distance, image.value().distance);
    EXPECT_LE(*image.value().certified_distance, 1.2 * image.value().distance + tolerance);
    bool bridged = false;
    for (const ProjectedEdge &part : image.value().edges)
        bridged = bridged || part.bridged;
    EXPECT_TRUE(bridged);
    EXPECT_LE(excess_seen(image.value(), face), 0.1 * image.value().distance);
}

TEST(ProjectCurve, NoSurfaceGoesOnPastItsLastKnot)
{
    const TopoDS_Face panel = test_support::panel_with_hole();
    const TopoDS_Edge line = BRepBuilderAPI_MakeEdge(gp_Pnt(50, 100, 80), gp_Pnt(700, 180, 80));
    const auto clipped = project_curve(panel, line);
    const auto extended = project_curve(panel, line, {tolerance, Outside::Extend});
    ASSERT_TRUE(clipped.ok() && extended.ok());
    for (const CurveProjection *image : {&clipped.value(), &extended.value()})
    {
        ASSERT_EQ(image->edges.size(), 1u);
        ASSERT_TRUE(image->certified_error);
        EXPECT_LE(*image->certified_error, tolerance);
        EXPECT_LE(sampled(image->wire, panel), *image->certified_error + 1e-12);
        EXPECT_GT(image->edges.front().last, 300.0);
        EXPECT_LT(image->edges.front().last, 500.0) << "the panel ends at x = 400";
    }
}

TEST(ProjectCurve, Refusals)
{
    const TopoDS_Face face = test_support::panel_with_hole();
    const TopoDS_Edge far = BRepBuilderAPI_MakeEdge(gp_Pnt(9000, 0, 0), gp_Pnt(9000, 10, 0));
    EXPECT_EQ(project_curve(face, far).failure().status, Status::NotSupported);
    EXPECT_EQ(project_curve(face, face).failure().status, Status::NotSupported);
    EXPECT_EQ(project_curve(face, TopoDS_Shape()).failure().status, Status::NotSupported);
    EXPECT_EQ(project_curve(far, far).failure().status, Status::NotAFace);
    EXPECT_EQ(project_curve(face, far, {0.0, Outside::Clip}).failure().status, Status::InvalidTolerance);
}
