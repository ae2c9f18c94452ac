// SPDX-License-Identifier: LGPL-2.1-or-later
// Loops that touch themselves or each other in one point, and loops of three sides: offset right to both sides, or refused
// by name and place.
#include "support/offset_oracle.h"
#include "support/offsets.h"
#include "support/sample_faces.h"

#include <laminate_offset/face_integrals.h>
#include <laminate_offset/offset_face.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Line.hxx>
#include <GeomConvert.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <ShapeFix_Face.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pln.hxx>
#include <gtest/gtest.h>

#include <cmath>

using namespace laminate_offset;
using namespace test_support;

namespace
{

constexpr double tolerance = 1e-3;

//! A side of a loop: straight in the parameters, or bent by this part of its length.
struct Side
{
    gp_Pnt2d from;
    double bend = 0.0;
};
using Loop = std::vector<Side>;

//! Builds faces from loops in the parameters. Corners at the same place of space are one vertex.
class FaceMaker
{
public:
    explicit FaceMaker(const Handle(Geom_Surface) & surface) : m_surface(surface)
    {
        m_builder.MakeFace(m_face, surface, 1e-7);
    }

    void add(const Loop &loop)
    {
        TopoDS_Wire wire;
        m_builder.MakeWire(wire);
        for (std::size_t i = 0; i < loop.size(); ++i)
            m_builder.Add(wire, edge(loop[i], loop[(i + 1) % loop.size()].from));
        wire.Closed(true);
        m_builder.Add(m_face, wire);
    }

    TopoDS_Face face()
    {
        BRepLib::BuildCurves3d(m_face, 1e-6);
        BRepLib::SameParameter(m_face, 1e-6);
        return m_face;
    }

private:
    TopoDS_Vertex vertex(const gp_Pnt2d &uv)
    {
        const gp_Pnt point = m_surface->Value(uv.X(), uv.Y());
        for (const TopoDS_Vertex &known : m_vertices)
            if (BRep_Tool::Pnt(known).Distance(point) < 1e-7)
                return known;
        TopoDS_Vertex vertex;
        m_builder.MakeVertex(vertex, point, 1e-6);
        m_vertices.push_back(vertex);
        return vertex;
    }

    TopoDS_Edge edge(const Side &side, const gp_Pnt2d &to)
    {
        const gp_Vec2d way(side.from, to);
        double last = way.Magnitude();
        Handle(Geom2d_Curve) pcurve = new Geom2d_Line(side.from, gp_Dir2d(way));
        if (side.bend != 0.0)
        {
            TColgp_Array1OfPnt2d poles(1, 3);
            poles(1) = side.from;
            poles(2) = gp_Pnt2d(0.5 * (side.from.XY() + to.XY()) + side.bend * gp_XY(way.Y(), -way.X()));
            poles(3) = to;
            pcurve = new Geom2d_BezierCurve(poles);
            last = 1.0;
        }
        const TopoDS_Vertex first_vertex = vertex(side.from);
        const TopoDS_Vertex last_vertex = vertex(to);
        TopoDS_Edge edge;
        m_builder.MakeEdge(edge);
        m_builder.UpdateEdge(edge, pcurve, m_surface, TopLoc_Location(), 1e-7);
        m_builder.Add(edge, TopoDS::Vertex(first_vertex.Oriented(TopAbs_FORWARD)));
        m_builder.Add(edge, TopoDS::Vertex(last_vertex.Oriented(TopAbs_REVERSED)));
        m_builder.Range(edge, 0.0, last);
        const gp_Pnt2d middle = pcurve->Value(0.5 * last);
        const gp_Pnt ends = BRep_Tool::Pnt(first_vertex);
        if (first_vertex.IsSame(last_vertex) && m_surface->Value(middle.X(), middle.Y()).Distance(ends) < 1e-7)
            m_builder.Degenerated(edge, true);
        return edge;
    }

    Handle(Geom_Surface) m_surface;
    BRep_Builder m_builder;
    TopoDS_Face m_face;
    std::vector<TopoDS_Vertex> m_vertices;
};

TopoDS_Face face_of(const Handle(Geom_Surface) & surface, const std::vector<Loop> &loops)
{
    FaceMaker maker(surface);
    for (const Loop &loop : loops)
        maker.add(loop);
    return maker.face();
}

//! A piece of a surface as a unit square of parameters: surfaces of several kinds, about 100 mm wide.
struct Ground
{
    const char *name;
    Handle(Geom_Surface) surface;
    ParameterBox box;

    [[nodiscard]] std::vector<Loop> placed(std::vector<Loop> loops) const
    {
        for (Loop &loop : loops)
            for (Side &side : loop)
                side.from = gp_Pnt2d(box.umin + side.from.X() * (box.umax - box.umin),
                                     box.vmin + side.from.Y() * (box.vmax - box.vmin));
        return loops;
    }
};

std::vector<Ground> grounds()
{
    const Handle(Geom_Surface) bumpy = height_surface(
        [](double x, double y) { return 9.0 * std::sin(0.03 * x) * std::cos(0.04 * y); }, 100.0, 100.0, 9, 8);
    return {{"plane", new Geom_Plane(gp_Ax3(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 2))), {0, 100, 0, 100}},
            {"cylinder", new Geom_CylindricalSurface(gp_Ax3(), 60.0), {0.3, 2.0, 0, 100}},
            {"sphere", new Geom_SphericalSurface(gp_Ax3(), 60.0), {0.3, 2.0, -0.7, 0.9}},
            {"bumpy spline", bumpy, {0, 1, 0, 1}}};
}

//! Offsets to both sides are right, valid and proven, with the base's loops and vertices.
void expect_right(const TopoDS_Face &base)
{
    ASSERT_TRUE(BRepCheck_Analyzer(base).IsValid());
    for (const double distance : {3.0, -3.0})
    {
        SCOPED_TRACE(distance);
        const auto result = offset(base, distance, tolerance);
        ASSERT_TRUE(result.ok()) << why(result);
        const TopoDS_Face made = result.value().face();
        EXPECT_TRUE(BRepCheck_Analyzer(made).IsValid());
        const OracleReport seen = measure_offset(base, made, distance, {60, 60});
        EXPECT_TRUE(confirms(seen, tolerance)) << to_text(seen);
        EXPECT_GT(seen.points, 100);
        const OffsetReport &report = result.value().report;
        ASSERT_TRUE(report.certified_error && report.edge_error);
        EXPECT_LE(*report.certified_error, tolerance);
        EXPECT_LE(*report.edge_error, tolerance);
        EXPECT_LE(seen.parametric_error, *report.certified_error + 1e-9);
    }
    GProp_GProps area;
    BRepGProp::SurfaceProperties(base, area, 1e-7);
    const auto ours = face_integrals(base);
    ASSERT_TRUE(ours.ok()) << ours.failure().message;
    EXPECT_NEAR(ours.value().area, area.Mass(), 1e-4 * area.Mass());
}

//! OpenCASCADE takes faces for invalid whose loops touch themselves, and on a cylinder some whose loops touch each other: they
//! are refused with the place. Others are right.
bool right_or_refused(const TopoDS_Face &base, const gp_Pnt &touch)
{
    if (BRepCheck_Analyzer(base).IsValid())
    {
        expect_right(base);
        return true;
    }
    for (const double distance : {3.0, -3.0})
    {
        const auto result = offset(base, distance, tolerance);
        EXPECT_FALSE(result.ok()) << "no invalid face is handed out";
        if (result.ok())
            continue;
        EXPECT_EQ(result.failure().status, Status::InvalidResult) << why(result);
        EXPECT_NE(result.failure().message.find("touch"), std::string::npos) << why(result);
        EXPECT_TRUE(result.failure().where.has_value());
        if (result.failure().where)
        {
            EXPECT_LT(result.failure().where->point.Distance(touch), 1e-6);
        }
    }
    return false;
}

} // namespace

TEST(TouchingLoops, ALoopThatTouchesItselfInAPoint)
{
    const Loop hourglass{{{0.1, 0.1}}, {{0.9, 0.1}}, {{0.5, 0.5}}, {{0.9, 0.9}}, {{0.1, 0.9}}, {{0.5, 0.5}}};
    const Loop bent{{{0.1, 0.1}, 0.1},  {{0.9, 0.1}, -0.1}, {{0.5, 0.5}, 0.1},
                    {{0.9, 0.9}, -0.1}, {{0.1, 0.9}, 0.1},  {{0.5, 0.5}, -0.1}};
    const Loop bay{{{0.1, 0.1}}, {{0.5, 0.1}}, {{0.3, 0.6}}, {{0.7, 0.6}}, {{0.5, 0.1}}, {{0.9, 0.1}}, {{0.5, 0.9}}};
    int tried = 0;
    for (const Ground &ground : grounds())
        for (const Loop &loop : {hourglass, bent, bay})
        {
            SCOPED_TRACE(testing::Message() << ground.name << ' ' << loop.size() << ' ' << loop.front().bend);
            const std::vector<Loop> placed = ground.placed({loop});
            const gp_Pnt2d touch = placed.front()[loop.size() == 6 ? 2 : 1].from;
            right_or_refused(face_of(ground.surface, placed), ground.surface->Value(touch.X(), touch.Y()));
            ++tried;
        }
    EXPECT_EQ(tried, 12);
}

//! A side shorter than what counts as one place does not make its neighbours touch: the loop crosses itself elsewhere.
TEST(TouchingLoops, ATinySideIsNoTouch)
{
    for (const double tiny : {5e-7, 50.0})
    {
        FaceMaker maker(new Geom_Plane(gp_Pln()));
        maker.add({{{0, 0}}, {{tiny, 0}}, {{1000, 600}}, {{1000, 0}}, {{0, 1000}}});
        const auto result = offset(maker.face(), 1.0, tolerance);
        ASSERT_FALSE(result.ok()) << tiny;
        EXPECT_EQ(result.failure().status, Status::InvalidResult) << why(result);
        EXPECT_FALSE(result.failure().where) << why(result);
        EXPECT_EQ(result.failure().message.find("touch"), std::string::npos) << why(result);
    }
}

TEST(TouchingLoops, TwoLoopsThatTouchInAPoint)
{
    const Loop square{{{0.1, 0.1}}, {{0.5, 0.1}}, {{0.9, 0.1}}, {{0.9, 0.9}}, {{0.1, 0.9}}};
    const Loop from_border{{{0.5, 0.1}}, {{0.3, 0.6}}, {{0.7, 0.6}}};
    const Loop left{{{0.5, 0.5}}, {{0.2, 0.3}, 0.1}, {{0.2, 0.7}}};
    const Loop right{{{0.5, 0.5}}, {{0.8, 0.7}}, {{0.8, 0.3}, -0.1}};
    int right_ones = 0;
    for (const Ground &ground : grounds())
        for (const std::vector<Loop> &loops : {std::vector<Loop>{square, from_border}, {square, left, right}})
        {
            SCOPED_TRACE(testing::Message() << ground.name << ' ' << loops.size());
            const std::vector<Loop> placed = ground.placed(loops);
            const gp_Pnt2d touch = placed[1].front().from;
            right_ones +=
                right_or_refused(face_of(ground.surface, placed), ground.surface->Value(touch.X(), touch.Y())) ? 1 : 0;
        }
    EXPECT_GE(right_ones, 6);
}

TEST(TriangularTrims, OnFreeFormFaces)
{
    const Ground ground = grounds().back();
    for (const Loop &loop :
         {Loop{{{0.1, 0.1}}, {{0.9, 0.2}}, {{0.4, 0.9}}},
          Loop{{{0.1, 0.1}, 0.1}, {{0.9, 0.2}, 0.15}, {{0.4, 0.9}, -0.1}},
          Loop{{{0.0, 0.0}}, {{1.0, 0.0}}, {{0.0, 1.0}}}, Loop{{{0.2, 0.2}}, {{0.8, 0.21}}, {{0.5, 0.22}}}})
    {
        SCOPED_TRACE(testing::Message() << loop[1].from.X() << ' ' << loop[2].from.Y());
        expect_right(face_of(ground.surface, ground.placed({loop})));
    }
}

//! Three sides and a fourth one that is a pole; three sides of which two run into a pole without an edge there.
TEST(TriangularTrims, WithASideThatIsAPole)
{
    const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(gp_Ax3(), 60.0);
    const Handle(Geom_Surface) cap =
        GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(sphere, 0.0, M_PI_2, 0.3, M_PI_2));
    const double w = M_PI_2;
    const Loop with_edge{{{0.0, 0.3}}, {{w, 0.3}}, {{w, w}}, {{0.0, w}}};
    const Loop slanted{{{0.2, 0.5}}, {{1.3, 0.7}}, {{1.0, w}}, {{0.4, w}}};
    const Loop bent{{{0.2, 0.5}, 0.1}, {{1.3, 0.7}, 0.1}, {{1.0, w}}, {{0.4, w}, 0.1}};
    for (const Handle(Geom_Surface) & surface : {sphere, cap})
        for (const Loop &loop : {with_edge, slanted, bent})
        {
            SCOPED_TRACE(testing::Message() << loop.front().from.X() << ' ' << loop.front().bend);
            expect_right(face_of(surface, {loop}));
        }
}
