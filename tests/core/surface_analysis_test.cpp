// SPDX-License-Identifier: LGPL-2.1-or-later
// Curvature, creases and the feasible range, against OpenCASCADE and against surfaces whose radii are known.
#include "support/offsets.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/analysis/creases.h>
#include <laminate_offset/analysis/curvature.h>
#include <laminate_offset/analysis/surface_analysis.h>
#include <laminate_offset/offset_face.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <GeomConvert.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <gp_Pln.hxx>

#include <gtest/gtest.h>

#include <cmath>

using namespace laminate_offset;
using namespace test_support;

namespace
{

//! The patch of a round surface as a rational B-spline over the given angles.
TopoDS_Face spline_face(const Handle(Geom_Surface) & round, double u0, double u1, double v0, double v1)
{
    const Handle(Geom_BSplineSurface) spline =
        GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(round, u0, u1, v0, v1));
    return BRepBuilderAPI_MakeFace(spline, 1e-7);
}

// A stated limit is never past the true one; and it gives away at most so much of it.
constexpr double given_away = 0.02;

FeasibleRange range_of(const TopoDS_Face &face)
{
    const Result<OffsetResult> result = offset(face, 0.0);
    EXPECT_TRUE(result.ok());
    return result.ok() ? result.value().report.limits.value_or(FeasibleRange{}) : FeasibleRange{};
}

void expect_limit(const std::optional<double> &limit, double expected)
{
    ASSERT_TRUE(limit.has_value());
    EXPECT_LE(*limit / expected, 1.0 + 1e-9) << *limit << " is past " << expected;
    EXPECT_GE(*limit / expected, 1.0 - given_away) << *limit << " falls short of " << expected;
}

bool is_torn(const Result<OffsetResult> &result)
{
    EXPECT_TRUE(result.ok()) << why(result);
    return result.ok() && result.value().report.faces == 2;
}

std::pair<double, double> curvatures(const Handle(Geom_Surface) & surface, const gp_Pnt2d &uv)
{
    GeomLProp_SLProps local(surface, uv.X(), uv.Y(), 2, 1e-9);
    return {local.MinCurvature(), local.MaxCurvature()};
}

//! A roof of two planes that meet at y = 0 under the given angle, as one surface with a C0 knot line.
Handle(Geom_BSplineSurface) roof(double angle)
{
    const double slope = std::tan(0.5 * angle);
    const Handle(Geom_BSplineSurface) surface =
        height_surface([slope](double, double y) { return -slope * std::abs(y); }, 60.0, 40.0, 2, 3, 1);
    surface->IncreaseDegree(3, 3);
    return surface;
}

} // namespace

TEST(PrincipalCurvatures, AreThoseOfOpenCascade)
{
    RandomCases random;
    int compared = 0;
    for (const bool rational : {false, true})
        for (int surfaces = 0; surfaces < 6; ++surfaces)
        {
            const Handle(Geom_BSplineSurface) surface =
                random_surface(random, {.degree_u = 3 + surfaces % 3, .jitter = 0.3, .rational = rational});
            const TensorSpline spline = from_geom(surface);
            for (int i = 0; i < 40; ++i)
            {
                const double u = random.uniform(0, 1), v = random.uniform(0, 1);
                GeomLProp_SLProps reference(surface, u, v, 2, 1e-9);
                ASSERT_TRUE(reference.IsCurvatureDefined());
                const auto k = principal_curvatures(spline.jets({u}, {v}, 2).front());
                ASSERT_TRUE(k.has_value());
                EXPECT_LE(k->first, k->second);
                const double scale = std::abs(k->first) + std::abs(k->second) + 1e-6;
                EXPECT_NEAR(k->first, reference.MinCurvature(), 1e-9 * scale);
                EXPECT_NEAR(k->second, reference.MaxCurvature(), 1e-9 * scale);
                ++compared;
            }
        }
    EXPECT_EQ(compared, 480);
}

TEST(PrincipalCurvatures, DoNotExistAtASingularPlace)
{
    SurfaceJet jet{};
    jet.u = {1, 0, 0};
    jet.v = {2, 0, 0};
    EXPECT_FALSE(principal_curvatures(jet).has_value());
    jet.v = {0, 0, 0};
    EXPECT_FALSE(principal_curvatures(jet).has_value());
}

TEST(FeasibleRange, OfRoundSplinesIsTheirRadius)
{
    const FeasibleRange ball = range_of(spline_face(new Geom_SphericalSurface(gp_Ax3(), 40.0), 0.1, 1.3, -0.5, 0.9));
    EXPECT_FALSE(ball.positive.has_value());
    expect_limit(ball.negative, -40.0);
    const FeasibleRange pipe = range_of(spline_face(new Geom_CylindricalSurface(gp_Ax3(), 7.0), 0.1, 1.3, 0.0, 30.0));
    EXPECT_FALSE(pipe.positive.has_value());
    expect_limit(pipe.negative, -7.0);
}

TEST(FeasibleRange, OfATorusHasTheTubeInsideAndTheHoleOutside)
{
    const double large = 30.0, small = 8.0;
    const Handle(Geom_Surface) torus = new Geom_ToroidalSurface(gp_Ax3(), large, small);
    const FeasibleRange inner = range_of(spline_face(torus, 0.2, 1.4, 0.75 * M_PI, 1.25 * M_PI));
    expect_limit(inner.negative, -small);
    expect_limit(inner.positive, large - small); // along the equator of the hole, radius R - r
    const FeasibleRange outer = range_of(spline_face(torus, 0.2, 1.4, -0.25 * M_PI, 0.25 * M_PI));
    expect_limit(outer.negative, -small);
    EXPECT_FALSE(outer.positive.has_value());
}

TEST(FeasibleRange, OfAReversedFaceIsTurnedRound)
{
    RandomCases random;
    const TopoDS_Face wavy = BRepBuilderAPI_MakeFace(random_surface(random, {}), 1e-7);
    for (const TopoDS_Face &face : {wavy, located(wavy)})
    {
        const FeasibleRange straight = range_of(face), turned = range_of(reversed(face));
        ASSERT_TRUE(straight.negative && straight.positive && turned.negative && turned.positive);
        EXPECT_LT(*straight.negative, 0.0);
        EXPECT_GT(*straight.positive, 0.0);
        EXPECT_NEAR(*turned.negative / *straight.positive, -1.0, 1e-9);
        EXPECT_NEAR(*turned.positive / *straight.negative, -1.0, 1e-9);
    }
}

TEST(FeasibleRange, OfAFlatFaceHasNoEnd)
{
    const auto flat = height_surface([](double x, double) { return 0.3 * x; }, 100.0, 80.0, 6, 5);
    EXPECT_EQ(range_of(BRepBuilderAPI_MakeFace(flat, 1e-7)), FeasibleRange{});
    EXPECT_EQ(range_of(BRepBuilderAPI_MakeFace(new Geom_Plane(gp_Pln()), 0, 10, 0, 10, 1e-7)), FeasibleRange{});
}

TEST(FeasibleRange, IsAttainedAtItsPlaceAndADenseScanFindsNothingTighter)
{
    RandomCases random;
    for (int i = 0; i < 8; ++i)
    {
        const auto surface = random_surface(random, {.spans_u = 2 + i % 4, .height = 6.0, .rational = i % 2 == 1});
        const Result<OffsetResult> below = offset(BRepBuilderAPI_MakeFace(surface, 1e-7), -1e6);
        const Result<OffsetResult> above = offset(BRepBuilderAPI_MakeFace(surface, 1e-7), 1e6);
        ASSERT_TRUE(!below.ok() && !above.ok());
        const double low = below.failure().feasible_range.value().negative.value();
        const double high = above.failure().feasible_range.value().positive.value();
        expect_limit(low, 1.0 / curvatures(surface, below.failure().where.value().uv).first);
        expect_limit(high, 1.0 / curvatures(surface, above.failure().where.value().uv).second);
        double lowest = 0.0, highest = 0.0;
        constexpr int scan = 220;
        for (int k = 0; k <= scan; ++k)
            for (int l = 0; l <= scan; ++l)
            {
                const auto [small, large] = curvatures(surface, gp_Pnt2d(1.0 * k / scan, 1.0 * l / scan));
                lowest = std::min(lowest, small);
                highest = std::max(highest, large);
            }
        EXPECT_LE(lowest * low, 1.0 + 1e-9) << "surface " << i;
        EXPECT_LE(highest * high, 1.0 + 1e-9) << "surface " << i;
    }
}

TEST(FeasibleRange, IgnoresWhatTheLoopsCutAway)
{
    const auto bumpy = [](double x, double y) {
        return 1e-3 * x * x + 6.0 * std::exp(-((x - 120) * (x - 120) + y * y) / 200.0);
    };
    const auto surface = height_surface(bumpy, 400.0, 200.0, 40, 20);
    const FeasibleRange whole = range_of(BRepBuilderAPI_MakeFace(surface, 1e-7));
    const FeasibleRange part = range_of(BRepBuilderAPI_MakeFace(surface, 0.0, 0.6, 0.0, 1.0, 1e-7));
    ASSERT_TRUE(whole.positive && part.positive);
    EXPECT_LT(*whole.positive, 60.0);
    EXPECT_GT(*part.positive, 400.0);
}

//! Limits of a feasible distance are proven; of the true limit they may give away a quarter, as a rule much less.
//! Where hardly any whole piece has a rough bound, the search has enough steps for all of them.
TEST(FeasibleRange, OfANoisyPanelIsFound)
{
    RandomCases random;
    for (const auto &[poles, noise] : {std::pair(40, 8.0), {60, 2.0}})
    {
        SCOPED_TRACE(poles);
        const auto surface =
            height_surface([&](double, double) { return random.uniform(-noise, noise); }, 100.0, 100.0, poles, poles);
        const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, 1e-7);
        GeomLProp_SLProps properties(surface, 2, 1e-12);
        double sharpest = 0.0;
        double u0, u1, v0, v1;
        surface->Bounds(u0, u1, v0, v1);
        for (int i = 0; i <= 300; ++i)
            for (int j = 0; j <= 300; ++j)
            {
                properties.SetParameters(u0 + (u1 - u0) * i / 300, v0 + (v1 - v0) * j / 300);
                sharpest = std::max({sharpest, properties.MaxCurvature(), -properties.MinCurvature()});
            }
        const FeasibleRange range = range_of(face);
        ASSERT_TRUE(range.negative && range.positive);
        EXPECT_LE(std::min(*range.positive, -*range.negative), 1.0 / sharpest);
        EXPECT_GE(std::min(*range.positive, -*range.negative), 0.8 / sharpest);
        const InputFace input = read_face(face).value();
        for (const double distance : {0.5 / sharpest, -0.5 / sharpest})
        {
            const auto analysis = analyse(input, distance, 0.1);
            ASSERT_TRUE(analysis.ok());
            EXPECT_TRUE(check_distance(analysis.value(), input, distance).ok());
        }
    }
}

TEST(FeasibleRange, OfAFeasibleDistanceIsProvenThoughNotSharp)
{
    RandomCases random;
    int compared = 0;
    for (int i = 0; i < 12; ++i)
    {
        const auto surface = random_surface(random, {.spans_u = 1 + i % 4, .height = 6.0, .rational = i % 2 == 1});
        const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, 1e-7);
        const FeasibleRange sharp = range_of(face);
        ASSERT_TRUE(sharp.negative && sharp.positive);
        for (const double part : {-0.9, -1e-2, 1e-2, 0.9})
        {
            const double distance = std::abs(part) * (part < 0.0 ? *sharp.negative : *sharp.positive);
            const auto made = offset(face, distance, 0.1);
            ASSERT_TRUE(made.ok()) << why(made);
            const FeasibleRange range = made.value().report.limits.value();
            // the sharp ones are themselves up to 0.5 percent short
            for (const auto &[wide, limit] :
                 {std::pair(range.negative, sharp.negative), {range.positive, sharp.positive}})
            {
                ASSERT_TRUE(wide.has_value());
                EXPECT_LE(*wide / *limit, 1.006);
                EXPECT_GE(*wide / *limit, 0.7);
                ++compared;
            }
            EXPECT_GT(distance < 0.0 ? distance - *range.negative : *range.positive - distance, 0.0);
        }
    }
    EXPECT_EQ(compared, 96);
}

TEST(Creases, AKinkIsFoundWhereItIs)
{
    for (const double degrees : {0.5, 5.0, 60.0, 150.0})
    {
        SCOPED_TRACE(degrees);
        const TopoDS_Face face = located(BRepBuilderAPI_MakeFace(roof(degrees * M_PI / 180.0), 1e-7));
        const InputFace input = read_face(face).value();
        const Result<SurfaceAnalysis> result = analyse(input, 2.0, 1e-3);
        ASSERT_FALSE(result.ok());
        EXPECT_EQ(result.failure().status, Status::KinkedSurface) << result.failure().message;
        EXPECT_EQ(result.failure().stage, Stage::Analysis);
        ASSERT_TRUE(result.failure().where.has_value());
        EXPECT_NEAR(result.failure().where->uv.Y(), 0.5, 1e-9);
        const gp_Pnt local = result.failure().where->point.Transformed(face.Location().Transformation().Inverted());
        EXPECT_NEAR(local.Y(), 0.0, 1e-9);
        EXPECT_NEAR(local.Z(), 0.0, 1e-9);
        const auto creases = find_creases(input, base_beside_creases(input, {2.0, 1e-3}), LoopRegion(input), 2.0, 1e-3);
        ASSERT_EQ(creases.size(), 1u);
        EXPECT_FALSE(creases.front().constant_u);
        EXPECT_NEAR(creases.front().angle, degrees * M_PI / 180.0, 1e-7);
        EXPECT_NEAR(creases.front().tear, 4.0 * std::sin(degrees * M_PI / 360.0), 1e-6);
    }
}

TEST(Creases, ATearBelowTheToleranceIsNone)
{
    // the tear at distance d is 2 d sin(angle / 2); half of the tolerance is where it begins to matter
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(roof(1e-5), 1e-7);
    for (const double side : {1.0, -1.0})
    {
        EXPECT_FALSE(is_torn(offset(face, side * 49.0)));
        EXPECT_TRUE(is_torn(offset(face, side * 51.0)));
    }
}

TEST(Creases, AtDistanceZeroNothingTears)
{
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(roof(1.0), 1e-7);
    EXPECT_TRUE(offset(face, 0.0, 1e-6).ok());
    EXPECT_TRUE(is_torn(offset(face, 1e-5, 1e-6)));
}

TEST(Creases, ACreaseOutsideTheLoopsDoesNotMatter)
{
    EXPECT_TRUE(offset(BRepBuilderAPI_MakeFace(roof(1.0), 0.0, 1.0, 0.0, 0.4, 1e-7).Face(), 5.0).ok());
    EXPECT_TRUE(is_torn(offset(BRepBuilderAPI_MakeFace(roof(1.0), 0.0, 1.0, 0.0, 0.6, 1e-7).Face(), 5.0)));
}

TEST(Creases, AC0KnotWithoutAJumpOfTheNormalIsNoCrease)
{
    const auto surface = height_surface([](double x, double y) { return 1e-3 * (x * x + y * y); }, 100, 100, 6, 6);
    surface->InsertUKnot(surface->UKnot(2), 3, 1e-9);
    ASSERT_EQ(surface->UMultiplicity(2), 3);
    EXPECT_TRUE(offset(BRepBuilderAPI_MakeFace(surface, 1e-7).Face(), 20.0, 1e-5).ok());
}

// OpenCASCADE cuts a periodic surface millimetres beside where it was asked to when an end misses the period's by rounding.
TEST(BaseSurface, IsTheSurfaceWhereverRoundingHasPutTheEndsOfAPeriod)
{
    int cut = 0;
    for (const int multiplicity : {1, 2})
        for (const bool swapped : {false, true})
        {
            const Handle(Geom_BSplineSurface) tube = wavy_tube(40.0);
            tube->IncreaseUMultiplicity(1, tube->NbUKnots(), multiplicity);
            tube->InsertVKnot(0.5 * (tube->VKnot(1) + tube->VKnot(tube->NbVKnots())), 1, 1e-9);
            double u0, u1, v0, v1;
            tube->Bounds(u0, u1, v0, v1);
            const double period = u1 - u0;
            const double third = (v1 - v0) / 3.0;
            if (swapped)
                tube->ExchangeUV();
            for (const double off : {-1e-12, -1e-14, 0.0, 1e-14, 1e-12})
                for (const double other_off : {-1e-14, 0.0, 1e-14})
                    for (const double turns : {-1.0, 0.0, 1.0})
                        for (const double length : {0.4, 1.0})
                        {
                            SCOPED_TRACE(testing::Message()
                                         << "multiplicity " << multiplicity << " swapped " << swapped << " off " << off
                                         << ' ' << other_off << " turns " << turns << " length " << length);
                            const double low = u0 + (turns + off) * period;
                            const double high = u0 + (turns + length + other_off) * period;
                            const ParameterBox box = swapped ? ParameterBox{v0 + third, v1, low, high}
                                                             : ParameterBox{low, high, v0 + third, v1};
                            const BaseSurface base(tube, box);
                            ASSERT_TRUE(base.spline());
                            for (int i = 0; i <= 20; ++i)
                                for (int j = 0; j <= 4; ++j)
                                {
                                    const double u = box.umin + (box.umax - box.umin) * (0.001 + 0.998 * i / 20.0);
                                    const double v = box.vmin + (box.vmax - box.vmin) * (0.001 + 0.998 * j / 4.0);
                                    const gp_Pnt exact = tube->Value(u, v);
                                    const Eigen::Vector3d seen = base.jets({u}, {v}, 0).front().s;
                                    EXPECT_LT((seen - Eigen::Vector3d(exact.X(), exact.Y(), exact.Z())).norm(), 1e-9);
                                    ++cut;
                                }
                        }
        }
    EXPECT_GT(cut, 10000);
}
