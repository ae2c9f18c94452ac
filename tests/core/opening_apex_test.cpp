// SPDX-License-Identifier: LGPL-2.1-or-later
// Splines that come to a point with a normal of its own on every ruling: outwards the point opens into an edge.
#include "support/data_files.h"
#include "support/offset_oracle.h"
#include "support/offsets.h"
#include "support/sample_faces.h"

#include <laminate_offset/offset_face.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GeomConvert.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>

#include <gtest/gtest.h>

#include <cmath>

using namespace laminate_offset;
using namespace test_support;

namespace
{

constexpr double tolerance = 1e-3;
constexpr double half_angle = 0.5;
constexpr double radius = 6.0;
// The oracle takes the normal at the apex from tangents a ten millionth of the face beside it: of its rounding, which
// is largest on the narrowest face (the surface itself is compared everywhere, and more sharply).
constexpr double oracle_angle = 1e-5;

//! A cone from its apex on as a rational spline over part of the turn; its outward normal points away from the axis.
TopoDS_Face rational_cone(double turn)
{
    const Handle(Geom_Surface) cone = new Geom_ConicalSurface(gp_Ax3(), half_angle, radius);
    const Handle(Geom_Surface) part =
        new Geom_RectangularTrimmedSurface(cone, 0.3, 0.3 + turn, -radius / std::sin(half_angle), 5.0);
    return BRepBuilderAPI_MakeFace(GeomConvert::SurfaceToBSplineSurface(part), 1e-7);
}

//! A cone over a parabola as a polynomial spline; rulings along u from the apex at u = 0.
TopoDS_Face polynomial_cone()
{
    const Handle(Geom_BSplineSurface) cone = height_surface([](double x, double) { return x; }, 10.0, 10.0, 4, 4);
    const gp_Pnt apex(-30.0, 0.0, 40.0);
    for (int j = 1; j <= 4; ++j)
    {
        const double y = -20.0 + 40.0 * (j - 1) / 3.0;
        const gp_Pnt foot(30.0, y, 0.05 * y * y);
        for (int i = 1; i <= 4; ++i)
            cone->SetPole(i, j, gp_Pnt(apex.XYZ() + (foot.XYZ() - apex.XYZ()) * ((i - 1) / 3.0)));
    }
    return BRepBuilderAPI_MakeFace(cone, 1e-7);
}

int count(const TopoDS_Shape &shape, TopAbs_ShapeEnum kind)
{
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(shape, kind, map);
    return map.Extent();
}

struct PointEdges
{
    int closed = 0;      //!< edges without a curve
    double length = 0.0; //!< of the edges that have a curve where the base has none
};

PointEdges at_points(const TopoDS_Face &base, const TopoDS_Face &made)
{
    TopTools_IndexedMapOfShape before, after;
    TopExp::MapShapes(base, TopAbs_EDGE, before);
    TopExp::MapShapes(made, TopAbs_EDGE, after);
    PointEdges edges;
    for (int i = 1; i <= before.Extent(); ++i)
        if (BRep_Tool::Degenerated(TopoDS::Edge(before(i))))
        {
            const TopoDS_Edge &edge = TopoDS::Edge(after(i));
            if (BRep_Tool::Degenerated(edge))
                ++edges.closed;
            else
                edges.length += GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(edge));
        }
    return edges;
}

//! Every edge of the wire starts at the vertex where the one before ends, and all edges are met.
void expect_closed_wire(const TopoDS_Face &face)
{
    const TopoDS_Wire wire = BRepTools::OuterWire(face);
    int edges = 0, met = 0;
    TopoDS_Vertex first, last;
    for (TopoDS_Iterator it(wire); it.More(); it.Next())
        ++edges;
    for (BRepTools_WireExplorer it(wire, face); it.More(); it.Next(), ++met)
    {
        const TopoDS_Vertex start = TopExp::FirstVertex(it.Current(), true);
        if (met == 0)
            first = start;
        else
            EXPECT_TRUE(start.IsSame(last)) << "edge " << met;
        last = TopExp::LastVertex(it.Current(), true);
    }
    EXPECT_EQ(met, edges);
    EXPECT_TRUE(first.IsSame(last));
}

void expect_right(const TopoDS_Face &base, const TopoDS_Face &made, const OffsetReport &report, double distance)
{
    const OracleReport seen = measure_offset(base, made, distance, {60, 60});
    EXPECT_TRUE(confirms(seen, tolerance)) << to_text(seen);
    ASSERT_TRUE(report.certified_error && report.edge_error);
    EXPECT_LE(seen.parametric_error, *report.certified_error + 1e-9);
    EXPECT_LE(seen.edge_error, *report.edge_error + 1e-9 + oracle_angle * std::abs(distance));
    EXPECT_LE(*report.edge_error, tolerance);
    EXPECT_TRUE(BRepCheck_Analyzer(made).IsValid());
    expect_closed_wire(made);
}

} // namespace

TEST(OpeningApex, OfARationalConeBecomesAnArc)
{
    for (const double turn : {2.0 * M_PI, 1.9 * M_PI, M_PI, 0.5 * M_PI, 0.05})
        for (const double distance : {0.01, 0.5, 6.0})
            for (const bool turned : {false, true})
            {
                SCOPED_TRACE(testing::Message() << "turn " << turn << " distance " << distance << " turned " << turned);
                const TopoDS_Face cone = rational_cone(turn);
                const TopoDS_Face base = turned ? located(reversed(cone)) : cone;
                const double outwards = turned ? -distance : distance;
                const auto result = offset(base, outwards, tolerance);
                ASSERT_TRUE(result.ok()) << why(result);
                const TopoDS_Face made = result.value().face();
                expect_right(base, made, result.value().report, outwards);
                const PointEdges opened = at_points(base, made);
                EXPECT_EQ(opened.closed, 0);
                EXPECT_NEAR(opened.length, turn * distance * std::cos(half_angle), 2.0 * turn * tolerance);
                const int more = turn < 2.0 * M_PI ? 1 : 0; // the apex is two vertices, unless the arc closes
                EXPECT_EQ(count(made, TopAbs_VERTEX), count(base, TopAbs_VERTEX) + more);
            }
}

TEST(OpeningApex, OfAPolynomialConeBecomesACurve)
{
    const TopoDS_Face cone = polynomial_cone();
    int opened = 0;
    for (const double distance : {0.05, -0.05, 2.0, -2.0, 15.0, -15.0})
        for (const bool turned : {false, true})
        {
            SCOPED_TRACE(testing::Message() << "distance " << distance << " turned " << turned);
            const TopoDS_Face base = turned ? reversed(cone) : cone;
            const auto result = offset(base, distance, tolerance);
            if (!result.ok())
            {
                EXPECT_EQ(result.failure().status, Status::CurvatureLimit) << why(result);
                ASSERT_TRUE(result.failure().where.has_value());
                EXPECT_LT(result.failure().where->point.Distance(gp_Pnt(-30.0, 0.0, 40.0)), 1.0);
                continue;
            }
            ++opened;
            expect_right(base, result.value().face(), result.value().report, distance);
            EXPECT_GT(at_points(base, result.value().face()).length, 0.0);
            EXPECT_EQ(count(result.value().face(), TopAbs_VERTEX), 4);
            EXPECT_EQ(count(base, TopAbs_VERTEX), 3);
        }
    EXPECT_EQ(opened, 6) << "one side of the cone opens, on the other it folds";
}

TEST(OpeningApex, IsRefusedInwards)
{
    for (const double turn : {2.0 * M_PI, M_PI, 0.5 * M_PI})
        for (const double distance : {-1e-2, -0.5, -20.0})
        {
            const auto result = offset(rational_cone(turn), distance, tolerance);
            ASSERT_FALSE(result.ok()) << distance;
            EXPECT_EQ(result.failure().status, Status::CurvatureLimit) << why(result);
        }
}

TEST(OpeningApex, StaysAPointWithinTheTolerance)
{
    for (const double turn : {2.0 * M_PI, M_PI, 0.5 * M_PI})
        for (const double distance : {0.0, 1e-9, 1e-6, 2e-5})
        {
            SCOPED_TRACE(testing::Message() << "turn " << turn << " distance " << distance);
            const TopoDS_Face base = rational_cone(turn);
            const auto result = offset(base, distance, tolerance);
            ASSERT_TRUE(result.ok()) << why(result);
            expect_right(base, result.value().face(), result.value().report, distance);
            EXPECT_EQ(at_points(base, result.value().face()).closed, 1);
            EXPECT_EQ(count(result.value().face(), TopAbs_VERTEX), count(base, TopAbs_VERTEX));
        }
}

TEST(OpeningApex, OpensOnRealHalfCones)
{
    const auto file = find_data_file("nist_MBE_PMI_5.stp");
    if (!file)
        GTEST_SKIP() << missing_data_message("nist_MBE_PMI_5.stp");
    const std::vector<TopoDS_Face> faces = read_faces(*file);
    for (const std::size_t number : {52, 54, 60, 62, 131, 133, 134, 136})
        for (const double distance : {-0.02, -0.5, -4.0})
        {
            SCOPED_TRACE(testing::Message() << "face " << number << " distance " << distance);
            const TopoDS_Face &base = faces.at(number - 1);
            const auto result = offset(base, distance, tolerance);
            ASSERT_TRUE(result.ok()) << why(result);
            expect_right(base, result.value().face(), result.value().report, distance);
            EXPECT_EQ(count(result.value().face(), TopAbs_VERTEX), count(base, TopAbs_VERTEX) + 1);
            EXPECT_GT(at_points(base, result.value().face()).length, std::abs(distance));
        }
}
