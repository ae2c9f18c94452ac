// SPDX-License-Identifier: LGPL-2.1-or-later
// Extrusions and revolutions of lines and circles that are planes, cylinders, cones, spheres or tori.
#include "support/deviation.h"
#include "support/offsets.h"
#include "support/sample_faces.h"

#include <laminate_offset/analysis/analytic_form.h>
#include <laminate_offset/analysis/closed_limits.h>
#include <laminate_offset/offset_limits.h>
#include <laminate_offset/surface/offset_surface.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace laminate_offset;
using namespace test_support;

namespace
{

struct Disguised
{
    std::string type;
    Handle(Geom_Surface) surface;
    Rectangle part;
};

Handle(Geom_Surface) turned(const Handle(Geom_Curve) & profile)
{
    return new Geom_SurfaceOfRevolution(profile, gp::OZ());
}

Handle(Geom_Curve) circle(const gp_Pnt &centre, const gp_Dir &normal, const gp_Dir &x, double radius)
{
    return new Geom_Circle(gp_Ax2(centre, normal, x), radius);
}

std::vector<Disguised> disguised()
{
    const Handle(Geom_Curve) line = new Geom_Line(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0));
    const Handle(Geom_Curve) ring = circle({3, 4, 5}, gp::DZ(), gp_Dir(1, 2, 0), 9.0);
    std::vector<Disguised> all{
        {"plane", new Geom_SurfaceOfLinearExtrusion(line, gp_Dir(-1, 1, 1)), {-4, 6, -3, 5}},
        {"cylinder", new Geom_SurfaceOfLinearExtrusion(ring, gp::DZ()), {0.3, 2.0, -4, 5}},
        {"cylinder", new Geom_SurfaceOfLinearExtrusion(ring, -gp::DZ()), {0.3, 2.0, -4, 5}},
        {"cylinder",
         new Geom_SurfaceOfLinearExtrusion(new Geom_TrimmedCurve(ring, 0.2, 2.5), gp::DZ()),
         {0.3, 2, -4, 5}},
    };
    for (const double up : {-1.0, 1.0})
    {
        all.push_back({"cylinder", turned(new Geom_Line(gp_Pnt(9, 0, 2), gp_Dir(0, 0, up))), {0.3, 2.0, -4, 5}});
        all.push_back({"cone", turned(new Geom_Line(gp_Pnt(9, 0, 2), gp_Dir(1, 0, 2 * up))), {0.3, 2.0, -4, 5}});
        all.push_back({"cone", turned(new Geom_Line(gp_Pnt(9, 0, 2), gp_Dir(-1, 0, up))), {0.3, 2.0, -4, 5}});
        // the line's own start lies on the far side of the axis
        all.push_back({"cone", turned(new Geom_Line(gp_Pnt(-2, 0, 2), gp_Dir(1, 0, up))), {0.3, 2.0, 12, 20}});
        for (const double start : {0.3, 0.7, -2.5})
        {
            const gp_Dir x(std::cos(start), 0, std::sin(start));
            const double middle = up > 0.0 ? start : -start; // where the circle's angle is that of the x axis
            all.push_back({"torus", turned(circle({40, 0, 3}, gp_Dir(0, up, 0), x, 11.0)), {0.3, 2.0, 1.0, 2.6}});
            all.push_back({"torus", turned(circle({40, 0, 3}, gp_Dir(0, up, 0), x, 11.0)), {0.3, 2.0, 5.0, 6.1}});
            all.push_back({"sphere",
                           turned(circle({0, 0, 3}, gp_Dir(0, up, 0), x, 15.0)),
                           {0.3, 2.0, middle - 0.9, middle + 1.1}});
        }
    }
    return all;
}

TopoDS_Face face_on(const Disguised &d)
{
    return BRepBuilderAPI_MakeFace(d.surface, d.part.u0, d.part.u1, d.part.v0, d.part.v1, 1e-7);
}

//! The same surface turned and moved: its numbers are no longer round.
Disguised askew(Disguised d)
{
    gp_Trsf move, turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(0.3, -0.5, 0.7)), 1.1);
    move.SetTranslation(gp_Vec(300, -200, 77));
    d.surface = Handle(Geom_Surface)::DownCast(d.surface->Transformed(move * turn));
    return d;
}

} // namespace

TEST(AnalyticForm, IsTheBaseInItsOwnParametersUpToAShift)
{
    int done = 0;
    for (const Disguised &straight : disguised())
        for (const Disguised &d : {straight, askew(straight)})
        {
            SCOPED_TRACE(testing::Message() << d.type << " case " << done);
            const auto form = analytic_form(read_face(face_on(d)).value());
            ASSERT_TRUE(form.has_value());
            EXPECT_TRUE(form->disguised);
            const Deviation found = deviation(d.surface, form->surface, d.part, 0.0, 21, form->shift);
            EXPECT_LE(found.largest, 1e-11);
            EXPECT_GT(found.least_cosine, 1.0 - 1e-12) << "the normals agree";
            ++done;
        }
    EXPECT_GT(done, 50);
}

TEST(AnalyticForm, MakesTheOffsetAnalytic)
{
    for (const Disguised &straight : disguised())
        for (const Disguised &d : {straight, askew(straight)})
            for (const double distance : {-2.0, 3.0})
            {
                SCOPED_TRACE(testing::Message() << d.type << " at " << distance);
                const TopoDS_Face face = face_on(d);
                const auto result = offset(face, distance, 1e-4);
                ASSERT_TRUE(result.ok()) << why(result);
                const OffsetReport &report = result.value().report;
                EXPECT_EQ(report.surface->type, d.type);
                ASSERT_TRUE(report.certified_error && report.edge_error);
                EXPECT_LE(*report.certified_error, 1e-9);
                EXPECT_LE(*report.edge_error, 1e-4);
                const Handle(Geom_Surface) made = BRep_Tool::Surface(result.value().face());
                const gp_Vec2d shift = analytic_form(read_face(face).value())->shift;
                const Deviation found = deviation(d.surface, made, d.part, distance, 21, shift);
                EXPECT_LE(found.largest, *report.certified_error);
                EXPECT_GT(found.least_cosine, 1.0 - 1e-12);
                EXPECT_TRUE(offset_limits(face).value().proven);
            }
}

TEST(AnalyticForm, WhatIsOnlyNearlyOneIsNone)
{
    const auto none = [](const Handle(Geom_Surface) & surface, const Rectangle &part) {
        return !analytic_form(read_face(face_on({"", surface, part})).value()).has_value();
    };
    const Handle(Geom_Curve) ring = circle({3, 4, 5}, gp::DZ(), gp::DX(), 9.0);
    EXPECT_TRUE(none(new Geom_SurfaceOfLinearExtrusion(ring, gp_Dir(1e-9, 0, 1)), {0.3, 2, -4, 5}));
    const Handle(Geom_Curve) line = new Geom_Line(gp_Pnt(1, 2, 3), gp::DX());
    EXPECT_TRUE(none(new Geom_SurfaceOfLinearExtrusion(line, gp_Dir(1e-9, 1, 0)), {-4, 6, -3, 5}));
    EXPECT_TRUE(none(turned(new Geom_Line(gp_Pnt(9, 0, 2), gp_Dir(0.2, 1e-9, 1))), {0.3, 2, -4, 5})) << "a hyperboloid";
    EXPECT_TRUE(none(turned(new Geom_Line(gp_Pnt(9, 0, 2), gp::DX())), {0.3, 2, -4, 5})) << "a disc";
    EXPECT_TRUE(none(turned(circle({40, 1e-9, 3}, gp::DY(), gp::DX(), 11.0)), {0.3, 2, -1, 1})) << "off the axis";
    EXPECT_TRUE(none(turned(circle({5, 0, 3}, gp::DY(), gp::DX(), 11.0)), {0.3, 2, -1, 1})) << "a spindle";
    EXPECT_TRUE(none(turned(circle({0, 0, 3}, gp::DY(), gp::DX(), 11.0)), {0.3, 2, 0.3, 2.2})) << "past the pole";
}

TEST(AnalyticForm, AHalfCircleRevolvedAllButAboutItsCentreIsASphereWithAnError)
{
    for (const auto &[off, beside] : {std::pair{1e-10, 0.0}, std::pair{1.6e-8, 2e-9}, std::pair{-1.6e-8, 3e-8},
                                      std::pair{0.0, 5e-8}, std::pair{9e-8, 0.0}, std::pair{-7e-8, -6e-8}})
        for (const Rectangle &part : {Rectangle{0.3, 2.0, -1.0, 0.8}, Rectangle{M_PI, 2.0 * M_PI, 0.9, M_PI_2}})
            for (const double distance : {-2.0, -1e-3, 0.01, 5.0})
            {
                SCOPED_TRACE(testing::Message()
                             << off << ", " << beside << " off the axis, to " << part.v1 << ", at " << distance);
                const double away = std::hypot(off, beside);
                const Disguised d{"sphere", turned(circle({off, beside, 3}, -gp::DY(), gp::DX(), 25.0)), part};
                const TopoDS_Face face = face_on(d);
                const auto form = analytic_form(read_face(face).value());
                ASSERT_TRUE(form);
                EXPECT_NEAR(form->error.point, away, 1e-14);
                EXPECT_NEAR(form->error.normal, 2.0 * std::abs(beside) / 25.0, 1e-16);
                const auto result = offset(face, distance, 1e-4);
                ASSERT_TRUE(result.ok()) << why(result);
                const OffsetReport &report = result.value().report;
                EXPECT_EQ(report.surface->type, "sphere");
                ASSERT_TRUE(report.certified_error && report.edge_error);
                EXPECT_GE(*report.certified_error, away);
                EXPECT_LE(*report.certified_error, 2e-7);
                const Handle(Geom_Surface) made = BRep_Tool::Surface(result.value().face());
                const Deviation found = deviation(d.surface, made, d.part, distance, 21, form->shift);
                EXPECT_LE(found.largest, *report.certified_error);
                EXPECT_GT(found.largest, 0.5 * away) << "the error is real";
            }
    const Disguised beside{"sphere", turned(circle({3e-7, 0, 3}, -gp::DY(), gp::DX(), 25.0)), {0.3, 2.0, -1.0, 0.8}};
    EXPECT_FALSE(analytic_form(read_face(face_on(beside)).value())) << "a spindle";
    const Disguised tiny{"sphere", turned(circle({1e-8, 0, 3}, -gp::DY(), gp::DX(), 1e-3)), {0.3, 2.0, -1.0, 0.8}};
    EXPECT_FALSE(analytic_form(read_face(face_on(tiny)).value())) << "off by a part of its radius that counts";
}

//! The surface itself, as OpenCASCADE evaluates it, is nowhere curved more than its limits say, but next to the axis.
TEST(AnalyticForm, LimitsOfARoundedSphereHoldForTheSurfaceAsItStands)
{
    constexpr double radius = 25.0;
    int sharper = 0, judged = 0;
    for (const auto &[off, beside] : {std::pair{-9e-8, 0.0}, std::pair{-5e-8, 5e-8}, std::pair{-1e-9, 0.0},
                                      std::pair{8e-8, 0.0}, std::pair{0.0, -9e-8}})
        for (const double top : {0.0, 0.8, 1.5, M_PI_2 - 1e-3, M_PI_2})
        {
            SCOPED_TRACE(testing::Message() << off << ", " << beside << " off the axis, to " << top);
            const double m = std::hypot(off, beside);
            const Rectangle part{0.3, 2.0, top - 0.9, top};
            const Disguised d{"sphere", turned(circle({off, beside, 3}, -gp::DY(), gp::DX(), radius)), part};
            const auto limits = closed_limits(read_face(face_on(d)).value());
            ASSERT_TRUE(limits);
            ASSERT_EQ(limits->negative.has_value(), !limits->positive.has_value());
            const CurvatureLimit &limit = limits->negative ? *limits->negative : *limits->positive;
            EXPECT_LT(std::abs(limit.distance), radius);
            EXPECT_GT(std::abs(limit.distance), radius - 1.01 * std::sqrt(m * radius));
            if (top <= 0.8)
            {
                EXPECT_GT(std::abs(limit.distance), radius - 2.0 * m);
            }
            EXPECT_GE(std::abs(limit.folds), radius);
            EXPECT_LT(std::abs(limit.folds), radius + 1e-9);
            double least = 1e100;
            for (int i = 0; i <= 4000; ++i)
            {
                const double part_way = i / 4000.0;
                const double v = part.v1 - (part.v1 - part.v0) * part_way * part_way * part_way; // dense near the pole
                if (radius * std::cos(v) < std::sqrt(m * radius))
                    continue;
                gp_Pnt s;
                gp_Vec u1, v1, uu, vv, uv;
                d.surface->D2(1.0, v, s, u1, v1, uu, vv, uv);
                const gp_Vec normal = u1.Crossed(v1).Normalized();
                const double across = std::abs(uu.Dot(normal)) / u1.SquareMagnitude();
                const double along = std::abs(vv.Dot(normal)) / v1.SquareMagnitude();
                least = std::min(least, 1.0 / std::max(across, along));
                ++judged;
            }
            EXPECT_LE(std::abs(limit.distance), least + 1e-10);
            sharper += least < radius - 10.0 * m ? 1 : 0;
        }
    EXPECT_GT(judged, 50000);
    EXPECT_GE(sharper, 5) << "near a pole the surface is really curved more than the sphere";
}

TEST(AnalyticForm, ToleranceBelowTheErrorOfTheFormIsKeptOtherwise)
{
    const Disguised d{"sphere", turned(circle({5e-8, 0, 3}, -gp::DY(), gp::DX(), 25.0)), {0.3, 2.0, -1.0, 0.8}};
    EXPECT_TRUE(exact_offset(read_face(face_on(d)).value(), 1.0, 1e-6));
    EXPECT_FALSE(exact_offset(read_face(face_on(d)).value(), 1.0, 1e-7));
}

TEST(AnalyticForm, HasTheSameLimitsInBothPlaces)
{
    for (const Disguised &d : disguised())
    {
        SCOPED_TRACE(d.type);
        const TopoDS_Face face = face_on(d);
        const auto limits = offset_limits(face);
        const auto made = offset(face, 0.5);
        ASSERT_TRUE(limits.ok() && made.ok()) << why(made);
        const FeasibleRange &report = *made.value().report.limits;
        ASSERT_EQ(report.negative.has_value(), limits.value().negative.has_value());
        ASSERT_EQ(report.positive.has_value(), limits.value().positive.has_value());
        for (const auto &[shown, limit] :
             {std::pair(report.negative, limits.value().negative), std::pair(report.positive, limits.value().positive)})
            if (limit)
            {
                EXPECT_EQ(*shown, limit->distance);
                const auto past = offset(face, 1.001 * limit->distance);
                ASSERT_FALSE(past.ok());
                EXPECT_EQ(past.failure().status, Status::CurvatureLimit) << why(past);
                EXPECT_TRUE(offset(face, 0.999 * limit->distance).ok());
            }
    }
}
