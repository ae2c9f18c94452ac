// SPDX-License-Identifier: LGPL-2.1-or-later
// Swept arcs that cross the zero of their circle or ellipse, with loops on the arc's own turn or beside it.
#include "support/offset_oracle.h"
#include "support/offsets.h"

#include <laminate_offset/face_integrals.h>
#include <laminate_offset/nearest_point.h>
#include <laminate_offset/offset_limits.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <gp_Ax1.hxx>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace laminate_offset;
using namespace test_support;

namespace
{

constexpr double tolerance = 1e-3;

TopoDS_Face inside_of(const Handle(Geom_Surface) & surface, const std::array<gp_Pnt2d, 4> &corners)
{
    BRepBuilderAPI_MakeWire wire;
    for (std::size_t i = 0; i < 4; ++i)
    {
        const Handle(Geom2d_TrimmedCurve) side = GCE2d_MakeSegment(corners[i], corners[(i + 1) % 4]).Value();
        const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(side, surface);
        BRepLib::BuildCurve3d(edge);
        wire.Add(edge);
    }
    return BRepBuilderAPI_MakeFace(surface, wire.Wire(), true);
}

void expect_right(const TopoDS_Face &face)
{
    for (const double distance : {1.5, -1.5})
    {
        SCOPED_TRACE(distance);
        const auto result = offset(face, distance, tolerance);
        ASSERT_TRUE(result.ok()) << why(result);
        const OracleReport seen = measure_offset(face, result.value().face(), distance, {30, 40});
        EXPECT_TRUE(confirms(seen, tolerance)) << to_text(seen);
        EXPECT_GT(seen.points, 100);
        ASSERT_TRUE(result.value().report.certified_error.has_value());
        EXPECT_LE(*result.value().report.certified_error, tolerance);
    }
    EXPECT_TRUE(offset_limits(face).ok());
    EXPECT_TRUE(face_integrals(face).ok());
    const InputFace input = read_face(face).value();
    const gp_Pnt2d middle(0.5 * (input.box.umin + input.box.umax), 0.5 * (input.box.vmin + input.box.vmax));
    const gp_Pnt on = input.place(middle).point;
    for (const bool trimmed : {false, true})
    {
        const auto found = nearest_points(face, {on}, trimmed);
        ASSERT_TRUE(found.ok()) << found.failure().message;
        EXPECT_LE(found.value().front().distance, 1e-9);
        EXPECT_LE(found.value().front().uv.Distance(middle), 1e-6);
    }
}

} // namespace

TEST(SweptArc, OverItsCirclesZero)
{
    const gp_Ax2 plane(gp_Pnt(40, 0, 5), gp_Dir(0, -1, 0), gp_Dir(1, 0, 0));
    const gp_Ax1 axis(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
    for (const Handle(Geom_Curve) & whole :
         {Handle(Geom_Curve)(new Geom_Circle(plane, 12.0)), Handle(Geom_Curve)(new Geom_Ellipse(plane, 12.0, 9.0))})
        for (const auto &[low, high] : {std::pair{-1.0, 1.0}, {-0.4, 0.9}, {-0.5, 0.0}})
            for (const double turns : {-1.0, 0.0, 1.0})
                for (const double slant : {0.0, 0.2})
                {
                    SCOPED_TRACE(testing::Message() << low << ' ' << high << ' ' << turns << ' ' << slant);
                    const double a = low + 2.0 * M_PI * turns;
                    const double b = high + 2.0 * M_PI * turns;
                    const Handle(Geom_Curve) arc = new Geom_TrimmedCurve(whole, low, high);
                    const Handle(Geom_Surface) turned = new Geom_SurfaceOfRevolution(arc, axis);
                    expect_right(inside_of(turned, {{{0.3, a}, {2.0, a + slant}, {2.0, b}, {0.3, b}}}));
                    const Handle(Geom_Surface) drawn = new Geom_SurfaceOfLinearExtrusion(arc, gp_Dir(0.1, 1, 0.2));
                    expect_right(inside_of(drawn, {{{a, 0.0}, {b, 0.0}, {b, 20.0}, {a + slant, 20.0}}}));
                }
}
