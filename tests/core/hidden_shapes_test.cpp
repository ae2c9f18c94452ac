// SPDX-License-Identifier: LGPL-2.1-or-later
// Planes, cylinders, cones, spheres and tori that are written as splines: their offsets are exact, on no more poles
// than the base has, and a base that is only nearly such a shape is not taken for one.
#include "support/deviation.h"
#include "support/offset_oracle.h"
#include "support/offsets.h"
#include "support/parameters.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/surface/hidden_shape.h>
#include <laminate_offset/surface/offset_surface.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

using namespace laminate_offset;
using namespace test_support;

namespace
{

using Spline = Handle(Geom_BSplineSurface);

struct Hidden
{
    std::string name;
    Spline surface;
    double inwards; //!< -1 or +1: the side that the radius ends, 0 for a plane
    double radius;  //!< where it ends
};

gp_Ax3 frame(double size)
{
    return {gp_Pnt(1.2 * size, -0.7 * size, 3.0 * size), gp_Dir(0.2, -0.3, 1.0), gp_Dir(1.0, 0.4, 0.0)};
}

Spline as_spline(const Handle(Geom_Surface) & surface, const Rectangle &r)
{
    return GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(surface, r.u0, r.u1, r.v0, r.v1));
}

//! All kinds at a size, S_u x S_v outwards.
std::vector<Hidden> hidden(double size)
{
    const gp_Ax3 axes = frame(size);
    const auto s = [size](double x) { return x * size; };
    const double angle = 0.4;
    const double tight = s(2.0) - s(0.9) * std::sin(angle);
    return {
        {"plane", as_spline(new Geom_Plane(axes), {s(-4), s(6), s(-3), s(5)}), 0.0, 0.0},
        {"cylinder", as_spline(new Geom_CylindricalSurface(axes, s(1)), {0.3, 2.0, s(-2), s(3)}), -1.0, s(1)},
        {"whole cylinder", as_spline(new Geom_CylindricalSurface(axes, s(1)), {0, 2 * M_PI, 0, s(3)}), -1.0, s(1)},
        {"sphere", as_spline(new Geom_SphericalSurface(axes, s(1)), {0.3, 2.0, -0.9, 1.1}), -1.0, s(1)},
        {"whole sphere", as_spline(new Geom_SphericalSurface(axes, s(1)), {0, 2 * M_PI, -M_PI_2, M_PI_2}), -1.0, s(1)},
        {"torus", as_spline(new Geom_ToroidalSurface(axes, s(4), s(1)), {0.3, 2.0, -1.2, 1.0}), -1.0, s(1)},
        {"cone", as_spline(new Geom_ConicalSurface(axes, angle, s(2)), {0.3, 2.0, s(-0.9), s(1.4)}), -1.0,
         tight / std::cos(angle)},
    };
}

Rectangle bounds(const Handle(Geom_Surface) & surface)
{
    Rectangle r;
    surface->Bounds(r.u0, r.u1, r.v0, r.v1);
    return r;
}

//! The same without its border, where the normals of a whole sphere's poles are undefined.
Rectangle inside(const Handle(Geom_Surface) & surface)
{
    const Rectangle r = bounds(surface);
    const double du = 1e-3 * (r.u1 - r.u0), dv = 1e-3 * (r.v1 - r.v0);
    return {r.u0 + du, r.u1 - du, r.v0 + dv, r.v1 - dv};
}

Spline copy_of(const Spline &s) { return Handle(Geom_BSplineSurface)::DownCast(s->Copy()); }

//! Of the clamped form, which a periodic surface is offset in.
int pole_count(const Handle(Geom_Surface) & surface)
{
    const auto s = Handle(Geom_BSplineSurface)::DownCast(surface->Copy());
    s->SetUNotPeriodic();
    s->SetVNotPeriodic();
    return s->NbUPoles() * s->NbVPoles();
}

Spline with_more_knots(const Spline &surface, int count)
{
    const Spline s = copy_of(surface);
    const Rectangle r = bounds(s);
    for (int i = 1; i < count; ++i)
    {
        s->InsertUKnot(r.u0 + (r.u1 - r.u0) * (i + 0.37) / count, 1, 1e-9);
        s->InsertVKnot(r.v0 + (r.v1 - r.v0) * (i + 0.21) / count, 1, 1e-9);
    }
    return s;
}

Spline with_higher_degree(const Spline &surface)
{
    const Spline s = copy_of(surface);
    s->IncreaseDegree(s->UDegree() + 1, s->VDegree() + 2);
    return s;
}

Spline with_other_parameters(const Spline &surface)
{
    const Spline s = copy_of(surface);
    move_parameters(s, 3.0, 7.0, -20.0, 0.3);
    return s;
}

//! The other direction runs first, so S_u x S_v turns over.
Spline exchanged(const Spline &surface)
{
    const Spline s = copy_of(surface);
    s->ExchangeUV();
    return s;
}

Spline disturbed(const Spline &surface, double amplitude, RandomCases &random)
{
    const Spline s = copy_of(surface);
    for (int i = 1; i <= s->NbUPoles(); ++i)
        for (int j = 1; j <= s->NbVPoles(); ++j)
        {
            const gp_Vec stray(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
            s->SetPole(i, j, s->Pole(i, j).Translated(amplitude * stray));
        }
    return s;
}

//! What the engine makes of the hidden shape alone.
std::optional<OffsetSurface> hidden_result(const TopoDS_Face &face, double distance, double tolerance)
{
    const InputFace input = read_face(face).value();
    const Result<SurfaceAnalysis> analysis = analyse(input, distance, tolerance);
    if (!analysis)
        return std::nullopt;
    return hidden_offset(analysis.value(), input.from_surface(distance), tolerance);
}

//! The hidden shape is found, proven to rounding, and right; the whole face is made with no more poles.
void expect_exact(const Spline &surface, double distance, double size)
{
    const double tolerance = 1e-6 * size;
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, 1e-7 * std::min(1.0, size));
    const std::optional<OffsetSurface> result = hidden_result(face, distance, tolerance);
    ASSERT_TRUE(result.has_value());
    const Deviation d = deviation(surface, result->geometry, inside(surface), distance, 31);
    EXPECT_GT(d.points, 800);
    EXPECT_LE(d.largest, *result->certified_error);
    EXPECT_LE(*result->certified_error, 1e-8 * (size + std::abs(distance)));
    EXPECT_GT(d.least_cosine, 0.999999);
    EXPECT_LE(pole_count(result->geometry), pole_count(surface));
}

} // namespace

TEST(HiddenShapes, AreExactInAnySizeAndOnBothSides)
{
    int done = 0;
    for (const double size : {1e-3, 1.0, 40.0, 1e4, 1e6})
        for (const Hidden &shape : hidden(size))
            for (const double relative : {-0.8, -0.1, -1e-3, 1e-3, 0.2, 3.0})
            {
                SCOPED_TRACE(testing::Message() << shape.name << " size " << size << " at " << relative);
                expect_exact(shape.surface, relative * (shape.radius > 0.0 ? shape.radius : size), size);
                ++done;
            }
    EXPECT_EQ(done, 5 * 7 * 6);
}

TEST(HiddenShapes, AreFoundWhateverTheirKnotsDegreesAndParameters)
{
    const std::function<Spline(const Spline &)> disguises[] = {
        with_other_parameters, with_higher_degree, [](const Spline &s) { return with_more_knots(s, 5); },
        [](const Spline &s) { return with_other_parameters(with_more_knots(with_higher_degree(s), 3)); }};
    for (const Hidden &shape : hidden(10.0))
        for (const auto &disguise : disguises)
            for (const double distance : {-3.0, 3.0})
            {
                SCOPED_TRACE(testing::Message() << shape.name << " at " << distance);
                expect_exact(disguise(shape.surface), distance, 10.0);
                expect_exact(exchanged(disguise(shape.surface)), distance, 10.0);
            }
}

TEST(HiddenShapes, LoseTheKnotsThatTheyDoNotNeed)
{
    for (const Hidden &shape : hidden(10.0))
    {
        SCOPED_TRACE(shape.name);
        const Spline dense = with_more_knots(shape.surface, 20);
        const std::optional<OffsetSurface> result = hidden_result(BRepBuilderAPI_MakeFace(dense, 1e-7), 1.5, 1e-6);
        ASSERT_TRUE(result.has_value());
        EXPECT_EQ(pole_count(result->geometry), pole_count(shape.surface));
    }
}

TEST(HiddenShapes, MakeWholeFacesWithNoMorePolesThanTheBase)
{
    for (const Hidden &shape : hidden(10.0))
        for (const double distance : {-2.0, 2.0})
        {
            const TopoDS_Face base = BRepBuilderAPI_MakeFace(shape.surface, 1e-7);
            for (const TopoDS_Face &face : {base, reversed(base), located(base)})
            {
                SCOPED_TRACE(testing::Message() << shape.name << " at " << distance);
                const auto result = offset(face, distance, 1e-4);
                ASSERT_TRUE(result.ok()) << why(result);
                const OracleReport measured = measure_offset(face, result.value().face(), distance, {25, 25});
                if (shape.name == "whole sphere") // the oracle has no normals for edges that end at its poles
                {
                    EXPECT_LE(measured.parametric_error, 1e-4);
                }
                else
                {
                    EXPECT_TRUE(confirms(measured, 1e-4));
                }
                const SurfaceSummary &made = *result.value().report.surface;
                EXPECT_LE(made.poles_u * made.poles_v, pole_count(shape.surface));
                EXPECT_EQ(made.type, "bspline");
                ASSERT_TRUE(result.value().report.certified_error && result.value().report.edge_error);
                EXPECT_LE(*result.value().report.edge_error, 1e-4);
            }
        }
}

TEST(HiddenShapes, AreExactInOtherRationalParameters)
{
    // weights in a geometric sequence run through the same piece at another pace
    const gp_Ax3 axes = frame(10.0);
    const Rectangle single{0.3, 1.2, -0.4, 0.5};
    for (const Spline &piece : {as_spline(new Geom_SphericalSurface(axes, 10.0), single),
                                as_spline(new Geom_CylindricalSurface(axes, 10.0), single),
                                as_spline(new Geom_ToroidalSurface(axes, 40.0, 10.0), single)})
    {
        ASSERT_EQ(piece->NbUKnots(), 2);
        ASSERT_EQ(piece->NbVKnots(), 2);
        for (int i = 1; i <= piece->NbUPoles(); ++i)
            for (int j = 1; j <= piece->NbVPoles(); ++j)
                piece->SetWeight(i, j, piece->Weight(i, j) * std::pow(1.3, i) * std::pow(0.8, j));
        for (const double distance : {-2.0, 2.0})
            expect_exact(piece, distance, 10.0);
    }
    TColgp_Array2OfPnt bilinear(1, 2, 1, 2);
    bilinear(1, 1) = gp_Pnt(0, 0, 5);
    bilinear(2, 1) = gp_Pnt(11, 1, 5);
    bilinear(1, 2) = gp_Pnt(-2, 7, 5);
    bilinear(2, 2) = gp_Pnt(8, 12, 5);
    TColStd_Array1OfReal ends(1, 2);
    ends(1) = 0.0;
    ends(2) = 1.0;
    TColStd_Array1OfInteger twice(1, 2);
    twice.Init(2);
    const Spline patch = new Geom_BSplineSurface(bilinear, ends, ends, twice, twice, 1, 1);
    for (const double distance : {-2.0, 2.0})
        expect_exact(patch, distance, 10.0);
}

TEST(HiddenShapes, ALineExtrudedAskewIsAPlane)
{
    const Handle(Geom_Surface) skew =
        new Geom_SurfaceOfLinearExtrusion(new Geom_Line(gp_Pnt(1, 2, 3), gp_Dir(1, 0.2, 0)), gp_Dir(0.5, 1, 0.3));
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(skew, 0, 10, -4, 8, 1e-7);
    const auto result = offset(face, 2.0, 1e-6);
    ASSERT_TRUE(result.ok()) << why(result);
    EXPECT_TRUE(confirms(measure_offset(face, result.value().face(), 2.0, {20, 20}), 1e-6));
    EXPECT_EQ(result.value().report.surface->poles_u * result.value().report.surface->poles_v, 4);
}

TEST(HiddenShapes, NoiseBelowTheToleranceIsProvenAndNoiseAboveItIsNoShape)
{
    RandomCases random;
    const double tolerance = 1e-3;
    int taken = 0;
    for (const Hidden &shape : hidden(10.0))
        for (const double distance : {-3.0, 3.0})
        {
            SCOPED_TRACE(testing::Message() << shape.name << " at " << distance);
            const Spline quiet = disturbed(shape.surface, 1e-6, random);
            const Spline loud = disturbed(shape.surface, 0.05, random);
            const TopoDS_Face quiet_face = BRepBuilderAPI_MakeFace(quiet, 1e-7);
            if (const auto result = hidden_result(quiet_face, distance, tolerance))
            {
                const Deviation d = deviation(quiet, result->geometry, inside(quiet), distance, 31);
                EXPECT_LE(d.largest, *result->certified_error);
                EXPECT_LE(*result->certified_error, tolerance);
                ++taken;
            }
            EXPECT_FALSE(hidden_result(BRepBuilderAPI_MakeFace(loud, 1e-7), distance, tolerance).has_value());
        }
    EXPECT_GE(taken, 8);
}

TEST(HiddenShapes, ABumpBetweenTheSamplesIsRefusedByTheProof)
{
    // one pole of a dense plane is pulled out far less than the samples can be sure to see
    const Spline plane = with_more_knots(with_higher_degree(hidden(10.0)[0].surface), 40);
    int refused = 0;
    for (int i = 3; i < plane->NbUPoles() - 2; i += 5)
    {
        const Spline bumpy = copy_of(plane);
        bumpy->SetPole(i, 7, bumpy->Pole(i, 7).Translated(gp_Vec(0.0, 0.0, 0.02)));
        refused += hidden_result(BRepBuilderAPI_MakeFace(bumpy, 1e-7), 2.0, 1e-3) ? 0 : 1;
    }
    EXPECT_GT(refused, 5);
    for (const Spline &shallow : {height_surface([](double x, double) { return 1e-4 * x * x; }, 60, 40, 6, 6)})
        EXPECT_FALSE(hidden_result(BRepBuilderAPI_MakeFace(shallow, 1e-7), 5.0, 1e-4).has_value());
}

TEST(HiddenShapes, AreRefusedPastTheirRadius)
{
    for (const Hidden &shape : hidden(10.0))
    {
        if (shape.radius == 0.0)
            continue;
        SCOPED_TRACE(shape.name);
        const TopoDS_Face face = BRepBuilderAPI_MakeFace(shape.surface, 1e-7);
        EXPECT_TRUE(offset(face, 0.98 * shape.inwards * shape.radius).ok());
        const auto past = offset(face, 1.02 * shape.inwards * shape.radius);
        ASSERT_FALSE(past.ok());
        EXPECT_EQ(past.failure().status, Status::CurvatureLimit);
        EXPECT_TRUE(past.failure().where.has_value());
        ASSERT_TRUE(past.failure().feasible_range && past.failure().feasible_range->negative);
        EXPECT_NEAR(*past.failure().feasible_range->negative, -shape.radius, 0.01 * shape.radius);
    }
}

TEST(HiddenShapes, AreRecognisedFromTheirSamplesWithTheirDimensions)
{
    const double size = 10.0;
    const gp_Ax3 axes = frame(size);
    const Eigen::Vector3d axis(axes.Direction().X(), axes.Direction().Y(), axes.Direction().Z());
    for (const Hidden &shape : hidden(size))
    {
        SCOPED_TRACE(shape.name);
        ShapeSamples samples{Eigen::MatrixX3d(64, 3), Eigen::MatrixX3d(64, 3)};
        const Rectangle r = bounds(shape.surface);
        for (int i = 0; i < 64; ++i)
        {
            gp_Pnt p;
            gp_Vec u, v;
            shape.surface->D1(r.u0 + (r.u1 - r.u0) * (i / 8 + 0.5) / 8, r.v0 + (r.v1 - r.v0) * (i % 8 + 0.5) / 8, p, u,
                              v);
            const gp_Vec n = u.Crossed(v).Normalized();
            samples.points.row(i) << p.X(), p.Y(), p.Z();
            samples.normals.row(i) << n.X(), n.Y(), n.Z();
        }
        const std::vector<HiddenShape> found = recognise(samples, 1e-9 * size);
        ASSERT_FALSE(found.empty());
        const HiddenShape &first = found.front();
        using Kind = HiddenShape::Kind;
        const bool round = shape.name != "plane" && shape.name != "cone";
        EXPECT_NEAR(first.radius, round ? size : 0.0, 1e-9 * size);
        EXPECT_NEAR(first.kind == Kind::Sphere ? 0.0 : first.axis.cross(axis).norm(), 0.0, 1e-9);
        EXPECT_NEAR(first.major, first.kind == Kind::Torus ? 4.0 * size : 0.0, 1e-9 * size);
        EXPECT_NEAR(std::abs(first.axial), first.kind == Kind::Cone ? std::sin(0.4) : 0.0, 1e-9);
    }
    // free samples are none of the five
    RandomCases random;
    const Eigen::MatrixX3d free = Eigen::MatrixX3d::NullaryExpr(64, 3, [&] { return random.uniform(-1.0, 1.0); });
    EXPECT_TRUE(recognise({free, free.rowwise().normalized()}, 1e-3).empty());
}
