// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts of creased faces that run into each other, at their creases and far from them.
#include "support/offsets.h"
#include "support/sample_faces.h"

#include <laminate_offset/creased_solids.h>
#include <laminate_offset/offset_face.h>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

using namespace laminate_offset;
using namespace test_support;

namespace
{

constexpr double tolerance = 1e-3;
constexpr double depth = 30.0;

using Polyline = std::vector<std::array<double, 2>>;

//! A polyline in the plane z = 0, extruded upwards: an extrusion, or the same surface as a spline.
TopoDS_Face folded(const Polyline &points, bool as_spline)
{
    const int count = static_cast<int>(points.size());
    TColStd_Array1OfReal knots(1, count);
    TColStd_Array1OfInteger multiplicities(1, count);
    TColgp_Array1OfPnt line(1, count);
    TColgp_Array2OfPnt net(1, count, 1, 2);
    for (int i = 1; i <= count; ++i)
    {
        const auto [x, y] = points[static_cast<std::size_t>(i) - 1];
        knots(i) = i - 1;
        multiplicities(i) = i == 1 || i == count ? 2 : 1;
        line(i) = net(i, 1) = gp_Pnt(x, y, 0.0);
        net(i, 2) = gp_Pnt(x, y, depth);
    }
    if (!as_spline)
    {
        const Handle(Geom_BSplineCurve) profile = new Geom_BSplineCurve(line, knots, multiplicities, 1);
        return BRepBuilderAPI_MakeFace(new Geom_SurfaceOfLinearExtrusion(profile, gp::DZ()), 0.0, count - 1.0, 0.0,
                                       depth, 1e-7);
    }
    TColStd_Array1OfReal ends(1, 2);
    TColStd_Array1OfInteger twice(1, 2);
    ends(1) = 0.0, ends(2) = 1.0;
    twice(1) = twice(2) = 2;
    return BRepBuilderAPI_MakeFace(new Geom_BSplineSurface(net, knots, ends, multiplicities, twice, 1, 1), 1e-7);
}

//! The last arm ends beside the first one. All turns are to the same side, so that the offset opens at every crease on one
//! side, and crosses at every crease on the other.
const Polyline hook{{0, 0}, {0, -20}, {20, -20}, {20, 20}, {-20, 20}, {-20, 0.3}, {-0.4, 0.3}};

double shared_volume(const std::vector<TopoDS_Solid> &solids)
{
    double volume = 0.0;
    for (std::size_t i = 0; i < solids.size(); ++i)
        for (std::size_t j = i + 1; j < solids.size(); ++j)
        {
            GProp_GProps figures;
            BRepGProp::VolumeProperties(BRepAlgoAPI_Common(solids[i], solids[j]).Shape(), figures);
            volume += figures.Mass();
        }
    return volume;
}

//! On one side of the hook all creases open, on the other all cross: the sign of the opening one.
double opening_side(const TopoDS_Face &face)
{
    const auto up = offset(face, 0.05, tolerance), down = offset(face, -0.05, tolerance);
    EXPECT_TRUE(up.ok() && down.ok()) << why(up) << why(down);
    const bool up_opens = *up.value().report.crease == CreaseKind::Gap;
    EXPECT_EQ(*(up_opens ? down : up).value().report.crease, CreaseKind::Overlap);
    return up_opens ? 1.0 : -1.0;
}

Result<std::vector<std::vector<TopoDS_Solid>>> solids(const TopoDS_Face &face, double distance)
{
    OffsetOptions options;
    options.tolerance = tolerance;
    return creased_ply_solids(
        face, {0.0, 0.5 * distance, distance},
        distance > 0.0 ? std::vector<SolidSpan>{{0, 1}, {1, 2}} : std::vector<SolidSpan>{{1, 0}, {2, 1}}, options);
}

TEST(PartsOfCreasedFaces, AHookWhoseEndRunsIntoItsStartIsRefused)
{
    for (const bool as_spline : {false, true})
        for (const bool turned : {false, true})
        {
            SCOPED_TRACE(testing::Message() << "spline " << as_spline << " turned " << turned);
            const TopoDS_Face plain = folded(hook, as_spline);
            const TopoDS_Face face = turned ? located(reversed(plain)) : plain;
            const double side = opening_side(face);
            const auto near = offset(face, 0.2 * side, tolerance);
            ASSERT_TRUE(near.ok()) << why(near);
            EXPECT_TRUE(near.value().report.apart);
            EXPECT_EQ(*near.value().report.crease, CreaseKind::Gap);
            const auto made = solids(face, 0.2 * side);
            ASSERT_TRUE(made.ok()) << made.failure().message;
            for (const std::vector<TopoDS_Solid> &parts : made.value())
            {
                EXPECT_EQ(parts.size(), hook.size() - 1);
                EXPECT_TRUE(turned || std::abs(shared_volume(parts)) < 1e-9);
            }
            for (const double distance : {1.0, 3.0})
            {
                const auto far = offset(face, distance * side, tolerance);
                ASSERT_FALSE(far.ok());
                EXPECT_EQ(far.failure().status, Status::SelfIntersection) << why(far);
                EXPECT_EQ(far.failure().stage, Stage::Surface);
                ASSERT_TRUE(far.failure().where.has_value());
                const auto filled = solids(face, distance * side);
                ASSERT_FALSE(filled.ok());
                EXPECT_EQ(filled.failure().status, Status::SelfIntersection) << filled.failure().message;
                ASSERT_TRUE(filled.failure().where.has_value());
            }
        }
}

TEST(PartsOfCreasedFaces, PliesThatPassRightThroughEachOtherAreRefused)
{
    // the plies of the first arm reach the last one, 6 away, whose own plies stand on its far side: at 7 the offsets of both
    // are 6 apart
    const Polyline arms{{0, 0}, {60, 0}, {60, -20}, {-20, -20}, {-20, 6}, {50, 6}};
    const TopoDS_Face face = folded(arms, true);
    int refused = 0, made = 0;
    for (const double distance : {-7.0, -5.9, 5.9, 7.0})
    {
        const auto laid = solids(face, distance);
        if (laid.ok())
        {
            ++made;
            EXPECT_LT(std::abs(distance), 6.0);
            EXPECT_LT(std::abs(shared_volume(laid.value()[0])) + std::abs(shared_volume(laid.value()[1])), 1e-9);
        }
        else if (laid.failure().status == Status::SelfIntersection)
        {
            ++refused;
            EXPECT_GT(std::abs(distance), 6.0);
        }
    }
    EXPECT_EQ(made, 1);
    EXPECT_EQ(refused, 1);
}

//! A roof along x whose ridge sinks below the eaves in a window of its poles (parts of its length), so that it is a valley
//! there.
TopoDS_Face roof_with_window(int spans, double from, double to, double length, double height)
{
    TColStd_Array1OfReal knots_u(1, 3), knots_v(1, spans + 1);
    TColStd_Array1OfInteger multiplicities_u(1, 3), multiplicities_v(1, spans + 1);
    for (int i = 1; i <= 3; ++i)
    {
        knots_u(i) = 0.5 * (i - 1);
        multiplicities_u(i) = i == 2 ? 1 : 2;
    }
    for (int i = 1; i <= spans + 1; ++i)
    {
        knots_v(i) = static_cast<double>(i - 1) / spans;
        multiplicities_v(i) = i == 1 || i == spans + 1 ? 4 : 1;
    }
    TColgp_Array2OfPnt poles(1, 3, 1, spans + 3);
    for (int j = 1; j <= poles.RowLength(); ++j)
    {
        const double t = std::clamp((j - 2.0) / spans, 0.0, 1.0);
        for (int i = 1; i <= poles.ColLength(); ++i)
            poles(i, j) = gp_Pnt(length * t, 20.0 * (i - 2), i != 2 ? 0.0 : t > from && t < to ? -height : height);
    }
    return BRepBuilderAPI_MakeFace(
        new Geom_BSplineSurface(poles, knots_u, knots_v, multiplicities_u, multiplicities_v, 1, 3), 1e-7);
}

TEST(PartsOfCreasedFaces, ANarrowWindowThatCrossesIsSeen)
{
    struct Case
    {
        int spans;
        double from, to;
        bool window;
        double length = 100.0, height = 1.0;
    };
    for (const Case &c : {Case{64, 2.0, 3.0, false}, Case{64, 0.5146, 0.5479, true}, Case{64, 0.3, 0.5, true},
                          Case{500, 0.3341, 0.3379, true, 1000.0, 0.1}})
    {
        SCOPED_TRACE(testing::Message() << c.spans << " spans, from " << c.from);
        const TopoDS_Face face = roof_with_window(c.spans, c.from, c.to, c.length, c.height);
        int opens = 0;
        for (const double distance : {1.0, -1.0})
        {
            const auto result = offset(face, distance, tolerance);
            ASSERT_TRUE(result.ok()) << why(result);
            const CreaseKind kind = *result.value().report.crease;
            const auto filled = solids(face, distance);
            EXPECT_EQ(filled.ok(), kind == CreaseKind::Gap);
            EXPECT_EQ(kind == CreaseKind::Both, c.window);
            opens += kind == CreaseKind::Gap ? 1 : 0;
            if (filled.ok())
                continue;
            EXPECT_EQ(filled.failure().status, Status::KinkedSurface) << filled.failure().message;
            const bool advises = filled.failure().message.find("other side") != std::string::npos;
            EXPECT_EQ(advises, !c.window) << "where both sides cross the other one does not help";
        }
        EXPECT_EQ(opens, c.window ? 0 : 1);
    }
}

//! A profile in the plane y = 0 that is a straight arm and, past a crease, a cubic spline, extruded along y.
TopoDS_Face arm_and_spline(const Polyline &arm, const Polyline &spline)
{
    const int count = static_cast<int>(spline.size());
    TColStd_Array1OfReal knots(1, count), ends(1, 2);
    TColStd_Array1OfInteger multiplicities(1, count), twice(1, 2);
    for (int i = 1; i <= knots.Length(); ++i)
    {
        knots(i) = i - 1;
        multiplicities(i) = i == 1 || i == knots.Length() ? 4 : i == 2 ? 3 : 1;
    }
    ends(1) = 0.0, ends(2) = 1.0, twice(1) = twice(2) = 2;
    Polyline line = arm;
    line.insert(line.end(), spline.begin(), spline.end());
    TColgp_Array2OfPnt net(1, static_cast<int>(line.size()), 1, 2);
    for (int i = 1; i <= net.ColLength(); ++i)
        for (int j = 1; j <= 2; ++j)
            net(i, j) = gp_Pnt(line[static_cast<std::size_t>(i) - 1][0], j == 1 ? 0.0 : depth,
                               line[static_cast<std::size_t>(i) - 1][1]);
    return BRepBuilderAPI_MakeFace(new Geom_BSplineSurface(net, knots, ends, multiplicities, twice, 3, 1), 1e-7);
}

//! On the side on which the parts cross at the crease.
double crossing_side(const TopoDS_Face &face)
{
    const auto up = offset(face, 0.1, tolerance), down = offset(face, -0.1, tolerance);
    EXPECT_TRUE(up.ok() && down.ok()) << why(up) << why(down);
    EXPECT_NE(*up.value().report.crease, *down.value().report.crease);
    return *up.value().report.crease == CreaseKind::Overlap ? 1.0 : -1.0;
}

TEST(PartsOfCreasedFaces, PartsThatCrossAtTheirCreaseAreComparedElsewhere)
{
    // the second part goes out from the crease at right angles and comes round again: its end stands upright 6 above the arm
    const Polyline arm{{60, 0}, {40, 0}, {20, 0}, {0, 0}};
    const TopoDS_Face plain = arm_and_spline(arm, {{0, 15}, {0, 30}, {20, 40}, {45, 35}, {50, 20}, {50, 6}});
    for (const TopoDS_Face &face : {plain, TopoDS_Face(located(reversed(plain)))})
    {
        const double side = crossing_side(face);
        for (const double distance : {0.5, 2.0, 4.0, 5.9})
        {
            SCOPED_TRACE(distance);
            const auto near = offset(face, distance * side, tolerance);
            ASSERT_TRUE(near.ok()) << why(near);
            EXPECT_EQ(*near.value().report.crease, CreaseKind::Overlap);
            EXPECT_TRUE(near.value().report.apart) << "the crossing at the crease is the only one";
        }
        for (const double distance : {6.1, 8.0})
        {
            SCOPED_TRACE(distance);
            const auto far = offset(face, distance * side, tolerance);
            ASSERT_FALSE(far.ok()) << "the end comes upon the arm";
            EXPECT_EQ(far.failure().status, Status::SelfIntersection) << why(far);
            EXPECT_EQ(far.failure().stage, Stage::Surface);
            ASSERT_TRUE(far.failure().where.has_value());
            // the one of the two places that is reported: below the end on the arm, or on the end itself
            const gp_Pnt place = far.failure().where->point.Transformed(face.Location().Transformation().Inverted());
            EXPECT_GT(place.X(), 30.0);
        }
        for (const double distance : {2.0, 8.0})
            EXPECT_TRUE(offset(face, -distance * side, tolerance).ok());
    }
}

//! Bilinear pieces over a grid of lines in x and y, with the same heights in both directions.
TopoDS_Face bilinear_pieces(const std::vector<double> &lines,
                            const std::function<double(std::size_t, std::size_t)> &height)
{
    const int count = static_cast<int>(lines.size());
    TColgp_Array2OfPnt net(1, count, 1, count);
    TColStd_Array1OfReal knots(1, count);
    TColStd_Array1OfInteger multiplicities(1, count);
    for (int i = 1; i <= count; ++i)
    {
        const auto k = static_cast<std::size_t>(i - 1);
        knots(i) = (lines[k] - lines.front()) / (lines.back() - lines.front());
        multiplicities(i) = i == 1 || i == count ? 2 : 1;
        for (std::size_t j = 0; j < lines.size(); ++j)
            net(i, static_cast<int>(j) + 1) = gp_Pnt(lines[k], lines[j], height(k, j));
    }
    return BRepBuilderAPI_MakeFace(new Geom_BSplineSurface(net, knots, knots, multiplicities, multiplicities, 1, 1),
                                   1e-7);
}

TEST(PartsOfCreasedFaces, PartsThatMeetInACornerOfCrossingCreasesAreNotRefused)
{
    std::vector<TopoDS_Face> faces;
    for (const double slope : {1.0, 0.2, 0.1}) // valleys that cross
        faces.push_back(bilinear_pieces({-100, 0, 100}, [slope](std::size_t i, std::size_t j) {
            return 60.0 * ((i == 1 ? 0.0 : 1.0) + (j == 1 ? 0.0 : slope));
        }));
    for (const double deep : {10.0, 40.0, 80.0}) // tubs
        faces.push_back(bilinear_pieces({0, 40, 160, 200}, [deep](std::size_t i, std::size_t j) {
            return i % 3 != 0 && j % 3 != 0 ? -deep : 0.0;
        }));
    for (std::size_t k = 0; k < faces.size(); ++k)
        for (const double distance : {0.01, 1.0, 5.0, -1.0, -5.0})
        {
            SCOPED_TRACE(testing::Message() << "face " << k << " at " << distance);
            const auto made = offset(faces[k], distance, tolerance);
            ASSERT_TRUE(made.ok()) << why(made);
            EXPECT_EQ(made.value().report.faces, k < 3 ? 4 : 9);
            ASSERT_TRUE(made.value().report.crease.has_value());
            EXPECT_EQ(*made.value().report.crease, distance > 0.0 ? CreaseKind::Overlap : CreaseKind::Gap);
        }
}

//! Two skins that leave one edge in the same direction, farther and farther apart from one end of it to the other.
TEST(PartsOfCreasedFaces, ATwistedCuspIsNotRefused)
{
    const double x[] = {50, 25, 0, 25, 50}, height[] = {2, 0, 0, 0, 4};
    TColgp_Array2OfPnt net(1, 5, 1, 3);
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 3; ++j)
            net(i + 1, j + 1) = gp_Pnt(x[i] + 3.0 * j, 50.0 * j, height[i] * (1.0 + 0.3 * j));
    TColStd_Array1OfReal us(1, 3), vs(1, 2);
    TColStd_Array1OfInteger mu(1, 3), mv(1, 2);
    for (int i = 1; i <= 3; ++i)
    {
        us(i) = 0.5 * (i - 1);
        mu(i) = i == 2 ? 2 : 3;
    }
    vs(1) = 0.0;
    vs(2) = 1.0;
    mv(1) = mv(2) = 3;
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(new Geom_BSplineSurface(net, us, vs, mu, mv, 2, 2), 1e-7);
    for (const double distance : {0.1, 0.5, -0.1, -0.5})
    {
        SCOPED_TRACE(distance);
        const auto made = offset(face, distance, tolerance);
        ASSERT_TRUE(made.ok()) << why(made);
        EXPECT_EQ(made.value().report.faces, 2);
    }
}

TEST(PartsOfCreasedFaces, WhatGrowsOutOfTheCreaseIsItsOwnCrossing)
{
    // both parts are hollow towards each other, so that their crossing moves away from the crease faster than the distance
    for (const double rise : {4.0, 10.0, 25.0, 60.0})
    {
        const TopoDS_Face face =
            arm_and_spline({{60, 0}, {40, 0}, {20, 0}, {0, 0}}, {{20, rise}, {40, 1.2 * rise}, {60, rise}});
        const double side = crossing_side(face);
        for (const double distance : {0.2, 0.4 * std::min(rise, 20.0)})
        {
            SCOPED_TRACE(testing::Message() << rise << " at " << distance);
            const auto made = offset(face, distance * side, tolerance);
            ASSERT_TRUE(made.ok()) << why(made);
            EXPECT_EQ(*made.value().report.crease, CreaseKind::Overlap);
            EXPECT_TRUE(made.value().report.apart);
        }
    }
}

TEST(PartsOfCreasedFaces, RingsWithASharpSeamHaveSolidsWhereItOpens)
{
    // a section 100 long, smooth but for its sharp tail, where it begins and ends, turned about the z axis
    const Polyline section{{130, 0},  {110, 3},  {80, 12},  {45, 16},  {30, 10}, {30, 0},
                           {30, -10}, {45, -16}, {80, -12}, {110, -3}, {130, 0}};
    TColgp_Array1OfPnt poles(1, 11);
    TColStd_Array1OfReal knots(1, 9);
    TColStd_Array1OfInteger multiplicities(1, 9);
    for (int i = 1; i <= 11; ++i)
        poles(i) =
            gp_Pnt(section[static_cast<std::size_t>(i) - 1][0], 0.0, section[static_cast<std::size_t>(i) - 1][1]);
    for (int i = 1; i <= 9; ++i)
    {
        knots(i) = i - 1;
        multiplicities(i) = i == 1 || i == 9 ? 4 : 1;
    }
    const Handle(Geom_Curve) profile = new Geom_BSplineCurve(poles, knots, multiplicities, 3);
    const Handle(Geom_Surface) ring = new Geom_SurfaceOfRevolution(profile, gp::OZ());
    for (const double angle : {1.0, 2.0 * M_PI})
        for (const bool turned : {false, true})
        {
            SCOPED_TRACE(testing::Message() << angle << ' ' << turned);
            const TopoDS_Face plain = BRepBuilderAPI_MakeFace(ring, 0.0, angle, 0.0, 8.0, 1e-7);
            const TopoDS_Face face = turned ? TopoDS_Face(located(reversed(plain))) : plain;
            const double side = -crossing_side(face);
            const auto made = solids(face, 1.0 * side);
            ASSERT_TRUE(made.ok()) << made.failure().message;
            for (const std::vector<TopoDS_Solid> &parts : made.value())
                EXPECT_EQ(parts.size(), 2U);
            const auto crossed = solids(face, -1.0 * side);
            ASSERT_FALSE(crossed.ok());
            EXPECT_EQ(crossed.failure().status, Status::KinkedSurface) << crossed.failure().message;
        }
}

//! Two parabolas from their common tip at the origin, which rise by the given heights over a length of 50; the second one
//! turned about the tip.
TopoDS_Face cusp(double first, double second, double turn = 0.0)
{
    TColgp_Array2OfPnt net(1, 5, 1, 2);
    const double x[] = {50, 25, 0, 25, 50}, z[] = {first, 0, 0, 0, second};
    for (int i = 1; i <= 5; ++i)
        for (int j = 1; j <= 2; ++j)
        {
            const double angle = i > 3 ? turn : 0.0, a = x[i - 1], h = z[i - 1];
            net(i, j) = gp_Pnt(a * std::cos(angle) - h * std::sin(angle), j == 1 ? 0.0 : depth,
                               a * std::sin(angle) + h * std::cos(angle));
        }
    TColStd_Array1OfReal knots(1, 3), ends(1, 2);
    TColStd_Array1OfInteger multiplicities(1, 3), twice(1, 2);
    for (int i = 1; i <= 3; ++i)
        knots(i) = i - 1.0, multiplicities(i) = i == 2 ? 2 : 3;
    ends(1) = 0.0, ends(2) = 1.0, twice(1) = twice(2) = 2;
    return BRepBuilderAPI_MakeFace(new Geom_BSplineSurface(net, knots, ends, multiplicities, twice, 2, 1), 1e-7);
}

TEST(PartsOfCreasedFaces, ACuspOpensOnTheSideOfItsSkinsAndCrossesBetweenThem)
{
    struct Case
    {
        double first, second, turn;
        bool second_is_above; // or else below
    };
    for (const Case &c :
         {Case{5, -5, 0.0, false}, Case{-5, 5, 0.0, true}, Case{2, 4, 0.0, true}, Case{4, 2, 0.0, false},
          Case{5, -5, 1e-9, false}, Case{5, -5, -1e-9, false}, Case{-5, 5, 1e-13, true}, Case{-5, 5, -1e-13, true},
          Case{5, -5, -1e-3, false}, Case{-5, 5, 1e-3, true}})
        for (const bool turned : {false, true})
        {
            SCOPED_TRACE(testing::Message() << c.first << ' ' << c.second << ' ' << c.turn << ' ' << turned);
            const TopoDS_Face plain = cusp(c.first, c.second, c.turn);
            const TopoDS_Face face = turned ? TopoDS_Face(located(reversed(plain))) : plain;
            // S_u x S_v of the first part is -x times y, which is downwards
            const double above = turned ? 1.0 : -1.0;
            const double crosses = c.second_is_above ? above : -above;
            for (const double distance : {0.5, -0.5})
            {
                const auto made = offset(face, distance, tolerance);
                ASSERT_TRUE(made.ok()) << why(made);
                EXPECT_NEAR(*made.value().report.gap, 1.0, 0.02);
                ASSERT_TRUE(made.value().report.crease.has_value());
                EXPECT_EQ(*made.value().report.crease, distance * crosses > 0.0 ? CreaseKind::Overlap : CreaseKind::Gap)
                    << distance;
                if (distance * crosses > 0.0)
                {
                    const auto filled = solids(face, distance);
                    ASSERT_FALSE(filled.ok());
                    EXPECT_EQ(filled.failure().status, Status::KinkedSurface) << filled.failure().message;
                }
            }
        }
    for (const double distance :
         {0.5, -0.5}) // a sheet folded flat: the offsets are on its two sides, whichever is which
        for (const double rise : {0.0, 3.0})
        {
            const auto made = offset(cusp(rise, rise), distance, tolerance);
            ASSERT_TRUE(made.ok()) << why(made);
            ASSERT_TRUE(made.value().report.crease.has_value());
            EXPECT_EQ(*made.value().report.crease, CreaseKind::Gap);
        }
}

} // namespace
