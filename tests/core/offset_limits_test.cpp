// SPDX-License-Identifier: LGPL-2.1-or-later
// Feasible distances against surfaces whose radii are known, and against what offset_face makes of them.
#include "support/offsets.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/offset_face.h>
#include <laminate_offset/offset_limits.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GeomConvert.hxx>
#include <GeomConvert_CompCurveToBSplineCurve.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <gp_Pln.hxx>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cmath>

using namespace laminate_offset;
using namespace test_support;

namespace
{

// A stated limit is never past the true one and gives away at most so much of it.
constexpr double given_away = 2e-3;

struct Expected
{
    std::optional<double> negative;
    std::optional<double> positive;
};

Handle(Geom_BSplineSurface) as_spline(const Handle(Geom_Surface) & round, double u0, double u1, double v0, double v1)
{
    return GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(round, u0, u1, v0, v1));
}

void expect_side(const std::optional<OffsetLimit> &limit, const std::optional<double> &expected)
{
    ASSERT_EQ(limit.has_value(), expected.has_value());
    if (!limit)
        return;
    EXPECT_LE(limit->distance / *expected, 1.0 + 1e-12) << limit->distance << " is past " << *expected;
    EXPECT_GE(limit->distance / *expected, 1.0 - given_away) << limit->distance << " falls short of " << *expected;
}

void expect_limits(const TopoDS_Face &face, const Expected &expected)
{
    const Result<OffsetLimits> limits = offset_limits(face);
    ASSERT_TRUE(limits.ok()) << limits.failure().message;
    EXPECT_TRUE(limits.value().proven);
    expect_side(limits.value().negative, expected.negative);
    expect_side(limits.value().positive, expected.positive);
}

//! The limits hold for the face in every position and orientation.
void expect_limits_everywhere(const TopoDS_Face &face, const Expected &expected)
{
    const auto turned = [](const std::optional<double> &side) { return side ? std::optional(-*side) : std::nullopt; };
    expect_limits(face, expected);
    expect_limits(located(face), expected);
    expect_limits(reversed(face), {turned(expected.positive), turned(expected.negative)});
    expect_limits(reversed(located(face)), {turned(expected.positive), turned(expected.negative)});
}

//! The limit's place lies on the face, and one principal radius there is the limit.
void expect_radius_at_place(const TopoDS_Face &face, const std::optional<OffsetLimit> &limit)
{
    ASSERT_TRUE(limit.has_value());
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    const gp_Pnt2d uv = limit->where.uv;
    GeomLProp_SLProps local(surface, uv.X(), uv.Y(), 2, 1e-9);
    EXPECT_LT(local.Value().Distance(limit->where.point), 1e-9);
    const double sign = face.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
    const double nearest = std::min(std::abs(sign * limit->distance * local.MinCurvature() - 1.0),
                                    std::abs(sign * limit->distance * local.MaxCurvature() - 1.0));
    EXPECT_LT(nearest, given_away);
}

//! Just inside the limit the offset is made, just outside it is refused for its curvature.
void expect_sharp(const TopoDS_Face &face, const std::optional<OffsetLimit> &limit)
{
    ASSERT_TRUE(limit.has_value());
    const Result<OffsetResult> inside = offset(face, 0.999 * limit->distance);
    EXPECT_TRUE(inside.ok()) << name(inside.failure().status) << ": " << inside.failure().message;
    const Result<OffsetResult> outside = offset(face, 1.002 * limit->distance);
    ASSERT_FALSE(outside.ok());
    EXPECT_EQ(outside.failure().status, Status::CurvatureLimit) << outside.failure().message;
    EXPECT_TRUE(outside.failure().stage == Stage::Analysis || outside.failure().stage == Stage::Surface);
    EXPECT_TRUE(outside.failure().where.has_value());
}

Handle(Geom_BSplineSurface) saddle()
{
    return height_surface([](double x, double y) { return (x * x - y * y) / 100.0; }, 60.0, 40.0, 3, 3, 2);
}

} // namespace

TEST(OffsetLimits, OfAnalyticFacesAreTheirClosedForms)
{
    const auto face = [](const Handle(Geom_Surface) & surface, double u0, double u1, double v0, double v1) {
        return BRepBuilderAPI_MakeFace(surface, u0, u1, v0, v1, 1e-7).Face();
    };
    expect_limits_everywhere(face(new Geom_Plane(gp_Pln()), 0, 10, 0, 10), {});
    expect_limits_everywhere(face(new Geom_CylindricalSurface(gp_Ax3(), 7.0), 0, 2, 0, 30), {-7.0, std::nullopt});
    expect_limits_everywhere(face(new Geom_SphericalSurface(gp_Ax3(), 40.0), 0, 2, -0.5, 0.5), {-40.0, std::nullopt});
    const Handle(Geom_Surface) torus = new Geom_ToroidalSurface(gp_Ax3(), 30.0, 8.0);
    expect_limits_everywhere(face(torus, 0, 2, 0.75 * M_PI, 1.25 * M_PI), {-8.0, 22.0});
    expect_limits_everywhere(face(torus, 0, 2, -0.25 * M_PI, 0.25 * M_PI), {-8.0, std::nullopt});
    // the cone's tight end has the radius 5, its normal is inclined by the half angle
    const Handle(Geom_Surface) cone = new Geom_ConicalSurface(gp_Ax3(), 0.3, 5.0);
    expect_limits_everywhere(face(cone, 0, 2, 0, 30), {-5.0 / std::cos(0.3), std::nullopt});
}

TEST(OffsetLimits, OfRoundSplinesAreTheirRadii)
{
    const auto face = [](const Handle(Geom_Surface) & surface, double u0, double u1, double v0, double v1) {
        return BRepBuilderAPI_MakeFace(as_spline(surface, u0, u1, v0, v1), 1e-7).Face();
    };
    expect_limits_everywhere(face(new Geom_SphericalSurface(gp_Ax3(), 40.0), 0.1, 1.3, -0.5, 0.9),
                             {-40.0, std::nullopt});
    expect_limits_everywhere(face(new Geom_CylindricalSurface(gp_Ax3(), 7.0), 0.1, 1.3, 0.0, 30.0),
                             {-7.0, std::nullopt});
    const Handle(Geom_Surface) torus = new Geom_ToroidalSurface(gp_Ax3(), 30.0, 8.0);
    expect_limits_everywhere(face(torus, 0.2, 1.4, 0.75 * M_PI, 1.25 * M_PI), {-8.0, 22.0});
    expect_limits_everywhere(face(torus, 0.2, 1.4, -0.25 * M_PI, 0.25 * M_PI), {-8.0, std::nullopt});
}

TEST(OffsetLimits, OfASaddleAreTheRadiiOfItsParabolas)
{
    // the poles make z = (x^2 - y^2) / 200: curvatures +-1/100 at the origin, smaller ones everywhere else
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(saddle(), 1e-7);
    expect_limits_everywhere(face, {-100.0, 100.0});
    const Result<OffsetLimits> limits = offset_limits(face);
    ASSERT_TRUE(limits.ok());
    EXPECT_LT(limits.value().positive->where.point.Distance(gp_Pnt(0, 0, 0)), 3.0);
    EXPECT_LT(limits.value().negative->where.point.Distance(gp_Pnt(0, 0, 0)), 3.0);
}

TEST(OffsetLimits, AreSharp)
{
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(saddle(), 1e-7);
    const TopoDS_Face ring =
        BRepBuilderAPI_MakeFace(as_spline(new Geom_ToroidalSurface(gp_Ax3(), 30.0, 8.0), 0.2, 1.4, 2.4, 3.9), 1e-7);
    for (const TopoDS_Face &each : {face, reversed(face), located(ring)})
    {
        const Result<OffsetLimits> limits = offset_limits(each);
        ASSERT_TRUE(limits.ok());
        expect_sharp(each, limits.value().negative);
        expect_sharp(each, limits.value().positive);
    }
}

TEST(OffsetLimits, OfRandomSurfacesAreAttainedWhereTheySay)
{
    RandomCases random;
    for (int i = 0; i < 8; ++i)
    {
        SCOPED_TRACE(i);
        const auto surface = random_surface(random, {.spans_u = 2 + i % 4, .height = 6.0, .rational = i % 2 == 1});
        TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, 1e-7);
        if (i % 3 == 0)
            face = reversed(face);
        const Result<OffsetLimits> limits = offset_limits(face);
        ASSERT_TRUE(limits.ok());
        EXPECT_TRUE(limits.value().proven);
        ASSERT_TRUE(limits.value().negative && limits.value().positive);
        EXPECT_LT(limits.value().negative->distance, 0.0);
        EXPECT_GT(limits.value().positive->distance, 0.0);
        expect_radius_at_place(face, limits.value().negative);
        expect_radius_at_place(face, limits.value().positive);
    }
}

TEST(OffsetLimits, OfATurnedOffsetCurveSayThatTheyAreSampled)
{
    const Handle(Geom_Curve) profile = new Geom_Ellipse(gp_Ax2(gp_Pnt(30, 0, 0), -gp::DY(), gp::DX()), 9.0, 8.0);
    const Handle(Geom_Curve) beside = new Geom_OffsetCurve(profile, 2.0, gp::DY());
    const Handle(Geom_Surface) surface = new Geom_SurfaceOfRevolution(beside, gp::OZ());
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, 0, 1, 0.1, 1.2, 1e-7);
    const Result<OffsetLimits> limits = offset_limits(face);
    ASSERT_TRUE(limits.ok());
    EXPECT_FALSE(limits.value().proven);
}

TEST(OffsetLimits, RefuseWhatIsNoFace)
{
    const Result<OffsetLimits> nothing = offset_limits(TopoDS_Shape());
    ASSERT_FALSE(nothing.ok());
    EXPECT_EQ(nothing.failure().status, Status::NullShape);
    EXPECT_EQ(nothing.failure().stage, Stage::Input);
}

//! An arc in the plane y = 0 that sinks from its ends, as a spline.
Handle(Geom_BSplineCurve) arc(double from, double to, double radius, bool hollow)
{
    const double half = 0.5 * (to - from), height = std::sqrt(radius * radius - half * half);
    const double side = hollow ? 1.0 : -1.0;
    const gp_Pnt deepest(from + half, 0.0, side * (height - radius));
    return GeomConvert::CurveToBSplineCurve(GC_MakeArcOfCircle(gp_Pnt(from, 0, 0), deepest, gp_Pnt(to, 0, 0)).Value());
}

//! The limits of the creased face are the tighter ones of two faces that are its parts.
void expect_tightest(const TopoDS_Face &creased, const TopoDS_Face &first, const TopoDS_Face &second)
{
    const auto tighter = [](const std::optional<OffsetLimit> &a, const std::optional<OffsetLimit> &b) {
        if (!a || !b)
            return a ? std::optional(a->distance) : b ? std::optional(b->distance) : std::nullopt;
        return std::optional(std::abs(a->distance) < std::abs(b->distance) ? a->distance : b->distance);
    };
    const Result<OffsetLimits> one = offset_limits(first), other = offset_limits(second);
    ASSERT_TRUE(one.ok() && other.ok());
    const auto near = [](const std::optional<OffsetLimit> &limit, const std::optional<double> &wanted) {
        ASSERT_EQ(limit.has_value(), wanted.has_value());
        if (!wanted)
            return;
        EXPECT_NEAR(limit->distance / *wanted, 1.0, 2.0 * given_away);
    };
    const Result<OffsetLimits> whole = offset_limits(creased);
    ASSERT_TRUE(whole.ok()) << whole.failure().message;
    EXPECT_TRUE(whole.value().proven);
    near(whole.value().negative, tighter(one.value().negative, other.value().negative));
    near(whole.value().positive, tighter(one.value().positive, other.value().positive));
}

TEST(OffsetLimits, OfACreasedFaceAreTheTightestOfItsParts)
{
    const gp_Ax1 axis(gp_Pnt(-60, 0, 0), gp_Dir(0, 0, 1));
    for (const double radius : {11.0, 25.0, 80.0})
        for (const bool hollow : {true, false})
        {
            SCOPED_TRACE(testing::Message() << "second radius " << radius << " hollow " << hollow);
            const Handle(Geom_BSplineCurve) first = arc(0.0, 30.0, 40.0, true),
                                            second = arc(30.0, 50.0, radius, hollow);
            GeomConvert_CompCurveToBSplineCurve both(first);
            ASSERT_TRUE(both.Add(second, 1e-9, true));
            const auto extruded = [](const Handle(Geom_Curve) & profile) {
                const Handle(Geom_Surface) sweep = new Geom_SurfaceOfLinearExtrusion(profile, gp::DY());
                return TopoDS_Face(BRepBuilderAPI_MakeFace(sweep, profile->FirstParameter(), profile->LastParameter(),
                                                           0.0, 70.0, 1e-7));
            };
            const auto revolved = [&](const Handle(Geom_Curve) & profile) {
                const Handle(Geom_Surface) sweep = new Geom_SurfaceOfRevolution(profile, axis);
                return TopoDS_Face(BRepBuilderAPI_MakeFace(sweep, 0.2, 2.0, profile->FirstParameter(),
                                                           profile->LastParameter(), 1e-7));
            };
            const auto spline = [&](const Handle(Geom_Curve) & profile) {
                return TopoDS_Face(
                    BRepBuilderAPI_MakeFace(GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(
                                                BRep_Tool::Surface(revolved(profile)), 0.2, 2.0,
                                                profile->FirstParameter(), profile->LastParameter())),
                                            1e-7));
            };
            ASSERT_EQ(both.BSplineCurve()->Continuity(), GeomAbs_C0);
            expect_tightest(extruded(both.BSplineCurve()), extruded(first), extruded(second));
            expect_tightest(revolved(both.BSplineCurve()), revolved(first), revolved(second));
            expect_tightest(spline(both.BSplineCurve()), spline(first), spline(second));
        }
}

TEST(OffsetLimits, OfManyFacetsAreFoundWithoutSplittingThem)
{
    // each facet is a twisted quadrilateral, straight along its sides: its largest curvature is near a corner
    const auto waves = [](double x, double y) { return 0.3 * std::sin(0.7 * x) * std::cos(0.9 * y); };
    constexpr int poles = 120;
    const auto surface = height_surface(waves, poles - 1.0, poles - 1.0, poles, poles, 1);
    const TopoDS_Face sheet = BRepBuilderAPI_MakeFace(surface, 1e-7);
    const Result<OffsetLimits> limits = offset_limits(sheet);
    ASSERT_TRUE(limits.ok()) << limits.failure().message;
    ASSERT_TRUE(limits.value().negative && limits.value().positive);
    double highest = 0.0, lowest = 0.0;
    for (int i = 0; i + 1 < poles; ++i)
        for (int j = 0; j + 1 < poles; ++j)
            for (int k = 0; k < 25; ++k)
            {
                GeomLProp_SLProps local(surface, (i + 0.01 + 0.245 * (k % 5)) / (poles - 1.0),
                                        (j + 0.01 + 0.245 * (k / 5)) / (poles - 1.0), 2, 1e-12);
                highest = std::max(highest, local.MaxCurvature());
                lowest = std::min(lowest, local.MinCurvature());
            }
    ASSERT_GT(highest, 0.1);
    ASSERT_LT(lowest, -0.1);
    EXPECT_LE(limits.value().positive->distance * highest, 1.0 + 1e-9);
    EXPECT_LE(limits.value().negative->distance * lowest, 1.0 + 1e-9);
    EXPECT_GE(limits.value().positive->distance * highest, 0.98) << "sampled at 25 places a facet";
    EXPECT_GE(limits.value().negative->distance * lowest, 0.98);
}

TEST(OffsetLimits, OfAReportAreOfUseOnBothSides)
{
    // rough ground of thousands of pieces, gentle ground, and a tube: the limits are a by-product of one distance here
    const auto rough = [](double x, double y) { return 2.0 * std::sin(1.3 * x) * std::cos(1.1 * y + 0.05 * x * x); };
    const auto gentle = [](double x, double y) { return 3.0 * std::sin(0.05 * x) * std::cos(0.06 * y); };
    const Handle(Geom_Surface) grounds[] = {height_surface(rough, 60.0, 50.0, 70, 60), saddle(),
                                            height_surface(gentle, 200.0, 150.0, 12, 10), wavy_tube(30.0)};
    for (const Handle(Geom_Surface) & ground : grounds)
    {
        const TopoDS_Face face = BRepBuilderAPI_MakeFace(ground, 1e-7);
        const Result<OffsetLimits> limits = offset_limits(face);
        ASSERT_TRUE(limits.ok()) << limits.failure().message;
        ASSERT_TRUE(limits.value().negative && limits.value().positive);
        for (const double part : {0.02, 0.5})
            for (const double side : {limits.value().negative->distance, limits.value().positive->distance})
            {
                SCOPED_TRACE(testing::Message() << ground->DynamicType()->Name() << " " << part * side);
                const Result<OffsetResult> made = offset(face, part * side, 0.05);
                ASSERT_TRUE(made.ok()) << made.failure().message;
                ASSERT_TRUE(made.value().report.limits);
                const FeasibleRange &told = *made.value().report.limits;
                ASSERT_TRUE(told.negative && told.positive);
                EXPECT_GE(*told.negative / limits.value().negative->distance, 0.45);
                EXPECT_GE(*told.positive / limits.value().positive->distance, 0.45);
                EXPECT_LE(*told.negative / limits.value().negative->distance, 1.0 + given_away);
                EXPECT_LE(*told.positive / limits.value().positive->distance, 1.0 + given_away);
            }
    }
}

TEST(OffsetLimits, InJsonHaveTheDocumentedForm)
{
    const TopoDS_Face pipe = BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(), 7.0), 0, 2, 0, 30, 1e-7);
    const auto json = to_json(offset_limits(pipe));
    EXPECT_EQ(json["status"], "ok");
    EXPECT_EQ(json["stage"], "analysis");
    EXPECT_TRUE(json["where"].is_null());
    EXPECT_TRUE(json["proven"].get<bool>());
    EXPECT_EQ(json["negative"]["distance"].get<double>(), -7.0);
    EXPECT_EQ(json["negative"]["where"].size(), 5u);
    EXPECT_TRUE(json["positive"].is_null());
    const auto refused = to_json(offset_limits(TopoDS_Shape()));
    EXPECT_EQ(refused["status"], "null-shape");
    EXPECT_EQ(refused["stage"], "input");
    EXPECT_EQ(refused.size(), json.size());
    EXPECT_TRUE(refused["proven"].is_null() && refused["negative"].is_null() && refused["where"].is_null());
}
