// SPDX-License-Identifier: LGPL-2.1-or-later
// Fitted offsets against S + d N at points that the engine does not know, over kinds, sizes and tolerances.
#include "support/deviation.h"
#include "support/offsets.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <GeomConvert.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <laminate_offset/offset_face.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>

#include <gtest/gtest.h>

#include <cmath>

using namespace laminate_offset;
using namespace test_support;

namespace
{

TopoDS_Face whole(const Handle(Geom_Surface) & surface) { return BRepBuilderAPI_MakeFace(surface, 1e-7); }

Handle(Geom_BSplineSurface) spline_of(const TopoDS_Face &face)
{
    return Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face));
}

//! A spline within the tolerance of S + d N over the whole face, with a report that says nothing better than the
//! truth. \return its number of poles, 0 if it failed
int expect_fitted(const TopoDS_Face &face, double distance, double tolerance, int max_degree = 7, int count = 67)
{
    SCOPED_TRACE(testing::Message() << "distance " << distance << " tolerance " << tolerance);
    const auto result = offset(face, distance, tolerance, max_degree);
    EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.failure().message);
    if (!result.ok())
        return 0;
    const Handle(Geom_BSplineSurface) made = spline_of(result.value().face());
    EXPECT_FALSE(made.IsNull());
    Rectangle box;
    BRepTools::UVBounds(face, box.u0, box.u1, box.v0, box.v1);
    const double along = face.Orientation() == TopAbs_REVERSED ? -distance : distance;
    const Deviation d = deviation(BRep_Tool::Surface(face), made, box, along, count);
    EXPECT_GT(d.points, count * count / 2);
    EXPECT_LE(d.largest, tolerance);
    EXPECT_GT(d.least_cosine, 0.99);
    const OffsetReport &report = result.value().report;
    EXPECT_LE(report.sampled_error.value_or(0.0), tolerance);
    if (report.certified_error)
    {
        EXPECT_LE(*report.certified_error, tolerance);
        EXPECT_GE(*report.certified_error * (1.0 + 1e-9), d.largest) << "the proven bound is none";
    }
    EXPECT_EQ(report.surface->poles_u, made->NbUPoles());
    EXPECT_EQ(report.surface->poles_v, made->NbVPoles());
    return made->NbUPoles() * made->NbVPoles();
}

//! The smallest radius of curvature of a surface over [0, 1]^2, by a scan.
double tightest_radius(const Handle(Geom_Surface) & surface)
{
    double sharpest = 0.0;
    GeomLProp_SLProps local(surface, 2, 1e-12);
    constexpr int scan = 60;
    for (int i = 0; i <= scan; ++i)
        for (int j = 0; j <= scan; ++j)
        {
            local.SetParameters(1.0 * i / scan, 1.0 * j / scan);
            sharpest = std::max({sharpest, std::abs(local.MinCurvature()), std::abs(local.MaxCurvature())});
        }
    return 1.0 / sharpest;
}

Handle(Geom_BSplineSurface) ball(double u1, double v0, double v1, double radius = 50.0)
{
    return GeomConvert::SurfaceToBSplineSurface(
        new Geom_RectangularTrimmedSurface(new Geom_SphericalSurface(gp_Ax3(), radius), 0.0, u1, v0, v1));
}

TopoDS_Face dome()
{
    return whole(height_surface([](double x, double y) { return -3e-3 * (x * x + 0.5 * y * y); }, 120.0, 90.0, 7, 6));
}

} // namespace

TEST(FittedOffset, OfRandomSurfacesIsWithinTheToleranceOnBothSides)
{
    RandomCases random;
    int done = 0;
    for (const int degree : {3, 5})
        for (const bool rational : {false, true})
            for (const double tolerance : {1e-1, 1e-3, 1e-4})
            {
                SCOPED_TRACE(testing::Message() << "degree " << degree << (rational ? " rational" : ""));
                const auto surface = random_surface(
                    random,
                    {.degree_u = degree, .degree_v = degree, .spans_u = 2, .height = 5.0, .rational = rational});
                const double distance = 0.4 * tightest_radius(surface);
                for (const double side : {1.0, -1.0})
                    done += expect_fitted(whole(surface), side * distance, tolerance) > 0 ? 1 : 0;
            }
    EXPECT_EQ(done, 24);
}

TEST(FittedOffset, ReachesEveryToleranceAndPaysForItInPoles)
{
    int before = 0;
    for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
    {
        const int poles = expect_fitted(dome(), 12.0, tolerance);
        EXPECT_GE(poles, before);
        EXPECT_LT(poles, 2500);
        before = poles;
    }
}

TEST(FittedOffset, OfARationalVaseStandsOverItsOwnWeights)
{
    TColgp_Array1OfPnt poles(1, 5);
    const double radii[] = {40, 55, 35, 30, 42};
    for (int i = 1; i <= 5; ++i)
        poles(i) = gp_Pnt(radii[i - 1], 0.0, 30.0 * i);
    const Handle(Geom_Surface) vase = GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(
        new Geom_SurfaceOfRevolution(new Geom_BezierCurve(poles), gp::OZ()), 0.0, M_PI, 0.0, 1.0));
    for (const double tolerance : {1e-1, 1e-3, 1e-5})
        for (const double distance : {2.0, -2.0})
        {
            const int made = expect_fitted(whole(vase), distance, tolerance);
            const auto result = offset(whole(vase), distance, tolerance);
            ASSERT_TRUE(result.ok());
            EXPECT_TRUE(result.value().report.surface->rational);
            EXPECT_EQ(result.value().report.surface->poles_u, 5) << "the two arcs of the half turn, as they are";
            EXPECT_LT(made, 5 * 40);
        }
}

TEST(FittedOffset, AToleranceOutOfReachIsRefusedWithItsPlace)
{
    for (const double side : {1.0, -1.0})
    {
        const auto result = offset(dome(), side * 12.0, 1e-14);
        ASSERT_FALSE(result.ok());
        EXPECT_EQ(result.failure().status, Status::ToleranceNotReached);
        EXPECT_EQ(result.failure().stage, Stage::Surface);
        EXPECT_TRUE(result.failure().where.has_value());
        EXPECT_EQ(result.failure().message.find("inf"), std::string::npos) << result.failure().message;
    }
}

TEST(FittedOffset, WorksForEverySizeOfFace)
{
    for (const double size : {1e-2, 1.0, 1e2, 1e3, 1e5})
    {
        const auto height = [size](double x, double y) { return 0.2 / size * (x * x - y * y + 0.3 * x * y); };
        const TopoDS_Face face = whole(height_surface(height, size, size, 6, 5));
        for (const double side : {1.0, -1.0})
            EXPECT_GT(expect_fitted(face, side * 0.2 * size, std::max(1e-5 * size, 1e-6)), 0);
    }
}

TEST(FittedOffset, WorksForEveryDistanceOutwards)
{
    for (const double distance : {1e-2, 1e-1, 1.0, 1e2, 1e4, 1e5})
        EXPECT_GT(expect_fitted(dome(), distance, std::max(1e-4, 1e-7 * distance)), 0);
}

TEST(FittedOffset, OfDistanceZeroIsTheBaseAndCostsNoMorePoles)
{
    const TopoDS_Face face = dome();
    EXPECT_LE(expect_fitted(face, 0.0, 1e-6), 42);
}

TEST(FittedOffset, KeepsToTheHighestDegreeAllowed)
{
    int before = 1 << 20;
    for (int degree = 3; degree <= 7; ++degree)
    {
        const auto result = offset(dome(), 10.0, 1e-5, degree);
        ASSERT_TRUE(result.ok()) << degree;
        EXPECT_LE(spline_of(result.value().face())->UDegree(), degree);
        EXPECT_LE(spline_of(result.value().face())->VDegree(), degree);
        EXPECT_EQ(result.value().report.surface->degree_u, spline_of(result.value().face())->UDegree());
        const int poles = expect_fitted(dome(), 10.0, 1e-5, degree);
        EXPECT_LE(poles, before * 1.3) << "more freedom should not cost poles";
        before = poles;
    }
}

TEST(FittedOffset, OfAPeriodicTube)
{
    const TopoDS_Face tube = whole(wavy_tube(60.0));
    for (const double distance : {15.0, -15.0})
    {
        EXPECT_GT(expect_fitted(tube, distance, 1e-3), 0);
        const auto result = offset(tube, distance, 1e-3);
        const auto made = spline_of(result.value().face());
        double u0, u1, v0, v1;
        made->Bounds(u0, u1, v0, v1);
        for (int j = 0; j <= 20; ++j)
        {
            const double v = v0 + (v1 - v0) * j / 20;
            EXPECT_LE(made->Value(u0, v).Distance(made->Value(u0 + 12.0, v)), 2e-3) << "the tube opens";
        }
    }
}

TEST(FittedOffset, OfAPartOfAPeriodicTubeAcrossItsSeam)
{
    const TopoDS_Face part = BRepBuilderAPI_MakeFace(wavy_tube(60.0), 9.5, 14.0, 0.2, 2.5, 1e-7);
    for (const double distance : {15.0, -15.0})
        EXPECT_GT(expect_fitted(part, distance, 1e-3), 0);
}

TEST(FittedOffset, OfLoopsAllTheWayRoundThatOverlapByWhatTheirEndsMissEachOther)
{
    const Handle(Geom_BSplineSurface) tube = wavy_tube(60.0); // its period in u is 12
    for (const double overlap : {0.0, 1e-9, 1e-7, 5e-6})
        for (const double start : {0.0, 3.3, -1.0})
            for (const double distance : {2.0, -2.0})
            {
                SCOPED_TRACE(testing::Message() << "overlap " << overlap << " from " << start);
                const TopoDS_Face base = rectangle_on(tube, start, start + 12.0 + overlap, 0.2, 2.5);
                EXPECT_GT(expect_fitted(base, distance, 1e-3), 0);
                const auto result = offset(base, distance, 1e-3);
                ASSERT_TRUE(result.ok() && result.value().report.certified_error);
                // past the end of the domain the surface's own error is not known
                EXPECT_EQ(result.value().report.edge_error.has_value(), overlap < 1e-8);
                EXPECT_LE(result.value().report.edge_error.value_or(0.0), 1e-3);
                EXPECT_LE(result.value().report.sampled_edge_error.value_or(1.0), 1e-3);
            }
    for (const double overlap : {1e-3, 0.3, 3.0})
    {
        const auto twice = offset(rectangle_on(tube, 0.0, 12.0 + overlap, 0.2, 2.5), 2.0, 1e-3);
        ASSERT_FALSE(twice.ok()) << overlap;
        EXPECT_EQ(twice.failure().status, Status::InvalidFace);
        EXPECT_EQ(twice.failure().stage, Stage::Input);
        EXPECT_TRUE(twice.failure().where.has_value());
    }
}

TEST(FittedOffset, OfALoopWhoseControlPointsReachFartherThanATurn)
{
    // the left side is a parabola that touches u = 0 from the right, and the right side is u = 12, a period on
    const Handle(Geom_BSplineSurface) tube = wavy_tube(60.0);
    const gp_Pnt2d corners[] = {{0.5, 0.2}, {12.0, 0.2}, {12.0, 2.5}, {0.5, 2.5}};
    BRepBuilderAPI_MakeWire wire;
    for (int i = 0; i < 4; ++i)
    {
        const gp_Pnt2d &from = corners[i], &to = corners[(i + 1) % 4];
        TColgp_Array1OfPnt2d poles(1, 3);
        poles(1) = from;
        poles(2) = i == 3 ? gp_Pnt2d(-0.5, 1.35) : gp_Pnt2d(0.5 * (from.XY() + to.XY()));
        poles(3) = to;
        const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(new Geom2d_BezierCurve(poles), tube);
        BRepLib::BuildCurve3d(edge);
        wire.Add(edge);
    }
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(tube, wire.Wire(), true);
    for (const double distance : {2.0, -2.0})
    {
        const auto result = offset(face, distance, 1e-3);
        ASSERT_TRUE(result.ok()) << why(result);
        const auto made = spline_of(result.value().face());
        const double along = face.Orientation() == TopAbs_REVERSED ? -distance : distance;
        EXPECT_LE(deviation(tube, made, {0.0, 12.0, 0.2, 2.5}, along, 61).largest, 1e-3);
        EXPECT_LE(result.value().report.edge_error.value_or(1.0), 1e-3);
        double u0, u1, v0, v1;
        made->Bounds(u0, u1, v0, v1);
        EXPECT_LE(u0, 1e-9) << "the surface covers the loop";
        EXPECT_GE(u1, 12.0 - 1e-9);
    }
}

TEST(FittedOffset, OfSurfacesThatAreNoSplines)
{
    const Handle(Geom_Curve) profile =
        height_surface([](double x, double) { return 1e-3 * x * x; }, 80, 40, 5, 4)->VIso(0.5);
    const Handle(Geom_Surface) turned =
        new Geom_SurfaceOfRevolution(profile, gp_Ax1(gp_Pnt(0.0, 0.0, 150.0), gp_Dir(1.0, 0.0, 0.0)));
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(turned, 0.3, 1.8, 0.1, 0.9, 1e-7);
    for (const double distance : {10.0, -10.0})
        EXPECT_GT(expect_fitted(face, distance, 1e-3), 0);
}

TEST(FittedOffset, ReversedFacesGoTheOtherWay)
{
    for (const double distance : {8.0, -8.0})
        EXPECT_GT(expect_fitted(reversed(dome()), distance, 1e-3), 0);
}

TEST(FittedOffset, JustInsideTheRadiusOfCurvatureIsMade)
{
    RandomCases random;
    for (int i = 0; i < 3; ++i)
    {
        const TopoDS_Face face = whole(random_surface(random, {.spans_u = 2, .spans_v = 2, .height = 3.0}));
        const auto far = offset(face, 1e6, 1e-2);
        ASSERT_FALSE(far.ok());
        const FeasibleRange range = far.failure().feasible_range.value();
        for (const double limit : {range.negative.value(), range.positive.value()})
        {
            const double distance = 0.995 * limit;
            const auto result = offset(face, distance, 1e-2);
            ASSERT_TRUE(result.ok()) << result.failure().message;
            const Deviation d =
                deviation(BRep_Tool::Surface(face), BRep_Tool::Surface(result.value().face()), {}, distance, 60);
            EXPECT_LE(d.largest, 1e-2);
        }
    }
}

TEST(FittedOffset, PastTheRadiusOfCurvatureIsRefusedWithPlaceAndRange)
{
    RandomCases random;
    int refused = 0;
    for (int i = 0; i < 4; ++i)
    {
        const auto surface = random_surface(random, {.height = 6.0, .rational = i % 2 == 1});
        for (const TopoDS_Face &face : {whole(surface), reversed(whole(surface)), located(whole(surface))})
            for (const double distance : {1e3, -1e3})
            {
                const auto result = offset(face, distance, 1e-3);
                ASSERT_FALSE(result.ok());
                const Failure &failure = result.failure();
                EXPECT_EQ(failure.status, Status::CurvatureLimit);
                EXPECT_EQ(failure.stage, Stage::Analysis);
                ASSERT_TRUE(failure.where && failure.feasible_range);
                const double limit =
                    (distance < 0.0 ? failure.feasible_range->negative : failure.feasible_range->positive).value();
                EXPECT_GT(limit * distance, 0.0);
                const gp_Pnt2d uv = failure.where->uv;
                GeomLProp_SLProps local(surface, uv.X(), uv.Y(), 2, 1e-9);
                const double along = face.Orientation() == TopAbs_REVERSED ? -limit : limit;
                const double k = along > 0.0 ? local.MaxCurvature() : local.MinCurvature();
                EXPECT_LE(along * k, 1.0 + 1e-9) << "the limit is past the radius at its place";
                EXPECT_GE(along * k, 0.98) << "the place does not have the radius that is named";
                EXPECT_LT(BRep_Tool::Surface(face)->Value(uv.X(), uv.Y()).Distance(failure.where->point), 1e-9);
                ++refused;
            }
    }
    EXPECT_EQ(refused, 24);
}

TEST(FittedOffset, CanBeCancelled)
{
    OffsetOptions options;
    options.distance = 3.0;
    int calls = 0;
    options.progress = [&calls](double fraction) {
        EXPECT_GE(fraction, 0.0);
        EXPECT_LE(fraction, 1.0);
        ++calls;
        return false;
    };
    const auto result = offset_face(dome(), options);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.failure().status, Status::Cancelled);
    EXPECT_EQ(result.failure().stage, Stage::Surface);
    EXPECT_EQ(calls, 1) << "the work went on after it was told to stop";
}

TEST(FittedOffset, IsTheSameEachTime)
{
    const auto once = offset(dome(), 7.0, 1e-4), again = offset(dome(), 7.0, 1e-4);
    ASSERT_TRUE(once.ok() && again.ok());
    const auto a = spline_of(once.value().face()), b = spline_of(again.value().face());
    ASSERT_EQ(a->NbUPoles(), b->NbUPoles());
    ASSERT_EQ(a->NbVPoles(), b->NbVPoles());
    for (int i = 1; i <= a->NbUPoles(); ++i)
        for (int j = 1; j <= a->NbVPoles(); ++j)
            EXPECT_EQ(a->Pole(i, j).Distance(b->Pole(i, j)), 0.0);
}

TEST(FittedOffset, OfSplineSpheresWithAPole)
{
    // the exact answer is known: the concentric sphere
    for (const auto &surface : {ball(0.5 * M_PI, 0.0, 0.5 * M_PI), ball(0.5 * M_PI, -0.5 * M_PI, 0.0),
                                ball(1.9 * M_PI, -0.5 * M_PI, 0.5 * M_PI)})
        for (const double distance : {20.0, -20.0})
        {
            const TopoDS_Face face = whole(surface);
            const auto result = offset(face, distance, 1e-3);
            ASSERT_TRUE(result.ok()) << result.failure().message;
            const Handle(Geom_Surface) made = BRep_Tool::Surface(result.value().face());
            double u0, u1, v0, v1, worst = 0.0;
            BRepTools::UVBounds(face, u0, u1, v0, v1);
            for (int i = 0; i <= 60; ++i)
                for (int j = 0; j <= 60; ++j)
                {
                    const gp_Pnt p = made->Value(u0 + (u1 - u0) * i / 60, v0 + (v1 - v0) * j / 60);
                    worst = std::max(worst, std::abs(p.Distance(gp_Pnt()) - (50.0 + distance)));
                }
            EXPECT_LE(worst, 1e-3);
        }
}
