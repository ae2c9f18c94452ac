// SPDX-License-Identifier: LGPL-2.1-or-later
// Areas, volumes and centres of gravity against closed forms, and on free-form faces against triangulations.
#include "support/data_files.h"
#include "support/sample_faces.h"

#include <laminate_offset/face_integrals.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Circle.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopoDS.hxx>
#include <gp_Circ2d.hxx>
#include <oneapi/tbb/global_control.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

using namespace laminate_offset;
using namespace test_support;

namespace
{

constexpr double pi = std::numbers::pi;

FaceIntegrals integrals(const TopoDS_Shape &face)
{
    const Result<FaceIntegrals> result = face_integrals(face);
    EXPECT_TRUE(result) << (result ? "" : result.failure().message);
    return result ? result.value() : FaceIntegrals{};
}

void expect_relative(double value, double expected, double relative = 1e-9)
{
    EXPECT_NEAR(value, expected, relative * std::abs(expected));
}

void expect_at(const gp_XYZ &point, const gp_XYZ &expected, double tolerance)
{
    EXPECT_LE((point - expected).Modulus(), tolerance) << point.X() << " " << point.Y() << " " << point.Z();
}

struct Hole
{
    gp_Pnt2d centre;
    double radius;
};

//! A rectangle of parameters with circular holes in the parameters.
TopoDS_Face with_holes(const Handle(Geom_Surface) & surface, double u0, double u1, double v0, double v1,
                       const std::vector<Hole> &holes)
{
    BRepBuilderAPI_MakeFace maker(surface, u0, u1, v0, v1, 1e-7);
    for (const Hole &hole : holes)
    {
        const Handle(Geom2d_Circle) circle = new Geom2d_Circle(gp_Ax2d(hole.centre, gp_Dir2d(1.0, 0.0)), hole.radius);
        const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle, surface).Edge()).Wire();
        maker.Add(TopoDS::Wire(wire.Reversed()));
    }
    TopoDS_Face face = maker.Face();
    BRepLib::BuildCurves3d(face);
    return face;
}

//! Those of S + d N over a region of parameters that is the image of unit squares, from triangles with corners on it.
struct Meshed
{
    double area = 0.0;
    double volume = 0.0; //!< under the triangles, by prisms from one offset to the other
};

using Region = std::vector<std::function<gp_Pnt2d(double, double)>>;

gp_XYZ offset_point(const Handle(Geom_Surface) & surface, const gp_Pnt2d &uv, double distance)
{
    GeomLProp_SLProps local(surface, uv.X(), uv.Y(), 1, 1e-12);
    return local.Value().XYZ() + distance * local.Normal().XYZ();
}

//! Volume under a triangle, seen from the origin.
double cone(const gp_XYZ &a, const gp_XYZ &b, const gp_XYZ &c) { return a.Dot(b.Crossed(c)) / 6.0; }

//! The same of a bilinear quadrilateral: the mean of both ways to cut it into triangles.
double cone(const gp_XYZ &a, const gp_XYZ &b, const gp_XYZ &c, const gp_XYZ &d)
{
    return 0.5 * (cone(a, b, c) + cone(a, c, d) + cone(a, b, d) + cone(b, c, d));
}

Meshed meshed(const Handle(Geom_Surface) & surface, const Region &region, double low, double high, int steps)
{
    Meshed result;
    for (const auto &patch : region)
    {
        std::vector<std::vector<std::array<gp_XYZ, 2>>> points(static_cast<std::size_t>(steps) + 1);
        for (int i = 0; i <= steps; ++i)
            for (int j = 0; j <= steps; ++j)
            {
                const gp_Pnt2d uv = patch(double(i) / steps, double(j) / steps);
                points[static_cast<std::size_t>(i)].push_back(
                    {offset_point(surface, uv, low), offset_point(surface, uv, high)});
            }
        const auto triangle = [&](const auto &a, const auto &b, const auto &c) {
            result.area += 0.5 * (b[0] - a[0]).Crossed(c[0] - a[0]).Modulus();
            result.volume += std::abs(cone(a[1], b[1], c[1]) - cone(a[0], b[0], c[0]) + cone(a[0], b[0], b[1], a[1]) +
                                      cone(b[0], c[0], c[1], b[1]) + cone(c[0], a[0], a[1], c[1]));
        };
        for (std::size_t i = 0; i < static_cast<std::size_t>(steps); ++i)
            for (std::size_t j = 0; j < static_cast<std::size_t>(steps); ++j)
            {
                triangle(points[i][j], points[i + 1][j], points[i + 1][j + 1]);
                triangle(points[i][j], points[i + 1][j + 1], points[i][j + 1]);
            }
    }
    return result;
}

//! What the meshes converge to (their error falls with the square of the step, then the fourth power).
Meshed converged(const Handle(Geom_Surface) & surface, const Region &region, double low, double high, int steps)
{
    const Meshed coarse = meshed(surface, region, low, high, steps);
    const Meshed middle = meshed(surface, region, low, high, 2 * steps);
    const Meshed fine = meshed(surface, region, low, high, 4 * steps);
    const auto limit = [](double a, double b, double c) {
        const double first = (4.0 * b - a) / 3.0;
        const double second = (4.0 * c - b) / 3.0;
        return (16.0 * second - first) / 15.0;
    };
    return {limit(coarse.area, middle.area, fine.area), limit(coarse.volume, middle.volume, fine.volume)};
}

//! The unit square without an ellipse, as four patches between a side and a quarter of the ellipse.
Region square_without(const gp_Pnt2d &centre, double radius_u, double radius_v)
{
    Region region;
    const gp_XY corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    for (int k = 0; k < 4; ++k)
        region.push_back([=](double x, double y) {
            const gp_XY outside = corners[k] * (1.0 - x) + corners[k + 1] * x;
            const double angle = 1.25 * pi + 0.5 * pi * (k + x);
            const gp_XY inside = centre.XY() + gp_XY(radius_u * std::cos(angle), radius_v * std::sin(angle));
            return gp_Pnt2d(outside * (1.0 - y) + inside * y);
        });
    return region;
}

Handle(Geom_BSplineSurface) wavy_panel()
{
    return height_surface(
        [](double x, double y) { return 12.0 * std::sin(x / 60.0) * std::cos(y / 45.0) + 0.001 * x * y; }, 300.0, 200.0,
        12, 9);
}

} // namespace

TEST(FaceIntegrals, SpherePatch)
{
    for (const double radius : {1e-2, 1.0, 250.0, 1e5})
    {
        const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(gp_Ax3(), radius);
        const TopoDS_Face face = BRepBuilderAPI_MakeFace(sphere, 0.3, 2.1, -0.4, 1.1, 1e-7).Face();
        const double angle = (2.1 - 0.3) * (std::sin(1.1) - std::sin(-0.4));
        for (const bool turned : {false, true})
        {
            const double sign = turned ? -1.0 : 1.0;
            const FaceIntegrals found = integrals(turned ? reversed(face) : face);
            expect_relative(found.area, angle * radius * radius);
            expect_relative(found.mean_curvature, -sign * angle * radius);
            expect_relative(found.gaussian_curvature, angle);
            EXPECT_LE(found.relative_error, 1e-9);
            for (const double distance : {0.1 * radius, -0.2 * radius, 1e-5 * radius})
            {
                const double other = radius + sign * distance;
                expect_relative(found.area_at(distance), angle * other * other);
                const double shell = sign * angle * (other * other * other - radius * radius * radius) / 3.0;
                EXPECT_NEAR(found.volume(0.0, distance), shell,
                            1e-9 * std::abs(shell) + 1e-14 * radius * radius * radius);
            }
        }
    }
}

TEST(FaceIntegrals, HemisphereHasItsCentreOfGravity)
{
    const double a = 40.0;
    const double b = 43.0;
    const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(gp_Ax3(), a);
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(sphere, 0.0, 2.0 * pi, 0.0, 0.5 * pi, 1e-7).Face();
    const double height = 0.375 * (std::pow(b, 4) - std::pow(a, 4)) / (std::pow(b, 3) - std::pow(a, 3));
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(0, 0, 5), gp_Dir(0, 0, 1)));
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 2)), 0.7);
    for (const gp_Trsf &place : {gp_Trsf(), mirror, turn, turn * mirror})
    {
        constexpr bool refuse_mirrors = false;
        const TopoDS_Face placed = TopoDS::Face(face.Located(TopLoc_Location(place), refuse_mirrors));
        for (const bool turned : {false, true})
        {
            const FaceIntegrals found = integrals(turned ? reversed(placed) : placed);
            const double sign = (turned != place.IsNegative()) ? -1.0 : 1.0;
            const double low = sign > 0.0 ? 0.0 : a - b;
            const double high = sign > 0.0 ? b - a : 0.0;
            const double volume = found.volume(low, high);
            expect_relative(volume, 2.0 * pi * (std::pow(b, 3) - std::pow(a, 3)) / 3.0);
            const gp_Pnt expected = gp_Pnt(0.0, 0.0, height).Transformed(place);
            expect_at(found.first_moment(low, high) / volume, expected.XYZ(), 1e-8);
        }
    }
}

TEST(FaceIntegrals, CylinderAndPlaneWithHoles)
{
    const double radius = 30.0;
    const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), radius);
    const std::vector<Hole> holes{{{1.0, 20.0}, 0.2}, {{2.0, 50.0}, 0.5}};
    const double parameters = 3.0 * 70.0 - pi * (0.2 * 0.2 + 0.5 * 0.5);
    const FaceIntegrals found = integrals(with_holes(cylinder, 0.0, 3.0, 0.0, 70.0, holes));
    expect_relative(found.area, parameters * radius);
    expect_relative(found.mean_curvature, -0.5 * parameters);
    EXPECT_NEAR(found.gaussian_curvature, 0.0, 1e-10);
    expect_relative(found.volume(-2.0, 3.0), 0.5 * parameters * (33.0 * 33.0 - 28.0 * 28.0));

    const FaceIntegrals flat =
        integrals(with_holes(new Geom_Plane(gp_Ax3()), -10.0, 50.0, 5.0, 45.0, {{{3.0, 20.0}, 7.5}}));
    const double area = 60.0 * 40.0 - pi * 7.5 * 7.5;
    expect_relative(flat.area, area);
    EXPECT_NEAR(flat.mean_curvature, 0.0, 1e-12);
    expect_relative(flat.volume(-1.0, 4.0), 5.0 * area);
    const double x = (20.0 * 2400.0 - 3.0 * pi * 7.5 * 7.5) / area;
    const double y = (25.0 * 2400.0 - 20.0 * pi * 7.5 * 7.5) / area;
    expect_at(flat.first_moment(-1.0, 4.0) / flat.volume(-1.0, 4.0), {x, y, 1.5}, 1e-8);
}

TEST(FaceIntegrals, WholeTorusAndSphere)
{
    const FaceIntegrals torus = integrals(
        BRepBuilderAPI_MakeFace(Handle(Geom_Surface)(new Geom_ToroidalSurface(gp_Ax3(), 80.0, 20.0)), 1e-7).Face());
    expect_relative(torus.area, 4.0 * pi * pi * 80.0 * 20.0);
    EXPECT_NEAR(torus.gaussian_curvature, 0.0, 1e-8);
    expect_relative(torus.volume(-3.0, 2.0), 2.0 * pi * pi * 80.0 * (22.0 * 22.0 - 17.0 * 17.0));
    const FaceIntegrals sphere =
        integrals(BRepBuilderAPI_MakeFace(Handle(Geom_Surface)(new Geom_SphericalSurface(gp_Ax3(), 7.0)), 1e-7).Face());
    expect_relative(sphere.area, 4.0 * pi * 49.0);
    expect_relative(sphere.gaussian_curvature, 4.0 * pi);
}

TEST(FaceIntegrals, AFaceOnAnOffsetSurfaceIsMeasuredWhereItStands)
{
    const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(gp_Ax3(), 20.0);
    const Handle(Geom_Surface) offset = new Geom_OffsetSurface(sphere, 5.0);
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(offset, 0.0, 1.0, 0.0, 1.0, 1e-7).Face();
    for (const bool turned : {false, true})
    {
        const FaceIntegrals found = integrals(turned ? reversed(face) : face);
        expect_relative(found.area, std::sin(1.0) * 625.0);
        expect_relative(found.mean_curvature, (turned ? 1.0 : -1.0) * std::sin(1.0) * 25.0);
        expect_relative(found.gaussian_curvature, std::sin(1.0));
    }
}

TEST(FaceIntegrals, FreeFormAgreesWithConvergingTriangulations)
{
    struct Case
    {
        Handle(Geom_Surface) surface;
        TopoDS_Face face;
        Region region;
    };
    const Handle(Geom_Surface) wavy = wavy_panel();
    const Hole hole{{0.55, 0.4}, 0.2};
    const TopoDS_Face panel = panel_with_hole();
    const Case cases[] = {{wavy, with_holes(wavy, 0.0, 1.0, 0.0, 1.0, {hole}), square_without(hole.centre, 0.2, 0.2)},
                          {BRep_Tool::Surface(panel), panel, square_without({0.6, 0.45}, 0.15, 0.1)}};
    for (const Case &one : cases)
    {
        const FaceIntegrals found = integrals(one.face);
        EXPECT_LE(found.relative_error, 1e-8);
        for (const auto &[low, high] : {std::pair{0.0, 2.0}, {-6.0, -1.0}, {3.0, 3.125}})
        {
            const Meshed expected = converged(one.surface, one.region, low, high, 60);
            expect_relative(found.area_at(low), expected.area, 1e-6);
            expect_relative(found.volume(low, high), expected.volume, 1e-6);
        }
    }
}

TEST(FaceIntegrals, PeriodicSplineAndSphereAsASpline)
{
    const Handle(Geom_BSplineSurface) tube = wavy_tube(50.0);
    const FaceIntegrals found = integrals(BRepBuilderAPI_MakeFace(Handle(Geom_Surface)(tube), 1e-7).Face());
    double u0, u1, v0, v1;
    tube->Bounds(u0, u1, v0, v1);
    const Region whole{[=](double x, double y) { return gp_Pnt2d(u0 + x * (u1 - u0), v0 + y * (v1 - v0)); }};
    const Meshed expected = converged(tube, whole, 0.0, 1.5, 120);
    expect_relative(found.area, expected.area, 1e-6);
    expect_relative(found.volume(0.0, 1.5), expected.volume, 1e-6);
}

TEST(FaceIntegrals, TheNumberOfThreadsChangesNothing)
{
    const TopoDS_Face face = panel_with_hole();
    const FaceIntegrals all = integrals(face);
    const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism, 1);
    const FaceIntegrals one = integrals(face);
    EXPECT_EQ(all.area, one.area);
    EXPECT_EQ(all.mean_curvature, one.mean_curvature);
    EXPECT_EQ(all.position[1].X(), one.position[1].X());
}

TEST(FaceIntegrals, RealFacesAgreeWithOpenCascadesArea)
{
    int checked = 0;
    for (const char *name :
         {"derived_D150_fuselage_2p3m_1hole_6curves.step", "derived_D150_fuselage_3p4m_2holes_9curves.step"})
    {
        const auto path = find_data_file(name);
        if (!path)
            continue;
        for (const TopoDS_Face &face : read_faces(*path))
        {
            const FaceIntegrals found = integrals(face);
            GProp_GProps properties;
            BRepGProp::SurfaceProperties(face, properties, 1e-9);
            expect_relative(found.area, properties.Mass(), 1e-6);
            expect_at(found.position[0] / found.area, properties.CentreOfMass().XYZ(), 1e-2);
            EXPECT_LE(found.relative_error, 1e-7);
            ++checked;
        }
    }
    if (checked == 0)
        GTEST_SKIP() << missing_data_message("derived_D150_fuselage_*.step");
}

TEST(FaceIntegralsRefusal, NotAFace) { EXPECT_EQ(face_integrals(TopoDS_Shape()).failure().status, Status::NullShape); }
