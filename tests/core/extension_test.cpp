// SPDX-License-Identifier: LGPL-2.1-or-later
// Extended curves and faces against their closed forms: lines, circles, planes, cylinders, spheres.
#include "support/data_files.h"
#include "support/offsets.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/extend_face.h>
#include <laminate_offset/extension/extend_curve.h>
#include <laminate_offset/offset_face.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GProp_GProps.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>

#include <gtest/gtest.h>

#include <cmath>

using namespace laminate_offset;
using namespace test_support;

namespace
{

constexpr double largest_join_angle = 1e-9;
const std::vector<Side> every_side{all_sides.begin(), all_sides.end()};

double area(const TopoDS_Shape &shape)
{
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(shape, properties, 1e-9);
    return properties.Mass();
}

ExtensionOptions by(double length, std::vector<Side> sides = every_side, Continuity continuity = Continuity::G1,
                    LengthRule rule = LengthRule::Mean)
{
    ExtensionOptions options;
    options.length = length;
    options.sides = std::move(sides);
    options.continuity = continuity;
    options.rule = rule;
    return options;
}

void expect_sides(const ExtensionReport &report, double length, std::size_t count)
{
    ASSERT_EQ(report.sides.size(), count);
    for (const ExtendedSide &side : report.sides)
    {
        EXPECT_NEAR(side.mean_length, length, 1e-6 * length) << name(side.side);
        EXPECT_LE(side.shortest, side.mean_length * (1 + 1e-12));
        EXPECT_GE(side.longest, side.mean_length * (1 - 1e-12));
        EXPECT_LT(side.join_angle, largest_join_angle) << name(side.side);
    }
}

void expect_refused(const TopoDS_Shape &face, const ExtensionOptions &options, Status status, Stage stage)
{
    const auto result = extend_face(face, options);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.failure().status, status) << result.failure().message;
    EXPECT_EQ(result.failure().stage, stage);
    EXPECT_FALSE(result.failure().message.empty());
    EXPECT_TRUE(stage == Stage::Options || result.failure().where.has_value());
}

TopoDS_Face face_on(const Handle(Geom_Surface) & surface, double u0, double u1, double v0, double v1)
{
    return BRepBuilderAPI_MakeFace(surface, u0, u1, v0, v1, 1e-7).Face();
}

TopoDS_Face spline_face_on(const Handle(Geom_Surface) & surface, double u0, double u1, double v0, double v1)
{
    const Handle(Geom_Surface) trimmed = new Geom_RectangularTrimmedSurface(surface, u0, u1, v0, v1);
    return BRepBuilderAPI_MakeFace(GeomConvert::SurfaceToBSplineSurface(trimmed), 1e-7).Face();
}

TopoDS_Face panel()
{
    const auto surface = height_surface([](double x, double y) { return 30.0 * std::sin(x / 90.0) + y * y / 900.0; },
                                        300.0, 200.0, 9, 7);
    return BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
}

int edges_of(const TopoDS_Shape &shape)
{
    int count = 0;
    for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next())
        ++count;
    return count;
}

Handle(Geom_BSplineCurve) arc(double radius, double angle)
{
    const Handle(Geom_Curve) circle = new Geom_Circle(gp_Ax2(), radius);
    return GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(circle, 0.0, angle));
}

double length_of(const Handle(Geom_Curve) & curve, double from, double to)
{
    return std::abs(GCPnts_AbscissaPoint::Length(GeomAdaptor_Curve(curve), from, to, 1e-10));
}

//! Tangent directions on both sides of the join, one from the curve before.
double angle_at_join(const Handle(Geom_Curve) & before, const Handle(Geom_Curve) & after, double join, double past)
{
    const double step = 1e-12 * past; // to the far side of a knot
    return before->DN(join, 1).Angle(after->DN(join + step, 1));
}

} // namespace

TEST(ExtendCurve, MirrorsAnArcIntoALongerArc)
{
    for (const double radius : {1e-2, 10.0, 1e5})
        for (const bool at_end : {true, false})
            for (const double share : {1e-3, 0.3, 1.4})
            {
                const Handle(Geom_BSplineCurve) curve = arc(radius, 1.1);
                const double length = share * radius;
                const auto made = extend_curve(curve, length, at_end, CurveExtension::Mirrored);
                ASSERT_TRUE(made.ok()) << made.failure().message;
                const Handle(Geom_BSplineCurve) longer = made.value();
                const double join = at_end ? curve->LastParameter() : curve->FirstParameter();
                const double end = at_end ? longer->LastParameter() : longer->FirstParameter();
                EXPECT_NEAR(length_of(longer, join, end), length, 1e-7 * length);
                for (int i = 0; i <= 40; ++i)
                {
                    const double t =
                        longer->FirstParameter() + (longer->LastParameter() - longer->FirstParameter()) * i / 40.0;
                    EXPECT_NEAR(longer->Value(t).Distance(gp_Pnt()), radius, 1e-11 * radius);
                }
                EXPECT_LT(angle_at_join(curve, longer, join, end - join), largest_join_angle);
            }
}

TEST(ExtendCurve, GoesOnStraightByTheFormulasOfThePaper)
{
    for (const bool at_end : {true, false})
        for (const double length : {1e-4, 3.0, 500.0})
        {
            const Handle(Geom_BSplineCurve) curve = arc(10.0, 1.1);
            const auto made = extend_curve(curve, length, at_end, CurveExtension::Straight);
            ASSERT_TRUE(made.ok()) << made.failure().message;
            const Handle(Geom_BSplineCurve) longer = made.value();
            const double join = at_end ? curve->LastParameter() : curve->FirstParameter();
            const double end = at_end ? longer->LastParameter() : longer->FirstParameter();
            const gp_Vec tangent = (at_end ? 1.0 : -1.0) * curve->DN(join, 1).Normalized();
            EXPECT_LT(longer->Value(end).Distance(curve->Value(join).Translated(length * tangent)),
                      1e-10 * length + 1e-12);
            EXPECT_NEAR(length_of(longer, join, end), length, 1e-9 * length + 1e-12);
            EXPECT_NEAR(std::abs(end - join), straight_increment(*curve, join, length), 1e-9 * std::abs(end - join));
            EXPECT_LT(angle_at_join(curve, longer, join, end - join), largest_join_angle);
        }
}

TEST(ExtendCurve, NaturalContinuationIsThePolynomialItself)
{
    // a parabola over two spans goes on as the same parabola
    TColgp_Array1OfPnt poles(1, 3);
    poles(1) = gp_Pnt(0, 0, 0);
    poles(2) = gp_Pnt(5, 0, 0);
    poles(3) = gp_Pnt(10, 10, 0); // y = x^2 / 10
    TColStd_Array1OfReal knots(1, 2);
    knots(1) = 0.0;
    knots(2) = 1.0;
    TColStd_Array1OfInteger multiplicities(1, 2);
    multiplicities.Init(3);
    const Handle(Geom_BSplineCurve) curve = new Geom_BSplineCurve(poles, knots, multiplicities, 2);
    curve->InsertKnot(0.4);
    for (const bool at_end : {true, false})
    {
        const auto made = extend_curve(curve, 7.0, at_end, CurveExtension::Natural);
        ASSERT_TRUE(made.ok()) << made.failure().message;
        const Handle(Geom_BSplineCurve) longer = made.value();
        EXPECT_EQ(longer->NbPoles(), curve->NbPoles());
        for (int i = 0; i <= 20; ++i)
        {
            const double t = longer->FirstParameter() + (longer->LastParameter() - longer->FirstParameter()) * i / 20.0;
            const gp_Pnt p = longer->Value(t);
            EXPECT_NEAR(p.Y(), 0.1 * p.X() * p.X(), 1e-11);
        }
    }
}

TEST(ExtendCurve, RefusesClosedCurvesAndBadLengths)
{
    const Handle(Geom_BSplineCurve) ring = GeomConvert::CurveToBSplineCurve(new Geom_Circle(gp_Ax2(), 5.0));
    const auto closed = extend_curve(ring, 1.0, true, CurveExtension::Mirrored);
    ASSERT_FALSE(closed.ok());
    EXPECT_EQ(closed.failure().status, Status::SelfIntersection);
    for (const double length : {0.0, -1.0, std::nan("")})
        EXPECT_FALSE(extend_curve(arc(5.0, 1.0), length, true, CurveExtension::Straight).ok());
}

TEST(ExtendFace, GrowsAPlaneExactly)
{
    for (const double length : {1e-3, 1.0, 25.0, 4000.0})
    {
        const auto result = extend_face(located(face_on(new Geom_Plane(gp_Pln()), 0, 30, 0, 20)), by(length));
        ASSERT_TRUE(result.ok()) << result.failure().message;
        expect_sides(result.value().report, length, 4);
        const double expected = (30.0 + 2 * length) * (20.0 + 2 * length);
        EXPECT_NEAR(area(result.value().face), expected, 1e-7 * expected);
        EXPECT_EQ(edges_of(result.value().face), 4);
    }
}

TEST(ExtendFace, KeepsCylindersAndSpheresThatAreSplines)
{
    const TopoDS_Face tube = spline_face_on(new Geom_CylindricalSurface(gp_Ax3(), 50.0), 0.2, 1.7, 0.0, 80.0);
    const TopoDS_Face cap = spline_face_on(new Geom_SphericalSurface(gp_Ax3(), 50.0), 0.2, 1.2, -0.4, 0.5);
    for (const Side side : every_side)
        for (const double length : {0.01, 1.0, 20.0})
        {
            const auto grown = extend_face(tube, by(length, {side}));
            ASSERT_TRUE(grown.ok()) << grown.failure().message;
            expect_sides(grown.value().report, length, 1);
            const bool round = side == Side::UMin || side == Side::UMax;
            const double expected = area(tube) + length * (round ? 80.0 : 75.0);
            EXPECT_NEAR(area(grown.value().face), expected, 1e-6 * expected) << name(side);
            const auto larger = extend_face(cap, by(length, {side}));
            ASSERT_TRUE(larger.ok()) << larger.failure().message;
            expect_sides(larger.value().report, length, 1);
        }
}

TEST(ExtendFace, GrowsAFreeFormPanelOnEverySide)
{
    const TopoDS_Face face = panel();
    for (const TopoDS_Face &each : {face, reversed(face), located(face)})
        for (const Continuity continuity : {Continuity::G1, Continuity::Natural})
            for (const double length : {0.1, 5.0, 20.0})
            {
                const auto result = extend_face(each, by(length, every_side, continuity));
                ASSERT_TRUE(result.ok()) << result.failure().message;
                expect_sides(result.value().report, length, 4);
                EXPECT_TRUE(BRepCheck_Analyzer(result.value().face).IsValid());
                EXPECT_EQ(result.value().face.Orientation(), each.Orientation());
                EXPECT_GT(area(result.value().face), area(face) + length * 900.0);
            }
}

TEST(ExtendFace, GivesEveryIsoCurveTheLengthWhenAsked)
{
    const auto result = extend_face(panel(), by(15.0, every_side, Continuity::G1, LengthRule::AtLeast));
    ASSERT_TRUE(result.ok()) << result.failure().message;
    for (const ExtendedSide &side : result.value().report.sides)
    {
        EXPECT_GE(side.shortest, 15.0 * (1.0 - 1e-8));
        EXPECT_LT(side.join_angle, largest_join_angle);
    }
}

TEST(ExtendFace, KeepsHolesAndInnerPoints)
{
    const TopoDS_Face face = panel_with_hole();
    const auto result = extend_face(face, by(30.0));
    ASSERT_TRUE(result.ok()) << result.failure().message;
    EXPECT_EQ(edges_of(result.value().face), edges_of(face));
    const Handle(Geom_Surface) before = BRep_Tool::Surface(face);
    const Handle(Geom_Surface) after = BRep_Tool::Surface(result.value().face);
    double u0, u1, v0, v1;
    before->Bounds(u0, u1, v0, v1);
    for (int i = 0; i <= 10; ++i)
        for (int j = 0; j <= 10; ++j)
        {
            const double u = u0 + (u1 - u0) * i / 10.0;
            const double v = v0 + (v1 - v0) * j / 10.0;
            EXPECT_LT(before->Value(u, v).Distance(after->Value(u, v)), 1e-9);
        }
}

TEST(ExtendFace, CarriesASeamAlong)
{
    const TopoDS_Face tube = BRepBuilderAPI_MakeFace(wavy_tube(40.0), 1e-7).Face();
    const auto result = extend_face(tube, by(6.0, {Side::VMin, Side::VMax}));
    ASSERT_TRUE(result.ok()) << result.failure().message;
    expect_sides(result.value().report, 6.0, 2);
    EXPECT_TRUE(BRepCheck_Analyzer(result.value().face).IsValid());
    expect_refused(tube, by(6.0), Status::SelfIntersection, Stage::Extension);
}

TEST(ExtendFace, GoesOnFromTheDomainsEndWhereLoopsHangOverIt)
{
    TColgp_Array1OfPnt poles(1, 4);
    for (int i = 1; i <= 4; ++i)
        poles(i) = gp_Pnt(20.0 * i, 0.0, i % 2 == 0 ? 6.0 : 0.0);
    const Handle(Geom_Surface) sweep = new Geom_SurfaceOfLinearExtrusion(new Geom_BezierCurve(poles), gp::DY());
    const Handle(Geom_Surface) spline =
        GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(sweep, 0.0, 1.0, 0.0, 50.0));
    for (const Handle(Geom_Surface) & surface : {sweep, spline})
        for (const double over : {5e-6, 1e-8})
            for (const Continuity continuity : {Continuity::G1, Continuity::Natural})
            {
                SCOPED_TRACE(testing::Message() << surface->DynamicType()->Name() << " over by " << over);
                const TopoDS_Face face = rectangle_on(surface, -over, 1.0 + over, 0.0, 50.0);
                const auto result = extend_face(face, by(4.0, {Side::UMin, Side::UMax}, continuity));
                ASSERT_TRUE(result.ok()) << result.failure().message;
                expect_sides(result.value().report, 4.0, 2);
                EXPECT_TRUE(BRepCheck_Analyzer(result.value().face).IsValid());
            }
}

TEST(ExtendFace, RefusesLoopsThatLeaveTheDomain)
{
    const Handle(Geom_Surface) sheet = BRep_Tool::Surface(panel());
    double u0, u1, v0, v1;
    sheet->Bounds(u0, u1, v0, v1);
    for (const double over : {2e-3, 0.02})
        expect_refused(rectangle_on(sheet, u0, u1 + over * (u1 - u0), v0, v1), by(4.0, {Side::UMax}),
                       Status::InvalidFace, Stage::Extension);
}

TEST(ExtendFace, GoesOnFromTheSeamOfAPeriodicSurface)
{
    const Handle(Geom_Surface) tube = wavy_tube(40.0); // its period in u is 12
    for (const Continuity continuity : {Continuity::G1, Continuity::Natural})
        for (const double start : {0.0, -1e-15, 4.0, 12.0})
        {
            SCOPED_TRACE(start);
            const TopoDS_Face part = rectangle_on(tube, start, start + 8.0, 0.2, 2.5);
            const auto result = extend_face(part, by(3.0, {Side::UMin, Side::UMax}, continuity));
            ASSERT_TRUE(result.ok()) << result.failure().message;
            expect_sides(result.value().report, 3.0, 2);
        }
}

TEST(ExtendFace, RefusesWhatWouldMeetItself)
{
    const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), 10.0);
    const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(gp_Ax3(), 10.0);
    const Handle(Geom_Surface) cone = new Geom_ConicalSurface(gp_Ax3(), 0.5, 10.0);
    const std::vector<Side> round{Side::UMax};
    expect_refused(face_on(cylinder, 0, 2 * M_PI, 0, 9), by(1.0), Status::SelfIntersection, Stage::Extension);
    expect_refused(face_on(cylinder, 0, 6.0, 0, 9), by(5.0, round), Status::SelfIntersection, Stage::Extension);
    EXPECT_TRUE(extend_face(face_on(cylinder, 0, 6.0, 0, 9), by(1.0, round)).ok());
    for (const Continuity continuity : {Continuity::G1, Continuity::Natural})
    {
        const TopoDS_Face open_ring = spline_face_on(cylinder, 0, 6.0, 0, 9);
        const auto made = extend_face(open_ring, by(5.0, round, continuity));
        EXPECT_FALSE(made.ok()); // the natural continuation of a rational arc may end before it comes round
        EXPECT_TRUE(extend_face(open_ring, by(1.0, round, continuity)).ok());
    }
    expect_refused(spline_face_on(cylinder, 0, 6.0, 0, 9), by(5.0, round), Status::SelfIntersection, Stage::Extension);
    expect_refused(face_on(sphere, 0, 2.0, -0.5, 1.2), by(8.0, {Side::VMax}), Status::NotSupported, Stage::Extension);
    expect_refused(face_on(sphere, 0, 2.0, -0.5, M_PI_2), by(1.0, {Side::VMax}), Status::SingularNormal,
                   Stage::Extension);
    expect_refused(face_on(cone, 0, 2.0, 0, 9), by(30.0, {Side::VMin}), Status::SelfIntersection, Stage::Extension);
}

TEST(ExtendFace, RefusesBadOptionsAndFacesWithoutSides)
{
    const TopoDS_Face face = panel();
    for (const double length : {0.0, -2.0, std::nan(""), HUGE_VAL})
        expect_refused(face, by(length), Status::InvalidOption, Stage::Options);
    expect_refused(face, by(1.0, {}), Status::InvalidOption, Stage::Options);
    const Handle(Geom_Surface) shifted = new Geom_OffsetSurface(BRep_Tool::Surface(face), 2.0);
    expect_refused(face_on(shifted, 0.1, 0.9, 0.1, 0.9), by(1.0), Status::NotSupported, Stage::Extension);
}

TEST(ExtendFace, ExtendsTheProfileOfASweep)
{
    const Handle(Geom_Curve) profile = arc(30.0, 1.2);
    const Handle(Geom_Surface) swept = new Geom_SurfaceOfLinearExtrusion(profile, gp_Dir(0, 0, 1));
    const TopoDS_Face face = face_on(swept, profile->FirstParameter(), profile->LastParameter(), 0.0, 40.0);
    const auto result = extend_face(face, by(4.0));
    ASSERT_TRUE(result.ok()) << result.failure().message;
    expect_sides(result.value().report, 4.0, 4);
    const Handle(Geom_Surface) longer = BRep_Tool::Surface(result.value().face);
    const auto &sides = result.value().report.sides;
    const double u0 = sides[0].parameter;
    const double u1 = sides[1].parameter;
    EXPECT_DOUBLE_EQ(sides[2].parameter, -4.0);
    EXPECT_DOUBLE_EQ(sides[3].parameter, 44.0);
    for (int i = 0; i <= 50; ++i)
        EXPECT_NEAR(longer->Value(u0 + (u1 - u0) * i / 50.0, 0.0).Distance(gp_Pnt()), 30.0, 1e-10);
    const double turn = gp_Vec(gp_Pnt(), longer->Value(u0, 0.0)).Angle(gp_Vec(gp_Pnt(), longer->Value(u1, 0.0)));
    EXPECT_NEAR(turn, 44.0 / 30.0, 1e-7);
}

TEST(ExtendFace, HoldsForRandomSurfaces)
{
    RandomCases random;
    int made = 0;
    for (int k = 0; k < 60; ++k)
    {
        SurfaceKind kind;
        kind.degree_u = random.integer(2, 5);
        kind.degree_v = random.integer(2, 5);
        kind.spans_u = random.integer(1, 4);
        kind.spans_v = random.integer(1, 4);
        kind.rational = random.integer(0, 1) == 1;
        kind.most_repeated = 1;
        const TopoDS_Face face = BRepBuilderAPI_MakeFace(random_surface(random, kind), 1e-7).Face();
        const double length = random.magnitude(0.05, 15.0);
        const Side side = all_sides[static_cast<std::size_t>(random.integer(0, 3))];
        const Continuity continuity = random.integer(0, 2) == 0 ? Continuity::Natural : Continuity::G1;
        const auto result = extend_face(face, by(length, {side}, continuity));
        if (!result)
        {
            EXPECT_TRUE(result.failure().where.has_value()) << result.failure().message;
            continue;
        }
        ++made;
        expect_sides(result.value().report, length, 1);
        EXPECT_GT(area(result.value().face), area(face));
    }
    EXPECT_GE(made, 30);
}

TEST(ExtendFace, HoldsForRealFaces)
{
    for (const char *file : {"derived_D150_fuselage_3p4m_2holes_9curves.step", "tigl_curvesToSurfaceContinuous.brep"})
    {
        const auto path = find_data_file(file);
        if (!path)
            GTEST_SKIP() << missing_data_message(file);
        for (const TopoDS_Face &face : read_faces(*path))
        {
            const auto result = extend_face(face, by(20.0));
            if (result)
                expect_sides(result.value().report, 20.0, 4);
            else
                EXPECT_TRUE(result.failure().where.has_value()) << result.failure().message;
        }
    }
}

TEST(OffsetExtension, GrowsTheOffsetPastItsSides)
{
    OffsetOptions options;
    options.distance = 5.0;
    const auto plain = offset_face(panel(), options);
    options.extension = 12.0;
    const auto grown = offset_face(panel(), options);
    ASSERT_TRUE(plain.ok() && grown.ok());
    ASSERT_TRUE(grown.value().report.extension.has_value());
    EXPECT_FALSE(plain.value().report.extension.has_value());
    EXPECT_EQ(plain.value().report.certified_error, grown.value().report.certified_error);
    for (const ExtendedSide &side : grown.value().report.extension->sides)
    {
        EXPECT_NEAR(side.mean_length, 12.0, 1e-5);
        EXPECT_LT(side.join_angle, largest_join_angle);
        EXPECT_EQ(side.moved_edges, 1);
    }
    EXPECT_GT(area(grown.value().shape), area(plain.value().shape) + 12.0 * 900.0);
    EXPECT_TRUE(BRepCheck_Analyzer(grown.value().shape).IsValid());
}

TEST(OffsetExtension, OfAClosedFaceIsRefused)
{
    OffsetOptions options;
    options.distance = 1.0;
    options.extension = 3.0;
    const auto result = offset_face(face_on(new Geom_CylindricalSurface(gp_Ax3(), 10.0), 0, 2 * M_PI, 0, 9), options);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.failure().status, Status::SelfIntersection);
    EXPECT_EQ(result.failure().stage, Stage::Extension);
    EXPECT_TRUE(result.failure().where.has_value());
}
