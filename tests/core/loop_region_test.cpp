// SPDX-License-Identifier: LGPL-2.1-or-later
// The inside of trimming loops against equations, dense polygons and OpenCASCADE's classifier.
#include "support/data_files.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/analysis/loop_region.h>
#include <laminate_offset/evaluate_face.h>
#include <laminate_offset/input/pcurve_pieces.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepClass_FaceClassifier.hxx>
#include <BRepLib.hxx>
#include <Geom2dConvert.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Plane.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace laminate_offset;
using namespace test_support;

namespace
{

//! A square of half the given side about the origin of a plane, with a hole.
TopoDS_Face square_with_hole(double half, const Handle(Geom2d_Curve) & hole)
{
    const Handle(Geom_Plane) plane = new Geom_Plane(gp_Pln());
    BRepBuilderAPI_MakeFace maker(plane, -half, half, -half, half, 1e-9);
    TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(hole, plane);
    BRepLib::BuildCurve3d(edge);
    maker.Add(TopoDS::Wire(BRepBuilderAPI_MakeWire(edge).Wire().Reversed()));
    return maker.Face();
}

gp_Pnt2d on_ellipse(const gp_Elips2d &ellipse, double angle, double share)
{
    const gp_XY out = ellipse.MajorRadius() * std::cos(angle) * ellipse.XAxis().Direction().XY() +
                      ellipse.MinorRadius() * std::sin(angle) * ellipse.YAxis().Direction().XY();
    return ellipse.Location().XY() + share * out;
}

//! A closed spline round the origin without self-intersections: its poles stand around in order.
Handle(Geom2d_BSplineCurve) star(RandomCases &random, int degree, bool rational)
{
    const int count = random.integer(8, 20);
    TColgp_Array1OfPnt2d poles(1, count + 1);
    TColStd_Array1OfReal weights(1, count + 1);
    for (int i = 1; i <= count + 1; ++i)
    {
        const double angle = 2.0 * M_PI * (i - 1) / count;
        const double radius = random.uniform(0.7, 1.3);
        poles(i) = i == count + 1 ? poles(1) : gp_Pnt2d(radius * std::cos(angle), radius * std::sin(angle));
        weights(i) = i == count + 1 ? weights(1) : rational ? random.uniform(0.5, 2.0) : 1.0;
    }
    const int spans = count + 1 - degree;
    TColStd_Array1OfReal knots(1, spans + 1);
    TColStd_Array1OfInteger multiplicities(1, spans + 1);
    for (int i = 1; i <= spans + 1; ++i)
    {
        knots(i) = i + random.uniform(-0.3, 0.3);
        multiplicities(i) = i == 1 || i == spans + 1 ? degree + 1 : 1;
    }
    return new Geom2d_BSplineCurve(poles, weights, knots, multiplicities, degree);
}

//! Parity of the sides of a polygon that the ray towards larger x meets.
bool inside_polygon(const std::vector<gp_Pnt2d> &polygon, const gp_Pnt2d &p)
{
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const gp_Pnt2d &a = polygon[i];
        const gp_Pnt2d &b = polygon[(i + 1) % polygon.size()];
        if ((a.Y() > p.Y()) != (b.Y() > p.Y()))
            inside ^= a.X() + (p.Y() - a.Y()) / (b.Y() - a.Y()) * (b.X() - a.X()) > p.X();
    }
    return inside;
}

} // namespace

//! Beside the border by parts of the radius from 1e-8 to 1e-2; chords of a sixteenth of the turn miss it by up to 2e-2.
TEST(LoopRegion, HolesWithAnEquationAreExact)
{
    RandomCases random;
    int chords_would_err = 0;
    for (const double size : {1e-3, 1.0, 1e4})
        for (int kind = 0; kind < 12; ++kind)
        {
            SCOPED_TRACE("size " + std::to_string(size) + " kind " + std::to_string(kind));
            const double turn = kind % 3 == 0 ? 0.0 : random.uniform(0.0, 6.0);
            const gp_Ax22d axes(gp_Pnt2d(random.uniform(-0.3, 0.3) * size, random.uniform(-0.3, 0.3) * size),
                                gp_Dir2d(std::cos(turn), std::sin(turn)), kind % 2 == 0);
            const double minor = kind % 4 == 0 ? size : random.uniform(0.3, 0.9) * size;
            const gp_Elips2d shape(axes, size, minor);
            Handle(Geom2d_Curve) hole = new Geom2d_Ellipse(shape);
            if (kind % 4 == 0)
                hole = new Geom2d_Circle(gp_Circ2d(axes, size));
            if (kind >= 8)
                hole = Geom2dConvert::CurveToBSplineCurve(hole);
            const InputFace input = read_face(square_with_hole(3.0 * size, hole)).value();
            const LoopRegion region(input);
            for (int i = 0; i < 400; ++i)
            {
                const double angle = i % 4 == 0 ? M_PI / 8.0 * random.integer(0, 15) : random.uniform(0.0, 2.0 * M_PI);
                const double away = random.magnitude(1e-8, 1e-2);
                EXPECT_TRUE(region.contains(on_ellipse(shape, angle, 1.0 + away))) << angle << ' ' << away;
                EXPECT_FALSE(region.contains(on_ellipse(shape, angle, 1.0 - away))) << angle << ' ' << away;
                EXPECT_TRUE(region.contains(on_ellipse(shape, angle, 1.0))) << angle << " on the border";
                chords_would_err += away < 2e-3 && i % 4 != 0 ? 1 : 0;
            }
            EXPECT_FALSE(region.contains(shape.Location()));
            EXPECT_TRUE(region.contains({2.9 * size, shape.Location().Y()}));
        }
    EXPECT_GT(chords_would_err, 1000);
}

//! Also where the ray passes through the ends of pieces.
TEST(LoopRegion, SplineLoopsAnswerLikeDensePolygons)
{
    constexpr int sides = 20000;
    constexpr double away = 1e-5; // a side's sag is below 1e-7
    RandomCases random;
    int inside = 0, outside = 0;
    for (int round = 0; round < 24; ++round)
    {
        SCOPED_TRACE(round);
        const Handle(Geom2d_BSplineCurve) loop = star(random, 2 + round % 5, round % 2 == 1);
        const double first = loop->FirstParameter();
        const double last = loop->LastParameter();
        std::vector<gp_Pnt2d> polygon;
        for (int i = 0; i < sides; ++i)
            polygon.push_back(loop->Value(first + (last - first) * i / sides));
        const InputFace input = read_face(square_with_hole(2.0, loop)).value();
        const LoopRegion region(input);
        std::vector<gp_Pnt2d> points;
        for (int i = 0; i < 60; ++i)
        {
            gp_Pnt2d p;
            gp_Vec2d along;
            loop->D1(random.uniform(first, last), p, along);
            const gp_Vec2d across = away / along.Magnitude() * gp_Vec2d(-along.Y(), along.X());
            points.insert(points.end(), {p.Translated(across), p.Translated(-across)});
            points.emplace_back(random.uniform(-1.4, 1.4), random.uniform(-1.4, 1.4));
        }
        for (const PcurvePiece &piece : input.loops.back().curves.front().pieces)
            points.emplace_back(random.uniform(-1.4, 0.6), piece.start.Y());
        for (const gp_Pnt2d &p : points)
        {
            const bool expected = !inside_polygon(polygon, p);
            EXPECT_EQ(region.contains(p), expected) << p.X() << ' ' << p.Y();
            ++(expected ? inside : outside);
        }
    }
    EXPECT_GT(inside, 1500);
    EXPECT_GT(outside, 1500);
}

TEST(LoopRegion, PcurvesThatMeetWithinToleranceOnlyCloseTheLoop)
{
    RandomCases random;
    int in_gaps = 0;
    for (const double gap : {1e-12, 1e-9, 1e-7, 1e-5})
    {
        SCOPED_TRACE(gap);
        InputFace input = read_face(BRepBuilderAPI_MakeFace(gp_Pln(), -1.0, 1.0, -1.0, 1.0).Face()).value();
        double widest = 0.0;
        for (TrimmingCurve &curve : input.loops.front().curves)
        {
            const gp_Vec2d shift(random.uniform(-gap, gap), random.uniform(-gap, gap));
            curve.pieces =
                cut_up(Handle(Geom2d_Curve)::DownCast(curve.pcurve->Translated(shift)), curve.first, curve.last);
            widest = std::max(widest, std::abs(shift.Y()));
        }
        const LoopRegion region(input);
        for (const double height : {-1.0, 1.0})
            for (int i = 0; i < 200; ++i)
            {
                const double v = height + random.uniform(-widest, widest);
                EXPECT_FALSE(region.contains({-1.5, v})) << v;
                EXPECT_FALSE(region.contains({1.5, v})) << v;
                ++in_gaps;
            }
        EXPECT_TRUE(region.contains({0.0, 0.0}));
    }
    EXPECT_EQ(in_gaps, 1600);
}

//! Where lines enter and leave a hole; between the outermost chord and the arc too.
TEST(LoopRegion, CrossingsLieOnTheLoops)
{
    const InputFace input = read_face(square_with_hole(2.0, new Geom2d_Circle(gp_Circ2d(gp_Ax22d(), 1.0)))).value();
    const LoopRegion region(input);
    for (const bool constant_u : {true, false})
        for (const double at : {-0.9999, -0.99, -0.5, 0.0, 0.3, 0.7071, 0.981, 0.995, 0.99999})
        {
            SCOPED_TRACE(at);
            const std::vector<double> places = region.crossings(constant_u, at);
            ASSERT_EQ(places.size(), 4u);
            const double half = std::sqrt(1.0 - at * at);
            EXPECT_NEAR(places[0], -2.0, 1e-9);
            EXPECT_NEAR(places[1], -half, 1e-7);
            EXPECT_NEAR(places[2], half, 1e-7);
            EXPECT_NEAR(places[3], 2.0, 1e-9);
        }
    EXPECT_EQ(region.crossings(true, 1.0001).size(), 2u);
    EXPECT_TRUE(region.crossings(true, 2.1).empty());
}

//! Bands leave no piece out, and a rectangle around a point inside is touched.
TEST(LoopRegion, BandsMissNoCrossing)
{
    RandomCases random;
    const InputFace input = read_face(panel_with_hole()).value();
    const LoopRegion region(input);
    int inside = 0;
    for (int i = 0; i < 4000; ++i)
    {
        const ParameterBox &box = input.box;
        const gp_Pnt2d uv(random.uniform(box.umin, box.umax), random.uniform(box.vmin, box.vmax));
        const bool expected = std::hypot((uv.X() - 0.6) / 0.15, (uv.Y() - 0.45) / 0.1) > 1.0;
        ASSERT_EQ(region.contains(uv), expected) << uv.X() << ' ' << uv.Y();
        const double size = 1e-3 * (box.umax - box.umin);
        if (expected)
        {
            EXPECT_TRUE(region.may_touch({uv.X() - size, uv.X() + size, uv.Y() - size, uv.Y() + size}));
            ++inside;
        }
    }
    EXPECT_GT(inside, 1000);
    EXPECT_LT(inside, 3999);
}

//! Rectangles, segments and points, also along the loops, against points of theirs: whatever holds a point inside is touched,
//! and segments that are touched hold one.
TEST(LoopRegion, RectanglesWithoutWidthAreTouchedToo)
{
    RandomCases random;
    int held[4] = {}, free[4] = {};
    for (int round = 0; round < 12; ++round)
    {
        const double size = random.magnitude(1e-3, 1e4);
        Handle(Geom2d_Curve) hole = new Geom2d_Circle(gp_Circ2d(gp_Ax22d(), 0.5 * size));
        if (round % 2 == 1)
        {
            hole = star(random, 2 + round % 4, round % 3 == 0);
            hole->Scale(gp_Pnt2d(), 0.4 * size);
        }
        const InputFace input = read_face(square_with_hole(size, hole)).value();
        const LoopRegion region(input);
        // places on the square's sides, at the circle's ends and anywhere
        const auto place = [&] {
            const double places[] = {-size, size, -0.5 * size, 0.5 * size, 0.0};
            const int kind = random.integer(0, 9);
            return kind < 5 ? places[kind] : random.uniform(-1.5 * size, 1.5 * size);
        };
        for (int i = 0; i < 400; ++i)
        {
            const bool flat_u = i % 2 == 1;
            const bool flat_v = i % 4 >= 2;
            const auto [u0, u1] = std::minmax({place(), place()});
            const auto [v0, v1] = std::minmax({place(), place()});
            const ParameterBox box{u0, flat_u ? u0 : u1, v0, flat_v ? v0 : v1};
            if ((!flat_u && u0 == u1) || (!flat_v && v0 == v1))
                continue;
            bool holds = false;
            const int along_u = flat_u ? 2 : 30;
            const int along_v = flat_v ? 2 : 30;
            for (int a = 1; a < along_u && !holds; ++a)
                for (int b = 1; b < along_v && !holds; ++b)
                    holds = region.contains({box.umin + (box.umax - box.umin) * a / along_u,
                                             box.vmin + (box.vmax - box.vmin) * b / along_v});
            SCOPED_TRACE("round " + std::to_string(round) + " case " + std::to_string(i));
            if (holds)
            {
                EXPECT_TRUE(region.touches(box));
                EXPECT_TRUE(region.may_touch(box));
            }
            else if (flat_u && flat_v)
                EXPECT_FALSE(region.touches(box));
            const auto kind = static_cast<std::size_t>(i % 4);
            held[kind] += holds ? 1 : 0;
            free[kind] += region.touches(box) ? 0 : 1;
        }
    }
    for (std::size_t kind = 0; kind < 4; ++kind)
    {
        EXPECT_GT(held[kind], 200) << kind;
        EXPECT_GT(free[kind], kind == 0 ? 30 : 100) << kind;
    }
}

TEST(LoopRegion, EvaluatedPlacesInsideAHoleAreOutside)
{
    const TopoDS_Face face = square_with_hole(2.0, new Geom2d_Circle(gp_Circ2d(gp_Ax22d(), 1.0)));
    std::vector<gp_Pnt2d> places;
    for (int i = 0; i < 1000; ++i)
        for (const double radius : {0.98, 0.999, 0.999999, 1.0, 1.000001, 1.01})
            places.emplace_back(radius * std::cos(0.1 * i), radius * std::sin(0.1 * i));
    const auto result = evaluate_face(face, places);
    ASSERT_TRUE(result.ok());
    for (std::size_t i = 0; i < places.size(); ++i)
        EXPECT_EQ(result.value()[i].inside, i % 6 >= 3) << i;
}

//! Real loops, near their pieces above all, where OpenCASCADE does not speak of the border.
TEST(LoopRegion, RealFacesAgreeWithOpenCascade)
{
    const std::string name = "nist_MBE_PMI_5.stp";
    const auto path = find_data_file(name);
    if (!path)
        GTEST_SKIP() << missing_data_message(name);
    RandomCases random;
    int inside = 0, outside = 0, holes = 0, border = 0;
    for (const TopoDS_Face &face : read_faces(*path))
    {
        const Result<InputFace> read = read_face(face);
        if (!read)
            continue;
        const InputFace &input = read.value();
        const LoopRegion region(input);
        holes += input.loops.size() > 1 ? 1 : 0;
        const double du = input.box.umax - input.box.umin;
        const double dv = input.box.vmax - input.box.vmin;
        const std::vector<gp_Pnt2d> edge = region.boundary_points();
        for (int i = 0; i < 60; ++i)
        {
            const gp_Pnt2d &from = edge[static_cast<std::size_t>(random.integer(0, static_cast<int>(edge.size()) - 1))];
            const double reach = random.magnitude(1e-4, 0.1);
            const gp_Pnt2d uv(from.X() + reach * du * random.uniform(-1.0, 1.0),
                              from.Y() + reach * dv * random.uniform(-1.0, 1.0));
            const TopAbs_State state = BRepClass_FaceClassifier(input.face, uv, 1e-6 * std::max(du, dv)).State();
            if (state != TopAbs_IN && state != TopAbs_OUT)
            {
                ++border;
                continue;
            }
            EXPECT_EQ(region.contains(uv), state == TopAbs_IN) << uv.X() << ' ' << uv.Y();
            ++(state == TopAbs_IN ? inside : outside);
        }
    }
    EXPECT_GT(holes, 3);
    EXPECT_GT(inside, 1000);
    EXPECT_GT(outside, 1000);
    EXPECT_LT(border, inside);
}
