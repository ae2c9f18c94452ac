// SPDX-License-Identifier: LGPL-2.1-or-later
// Plies on parts of a face, judged with OpenCASCADE's evaluation alone: at equal parameters, along the lay-up face's own
// normal, every ply is as thick as it should be, no ply crosses another, and ramps begin and end where they should.
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/ply_stack.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <GeomConvert.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <IntTools_FClass2d.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

using namespace laminate_offset;
using namespace test_support;

namespace
{

TopoDS_Face panel()
{
    return BRepBuilderAPI_MakeFace(
        height_surface([](double x, double y) { return 40.0 * std::sin(0.006 * x) * std::cos(0.008 * y); }, 400.0,
                       300.0, 8, 7),
        1e-7);
}

TopoDS_Wire circle(double x, double y, double radius)
{
    return BRepBuilderAPI_MakeWire(
        BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(x, y, 10.0), gp_Dir(0, 0, 1)), radius)));
}

TopoDS_Wire line(const gp_Pnt &from, const gp_Pnt &to)
{
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(from, to));
}

std::string why(const Result<PlyStackResult> &result)
{
    return result.ok() ? "ok"
                       : std::string(name(result.failure().status)) + " at " +
                             std::string(name(result.failure().stage)) + ": " + result.failure().message;
}

PlyStackOptions options_of(double ramp, double tolerance = 1e-3)
{
    PlyStackOptions options;
    options.tolerance = tolerance;
    options.ramp_length = ramp;
    return options;
}

double area_of(const TopoDS_Face &face)
{
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(face, properties, 1e-7);
    return properties.Mass();
}

//! A face that answers where parameters lie and what its surface is.
class Judge
{
public:
    explicit Judge(const TopoDS_Face &face)
        : m_face(face), m_surface(BRep_Tool::Surface(face)), m_inside(TopoDS::Face(face.Oriented(TopAbs_FORWARD)), 1e-9)
    {
    }

    [[nodiscard]] bool contains(const gp_Pnt2d &uv) { return m_inside.Perform(uv) == TopAbs_IN; }
    [[nodiscard]] gp_Pnt point(const gp_Pnt2d &uv) const { return m_surface->Value(uv.X(), uv.Y()); }

    //! Outward.
    [[nodiscard]] gp_Vec normal(const gp_Pnt2d &uv) const
    {
        GeomLProp_SLProps props(m_surface, uv.X(), uv.Y(), 1, 1e-12);
        return gp_Vec(props.Normal()) * (m_face.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0);
    }

private:
    TopoDS_Face m_face;
    Handle(Geom_Surface) m_surface;
    IntTools_FClass2d m_inside;
};

struct Seen
{
    int present = 0;        //!< places of a ply
    int absent = 0;         //!< places beside a ply with a boundary
    int on_ramps = 0;       //!< places where a surface is between two nominal heights
    double thickness = 0.0; //!< largest error of a ply's thickness
    double sideways = 0.0;  //!< largest distance of a surface's point from the lay-up face's normal
    double crossing = 0.0;  //!< how far a ply's bottom reaches below the top of a ply under it
    double largest_gap = 0.0;
};

//! Follows the normals of the lay-up face through all plies.
Seen look_through(const TopoDS_Face &face, const std::vector<PlySpec> &plies, const PlyStackResult &stack,
                  double direction, int grid = 61)
{
    Judge base(face);
    std::deque<Judge> bottoms, tops;
    for (const StackedPly &ply : stack.plies)
    {
        EXPECT_TRUE(BRepCheck_Analyzer(ply.region).IsValid());
        EXPECT_TRUE(BRepCheck_Analyzer(ply.bottom.result.face()).IsValid());
        EXPECT_TRUE(BRepCheck_Analyzer(ply.top.result.face()).IsValid());
        bottoms.emplace_back(ply.bottom.result.face());
        tops.emplace_back(ply.top.result.face());
    }
    double u0, u1, v0, v1;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    Seen seen;
    for (int k = 0; k < grid; ++k)
        for (int l = 0; l < grid; ++l)
        {
            const gp_Pnt2d uv(u0 + (u1 - u0) * (k + 0.37) / grid, v0 + (v1 - v0) * (l + 0.61) / grid);
            if (!base.contains(uv))
                continue;
            const gp_Vec up = direction * base.normal(uv);
            double reached = 0.0; // the height of the last top
            for (std::size_t i = 0; i < plies.size(); ++i)
            {
                if (!bottoms[i].contains(uv))
                {
                    ++seen.absent;
                    continue;
                }
                ++seen.present;
                const gp_Vec low(base.point(uv), bottoms[i].point(uv));
                const gp_Vec high(base.point(uv), tops[i].point(uv));
                seen.thickness = std::max(seen.thickness, std::abs((high - low).Dot(up) - plies[i].thickness));
                for (const gp_Vec &v : {low, high})
                    seen.sideways = std::max(seen.sideways, (v - v.Dot(up) * up).Magnitude());
                seen.crossing = std::max(seen.crossing, reached - low.Dot(up));
                seen.largest_gap = std::max(seen.largest_gap, low.Dot(up) - reached);
                reached = high.Dot(up);
            }
        }
    return seen;
}

void expect_proven(const PlyStackResult &stack, double tolerance)
{
    for (const StackedPly &ply : stack.plies)
        for (const PlySurface *surface : {&ply.bottom, &ply.top})
        {
            ASSERT_TRUE(surface->result.report.certified_error);
            ASSERT_TRUE(surface->result.report.edge_error);
            EXPECT_LE(*surface->result.report.certified_error, tolerance);
            EXPECT_LE(*surface->result.report.edge_error, tolerance);
        }
}

} // namespace

TEST(PlyStack, APatchLiesUnderARampOfThePlyAbove)
{
    const std::vector<PlySpec> plies{{0.5, {}, 0.0}, {1.0, 0, 0.0}, {0.25, {}, 0.0}};
    const double ramp = 60.0;
    for (const TopoDS_Face &face : {panel(), reversed(panel())})
        for (const double direction : {1.0, -1.0})
        {
            PlyStackOptions options = options_of(ramp);
            options.direction = direction;
            const auto made =
                stack_plies(face, plies, {{"patch", circle(20.0, 10.0, 70.0), PlySide::Inside, {}}}, options);
            ASSERT_TRUE(made) << why(made);
            expect_proven(made.value(), options.tolerance);
            const Seen seen = look_through(face, plies, made.value(), direction);
            EXPECT_GT(seen.present, 7000);
            EXPECT_GT(seen.absent, 2000);
            EXPECT_LE(seen.thickness, 2.0 * options.tolerance);
            EXPECT_LE(seen.sideways, options.tolerance);
            EXPECT_LE(seen.crossing, 2.0 * options.tolerance);
            EXPECT_TRUE(made.value().plies[2].bottom.over_ramp);
            EXPECT_FALSE(made.value().plies[1].bottom.over_ramp || made.value().plies[1].top.over_ramp);
            // the ramp: nothing left where it ends, all of the patch where it begins, never up and down
            Judge base(face), above(made.value().plies[2].bottom.result.face());
            double u0, u1, v0, v1;
            BRepTools::UVBounds(face, u0, u1, v0, v1);
            double before = 2.0;
            int between = 0;
            for (int i = 0; i <= 400; ++i) // along v = const from the circle's middle outwards
            {
                const gp_Pnt2d uv(0.55 + 0.44 * i / 400.0, 0.53);
                const gp_Pnt p = base.point(uv);
                const double height = gp_Vec(p, above.point(uv)).Dot(direction * base.normal(uv));
                const double away = std::hypot(p.X() - 20.0, p.Y() - 10.0) - 70.0; // seen from above
                if (away < -5.0)
                {
                    EXPECT_NEAR(height, 1.5, options.tolerance);
                }
                if (away > ramp + 5.0)
                {
                    EXPECT_NEAR(height, 0.5, options.tolerance);
                }
                EXPECT_LE(height, before + 2.0 * options.tolerance);
                between += height > 0.6 && height < 1.4 ? 1 : 0;
                before = height;
            }
            EXPECT_GT(between, 20);
            const auto top =
                Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(made.value().plies[2].top.result.face()));
            ASSERT_FALSE(top.IsNull());
            EXPECT_TRUE(top->IsCNu(1) && top->IsCNv(1));
        }
}

TEST(PlyStack, SidesHolesAndTheFacesOwnLoops)
{
    const TopoDS_Face face = panel_with_hole(); // 800 x 500
    const double whole = area_of(face);
    const auto half = line(gp_Pnt(0.0, -400.0, 20.0), gp_Pnt(0.0, 400.0, 20.0)); // through the hole, towards +y
    const auto region_area = [&](const TopoDS_Shape &shape, PlySide side, const gp_Pnt &point = {}) {
        const auto made = stack_plies(face, {{0.5, 0, 0.0}}, {{"b", shape, side, point}}, options_of(50.0));
        EXPECT_TRUE(made) << why(made);
        if (!made)
            return 0.0;
        EXPECT_TRUE(BRepCheck_Analyzer(made.value().plies[0].top.result.face()).IsValid());
        EXPECT_FALSE(made.value().plies[0].top.over_ramp);
        return area_of(made.value().plies[0].region);
    };
    const double left = region_area(half, PlySide::Left), right = region_area(half, PlySide::Right);
    EXPECT_NEAR(left + right, whole, 1e-3 * whole);
    EXPECT_GT(left, 0.2 * whole);
    EXPECT_GT(right, 0.2 * whole);
    EXPECT_NEAR(region_area(half, PlySide::Nearest, gp_Pnt(-300.0, 0.0, 0.0)), left, 1e-6 * whole);
    EXPECT_NEAR(region_area(half, PlySide::Nearest, gp_Pnt(300.0, 0.0, 0.0)), right, 1e-6 * whole);
    // sides are those of the outward normal
    const auto other = stack_plies(reversed(face), {{0.5, 0, 0.0}}, {{"b", half, PlySide::Left, {}}}, options_of(50.0));
    ASSERT_TRUE(other) << why(other);
    EXPECT_NEAR(area_of(other.value().plies[0].region), right, 1e-6 * whole);
    // a ring: one circle inside another, in any direction
    TopoDS_Compound ring;
    BRep_Builder().MakeCompound(ring);
    BRep_Builder().Add(ring, circle(-250.0, 100.0, 90.0));
    BRep_Builder().Add(ring, circle(-250.0, 100.0, 40.0).Reversed());
    const double outer = region_area(circle(-250.0, 100.0, 90.0), PlySide::Inside);
    const double inner = region_area(circle(-250.0, 100.0, 40.0), PlySide::Inside);
    EXPECT_NEAR(region_area(ring, PlySide::Inside), outer - inner, 1e-3 * outer);
    EXPECT_NEAR(region_area(circle(-250.0, 100.0, 90.0), PlySide::Outside), whole - outer, 1e-3 * whole);
    // a circle that hangs over the face's corner
    const double corner = region_area(circle(-400.0, -250.0, 150.0), PlySide::Inside);
    EXPECT_GT(corner, 0.2 * M_PI * 150.0 * 150.0);
    EXPECT_LT(corner, 0.4 * M_PI * 150.0 * 150.0);
}

TEST(PlyStack, SeveralPatchesOverlapAndNoPlyCrossesAnother)
{
    const TopoDS_Face face = panel();
    const std::vector<PlyBoundary> boundaries{{"a", circle(-30.0, 0.0, 60.0), PlySide::Inside, {}},
                                              {"b", circle(40.0, 20.0, 70.0), PlySide::Inside, {}},
                                              {"c", line(gp_Pnt(0, -200, 0), gp_Pnt(0, 200, 0)), PlySide::Right, {}}};
    const std::vector<PlySpec> plies{{0.5, 0, 0.0},  {0.5, 2, 0.0}, {0.25, {}, 0.0},
                                     {0.75, 1, 0.0}, {0.5, 0, 0.0}, {0.25, {}, 0.0}};
    PlyStackOptions options = options_of(80.0);
    options.middle = true;
    const auto made = stack_plies(face, plies, boundaries, options);
    ASSERT_TRUE(made) << why(made);
    expect_proven(made.value(), options.tolerance);
    const Seen seen = look_through(face, plies, made.value(), 1.0);
    EXPECT_GT(seen.present, 10000);
    EXPECT_GT(seen.absent, 5000);
    EXPECT_LE(seen.thickness, 2.0 * options.tolerance);
    EXPECT_LE(seen.sideways, options.tolerance);
    EXPECT_LE(seen.crossing, 2.0 * options.tolerance);
    EXPECT_GT(seen.largest_gap, 0.3); // pockets of resin beside the patches
    for (const StackedPly &ply : made.value().plies)
        ASSERT_TRUE(ply.middle);
}

TEST(PlyStack, AnalyticFacesTakePatches)
{
    const TopoDS_Face plane =
        BRepBuilderAPI_MakeFace(gp_Pln(gp_Ax3(gp_Pnt(5, 6, 7), gp_Dir(0, 0, 1))), -200.0, 200.0, -150.0, 150.0);
    const TopoDS_Face tube =
        BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(gp_Pnt(0, 0, -150), gp_Dir(0, 1, 0)), 150.0), -1.0,
                                1.0, -200.0, 200.0, 1e-7);
    const std::vector<PlySpec> plies{{0.5, {}, 0.0}, {1.0, 0, 0.0}, {0.25, {}, 0.0}};
    for (const TopoDS_Face &face : {plane, tube, sphere_patch(300.0)})
    {
        Judge base(face);
        double u0, u1, v0, v1;
        BRepTools::UVBounds(face, u0, u1, v0, v1);
        const gp_Pnt2d middle(0.5 * (u0 + u1), 0.5 * (v0 + v1));
        const TopoDS_Wire around = BRepBuilderAPI_MakeWire(
            BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(base.point(middle), gp_Dir(base.normal(middle))), 50.0)));
        const auto made = stack_plies(face, plies, {{"patch", around, PlySide::Inside, {}}}, options_of(60.0));
        ASSERT_TRUE(made) << why(made);
        expect_proven(made.value(), 1e-3);
        const Seen seen = look_through(face, plies, made.value(), 1.0);
        EXPECT_GT(seen.absent, 1000);
        EXPECT_GT(seen.present, 5000);
        EXPECT_LE(seen.thickness, 2e-3);
        EXPECT_LE(seen.crossing, 2e-3);
        EXPECT_LE(seen.sideways, 1e-3);
        EXPECT_TRUE(BRep_Tool::Surface(made.value().plies[0].top.result.face())->DynamicType() ==
                    BRep_Tool::Surface(face)->DynamicType());
    }
}

TEST(PlyStack, ABoundarysDistanceFromTheFaceIsReportedAndLimited)
{
    const TopoDS_Face plane = BRepBuilderAPI_MakeFace(gp_Pln(), -200.0, 200.0, -150.0, 150.0);
    const auto lay = [](const TopoDS_Face &face, const TopoDS_Shape &shape, PlySide side, std::optional<double> most) {
        PlyStackOptions options = options_of(50.0);
        options.boundary_gap = most;
        return stack_plies(face, {{0.5, {}, 0.0}, {0.5, 1, 0.0}},
                           {{"unused", shape, side, {}}, {"flap", shape, side, {}}}, options);
    };
    const auto circle_at = [](double height) -> TopoDS_Wire {
        return BRepBuilderAPI_MakeWire(
            BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(10.0, 20.0, height), gp_Dir(0, 0, 1)), 50.0)));
    };
    for (const double height : {0.0, 1e-4, 0.5, 35.0, -35.0}) // a quarter of its box is 35.4
    {
        const auto made = lay(plane, circle_at(height), PlySide::Inside, {});
        ASSERT_TRUE(made) << why(made);
        ASSERT_EQ(made.value().boundary_gaps.size(), 2U);
        EXPECT_FALSE(made.value().boundary_gaps[0]);
        ASSERT_TRUE(made.value().boundary_gaps[1]);
        EXPECT_NEAR(*made.value().boundary_gaps[1], std::abs(height), 1e-3); // the image is so near
    }
    for (const double height : {36.0, -90.0, 5000.0})
    {
        const auto refused = lay(plane, circle_at(height), PlySide::Inside, {});
        ASSERT_FALSE(refused) << height;
        EXPECT_EQ(refused.failure().status, Status::NotSupported);
        EXPECT_NE(refused.failure().message.find("'flap'"), std::string::npos) << refused.failure().message;
        EXPECT_NE(refused.failure().message.find("boundary gap"), std::string::npos) << refused.failure().message;
        ASSERT_TRUE(refused.failure().where);
        EXPECT_NEAR(refused.failure().where->point.Distance(gp_Pnt(10.0, 20.0, 0.0)), 50.0, 1e-3);
        EXPECT_TRUE(lay(plane, circle_at(height), PlySide::Inside, 1.001 * std::abs(height)));
    }
    EXPECT_FALSE(lay(plane, circle_at(0.5), PlySide::Inside, 0.4));
    EXPECT_FALSE(lay(plane, circle_at(0.5), PlySide::Inside, -1.0));
    // of a rising line only what lies over the face counts
    const auto rising = lay(plane, line(gp_Pnt(0, -400, 0), gp_Pnt(0, 400, 80)), PlySide::Left, 60.0);
    ASSERT_TRUE(rising) << why(rising);
    EXPECT_NEAR(*rising.value().boundary_gaps[1], 55.0, 0.8);
}

TEST(PlyStack, TheSlopesOfRampsAreReportedAndCanBeLimited)
{
    const TopoDS_Face plane = BRepBuilderAPI_MakeFace(gp_Pln(), -200.0, 200.0, -150.0, 150.0);
    const double thickness = 0.5;
    const TopoDS_Wire across = line(gp_Pnt(20.0, -200.0, 0.0), gp_Pnt(20.0, 200.0, 0.0));
    for (const bool straight : {true, false})
        for (const RampSlope kind : {RampSlope::Mean, RampSlope::Steepest})
        {
            SCOPED_TRACE(straight ? "straight" : "round");
            PlyStackOptions options;
            options.ratio = 40.0;
            options.ramp_slope = kind;
            const PlyBoundary boundary{
                "b", straight ? across : circle(20.0, 0.0, 60.0), straight ? PlySide::Left : PlySide::Inside, {}};
            const auto made = stack_plies(plane, {{thickness, 0, 0.0}, {0.25, {}, 0.0}}, {boundary}, options);
            ASSERT_TRUE(made) << why(made);
            EXPECT_FALSE(made.value().plies[1].ramp);
            ASSERT_TRUE(made.value().plies[0].ramp);
            const RampFigures ramp = *made.value().plies[0].ramp;
            EXPECT_DOUBLE_EQ(ramp.mean, thickness / ramp.length);
            // slopes of the ply above by differences of its points, row by row
            const Handle(Geom_Surface) above = BRep_Tool::Surface(made.value().plies[1].bottom.result.face());
            double steepest = 0.0;
            const double step = 0.01;
            for (double x = -195.0; x < 195.0; x += 0.25)
                for (const double y : {-60.0, -7.0, 0.0, 31.0, 80.0})
                {
                    const double here = above->Value(x, y).Z();
                    const double a = (above->Value(x + step, y).Z() - here) / step;
                    const double b = (above->Value(x, y + step).Z() - here) / step;
                    steepest = std::max(steepest, std::hypot(a, b));
                }
            EXPECT_GT(steepest, 0.0);
            EXPECT_LE(steepest, 1.01 * ramp.steepest);
            if (straight)
            {
                EXPECT_NEAR(steepest, ramp.steepest, 0.02 * ramp.steepest);
                EXPECT_GT(ramp.steepest / ramp.mean, 1.3);
                EXPECT_LT(ramp.steepest / ramp.mean, 1.9);
            }
            if (kind == RampSlope::Mean)
            {
                EXPECT_DOUBLE_EQ(ramp.length, 40.0 * thickness);
                EXPECT_GT(ramp.steepest, 1.0 / 40.0);
            }
            else
            {
                EXPECT_LE(ramp.steepest, 1.0 / 40.0);
                EXPECT_GE(ramp.steepest, 0.9 / 40.0);
                EXPECT_LE(steepest, 1.01 / 40.0);
            }
            // level where it begins and ends
            if (straight)
            {
                for (const double x : {20.0, 20.0 + 1.02 * ramp.length})
                    EXPECT_NEAR((above->Value(x + step, 0.0).Z() - above->Value(x - step, 0.0).Z()) / step, 0.0, 1e-3);
            }
        }
}

//! The steepest place of a surface that hardly bends, over the plane z = 0 along x, by differences of its points.
double steepest_along_x(const TopoDS_Face &face)
{
    const Handle(Geom_Surface) above = BRep_Tool::Surface(face);
    double steepest = 0.0;
    constexpr double step = 0.01;
    for (double x = -195.0; x < 195.0; x += 0.05)
        steepest = std::max(steepest, std::abs(above->Value(x + step, 7.0).Z() - above->Value(x, 7.0).Z()) / step);
    return steepest;
}

TEST(PlyStack, RampsThatAddUpAreToldOf)
{
    const TopoDS_Face plane = BRepBuilderAPI_MakeFace(gp_Pln(), -200.0, 200.0, -150.0, 150.0);
    const auto line_at = [](double x) { return line(gp_Pnt(x, -200.0, 0.0), gp_Pnt(x, 200.0, 0.0)); };
    const std::vector<PlyBoundary> boundaries{{"a", line_at(20.0), PlySide::Left, {}},
                                              {"b", line_at(20.0), PlySide::Left, {}}};
    for (const RampSlope kind : {RampSlope::Mean, RampSlope::Steepest})
        for (const double apart : {0.0, 4.0, 10.0, 40.0})
        {
            SCOPED_TRACE(apart);
            PlyStackOptions options;
            options.ramp_slope = kind;
            const std::vector<PlySpec> plies{
                {0.5, {}, 0.0}, {0.5, 0, 0.0}, {0.5, 0, apart}, {0.5, 1, 2.0 * apart}, {0.5, {}, 0.0}};
            const auto made = stack_plies(plane, plies, boundaries, options);
            ASSERT_TRUE(made) << why(made);
            const std::vector<SteepRamps> &places = made.value().steep_ramps;
            const SteepRamps *steep = places.empty() ? nullptr : &places.front();
            const double one = made.value().plies[1].ramp->steepest;
            const double seen = steepest_along_x(made.value().plies[4].bottom.result.face());
            ASSERT_GT(seen, 0.5 * one);
            EXPECT_EQ(steep != nullptr, seen > 1.05 * std::max(one, kind == RampSlope::Steepest ? 0.05 : 0.0)) << seen;
            EXPECT_TRUE(steep || apart > 5.0); // ramps are 10 mm long at least, and level at their ends
            EXPECT_FALSE(steep && apart > 20.0);
            if (!steep)
                continue;
            EXPECT_NEAR(steep->slope, seen, 0.03 * seen);
            EXPECT_GE(steep->alone, one);
            EXPECT_GE(steep->longest, 10.0);
            EXPECT_GE(steep->plies.size(), 2U);
            EXPECT_GT(steep->where.point.X(), 20.0 - 2.0 * apart);
            EXPECT_LT(steep->where.point.X(), 20.0 + steep->longest);
            if (apart == 0.0)
            {
                EXPECT_NEAR(steep->slope, 3.0 * one, 0.02 * one);
                EXPECT_EQ(steep->plies, (std::vector<std::size_t>{1, 2, 3}));
            }
        }
    const auto single = stack_plies(plane, {{0.5, 0, 0.0}, {0.5, {}, 0.0}}, boundaries, {});
    ASSERT_TRUE(single) << why(single);
    EXPECT_TRUE(single.value().steep_ramps.empty());
}

TEST(PlyStack, RampsOfDifferentPlacesDoNotAddUp)
{
    const TopoDS_Face plane = BRepBuilderAPI_MakeFace(gp_Pln(), -200.0, 200.0, -150.0, 150.0);
    const std::vector<PlyBoundary> boundaries{{"left", circle(-90.0, 0.0, 40.0), PlySide::Inside, {}},
                                              {"right", circle(90.0, 0.0, 40.0), PlySide::Inside, {}},
                                              {"round", circle(90.0, 0.0, 55.0), PlySide::Inside, {}}};
    const std::vector<PlySpec> apart{{0.5, 0, 0.0}, {0.5, 1, 0.0}, {0.5, {}, 0.0}};
    const auto made = stack_plies(plane, apart, boundaries, options_of(20.0));
    ASSERT_TRUE(made) << why(made);
    EXPECT_TRUE(made.value().steep_ramps.empty());
    // with a third ply that ends 15 mm beside the second one, whose ramp is 20 mm long
    const std::vector<PlySpec> near{{0.5, 0, 0.0}, {0.5, 2, 0.0}, {0.5, 1, 0.0}, {0.5, {}, 0.0}};
    const auto both = stack_plies(plane, near, boundaries, options_of(40.0));
    ASSERT_TRUE(both) << why(both);
    ASSERT_EQ(both.value().steep_ramps.size(), 1U);
    EXPECT_EQ(both.value().steep_ramps[0].plies, (std::vector<std::size_t>{1, 2}));
    EXPECT_NEAR(
        std::hypot(both.value().steep_ramps[0].where.point.X() - 90.0, both.value().steep_ramps[0].where.point.Y()),
        65.0, 20.0);
}

TEST(PlyStack, BehindARampHardlyAnythingIsLeft)
{
    constexpr double height = 5.0, radius = 50.0;
    const TopoDS_Face plane = BRepBuilderAPI_MakeFace(gp_Pln(), -200.0, 200.0, -150.0, 150.0);
    const std::vector<PlyBoundary> boundaries{{"pad", circle(0.0, 0.0, radius), PlySide::Inside, {}}};
    const auto made =
        stack_plies(plane, {{0.5, {}, 0.0}, {height, 0, 0.0}, {0.5, {}, 0.0}}, boundaries, options_of(8.0));
    ASSERT_TRUE(made) << why(made);
    const double length = made.value().plies[1].ramp->length;
    const Handle(Geom_Surface) above = BRep_Tool::Surface(made.value().plies[2].bottom.result.face());
    const auto left = [&](double reach) {
        double most = 0.0;
        for (int i = 0; i < 720; ++i)
        {
            const double turn = 2.0 * M_PI * i / 720.0, r = radius + reach * length;
            most = std::max(most, std::abs(above->Value(r * std::cos(turn), r * std::sin(turn)).Z() - 0.5));
        }
        return most;
    };
    EXPECT_GT(left(0.9), 0.01 * height);
    for (const double reach : {1.0, 1.01, 1.02, 1.05, 1.1, 1.2, 1.5})
        EXPECT_LT(left(reach), reach < 1.05 ? 2e-3 * height : 1e-3) << reach;
}

TEST(PlyStack, RefusalsNameTheBoundaryAndTheRemedy)
{
    const TopoDS_Face face = panel();
    const std::vector<PlySpec> plies{{0.5, {}, 0.0}, {0.125, 0, 0.0}, {0.25, {}, 0.0}};
    const auto refused = [&](const TopoDS_Shape &shape, PlySide side, PlyStackOptions options) {
        const auto made = stack_plies(face, plies, {{"flap", shape, side, {}}}, options);
        EXPECT_FALSE(made);
        return made ? Failure{} : made.failure();
    };
    const Failure short_ramp = refused(circle(0, 0, 70), PlySide::Inside, options_of(0.5));
    EXPECT_EQ(short_ramp.status, Status::NotSupported);
    EXPECT_NE(short_ramp.message.find("flap"), std::string::npos) << short_ramp.message;
    EXPECT_NE(short_ramp.message.find("longer"), std::string::npos) << short_ramp.message;
    const Failure open = refused(line(gp_Pnt(0, -200, 0), gp_Pnt(0, 200, 0)), PlySide::Inside, options_of(50.0));
    EXPECT_EQ(open.status, Status::InvalidOption);
    EXPECT_NE(open.message.find("'flap'"), std::string::npos) << open.message;
    const Failure dangling = refused(line(gp_Pnt(0, -50, 0), gp_Pnt(0, 50, 0)), PlySide::Left, options_of(50.0));
    EXPECT_EQ(dangling.status, Status::NotSupported) << dangling.message;
    TopoDS_Compound two;
    BRep_Builder().MakeCompound(two);
    BRep_Builder().Add(two, circle(-100.0, 0.0, 30.0));
    BRep_Builder().Add(two, circle(100.0, 0.0, 30.0));
    const Failure parts = refused(two, PlySide::Inside, options_of(50.0));
    EXPECT_EQ(parts.status, Status::NotSupported);
    EXPECT_NE(parts.message.find("2 separate parts"), std::string::npos) << parts.message;
    PlyStackOptions bad = options_of(50.0);
    bad.ratio = 0.5;
    EXPECT_EQ(refused(circle(0, 0, 70), PlySide::Inside, bad).status, Status::InvalidOption);
    bad = options_of(-1.0);
    EXPECT_EQ(refused(circle(0, 0, 70), PlySide::Inside, bad).status, Status::InvalidOption);
    EXPECT_FALSE(stack_plies(face, {}, {}, options_of(50.0)));
    EXPECT_FALSE(stack_plies(face, {{-1.0, {}, 0.0}}, {}, options_of(50.0)));
    EXPECT_FALSE(stack_plies(face, {{1.0, 3, 0.0}}, {}, options_of(50.0)));
}

namespace
{

//! The region's edges that are not the whole face's, as points: those that keep away from its border.
std::vector<gp_Pnt> inner_edge_points(const TopoDS_Face &region, const gp_Pnt &centre, double most)
{
    std::vector<gp_Pnt> points;
    for (TopExp_Explorer it(region, TopAbs_EDGE); it.More(); it.Next())
    {
        const BRepAdaptor_Curve curve(TopoDS::Edge(it.Current()));
        for (int i = 0; i <= 60; ++i)
        {
            const gp_Pnt p =
                curve.Value(curve.FirstParameter() + (curve.LastParameter() - curve.FirstParameter()) * i / 60);
            if (p.Distance(centre) < most)
                points.push_back(p);
        }
    }
    return points;
}

TopoDS_Wire polygon(const std::vector<gp_Pnt> &corners)
{
    BRepBuilderAPI_MakeWire wire;
    for (std::size_t i = 0; i < corners.size(); ++i)
        wire.Add(BRepBuilderAPI_MakeEdge(corners[i], corners[(i + 1) % corners.size()]));
    return wire;
}

} // namespace

namespace
{

//! A roof of two planes, 200 by 100, whose ridge or valley runs along y at x = 0.
TopoDS_Face roof(double slope)
{
    TColgp_Array2OfPnt poles(1, 3, 1, 2);
    for (int i = 1; i <= 3; ++i)
        for (int j = 1; j <= 2; ++j)
            poles(i, j) = gp_Pnt(100.0 * (i - 2), 100.0 * (j - 1.5), -slope * 100.0 * std::abs(i - 2));
    TColStd_Array1OfReal across(1, 3), along(1, 2);
    TColStd_Array1OfInteger once(1, 3), twice(1, 2);
    for (int i = 1; i <= 3; ++i)
        across(i) = i - 1.0, once(i) = i == 2 ? 1 : 2;
    along(1) = 0.0, along(2) = 1.0, twice(1) = twice(2) = 2;
    return BRepBuilderAPI_MakeFace(new Geom_BSplineSurface(poles, across, along, once, twice, 1, 1), 1e-7);
}

} // namespace

TEST(PlyStack, OnACreasedFaceTheCreaseIsWhatIsRefusedWhateverTheBoundary)
{
    const auto around = [](double x) {
        return BRepBuilderAPI_MakeWire(
                   BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(x, 0.0, 0.0), gp_Dir(0, 0, 1)), 30.0)))
            .Wire();
    };
    for (const double slope : {0.5, -0.5, 3.0})
        for (const double direction : {1.0, -1.0})
            for (const double x : {0.0, 60.0, 500.0})
                for (const double inset : {0.0, 2.0, 40.0})
                {
                    SCOPED_TRACE(testing::Message() << slope << ' ' << direction << ' ' << x << ' ' << inset);
                    PlyStackOptions options = options_of(20.0);
                    options.direction = direction;
                    const std::vector<PlySpec> plies{{0.25, {}, 0.0}, {0.25, 0, inset}, {0.25, {}, 0.0}};
                    const auto made =
                        stack_plies(roof(slope), plies, {{"patch", around(x), PlySide::Inside, {}}}, options);
                    ASSERT_FALSE(made.ok());
                    EXPECT_EQ(made.failure().status, Status::NotSupported) << why(made);
                    EXPECT_EQ(made.failure().stage, Stage::Analysis) << why(made);
                    EXPECT_NE(made.failure().message.find("split the face along the crease"), std::string::npos)
                        << why(made);
                    ASSERT_TRUE(made.failure().where.has_value());
                    EXPECT_NEAR(made.failure().where->point.X(), 0.0, 1e-6);
                }
    const auto flat = stack_plies(roof(1e-6), {{0.25, 0, 2.0}, {0.25, {}, 0.0}},
                                  {{"patch", around(60.0), PlySide::Inside, {}}}, options_of(20.0));
    EXPECT_TRUE(flat.ok()) << "a crease that tears nothing is none: " << why(flat);
}

TEST(PlyStack, InsetsKeepTheirDistanceInTheSurface)
{
    // on a sphere a parallel of a circle about a point is a circle about it, known in closed form
    const double radius = 300.0;
    const TopoDS_Face face = sphere_patch(radius);
    Judge base(face);
    double u0, u1, v0, v1;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    const gp_Pnt2d middle(0.5 * (u0 + u1), 0.5 * (v0 + v1));
    const gp_Vec axis = base.normal(middle);
    const double angle = 0.2; // of the circle about the axis
    const gp_Pnt centre = gp_Pnt(0, 0, 0).Translated(radius * std::cos(angle) * axis);
    const TopoDS_Wire around = BRepBuilderAPI_MakeWire(
        BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(centre, gp_Dir(axis)), radius * std::sin(angle))));
    for (const PlySide side : {PlySide::Inside, PlySide::Outside})
        for (const double inset : {0.5, 5.0, 20.0})
        {
            const auto made = stack_plies(face, {{0.5, 0, inset}}, {{"b", around, side, {}}}, options_of(50.0));
            ASSERT_TRUE(made) << why(made);
            const double expected = radius * angle + (side == PlySide::Inside ? -inset : inset);
            const auto points = inner_edge_points(made.value().plies[0].region, base.point(middle), 90.0);
            EXPECT_GT(points.size(), 20U);
            for (const gp_Pnt &p : points)
                EXPECT_NEAR(radius * gp_Vec(gp_Pnt(0, 0, 0), p).Angle(axis), expected, 2e-3);
            EXPECT_LE(made.value().inset_error, 1e-3);
            EXPECT_TRUE(BRepCheck_Analyzer(made.value().plies[0].top.result.face()).IsValid());
        }
}

TEST(PlyStack, InsetsOfCornersAreCutOrRounded)
{
    const TopoDS_Face plane = BRepBuilderAPI_MakeFace(gp_Pln(), -200.0, 200.0, -200.0, 200.0);
    const std::vector<gp_Pnt> ell{{-100, -100, 0}, {100, -100, 0}, {100, 0, 0}, {0, 0, 0}, {0, 100, 0}, {-100, 100, 0}};
    const auto area = [&](double inset, PlySide side) {
        const auto made = stack_plies(plane, {{0.5, 0, inset}}, {{"b", polygon(ell), side, {}}}, options_of(50.0));
        EXPECT_TRUE(made) << why(made);
        return made ? area_of(made.value().plies[0].region) : 0.0;
    };
    // inwards: five corners are cut, the sixth is rounded
    const double d = 12.0;
    const double straight = 30000.0 - 800.0 * d + 4.0 * d * d; // with square corners everywhere
    EXPECT_NEAR(area(d, PlySide::Inside), straight + (1.0 - 0.25 * M_PI) * d * d, 1.0);
    // outwards: five corners are rounded, the sixth is cut
    const double outer = 30000.0 + 800.0 * d + 4.0 * d * d - 5.0 * (1.0 - 0.25 * M_PI) * d * d;
    EXPECT_NEAR(area(d, PlySide::Outside), 160000.0 - outer, 1.0);
}

namespace
{

//! A rectangle of 100 x 60 about the origin whose corners are rounded, or cut off at 45 degrees, put onto a surface by a
//! map of the plane's points.
TopoDS_Wire rectangle_with_corners(double corner, bool rounded, const std::function<gp_Pnt(double, double)> &map)
{
    const auto curve = [&](const std::function<gp_Pnt2d(double)> &at) {
        constexpr int points = 41;
        TColgp_Array1OfPnt places(1, points);
        for (int i = 0; i < points; ++i)
        {
            const gp_Pnt2d p = at(i / (points - 1.0));
            places(i + 1) = map(p.X(), p.Y());
        }
        return BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(places, 3, 8, GeomAbs_C2, 1e-7).Curve()).Edge();
    };
    BRepBuilderAPI_MakeWire wire;
    const double x = 50.0, y = 30.0;
    for (int side = 0; side < 4; ++side)
    {
        const double a = side % 2 == 0 ? x : y, b = side % 2 == 0 ? y : x; // along the side, and its distance
        const double turn = 0.5 * M_PI * side;
        const auto turned = [turn](double p, double q) {
            return gp_Pnt2d(std::cos(turn) * p - std::sin(turn) * q, std::sin(turn) * p + std::cos(turn) * q);
        };
        wire.Add(curve([&](double t) { return turned(-a + corner + t * 2.0 * (a - corner), -b); }));
        wire.Add(curve([&](double t) {
            if (!rounded)
                return turned(a - corner + t * corner, -b + t * corner);
            const double angle = 0.5 * M_PI * (t - 1.0);
            return turned(a - corner + corner * std::cos(angle), -b + corner + corner * std::sin(angle));
        }));
    }
    return wire;
}

} // namespace

TEST(PlyStack, InsetsGoPastFilletsAndChamfers)
{
    // a cylinder is developed to the plane: areas and distances along it are those of the plane
    const double radius = 80.0;
    const TopoDS_Face plane = BRepBuilderAPI_MakeFace(gp_Pln(), -100.0, 100.0, -100.0, 100.0);
    const TopoDS_Face tube = BRepBuilderAPI_MakeFace(
        new Geom_CylindricalSurface(gp_Ax3(gp_Pnt(0, 0, -radius), gp_Dir(0, 1, 0), gp_Dir(0, 0, 1)), radius), -1.5, 1.5,
        -100.0, 100.0, 1e-7);
    const auto flat = [](double x, double y) { return gp_Pnt(x, y, 0.0); };
    const auto bent = [radius](double x, double y) {
        return gp_Pnt(radius * std::sin(x / radius), y, radius * (std::cos(x / radius) - 1.0));
    };
    int past = 0;
    for (const bool rounded : {true, false})
        for (const double inset : {2.0, 5.5, 8.0, 12.0, 25.0})
        {
            const double corner = 5.0;
            const double left =
                rounded ? std::max(0.0, corner - inset) : std::max(0.0, corner - (2.0 - std::sqrt(2.0)) * inset);
            past += left == 0.0 ? 1 : 0;
            const double expected = (100.0 - 2.0 * inset) * (60.0 - 2.0 * inset) -
                                    (rounded ? (4.0 - M_PI) * left * left : 2.0 * left * left);
            for (const bool on_plane : {true, false})
            {
                SCOPED_TRACE((rounded ? "rounded, inset " : "cut off, inset ") + std::to_string(inset));
                const TopoDS_Wire wire = on_plane ? rectangle_with_corners(corner, rounded, flat)
                                                  : rectangle_with_corners(corner, rounded, bent);
                const auto made = stack_plies(on_plane ? plane : tube, {{0.5, 0, inset}},
                                              {{"b", wire, PlySide::Inside, {}}}, options_of(50.0));
                ASSERT_TRUE(made) << why(made);
                EXPECT_NEAR(area_of(made.value().plies[0].region), expected, 0.3);
                EXPECT_TRUE(BRepCheck_Analyzer(made.value().plies[0].top.result.face()).IsValid());
            }
        }
    EXPECT_EQ(past, 4 + 2);
    for (const double inset : {30.0, 31.0, 45.0, 60.0})
    {
        const auto nothing =
            stack_plies(plane, {{0.5, 0, inset}}, {{"b", rectangle_with_corners(5.0, true, flat), PlySide::Inside, {}}},
                        options_of(50.0));
        ASSERT_FALSE(nothing) << inset;
        EXPECT_EQ(nothing.failure().status, Status::NotSupported);
    }
}

TEST(PlyStack, InsetsOfOpenCurvesReachTheFacesEdges)
{
    const TopoDS_Face face = panel(); // 400 x 300
    const auto across = line(gp_Pnt(20.0, -200.0, 0.0), gp_Pnt(60.0, 200.0, 0.0));
    double before = area_of(face);
    for (const double inset : {0.0, 10.0, 25.0, 60.0})
    {
        const auto made = stack_plies(face, {{0.5, 0, inset}}, {{"b", across, PlySide::Left, {}}}, options_of(50.0));
        ASSERT_TRUE(made) << why(made);
        const double here = area_of(made.value().plies[0].region);
        EXPECT_LT(here, before);
        EXPECT_GT(here, 0.1 * area_of(face));
        before = here;
    }
}

TEST(PlyStack, InsetsThatFoldOrCrossAreRefused)
{
    const TopoDS_Face face = panel();
    const auto refused = [&](const TopoDS_Shape &shape, double inset, PlySide side = PlySide::Inside) {
        const auto made = stack_plies(face, {{0.5, 0, inset}}, {{"b", shape, side, {}}}, options_of(50.0));
        EXPECT_FALSE(made);
        return made ? Failure{} : made.failure();
    };
    const Failure folded = refused(circle(0.0, 0.0, 40.0), 45.0);
    EXPECT_EQ(folded.status, Status::NotSupported);
    EXPECT_NE(folded.message.find("smaller distance"), std::string::npos) << folded.message;
    // a dumbbell whose waist is narrower than twice the distance
    const Failure crossed = refused(polygon({{-100, -60, 0},
                                             {-40, -60, 0},
                                             {-40, -10, 0},
                                             {40, -10, 0},
                                             {40, -60, 0},
                                             {100, -60, 0},
                                             {100, 60, 0},
                                             {40, 60, 0},
                                             {40, 10, 0},
                                             {-40, 10, 0},
                                             {-40, 60, 0},
                                             {-100, 60, 0}}),
                                    15.0);
    EXPECT_EQ(crossed.status, Status::NotSupported) << crossed.message;
    EXPECT_EQ(refused(circle(0.0, 0.0, 40.0), -1.0).status, Status::InvalidOption);
    EXPECT_EQ(refused(circle(0.0, 0.0, 40.0), 5.0, PlySide::Nearest).status, Status::InvalidOption);
}

namespace
{

//! A patch of 60 x 100 on the cylinder of radius 100 about z, around the angle.
TopoDS_Wire patch_on_cylinder(double angle)
{
    const auto at = [&](double along, double z) {
        const double a = angle + along / 100.0;
        return gp_Pnt(100.0 * std::cos(a), 100.0 * std::sin(a), z);
    };
    const auto arc = [&](double from, double to, double z) {
        const gp_Circ round(gp_Ax2(gp_Pnt(0, 0, z), gp_Dir(0, 0, from < to ? 1 : -1)), 100.0);
        return BRepBuilderAPI_MakeEdge(round, at(from, z), at(to, z)).Edge();
    };
    return BRepBuilderAPI_MakeWire(arc(-30, 30, 100), BRepBuilderAPI_MakeEdge(at(30, 100), at(30, 200)),
                                   arc(30, -30, 200), BRepBuilderAPI_MakeEdge(at(-30, 200), at(-30, 100)));
}

TopoDS_Face cylinder_face(double from, double to)
{
    return BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(), 100.0), from, to, 0.0, 300.0, 1e-7);
}

} // namespace

TEST(PlyStack, TheInsideOfAPatchIsItsInsideAllRoundACylinder)
{
    const PlySpec whole{0.5, std::nullopt, 0.0};
    const PlySpec partial{0.5, 0, 0.0};
    for (const TopoDS_Face &face :
         {cylinder_face(0.0, 2.0 * M_PI), cylinder_face(0.0, 5.0), reversed(cylinder_face(0.0, 2.0 * M_PI))})
        for (const double angle : {0.6, M_PI_2, 2.5, M_PI, 4.0, 4.6})
            for (const bool outside : {false, true})
            {
                SCOPED_TRACE(angle);
                const PlyBoundary boundary{"patch", patch_on_cylinder(angle),
                                           outside ? PlySide::Outside : PlySide::Inside, gp_Pnt()};
                const auto stack = stack_plies(face, {whole, partial}, {boundary}, options_of(10.0));
                ASSERT_TRUE(stack.ok()) << why(stack);
                const double expected = outside ? area_of(face) - 6000.0 : 6000.0;
                EXPECT_NEAR(area_of(stack.value().plies[1].region), expected, 1e-3 * 6000.0);
            }
}

TEST(PlyStack, ARingRoundAClosedFaceHasNoInside)
{
    const TopoDS_Wire ring =
        BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(0, 0, 100), gp_Dir(0, 0, 1)), 100.0)));
    const PlyBoundary boundary{"ring", ring, PlySide::Inside, gp_Pnt()};
    const auto stack = stack_plies(cylinder_face(0.0, 2.0 * M_PI), {{0.5, 0, 0.0}}, {boundary}, options_of(10.0));
    ASSERT_FALSE(stack.ok());
    EXPECT_EQ(stack.failure().status, Status::InvalidOption);
    EXPECT_NE(stack.failure().message.find("goes round"), std::string::npos) << stack.failure().message;
}

TEST(PlyStack, ASeamInTheWayIsMoved)
{
    const std::vector<PlySpec> plies{{0.25, std::nullopt, 0.0}, {0.25, 0, 0.0}, {0.25, std::nullopt, 0.0}};
    const TopoDS_Face tube = cylinder_face(0.0, 2.0 * M_PI);
    gp_Trsf placing;
    placing.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 2)), 0.7);
    Handle(Geom_BSplineSurface) spline = GeomConvert::SurfaceToBSplineSurface(
        new Geom_RectangularTrimmedSurface(new Geom_CylindricalSurface(gp_Ax3(), 100.0), 0.0, 2.0 * M_PI, 0.0, 300.0));
    const TopoDS_Face spline_tube = BRepBuilderAPI_MakeFace(spline, 1e-7);
    for (const bool placed : {false, true})
        for (const TopoDS_Face &standing : {tube, reversed(tube), spline_tube})
            for (const double angle : {0.0, 0.29, 0.35, -0.1, 2.0})
            {
                SCOPED_TRACE(angle);
                const TopoDS_Face face = placed ? TopoDS::Face(standing.Moved(TopLoc_Location(placing))) : standing;
                const TopoDS_Shape patch =
                    placed ? patch_on_cylinder(angle).Moved(TopLoc_Location(placing)) : patch_on_cylinder(angle);
                const auto made = stack_plies(face, plies, {{"patch", patch, PlySide::Inside, {}}}, options_of(10.0));
                ASSERT_TRUE(made) << why(made);
                EXPECT_EQ(made.value().moved_seam.has_value(), angle < 1.0);
                const TopoDS_Face lay_up = made.value().moved_seam.value_or(face);
                EXPECT_TRUE(BRepCheck_Analyzer(lay_up).IsValid());
                EXPECT_EQ(lay_up.Orientation(), face.Orientation());
                // the same face: of equal size, and on it where it is
                EXPECT_NEAR(area_of(lay_up), area_of(face), 1e-3 * area_of(face));
                double u0, u1, v0, v1;
                BRepTools::UVBounds(lay_up, u0, u1, v0, v1);
                for (int i = 0; i < 40; ++i)
                {
                    const gp_Pnt p = BRep_Tool::Surface(lay_up)
                                         ->Value(u0 + (u1 - u0) * i / 39.0, v0 + (v1 - v0) * (i % 7) / 6.0)
                                         .Transformed(placed ? placing.Inverted() : gp_Trsf());
                    EXPECT_NEAR(std::hypot(p.X(), p.Y()), 100.0, 1e-9);
                    EXPECT_GT(p.Z(), -1e-9);
                    EXPECT_LT(p.Z(), 300.0 + 1e-9);
                }
                EXPECT_NEAR(area_of(made.value().plies[1].region), 6000.0, 1e-3 * 6000.0);
                expect_proven(made.value(), 1e-3);
                const Seen seen = look_through(lay_up, plies, made.value(), 1.0);
                EXPECT_GT(seen.present, 5000);
                EXPECT_GT(seen.absent, 3000);
                EXPECT_LE(seen.thickness, 2e-3);
                EXPECT_LE(seen.crossing, 2e-3);
                EXPECT_LE(seen.sideways, 1e-3);
            }
}

TEST(PlyStack, ATubeWithASlitIsNotClosed)
{
    const std::vector<PlySpec> plies{{0.25, std::nullopt, 0.0}, {0.25, 0, 0.0}, {0.25, std::nullopt, 0.0}};
    for (const double start : {-1.0, 2.0}) // two edges lie on each other there, which are no seam
    {
        SCOPED_TRACE(start);
        const TopoDS_Face face = cylinder_face(start, start + 2.0 * M_PI);
        const auto over =
            stack_plies(face, plies, {{"patch", patch_on_cylinder(start), PlySide::Inside, {}}}, options_of(10.0));
        EXPECT_FALSE(over);
        const auto beside = stack_plies(face, plies, {{"patch", patch_on_cylinder(start + 1.0), PlySide::Inside, {}}},
                                        options_of(10.0));
        ASSERT_TRUE(beside) << why(beside);
        EXPECT_FALSE(beside.value().moved_seam);
        EXPECT_NEAR(area_of(beside.value().plies[1].region), 6000.0, 1e-3 * 6000.0);
    }
}

TEST(PlyStack, ASurfaceThatClosesWithOtherWeightsKeepsItsSeam)
{
    const std::vector<PlySpec> plies{{0.25, std::nullopt, 0.0}, {0.25, 0, 0.0}, {0.25, std::nullopt, 0.0}};
    for (const double growth : {1.0, 1.1, 1.5})
    {
        SCOPED_TRACE(growth); // of the weights from one pole to the next: the same tube with other parameters
        const double corners[9][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
        TColgp_Array2OfPnt poles(1, 9, 1, 2);
        TColStd_Array2OfReal weights(1, 9, 1, 2);
        for (int i = 0; i < 9; ++i)
            for (int j = 0; j < 2; ++j)
            {
                poles(i + 1, j + 1) = gp_Pnt(100.0 * corners[i][0], 100.0 * corners[i][1], 300.0 * j);
                weights(i + 1, j + 1) = (i % 2 == 1 ? M_SQRT1_2 : 1.0) * std::pow(growth, i);
            }
        TColStd_Array1OfReal knots(1, 5), ends(1, 2);
        TColStd_Array1OfInteger multiplicities(1, 5), twice(1, 2);
        for (int i = 1; i <= 5; ++i)
        {
            knots(i) = i - 1;
            multiplicities(i) = i == 1 || i == 5 ? 3 : 2;
        }
        ends(1) = 0.0;
        ends(2) = 1.0;
        twice.Init(2);
        const TopoDS_Face tube = BRepBuilderAPI_MakeFace(
            new Geom_BSplineSurface(poles, weights, knots, ends, multiplicities, twice, 2, 1), 1e-7);
        const auto made =
            stack_plies(tube, plies, {{"patch", patch_on_cylinder(0.0), PlySide::Inside, {}}}, options_of(10.0));
        EXPECT_EQ(made.ok(), growth == 1.0) << why(made);
    }
}

TEST(PlyStack, ARampThatReachesASeamWithoutAnotherPlaceIsRefused)
{
    const auto face = cylinder_face(0.0, 2.0 * M_PI);
    const TopoDS_Wire ring =
        BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(0, 0, 40), gp_Dir(0, 0, 1)), 100.0)));
    const std::vector<PlyBoundary> boundaries{{"patch", patch_on_cylinder(0.35), PlySide::Inside, gp_Pnt()},
                                              {"ring", ring, PlySide::Left, gp_Pnt()}};
    const std::vector<PlySpec> plies{{0.25, 0, 0.0}, {0.25, 1, 0.0}, {0.25, std::nullopt, 0.0}};
    const auto stack = stack_plies(face, plies, boundaries, options_of(10.0));
    ASSERT_FALSE(stack.ok());
    EXPECT_EQ(stack.failure().status, Status::NotSupported);
    EXPECT_NE(stack.failure().message.find("seam"), std::string::npos) << stack.failure().message;
}

TEST(PlyStack, NoInsetTurnsABoundaryInsideOut)
{
    const TopoDS_Face plate = BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), -100.0, 100.0, -100.0, 100.0);
    const auto rectangle = [](double width, double height) {
        const double x = 0.5 * width;
        const double y = 0.5 * height;
        const gp_Pnt a(-x, -y, 0), b(x, -y, 0), c(x, y, 0), d(-x, y, 0);
        return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(a, b), BRepBuilderAPI_MakeEdge(b, c),
                                       BRepBuilderAPI_MakeEdge(c, d), BRepBuilderAPI_MakeEdge(d, a))
            .Wire();
    };
    const auto region = [&](const TopoDS_Wire &wire, double inset) {
        const PlyBoundary boundary{"patch", wire, PlySide::Inside, gp_Pnt()};
        return stack_plies(plate, {{0.25, 0, inset}}, {boundary}, options_of(10.0));
    };
    for (const double inset : {5.0, 15.0, 19.0})
    {
        const auto made = region(rectangle(80.0, 40.0), inset);
        ASSERT_TRUE(made.ok()) << why(made);
        EXPECT_NEAR(area_of(made.value().plies[0].region), (80.0 - 2 * inset) * (40.0 - 2 * inset), 0.1);
    }
    for (const double inset : {20.0, 20.5, 25.0, 39.0, 60.0})
    {
        const auto made = region(rectangle(80.0, 40.0), inset);
        EXPECT_FALSE(made.ok()) << inset << " leaves " << (made.ok() ? area_of(made.value().plies[0].region) : 0.0);
    }
    EXPECT_FALSE(region(rectangle(40.0, 40.0), 20.0).ok());
}

TEST(PlyStack, BoundariesThatCrossThemselvesAreRefused)
{
    const gp_Pnt a(-100, -50, 0), b(100, 50, 0), c(100, -50, 0), d(-100, 50, 0);
    const TopoDS_Wire eight = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(a, b), BRepBuilderAPI_MakeEdge(b, c),
                                                      BRepBuilderAPI_MakeEdge(c, d), BRepBuilderAPI_MakeEdge(d, a));
    const auto crossed =
        stack_plies(panel(), {{0.25, 0, 0.0}}, {{"eight", eight, PlySide::Inside, gp_Pnt()}}, options_of(10.0));
    ASSERT_FALSE(crossed.ok());
    EXPECT_EQ(crossed.failure().status, Status::NotSupported);
    BRep_Builder builder;
    TopoDS_Compound both;
    builder.MakeCompound(both);
    builder.Add(both, circle(-20, 0, 50));
    builder.Add(both, circle(20, 0, 50));
    const auto overlapping =
        stack_plies(panel(), {{0.25, 0, 0.0}}, {{"both", both, PlySide::Inside, gp_Pnt()}}, options_of(10.0));
    ASSERT_FALSE(overlapping.ok());
    EXPECT_NE(overlapping.failure().message.find("crosses or touches"), std::string::npos)
        << overlapping.failure().message;
}

TEST(PlyStack, AStaggeredDropOffNeverCrosses)
{
    const TopoDS_Face face = panel();
    const std::vector<PlyBoundary> boundaries{
        {"edge", line(gp_Pnt(30, -200, 0), gp_Pnt(30, 200, 0)), PlySide::Left, {}}};
    std::vector<PlySpec> plies{{0.5, {}, 0.0}};
    for (int i = 0; i < 5; ++i)
        plies.push_back({0.5, 0, 12.0 * i});
    plies.push_back({0.5, {}, 0.0});
    PlyStackOptions options;
    const auto made = stack_plies(face, plies, boundaries, options); // ramps of 1:20
    ASSERT_TRUE(made) << why(made);
    expect_proven(made.value(), options.tolerance);
    const Seen seen = look_through(face, plies, made.value(), 1.0);
    EXPECT_GT(seen.present, 15000);
    EXPECT_GT(seen.absent, 5000);
    EXPECT_LE(seen.thickness, 2.0 * options.tolerance);
    EXPECT_LE(seen.crossing, 2.0 * options.tolerance);
    EXPECT_LE(seen.sideways, options.tolerance);
}
