// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces on offset surfaces, however nested: their offset is one offset of the basis. And distances of nothing or
// next to nothing, which a tolerance must not swallow.
#include "support/deviation.h"
#include "support/offset_oracle.h"
#include "support/offsets.h"
#include "support/sample_faces.h"

#include <laminate_offset/offset_limits.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>

#include <gtest/gtest.h>

#include <cmath>

using namespace laminate_offset;
using namespace test_support;

namespace
{

Handle(Geom_BSplineSurface) panel()
{
    return height_surface(
        [](double x, double y) { return 1e-3 * (x * x - 0.5 * y * y) + 0.02 * std::sin(0.1 * x * y); }, 100.0, 80.0, 8,
        7);
}

Handle(Geom_Surface) off(const Handle(Geom_Surface) & basis, double distance)
{
    return new Geom_OffsetSurface(basis, distance);
}

Handle(Geom_Surface) trimmed(const Handle(Geom_Surface) & basis, const Rectangle &r)
{
    return new Geom_RectangularTrimmedSurface(basis, r.u0, r.u1, r.v0, r.v1);
}

TopoDS_Face face_on(const Handle(Geom_Surface) & surface, const Rectangle &r)
{
    return BRepBuilderAPI_MakeFace(surface, r.u0, r.u1, r.v0, r.v1, 1e-7);
}

//! The offset is made, and lies where one offset of the basis by the sum of both distances does.
void expect_one_offset(const TopoDS_Face &face, const Handle(Geom_Surface) & basis, const Rectangle &r,
                       double base_distance, double distance, double tolerance, const std::string &type)
{
    SCOPED_TRACE(testing::Message() << base_distance << " then " << distance);
    const auto result = offset(face, distance, tolerance);
    ASSERT_TRUE(result.ok()) << why(result);
    const OffsetReport &report = result.value().report;
    EXPECT_EQ(report.surface->type, type);
    EXPECT_EQ(report.distance, distance);
    ASSERT_TRUE(report.certified_error.has_value() && report.edge_error.has_value());
    EXPECT_LE(*report.certified_error, tolerance);
    EXPECT_LE(*report.edge_error, tolerance);
    const double along = face.Orientation() == TopAbs_REVERSED ? -distance : distance;
    const Handle(Geom_Surface) made = BRep_Tool::Surface(result.value().face());
    EXPECT_FALSE(made->IsKind(STANDARD_TYPE(Geom_OffsetSurface)));
    const Deviation d = deviation(basis, made, r, base_distance + along, 41);
    EXPECT_GT(d.points, 1000);
    EXPECT_LE(d.largest, *report.certified_error);
    EXPECT_TRUE(confirms(measure_offset(face, result.value().face(), distance, {25, 25}), tolerance + 1e-6));
}

const Rectangle unit{0.0, 1.0, 0.0, 1.0};

} // namespace

TEST(BaseDistance, OfASplineAddsUp)
{
    const auto basis = panel();
    for (const double base_distance : {-6.0, 4.0, 1e-5})
        for (const double distance : {-5.0, 0.0, 3.0})
        {
            const TopoDS_Face face = face_on(off(basis, base_distance), unit);
            expect_one_offset(face, basis, unit, base_distance, distance, 1e-3, "bspline");
            expect_one_offset(reversed(face), basis, unit, base_distance, distance, 1e-3, "bspline");
        }
}

TEST(BaseDistance, OfAnAnalyticSurfaceStaysAnalytic)
{
    const gp_Ax3 axes(gp_Pnt(12.0, -7.0, 30.0), gp_Dir(0.2, -0.3, 1.0), gp_Dir(1.0, 0.4, 0.0));
    const Rectangle flat{-4, 6, -3, 5}, round{0.3, 2.0, -0.9, 1.1};
    for (const double base_distance : {-2.0, 3.0})
        for (const double distance : {-4.0, 5.0})
        {
            const auto check = [&](const Handle(Geom_Surface) & basis, const Rectangle &r, const std::string &type) {
                expect_one_offset(face_on(off(basis, base_distance), r), basis, r, base_distance, distance, 1e-5, type);
            };
            check(new Geom_Plane(axes), flat, "plane");
            check(new Geom_CylindricalSurface(axes, 9.0), round, "cylinder");
            check(new Geom_SphericalSurface(axes, 15.0), round, "sphere");
            check(new Geom_ToroidalSurface(axes, 40.0, 11.0), round, "torus");
            check(new Geom_ConicalSurface(axes, 0.4, 12.0), round, "cone");
        }
}

TEST(BaseDistance, MayBeNestedWithTrims)
{
    const auto basis = panel();
    const Rectangle inner{0.1, 0.9, 0.05, 0.95}, innermost{0.2, 0.8, 0.1, 0.7};
    const Handle(Geom_Surface) nested = trimmed(off(trimmed(off(trimmed(basis, inner), 2.0), inner), -5.0), innermost);
    expect_one_offset(face_on(nested, innermost), basis, innermost, -3.0, 4.5, 1e-3, "bspline");
    const Handle(Geom_Surface) pipe = new Geom_CylindricalSurface(gp_Ax3(), 10.0);
    const Rectangle part{0.5, 2.0, -4.0, 6.0};
    const Handle(Geom_Surface) nested_pipe = off(trimmed(off(trimmed(pipe, part), 2.0), part), 1.0);
    expect_one_offset(face_on(nested_pipe, part), pipe, part, 3.0, -7.0, 1e-5, "cylinder");
}

TEST(BaseDistance, ThereAndBackIsTheBasisItself)
{
    const auto basis = panel();
    const auto result = offset(face_on(off(basis, 7.0), unit), -7.0, 1e-6);
    ASSERT_TRUE(result.ok()) << why(result);
    EXPECT_LE(*result.value().report.certified_error, 1e-10);
    const auto made = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(result.value().face()));
    ASSERT_FALSE(made.IsNull());
    EXPECT_EQ(made->NbUPoles() * made->NbVPoles(), 56);
    EXPECT_LE(deviation(basis, made, unit, 0.0, 41).largest, 1e-11);
}

TEST(BaseDistance, ShiftsTheLimits)
{
    const Handle(Geom_Surface) pipe = new Geom_CylindricalSurface(gp_Ax3(), 10.0);
    const Rectangle part{0.5, 2.0, -4.0, 6.0};
    const Handle(Geom_BSplineSurface) written = GeomConvert::SurfaceToBSplineSurface(
        new Geom_RectangularTrimmedSurface(new Geom_SphericalSurface(gp_Ax3(), 10.0), 0.3, 2.0, -0.9, 1.1));
    for (const TopoDS_Face &face : {face_on(off(pipe, 4.0), part), face_on(off(written, 4.0), {0.4, 1.9, -0.8, 1.0})})
    {
        const auto limits = offset_limits(face), turned = offset_limits(reversed(face));
        ASSERT_TRUE(limits.ok() && turned.ok());
        ASSERT_TRUE(limits.value().negative && turned.value().positive);
        EXPECT_NEAR(limits.value().negative->distance, -14.0, 0.02);
        EXPECT_NEAR(turned.value().positive->distance, 14.0, 0.02);
        EXPECT_FALSE(limits.value().positive || turned.value().negative);
        const auto folded = offset(face, -14.5);
        ASSERT_FALSE(folded.ok());
        EXPECT_EQ(folded.failure().status, Status::CurvatureLimit) << why(folded);
        ASSERT_TRUE(folded.failure().feasible_range && folded.failure().where);
        EXPECT_NEAR(*folded.failure().feasible_range->negative, -14.0, 0.1);
        EXPECT_NEAR(folded.failure().where->point.XYZ().Modulus(), 14.0, 8.0) << "the place lies on the face";
        EXPECT_NE(folded.failure().message.find("-14.5"), std::string::npos) << "the user's distance is named";
        const auto made = offset(face, -13.5);
        EXPECT_TRUE(made.ok()) << why(made);
    }
}

TEST(BaseDistance, ThatFoldsTheBaseIsRefused)
{
    const Handle(Geom_BSplineSurface) written = GeomConvert::SurfaceToBSplineSurface(
        new Geom_RectangularTrimmedSurface(new Geom_SphericalSurface(gp_Ax3(), 10.0), 0.3, 2.0, -0.9, 1.1));
    const TopoDS_Face face = face_on(off(written, -13.0), {0.4, 1.9, -0.8, 1.0});
    for (const double distance : {-1.0, 1.0, 5.0})
    {
        const auto result = offset(face, distance);
        ASSERT_FALSE(result.ok());
        EXPECT_EQ(result.failure().status, Status::CurvatureLimit) << why(result);
        EXPECT_EQ(result.failure().stage, Stage::Analysis);
        EXPECT_TRUE(result.failure().where.has_value());
    }
    EXPECT_FALSE(offset_limits(face).ok());
}

TEST(BaseDistance, OnAWholeBallWithPolesIsRead)
{
    const Handle(Geom_BSplineSurface) ball = GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(
        new Geom_SphericalSurface(gp_Ax3(), 10.0), 0.0, 2.0 * M_PI, -M_PI_2, M_PI_2));
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(ball, 1e-7);
    const auto there = offset(face, 3.0);
    ASSERT_TRUE(there.ok()) << why(there);
    const TopoDS_Face bigger = BRepBuilderAPI_MakeFace(off(ball, 3.0), 1e-7);
    const auto result = offset(bigger, -5.0);
    ASSERT_TRUE(result.ok()) << why(result);
    const Rectangle between_poles{0.0, 2.0 * M_PI, -1.57, 1.57};
    const Handle(Geom_Surface) made = BRep_Tool::Surface(result.value().face());
    EXPECT_LE(deviation(ball, made, between_poles, -2.0, 41).largest, 1e-3);
}

TEST(DistanceZero, GivesTheBaseItself)
{
    TColgp_Array2OfPnt poles(1, 3, 1, 2);
    for (int i = 1; i <= 3; ++i)
        for (int j = 1; j <= 2; ++j)
            poles(i, j) = gp_Pnt(10 * i, 15 * j, i == 2 ? 6 : 0);
    const Handle(Geom_Surface) arch = new Geom_SurfaceOfRevolution(
        new Geom_Ellipse(gp_Ax2(gp_Pnt(30, 0, 0), -gp::DY(), gp::DX()), 9.0, 8.0), gp::OZ());
    const Handle(Geom_Surface) bezier = new Geom_BezierSurface(poles);
    const std::pair<TopoDS_Face, const char *> cases[] = {{face_on(panel(), unit), "bspline"},
                                                          {face_on(panel(), {0.2, 0.4, 0.1, 0.6}), "bspline"},
                                                          {panel_with_hole(), "bspline"},
                                                          {face_on(bezier, unit), "bspline"},
                                                          {face_on(arch, {0, 1, 0.1, 1.2}), "revolution"}};
    for (const auto &[face, type] : cases)
    {
        SCOPED_TRACE(type);
        const auto result = offset(face, 0.0, 1e-9 * 1e3);
        ASSERT_TRUE(result.ok()) << why(result);
        EXPECT_EQ(result.value().report.surface->type, type);
        EXPECT_LE(*result.value().report.certified_error, 1e-10);
        Rectangle r;
        BRepTools::UVBounds(face, r.u0, r.u1, r.v0, r.v1);
        const Handle(Geom_Surface) made = BRep_Tool::Surface(result.value().face());
        EXPECT_LE(deviation(BRep_Tool::Surface(face), made, r, 0.0, 41).largest, 1e-11);
        EXPECT_NE(made, BRep_Tool::Surface(face)) << "a copy, so that nothing is shared with the base";
        EXPECT_TRUE(confirms(measure_offset(face, result.value().face(), 0.0, {25, 25}), 1e-6));
    }
}

TEST(DistanceBelowTheTolerance, IsStillAnOffsetWithinIt)
{
    const TopoDS_Face faces[] = {face_on(panel(), unit), panel_with_hole(), sphere_patch(40.0)};
    int base_kept = 0;
    for (const TopoDS_Face &face : faces)
        for (const double part : {1e-9, 1e-3, 0.2, 0.5, 0.8, 0.95, 1.0, 1.5})
            for (const double sign : {-1.0, 1.0})
            {
                const double tolerance = 1e-3, distance = sign * part * tolerance;
                SCOPED_TRACE(testing::Message() << "distance " << distance);
                const auto result = offset(face, distance, tolerance);
                ASSERT_TRUE(result.ok()) << why(result);
                const OffsetReport &report = result.value().report;
                ASSERT_TRUE(report.certified_error.has_value());
                EXPECT_LE(*report.certified_error, tolerance);
                EXPECT_TRUE(confirms(measure_offset(face, result.value().face(), distance, {25, 25}), tolerance));
                Rectangle r;
                BRepTools::UVBounds(face, r.u0, r.u1, r.v0, r.v1);
                const Handle(Geom_Surface) base = BRep_Tool::Surface(face),
                                           made = BRep_Tool::Surface(result.value().face());
                const double found = deviation(base, made, r, distance, 41).largest;
                EXPECT_LE(found, *report.certified_error);
                base_kept += !report.sampled_error && report.surface->type == "bspline" ? 1 : 0;
                const auto spline = Handle(Geom_BSplineSurface)::DownCast(base);
                if (!spline.IsNull() && part < 0.9)
                {
                    EXPECT_LE(report.surface->poles_u * report.surface->poles_v,
                              spline->NbUPoles() * spline->NbVPoles());
                }
            }
    EXPECT_GT(base_kept, 5);
}
