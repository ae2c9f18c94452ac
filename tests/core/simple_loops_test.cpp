// SPDX-License-Identifier: LGPL-2.1-or-later
// Trimming loops that bound a region, proven from control points, against dense polylines and BRepCheck_Analyzer.
#include "support/data_files.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/topology/simple_loops.h>

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom_Plane.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace laminate_offset;
using namespace test_support;

namespace
{

using Points = std::vector<gp_Pnt2d>;
//! A loop of Bezier curves: each goes from its own first pole to that of the next curve.
using BezierLoop = std::vector<Points>;

Handle(Geom2d_BezierCurve) bezier(const BezierLoop &loop, std::size_t i)
{
    TColgp_Array1OfPnt2d poles(1, static_cast<int>(loop[i].size()) + 1);
    for (std::size_t k = 0; k < loop[i].size(); ++k)
        poles(static_cast<int>(k) + 1) = loop[i][k];
    poles(poles.Upper()) = loop[(i + 1) % loop.size()].front();
    return new Geom2d_BezierCurve(poles);
}

//! A face on the plane z = 0 with these loops as they are, whatever they look like.
TopoDS_Face plane_face(const std::vector<BezierLoop> &loops)
{
    const Handle(Geom_Plane) plane = new Geom_Plane(gp::XOY());
    BRep_Builder builder;
    TopoDS_Face face;
    builder.MakeFace(face, plane, 1e-7);
    for (const BezierLoop &loop : loops)
    {
        std::vector<TopoDS_Vertex> vertices;
        for (const Points &curve : loop)
            vertices.push_back(BRepBuilderAPI_MakeVertex(gp_Pnt(curve.front().X(), curve.front().Y(), 0.0)).Vertex());
        TopoDS_Wire wire;
        builder.MakeWire(wire);
        for (std::size_t i = 0; i < loop.size(); ++i)
        {
            TopoDS_Edge edge;
            builder.MakeEdge(edge);
            builder.UpdateEdge(edge, bezier(loop, i), plane, TopLoc_Location(), 1e-7);
            builder.Range(edge, 0.0, 1.0);
            builder.Add(edge, vertices[i].Oriented(TopAbs_FORWARD));
            builder.Add(edge, vertices[(i + 1) % loop.size()].Oriented(TopAbs_REVERSED));
            builder.Add(wire, edge);
        }
        wire.Closed(true);
        builder.Add(face, wire);
    }
    BRepLib::BuildCurves3d(face);
    return face;
}

BezierLoop polygon(const Points &corners)
{
    BezierLoop loop;
    for (const gp_Pnt2d &corner : corners)
        loop.push_back({corner});
    return loop;
}

//! Anticlockwise for a positive side.
BezierLoop square(double x, double y, double side)
{
    const double width = std::abs(side);
    const Points corners{{x, y}, {x + width, y}, {x + width, y + width}, {x, y + width}};
    return polygon(side > 0.0 ? corners : Points(corners.rbegin(), corners.rend()));
}

bool proven(const std::vector<BezierLoop> &loops)
{
    const TopoDS_Face face = plane_face(loops);
    const bool simple = loops_proven_simple(face);
    if (simple)
        EXPECT_TRUE(BRepCheck_Analyzer(face).IsValid());
    return simple;
}

//! What a fine polyline says of one loop.
struct Polyline
{
    Points points;
    double area = 0.0;
    double clearance = std::numeric_limits<double>::infinity(); //!< smallest distance of points far apart along it
    bool crosses_itself = false;
};

//! Do two segments cross, beyond the rounding that makes neighbours on one line seem to?
bool cross(const gp_Pnt2d &a, const gp_Pnt2d &b, const gp_Pnt2d &c, const gp_Pnt2d &d)
{
    const auto opposite_sides = [](const gp_Pnt2d &p, const gp_Pnt2d &q, const gp_Pnt2d &r, const gp_Pnt2d &s) {
        const gp_XY along = q.XY() - p.XY();
        const double of_r = along.Crossed(r.XY() - p.XY());
        const double of_s = along.Crossed(s.XY() - p.XY());
        const double rounding = 1e-9 * along.Modulus() * r.Distance(s);
        return of_r * of_s < 0.0 && std::min(std::abs(of_r), std::abs(of_s)) > rounding;
    };
    return opposite_sides(a, b, c, d) && opposite_sides(c, d, a, b);
}

Polyline traced(const BezierLoop &loop, std::size_t per_curve = 80)
{
    Polyline line;
    for (std::size_t i = 0; i < loop.size(); ++i)
        for (std::size_t k = 0; k < per_curve; ++k)
            line.points.push_back(bezier(loop, i)->Value(static_cast<double>(k) / static_cast<double>(per_curve)));
    const std::size_t n = line.points.size();
    for (std::size_t i = 0; i < n; ++i)
    {
        const gp_Pnt2d &a = line.points[i];
        const gp_Pnt2d &b = line.points[(i + 1) % n];
        line.area += 0.5 * a.XY().Crossed(b.XY());
        for (std::size_t j = 0; j < i; ++j)
        {
            const std::size_t along = std::min(i - j, n - (i - j));
            if (along > 1 && cross(a, b, line.points[j], line.points[(j + 1) % n]))
                line.crosses_itself = true;
            if (along > per_curve / 2)
                line.clearance = std::min(line.clearance, a.Distance(line.points[j]));
        }
    }
    return line;
}

} // namespace

TEST(SimpleLoops, ASquareIsProvenAndABowTieIsNot)
{
    for (const double size : {1e-3, 1.0, 1e6})
    {
        SCOPED_TRACE(size);
        EXPECT_TRUE(proven({square(0.0, 0.0, size)}));
        EXPECT_FALSE(proven({square(0.0, 0.0, -size)})) << "clockwise";
        EXPECT_FALSE(proven({polygon({{0.0, 0.0}, {size, size}, {size, 0.0}, {0.0, size}})}));
    }
}

TEST(SimpleLoops, HolesHaveToLieInsideBesideEachOtherAndGoRoundTheOtherWay)
{
    const BezierLoop outer = square(0.0, 0.0, 10.0);
    EXPECT_TRUE(proven({outer, square(2.0, 2.0, -3.0), square(6.0, 6.0, -3.0)}));
    EXPECT_TRUE(proven({square(2.0, 2.0, -3.0), outer})) << "in any order";
    EXPECT_FALSE(proven({outer, square(2.0, 2.0, 3.0)})) << "same way round";
    EXPECT_FALSE(proven({outer, square(12.0, 2.0, -3.0)})) << "outside";
    EXPECT_FALSE(proven({outer, square(8.0, 2.0, -3.0)})) << "across";
    EXPECT_FALSE(proven({outer, square(2.0, 2.0, -5.0), square(3.0, 3.0, -2.0)})) << "one in the other";
    EXPECT_FALSE(proven({outer, square(2.0, 2.0, -3.0), square(4.0, 4.0, -3.0)})) << "overlapping";
    EXPECT_FALSE(proven({outer, square(0.0, 4.0, -3.0)})) << "along the same line";
    EXPECT_FALSE(proven({outer, polygon({{0.0, 5.0}, {3.0, 6.0}, {3.0, 4.0}})})) << "touching";
}

TEST(SimpleLoops, CurvedNeighboursAreToldFromTouchingOnes)
{
    const auto lens = [](double bulge) {
        return BezierLoop{{{0.0, 0.0}, {3.0, -1.0}, {7.0, -1.0}}, {{10.0, 0.0}, {7.0, bulge}, {3.0, bulge}}};
    };
    EXPECT_TRUE(proven({lens(1.0)}));
    EXPECT_TRUE(proven({lens(-0.9)})) << "a thin crescent";
    EXPECT_FALSE(proven({lens(-1.0)})) << "one curve twice";
    EXPECT_FALSE(proven({lens(-1.1)})) << "clockwise";
    const BezierLoop loop_in_one_edge{{{0.0, 0.0}, {14.0, 10.0}, {-4.0, 10.0}}, {{10.0, 0.0}, {5.0, -3.0}}};
    EXPECT_FALSE(proven({loop_in_one_edge}));
}

TEST(SimpleLoops, OneClosedCurveIsALoop)
{
    EXPECT_TRUE(proven({BezierLoop{{{0.0, 0.0}, {8.0, 0.0}, {4.0, 8.0}, {-4.0, 8.0}, {-8.0, 0.0}}}}));
    EXPECT_FALSE(proven({BezierLoop{{{0.0, 0.0}, {8.0, 8.0}, {-8.0, 8.0}, {8.0, -8.0}, {-8.0, -8.0}}}}));
}

TEST(SimpleLoops, RandomLoopsAreProvenWhereTheyAreSimpleAndNowhereElse)
{
    RandomCases random;
    int simple = 0, simple_proven = 0, crossing = 0;
    for (int i = 0; i < 600; ++i)
    {
        const double size = random.magnitude(1e-2, 1e5);
        const double jitter = random.uniform(0.0, 1.2);
        const int corners = random.integer(2, 7);
        BezierLoop loop;
        for (int k = 0; k < corners; ++k)
        {
            const int degree = random.integer(1, 4);
            Points poles;
            for (int r = 0; r < degree; ++r)
            {
                const double angle = 2.0 * M_PI * (k + static_cast<double>(r) / degree) / corners;
                poles.emplace_back(size * (std::cos(angle) + jitter * random.uniform(-1.0, 1.0)),
                                   size * (std::sin(angle) + jitter * random.uniform(-1.0, 1.0)));
            }
            loop.push_back(poles);
        }
        const Polyline seen = traced(loop);
        const bool said = loops_proven_simple(plane_face({loop}));
        // a coarse polyline may cross where the curves do not
        const bool crosses = seen.crosses_itself && (!said || traced(loop, 1600).crosses_itself);
        if (crosses || seen.area < 0.0)
        {
            EXPECT_FALSE(said) << "loop " << i;
            ++crossing;
        }
        else if (seen.clearance > 0.05 * size)
        {
            ++simple;
            simple_proven += said ? 1 : 0;
        }
    }
    EXPECT_GE(crossing, 100);
    EXPECT_GE(simple, 100);
    EXPECT_GE(simple_proven, 0.98 * simple);
}

TEST(SimpleLoops, WhatIsProvenOfRealFacesPassesTheGeneralCheck)
{
    int valid = 0, valid_proven = 0;
    for (const char *name : {"psas_nose_mold.igs", "cpacs_seat.stp", "nist_MBE_PMI_5.stp", "tigl_D150_fused_faces.brep",
                             "dagmc_curved_extrude.stp", "axom_boxed_sphere.step"})
    {
        const auto path = find_data_file(name);
        if (!path)
            GTEST_SKIP() << missing_data_message(name);
        int number = 0;
        for (const TopoDS_Face &face : read_faces(*path))
        {
            ++number;
            const bool checked = BRepCheck_Analyzer(face).IsValid();
            const bool said = loops_proven_simple(face);
            valid += checked ? 1 : 0;
            valid_proven += checked && said ? 1 : 0;
            EXPECT_TRUE(checked || !said) << name << " face " << number;
        }
    }
    EXPECT_GE(valid, 400);
    EXPECT_GE(valid_proven, 0.9 * valid);
}
