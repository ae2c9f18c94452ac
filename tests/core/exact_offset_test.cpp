// SPDX-License-Identifier: LGPL-2.1-or-later
// Plane, cylinder, cone, sphere and torus stay what they are: each result is compared with S + d N point by point.
#include "support/deviation.h"
#include "support/offset_oracle.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/offset_face.h>
#include <laminate_offset/surface/offset_surface.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

using namespace laminate_offset;
using namespace test_support;

namespace
{

//! A right- or left-handed frame away from the origin.
gp_Ax3 frame(bool direct)
{
    gp_Ax3 axes(gp_Pnt(12.0, -7.0, 30.0), gp_Dir(0.2, -0.3, 1.0), gp_Dir(1.0, 0.4, 0.0));
    if (!direct)
        axes.YReverse();
    return axes;
}

struct Kind
{
    std::string type;
    Handle(Geom_Surface) surface;
    Rectangle part;
    double size;         //!< a length that is typical of it [mm]
    bool turned = false; //!< S_u x S_v points inwards in a right-handed frame
};

std::vector<Kind> kinds(bool direct)
{
    const gp_Ax3 axes = frame(direct);
    constexpr bool past_its_axis = true;
    return {{"plane", new Geom_Plane(axes), {-4, 6, -3, 5}, 10.0},
            {"cylinder", new Geom_CylindricalSurface(axes, 9.0), {0.3, 2.0, -4, 5}, 9.0},
            {"sphere", new Geom_SphericalSurface(axes, 15.0), {0.3, 2.0, -0.9, 1.1}, 15.0},
            {"torus", new Geom_ToroidalSurface(axes, 40.0, 11.0), {0.3, 2.0, -1.2, 1.0}, 11.0},
            {"torus", new Geom_ToroidalSurface(axes, 8.0, 55.0), {0.3, 2.0, 2.5, 4.4}, 8.0, past_its_axis},
            {"cone", new Geom_ConicalSurface(axes, 0.4, 12.0), {0.3, 2.0, -9, 14}, 12.0},
            {"cone", new Geom_ConicalSurface(axes, 0.4, 12.0), {0.3, 2.0, -70, -60}, 12.0},
            {"cone", new Geom_ConicalSurface(axes, -1.2, 5.0), {0.3, 2.0, 20, 26}, 12.0}};
}

TopoDS_Face face_on(const Handle(Geom_Surface) & surface, const Rectangle &part)
{
    return BRepBuilderAPI_MakeFace(surface, part.u0, part.u1, part.v0, part.v1, 1e-7);
}

Result<OffsetSurface> exact(const TopoDS_Face &face, double distance)
{
    const auto result = exact_offset(read_face(face).value(), distance, 1e-3);
    if (!result)
        return Failure{Status::NotSupported, Stage::Surface, "no exact offset of this kind", std::nullopt,
                       std::nullopt};
    return *result;
}

//! An Ok result of the same type that is S + d N everywhere, with a proven bound that holds.
void expect_exact(const Kind &kind, double distance)
{
    SCOPED_TRACE(testing::Message() << kind.type << " at " << distance);
    const Result<OffsetSurface> result = exact(face_on(kind.surface, kind.part), distance);
    ASSERT_TRUE(result.ok()) << result.failure().message;
    EXPECT_EQ(result.value().geometry->DynamicType(), kind.surface->DynamicType());
    const Deviation d =
        deviation(kind.surface, result.value().geometry, kind.part, distance, 23, result.value().parameter_shift);
    EXPECT_GT(d.points, 400);
    ASSERT_TRUE(result.value().certified_error.has_value());
    EXPECT_LE(d.largest, *result.value().certified_error);
    EXPECT_LE(*result.value().certified_error, 1e-12 * (std::abs(distance) + 100.0)) << "an exact result is exact";
    EXPECT_FALSE(result.value().sampled_error.has_value()) << "a sampled figure does not belong to an exact result";
    EXPECT_GT(d.least_cosine, 0.999999);
}

//! Refused because the offset folds, at a place of the face, naming the limit.
void expect_folded(const TopoDS_Face &face, double distance, double limit)
{
    SCOPED_TRACE(testing::Message() << "distance " << distance << " limit " << limit);
    OffsetOptions options;
    options.distance = distance;
    const Result<OffsetResult> result = offset_face(face, options);
    ASSERT_FALSE(result.ok()) << "a folded offset was handed out";
    const Failure &failure = result.failure();
    EXPECT_EQ(failure.status, Status::CurvatureLimit) << failure.message;
    EXPECT_EQ(failure.stage, Stage::Analysis);
    ASSERT_TRUE(failure.where.has_value());
    const gp_Pnt there = BRep_Tool::Surface(face)->Value(failure.where->uv.X(), failure.where->uv.Y());
    EXPECT_LT(there.Distance(failure.where->point), 1e-9);
    ASSERT_TRUE(failure.feasible_range.has_value());
    const auto &side = distance < 0.0 ? failure.feasible_range->negative : failure.feasible_range->positive;
    ASSERT_TRUE(side.has_value());
    EXPECT_NEAR(*side, limit, 1e-9 * (1.0 + std::abs(limit)));
}

//! Accepted just inside the limit and right there, refused just past it.
void expect_limit(const TopoDS_Face &face, double limit)
{
    OffsetOptions options;
    options.distance = 0.999 * limit;
    const Result<OffsetResult> inside = offset_face(face, options);
    ASSERT_TRUE(inside.ok()) << inside.failure().message;
    EXPECT_TRUE(confirms(measure_offset(face, inside.value().face(), options.distance, {20, 20}), 1e-6));
    expect_folded(face, 1.001 * limit, limit);
}

} // namespace

TEST(ExactOffset, IsSPlusDNForEveryKindHandAndMagnitude)
{
    int done = 0;
    for (const bool direct : {true, false})
        for (const Kind &kind : kinds(direct))
            for (const double relative : {1e-3, 1e-2, 0.1, 0.5, 0.9, 10.0, 1e3, 1e5})
                for (const double side : {-1.0, 1.0})
                {
                    // past the radius on the inner side there is nothing; and the torus' outside is free here
                    const bool inwards = side * (direct != kind.turned ? 1.0 : -1.0) < 0.0;
                    if (inwards && relative > 0.5 && kind.type != "plane")
                        continue;
                    expect_exact(kind, side * relative * kind.size);
                    ++done;
                }
    EXPECT_GT(done, 100);
}

TEST(ExactOffset, OfDistanceZeroIsTheBase)
{
    for (const bool direct : {true, false})
        for (const Kind &kind : kinds(direct))
            expect_exact(kind, 0.0);
}

TEST(ExactOffset, OtherSurfacesHaveNone)
{
    const InputFace panel = read_face(panel_with_hole()).value();
    EXPECT_FALSE(exact_offset(panel, 1.0, 1e-3).has_value());
}

TEST(ExactOffset, TheWholeFaceIsRightInAllPlaces)
{
    int done = 0;
    for (const bool direct : {true, false})
        for (const Kind &kind : kinds(direct))
            for (const double distance : {0.3 * kind.size, -0.3 * kind.size})
            {
                const TopoDS_Face base = face_on(kind.surface, kind.part);
                for (const TopoDS_Face &face : {base, reversed(base), located(base)})
                {
                    SCOPED_TRACE(testing::Message() << kind.type << " direct " << direct << " distance " << distance);
                    OffsetOptions options;
                    options.distance = distance;
                    const Result<OffsetResult> result = offset_face(face, options);
                    ASSERT_TRUE(result.ok()) << result.failure().message;
                    EXPECT_TRUE(confirms(measure_offset(face, result.value().face(), distance, {20, 20}), 1e-6));
                    EXPECT_EQ(result.value().report.surface->type, kind.type);
                    ++done;
                }
            }
    EXPECT_EQ(done, 96);
}

TEST(ExactOffset, RoundKindsEndAtTheirRadius)
{
    for (const bool direct : {true, false})
        for (const Kind &kind : kinds(direct))
        {
            SCOPED_TRACE(testing::Message() << kind.type << " direct " << direct);
            if (kind.type == "plane" || kind.type == "cone" || kind.turned)
                continue;
            const TopoDS_Face face = face_on(kind.surface, kind.part);
            expect_limit(face, direct ? -kind.size : kind.size);
            expect_limit(reversed(face), direct ? kind.size : -kind.size);
        }
}

TEST(ExactOffset, TheTorusEndsWhereItsTubeReachesTheAxis)
{
    const double large = 40.0, small = 11.0;
    const Handle(Geom_Surface) torus = new Geom_ToroidalSurface(frame(true), large, small);
    // the inner equator v = pi is part of it: R - (r + d) = 0
    expect_limit(face_on(torus, {0.3, 2.0, 2.0, 4.0}), large - small);
    // it ends before the equator, at v = 2.5: R + (r + d) cos v = 0
    expect_limit(face_on(torus, {0.3, 2.0, 1.0, 2.5}), -large / std::cos(2.5) - small);
    // only the outside: no limit outwards
    expect_exact({"torus", torus, {0.3, 2.0, -1.5, 1.5}, small}, 1e4);
}

TEST(ExactOffset, PastItsAxisATorusEndsWhereItsTubeReachesTheAxisAndGrowsWithoutEnd)
{
    for (const bool direct : {true, false})
        for (const auto &[low, high] : {std::pair(2.5, 4.4), {3.0, 3.2}, {4.0, 4.4}, {2.0, 2.2}})
        {
            SCOPED_TRACE(testing::Message() << "direct " << direct << " from " << low << " to " << high);
            const Handle(Geom_Surface) lemon = new Geom_ToroidalSurface(frame(direct), 8.0, 55.0);
            const TopoDS_Face face = face_on(lemon, {0.3, 2.0, low, high});
            const double nearest = std::max(std::cos(low), std::cos(high));
            ASSERT_LT(8.0 + 55.0 * nearest, 0.0);
            // the tube's own outside lies against S_u x S_v here
            const double shrinks = direct ? 1.0 : -1.0;
            expect_limit(face, shrinks * (55.0 + 8.0 / nearest));
            OffsetOptions options;
            options.distance = -shrinks * 500.0;
            const Result<OffsetResult> grown = offset_face(face, options);
            ASSERT_TRUE(grown.ok()) << grown.failure().message;
            EXPECT_TRUE(confirms(measure_offset(face, grown.value().face(), options.distance, {20, 20}), 1e-6));
        }
}

TEST(ExactOffset, DomesAndTipsThatEndOnTheAxisDoNotDependOnTheLastBit)
{
    const double on_axis = std::acos(-8.0 / 55.0), apex = -12.0 / std::sin(0.4);
    const Handle(Geom_Surface) lemon = new Geom_ToroidalSurface(gp_Ax3(), 8.0, 55.0);
    const Handle(Geom_Surface) cone = new Geom_ConicalSurface(gp_Ax3(), 0.4, 12.0);
    for (const double over : {0.0, 1e-15, -1e-15, 1e-12, 1e-10, -1e-10})
    {
        SCOPED_TRACE(over);
        // S_u x S_v points towards the tube's inside past the axis, and away from a cone's axis on both nappes
        const std::pair<TopoDS_Face, double> cases[] = {{face_on(lemon, {0.0, 2.0 * M_PI, on_axis - over, M_PI}), -1.0},
                                                        {face_on(lemon, {0.0, 2.0 * M_PI, 0.5, on_axis + over}), -1.0},
                                                        {face_on(cone, {0.0, 2.0 * M_PI, apex - over, 5.0}), 1.0},
                                                        {face_on(cone, {0.0, 2.0 * M_PI, -60.0, apex + over}), 1.0}};
        for (const auto &[face, open] : cases)
        {
            OffsetOptions options;
            options.distance = 0.5 * open;
            const Result<OffsetResult> made = offset_face(face, options);
            ASSERT_TRUE(made.ok()) << made.failure().message;
            // a circle of 1e-10 mm past the axis has a normal of its own, which the measure takes at its word
            if (over < 1e-11)
                EXPECT_TRUE(confirms(measure_offset(face, made.value().face(), options.distance, {30, 30}), 1e-6));
            options.distance = -options.distance;
            EXPECT_FALSE(offset_face(face, options).ok()) << "the tip closes up";
        }
    }
}

TEST(ExactOffset, AFaceOfATorusAcrossItsAxisIsRefused)
{
    const Handle(Geom_Surface) lemon = new Geom_ToroidalSurface(frame(true), 8.0, 55.0);
    const TopoDS_Face face = face_on(lemon, {0.3, 2.0, 1.0, 2.5});
    for (const double distance : {0.5, -0.5})
        expect_folded(face, distance, 0.0);
}

TEST(ExactOffset, ARefusalNamesTheLimitsOfBothSides)
{
    const double large = 40.0, small = 11.0;
    const TopoDS_Face ring = face_on(new Geom_ToroidalSurface(frame(true), large, small), {0.3, 2.0, 2.0, 4.0});
    for (const TopoDS_Face &face : {ring, reversed(ring)})
        for (const double distance : {-50.0, 50.0})
        {
            OffsetOptions options;
            options.distance = distance;
            const auto result = offset_face(face, options);
            ASSERT_FALSE(result.ok());
            ASSERT_TRUE(result.failure().feasible_range.has_value());
            const FeasibleRange &range = *result.failure().feasible_range;
            ASSERT_TRUE(range.negative && range.positive);
            const bool turned = face.Orientation() == TopAbs_REVERSED;
            EXPECT_NEAR(*range.negative, turned ? small - large : -small, 0.02 * large);
            EXPECT_NEAR(*range.positive, turned ? small : large - small, 0.02 * large);
        }
}

TEST(ExactOffset, TheConeEndsWhereItsTightEndClosesUp)
{
    for (const bool direct : {true, false})
        for (const double angle : {0.4, -0.4, 1.2})
        {
            SCOPED_TRACE(testing::Message() << "direct " << direct << " angle " << angle);
            const Handle(Geom_Surface) cone = new Geom_ConicalSurface(frame(direct), angle, 12.0);
            const Rectangle part{0.3, 2.0, -5.0, 9.0};
            const double tight = std::min(12.0 - 5.0 * std::sin(angle), 12.0 + 9.0 * std::sin(angle));
            ASSERT_GT(tight, 0.0);
            expect_limit(face_on(cone, part), (direct ? -1.0 : 1.0) * tight / std::cos(angle));
        }
}

TEST(ExactOffset, PastItsApexTheConeEndsWhereItsTightEndClosesUp)
{
    for (const bool direct : {true, false})
        for (const double angle : {0.4, -0.4, 1.2, -0.05})
        {
            SCOPED_TRACE(testing::Message() << "direct " << direct << " angle " << angle);
            const Handle(Geom_Surface) cone = new Geom_ConicalSurface(frame(direct), angle, 12.0);
            const double apex = -12.0 / std::sin(angle), side = angle > 0.0 ? -1.0 : 1.0;
            const double tight = apex + side * 10.0, wide = apex + side * 25.0;
            const TopoDS_Face face = face_on(cone, {0.3, 2.0, std::min(tight, wide), std::max(tight, wide)});
            const double inwards = (direct ? -1.0 : 1.0) * 10.0 * std::tan(std::abs(angle));
            expect_limit(face, inwards);
            const TopoDS_Face whole = face_on(cone, {0.0, 2.0 * M_PI, std::min(tight, wide), std::max(tight, wide)});
            expect_limit(whole, inwards);
            const TopoDS_Face tip = face_on(cone, {0.3, 2.0, std::min(apex, wide), std::max(apex, wide)});
            expect_folded(tip, 0.01 * inwards, 0.0);
            OffsetOptions options;
            options.distance = inwards > 0.0 ? -1.0 : 1.0;
            const Result<OffsetResult> outwards = offset_face(tip, options);
            ASSERT_TRUE(outwards.ok()) << outwards.failure().message;
            EXPECT_TRUE(confirms(measure_offset(tip, outwards.value().face(), options.distance, {20, 20}), 1e-6));
        }
}

TEST(ExactOffset, AConeWhoseReferenceCircleTurnsInsideOutShiftsItsParameters)
{
    // the face lies at v in [30, 60], where the radius is large; at v = 0 it would become negative
    const Handle(Geom_Surface) cone = new Geom_ConicalSurface(frame(true), 0.5, 2.0);
    const Rectangle part{0.3, 2.0, 30.0, 60.0};
    for (const double distance : {-10.0, -15.0})
    {
        const Result<OffsetSurface> result = exact(face_on(cone, part), distance);
        ASSERT_TRUE(result.ok());
        EXPECT_NE(result.value().parameter_shift.Y(), 0.0);
        expect_exact({"cone", cone, part, 12.0}, distance);
    }
    OffsetOptions options;
    options.distance = -10.0;
    const TopoDS_Face face = face_on(cone, part);
    const Result<OffsetResult> result = offset_face(face, options);
    ASSERT_TRUE(result.ok()) << result.failure().message;
    EXPECT_TRUE(confirms(measure_offset(face, result.value().face(), -10.0, {30, 30}), 1e-6));
}

TEST(ExactOffset, AConeUpToItsApexGoesOutwardsOnly)
{
    const double angle = 0.5, radius = 6.0, apex = -radius / std::sin(angle);
    const Handle(Geom_Surface) cone = new Geom_ConicalSurface(gp_Ax3(), angle, radius);
    for (const double turn : {2.0 * M_PI, M_PI, 0.7})
    {
        const TopoDS_Face tip = face_on(cone, {0.0, turn, apex, 5.0});
        expect_folded(tip, -0.5, 0.0);
        OffsetOptions options;
        options.distance = 0.5;
        const Result<OffsetResult> outwards = offset_face(tip, options);
        ASSERT_TRUE(outwards.ok()) << outwards.failure().message;
        EXPECT_TRUE(confirms(measure_offset(tip, outwards.value().face(), 0.5, {30, 30}), 1e-6));
    }
}

TEST(ExactOffset, AFaceAcrossTheApexIsRefused)
{
    const double angle = 0.5, radius = 6.0, apex = -radius / std::sin(angle);
    const Handle(Geom_Surface) cone = new Geom_ConicalSurface(gp_Ax3(), angle, radius);
    const TopoDS_Face both = face_on(cone, {0.2, 1.0, apex - 4.0, 5.0});
    for (const double distance : {0.5, -0.5})
    {
        OffsetOptions options;
        options.distance = distance;
        const Result<OffsetResult> result = offset_face(both, options);
        ASSERT_FALSE(result.ok());
        EXPECT_EQ(result.failure().status, Status::CurvatureLimit) << result.failure().message;
        EXPECT_EQ(result.failure().stage, Stage::Analysis);
    }
}

TEST(ExactOffset, ThereAndBackIsTheBase)
{
    RandomCases random;
    int done = 0;
    for (const bool direct : {true, false})
        for (const Kind &kind : kinds(direct))
            for (int i = 0; i < 5; ++i)
            {
                const double distance = random.sign() * random.magnitude(1e-3, 0.4) * kind.size;
                const TopoDS_Face base = face_on(kind.surface, kind.part);
                OffsetOptions options;
                options.distance = distance;
                const auto there = offset_face(base, options);
                ASSERT_TRUE(there.ok()) << there.failure().message;
                options.distance = -distance;
                const auto back = offset_face(there.value().face(), options);
                ASSERT_TRUE(back.ok()) << back.failure().message;
                const Handle(Geom_Surface) again = BRep_Tool::Surface(back.value().face());
                double u0, u1, v0, v1; // a cone past its apex gets parameters of its own
                BRepTools::UVBounds(back.value().face(), u0, u1, v0, v1);
                const gp_Vec2d shift(u0 - kind.part.u0, v0 - kind.part.v0);
                EXPECT_LT(deviation(kind.surface, again, kind.part, 0.0, 15, shift).largest, 1e-10) << kind.type;
                ++done;
            }
    EXPECT_EQ(done, 80);
}
