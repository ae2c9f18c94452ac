// SPDX-License-Identifier: LGPL-2.1-or-later
// What must not matter does not matter: place, size, direction of the parameters, their ranges, needless poles, and
// tolerances of the input larger than the user's.
#include "support/deviation.h"
#include "support/offsets.h"
#include "support/parameters.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

#include <gtest/gtest.h>

#include <cmath>

using namespace laminate_offset;
using namespace test_support;

namespace
{

constexpr double face_tolerance = 1e-9;

double wave(double x, double y) { return 6.0 * std::sin(0.031 * x) * std::cos(0.043 * y) + 4e-4 * x * y; }

Handle(Geom_BSplineSurface) sheet(int poles_u = 9, int poles_v = 8)
{
    return height_surface(wave, 200.0, 150.0, poles_u, poles_v);
}

//! A certified offset of the whole surface that keeps within the tolerance by an independent measure.
OffsetReport expect_right(const Handle(Geom_BSplineSurface) & base, double distance, double tolerance)
{
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(base, face_tolerance);
    const auto result = offset(face, distance, tolerance);
    EXPECT_TRUE(result.ok()) << why(result);
    if (!result.ok())
        return {};
    Rectangle box;
    BRepTools::UVBounds(face, box.u0, box.u1, box.v0, box.v1);
    const Deviation seen = deviation(base, BRep_Tool::Surface(result.value().face()), box, distance, 57);
    const OffsetReport &report = result.value().report;
    EXPECT_GT(seen.points, 57 * 57 / 2);
    EXPECT_TRUE(report.certified_error.has_value());
    EXPECT_LE(report.certified_error.value_or(HUGE_VAL), tolerance);
    EXPECT_LE(seen.largest, report.certified_error.value_or(0.0) + 1e-12 * std::abs(distance) + 1e-13);
    EXPECT_LE(report.edge_error.value_or(HUGE_VAL), tolerance);
    EXPECT_TRUE(BRepCheck_Analyzer(result.value().face()).IsValid());
    return report;
}

int poles(const OffsetReport &report) { return report.surface ? report.surface->poles_u * report.surface->poles_v : 0; }

void rescale_knots(const Handle(Geom_BSplineSurface) & surface, double u_range, double v_range)
{
    move_parameters(surface, -3.0 * u_range, u_range, 7.0 * v_range, v_range);
}

} // namespace

TEST(Similarity, MovingAndTurningChangesNoPoleCount)
{
    RandomCases random;
    const int still = poles(expect_right(sheet(), 3.0, 1e-3));
    for (int run = 0; run < 4; ++run)
    {
        gp_Trsf turn, move;
        turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(random.uniform(-1, 1), random.uniform(-1, 1), 1.0)),
                         random.uniform(0.0, 6.0));
        move.SetTranslation(gp_Vec(random.uniform(-1e4, 1e4), random.uniform(-1e4, 1e4), random.uniform(-1e4, 1e4)));
        const auto moved = Handle(Geom_BSplineSurface)::DownCast(sheet()->Transformed(move * turn));
        EXPECT_NEAR(poles(expect_right(moved, 3.0, 1e-3)), still, 0.1 * still);
    }
}

TEST(Similarity, ScalingEverythingChangesNoPoleCount)
{
    const int plain = poles(expect_right(sheet(), -3.0, 1e-3));
    for (const double scale : {1e-2, 1e1, 1e3})
    {
        SCOPED_TRACE(scale);
        gp_Trsf grow;
        grow.SetScaleFactor(scale);
        const auto scaled = Handle(Geom_BSplineSurface)::DownCast(sheet()->Transformed(grow));
        EXPECT_NEAR(poles(expect_right(scaled, -3.0 * scale, 1e-3 * scale)), plain, 0.1 * plain);
    }
}

TEST(Similarity, SwappedAndReversedParametersChangeTheSideOnly)
{
    const OffsetReport plain = expect_right(sheet(), 3.0, 1e-3);
    const Handle(Geom_BSplineSurface) swapped = sheet();
    swapped->ExchangeUV();
    const OffsetReport exchanged = expect_right(swapped, -3.0, 1e-3);
    EXPECT_NEAR(poles(exchanged), poles(plain), 0.1 * poles(plain));
    EXPECT_NEAR(exchanged.surface->poles_u, plain.surface->poles_v, 2);
    const Handle(Geom_BSplineSurface) reversed = sheet();
    reversed->UReverse();
    EXPECT_NEAR(poles(expect_right(reversed, -3.0, 1e-3)), poles(plain), 0.1 * poles(plain));
}

TEST(Robustness, ParameterRangesOfAnySizeAreTheSameFace)
{
    const int plain = poles(expect_right(sheet(), 3.0, 1e-3));
    for (const auto &[u, v] : {std::pair{1e-6, 1e6}, std::pair{1e6, 1e-3}, std::pair{1e-5, 1e-5}})
    {
        SCOPED_TRACE(testing::Message() << u << " x " << v);
        const Handle(Geom_BSplineSurface) surface = sheet();
        rescale_knots(surface, u, v);
        EXPECT_NEAR(poles(expect_right(surface, 3.0, 1e-3)), plain, 0.1 * plain);
    }
}

TEST(Robustness, ThousandsOfPolesCostOnlyWhatTheShapeNeeds)
{
    for (const double distance : {2.0, -2.0})
    {
        const OffsetReport report = expect_right(sheet(90, 80), distance, 1e-3);
        EXPECT_GT(poles(report), 0);
        EXPECT_LT(poles(report), 90 * 80 / 10);
    }
}

TEST(Robustness, ADerivativeThatVanishesAlongABorderIsNoPole)
{
    // the first two rows of poles coincide: S_u is zero on the border, which is a line all the same
    for (const double distance : {2.0, -2.0})
    {
        const Handle(Geom_BSplineSurface) surface = sheet();
        for (int j = 1; j <= surface->NbVPoles(); ++j)
            surface->SetPole(2, j, surface->Pole(1, j));
        const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, face_tolerance);
        const auto result = offset(face, distance, 1e-2);
        if (!result.ok()) // a refusal has to say where
        {
            EXPECT_TRUE(result.failure().where.has_value()) << why(result);
            continue;
        }
        EXPECT_LE(result.value().report.certified_error.value_or(HUGE_VAL), 1e-2);
        EXPECT_TRUE(BRepCheck_Analyzer(result.value().face()).IsValid());
    }
}

TEST(Robustness, ToleranceOfTheInputMayBeLargerThanTheUsers)
{
    const TopoDS_Face face = panel_with_hole();
    BRep_Builder builder;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
        builder.UpdateEdge(TopoDS::Edge(it.Current()), 0.05);
    for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More(); it.Next())
        builder.UpdateVertex(TopoDS::Vertex(it.Current()), 0.06);
    for (const double distance : {4.0, -4.0})
    {
        const auto result = offset(face, distance, 1e-4);
        ASSERT_TRUE(result.ok()) << why(result);
        EXPECT_LE(result.value().report.certified_error.value_or(HUGE_VAL), 1e-4);
        EXPECT_LE(result.value().report.edge_error.value_or(HUGE_VAL), 1e-4);
        EXPECT_TRUE(BRepCheck_Analyzer(result.value().face()).IsValid());
    }
}

//! A triangle of parameters whose sides overrun two of its corners, whose vertices hold that.
TopoDS_Face with_crossing_corners(const Handle(Geom_Surface) & surface, double overrun, double vertex_tolerance)
{
    const gp_Pnt2d corners[] = {{0.2, 0.2}, {0.8, 0.3}, {0.4, 0.8}};
    const BRep_Builder builder;
    TopoDS_Vertex vertices[3];
    for (int i = 0; i < 3; ++i)
        builder.MakeVertex(vertices[i], surface->Value(corners[i].X(), corners[i].Y()), vertex_tolerance);
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (int i = 0; i < 3; ++i)
    {
        const gp_Vec2d way(corners[i], corners[(i + 1) % 3]);
        const double before = i == 1 ? overrun : 0.0, after = i == 0 || i == 1 ? overrun : 0.0;
        TopoDS_Edge edge;
        builder.MakeEdge(edge);
        builder.UpdateEdge(edge, new Geom2d_Line(corners[i].Translated(-before * way), gp_Dir2d(way)), surface,
                           TopLoc_Location(), 1e-7);
        builder.Add(edge, TopoDS::Vertex(vertices[i].Oriented(TopAbs_FORWARD)));
        builder.Add(edge, TopoDS::Vertex(vertices[(i + 1) % 3].Oriented(TopAbs_REVERSED)));
        builder.Range(edge, surface, TopLoc_Location(), 0.0, (1.0 + before + after) * way.Magnitude());
        BRepLib::BuildCurve3d(edge, 1e-7);
        builder.Add(wire, edge);
    }
    TopoDS_Face face;
    builder.MakeFace(face, surface, 1e-7);
    builder.Add(face, wire);
    return face;
}

TEST(Robustness, EdgesMayCrossInsideAVertexOfTheBase)
{
    for (const double overrun : {2e-7, 1e-5, 1e-4})
        for (const double distance : {3.0, -3.0})
        {
            SCOPED_TRACE(testing::Message() << "overrun " << overrun << " distance " << distance);
            const double wide = 400.0 * overrun; // the triangle's sides are some 120 mm long
            const TopoDS_Face base = with_crossing_corners(sheet(), overrun, wide);
            ASSERT_TRUE(BRepCheck_Analyzer(base).IsValid());
            const auto result = offset(base, distance, 1e-3);
            ASSERT_TRUE(result.ok()) << why(result);
            EXPECT_TRUE(BRepCheck_Analyzer(result.value().shape).IsValid());
            ASSERT_TRUE(result.value().report.edge_error);
            EXPECT_LE(*result.value().report.edge_error, 1e-3) << "curves are as near as ever";
            for (TopExp_Explorer it(result.value().shape, TopAbs_VERTEX); it.More(); it.Next())
                EXPECT_LE(BRep_Tool::Tolerance(TopoDS::Vertex(it.Current())), wide + 1e-3);
            if (overrun < 1e-5) // the edges' own tolerances hold that
                continue;
            const auto narrow = offset(with_crossing_corners(sheet(), overrun, 1e-7), distance, 1e-3);
            ASSERT_FALSE(narrow.ok()) << "no vertex of the base holds the crossing";
            EXPECT_EQ(narrow.failure().status, Status::InvalidResult);
        }
}
