// SPDX-License-Identifier: LGPL-2.1-or-later
// A whole interval of distances from one fit, judged by OpenCASCADE's evaluation of the base at points and distances
// that the engine does not know.
#include "support/deviation.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/input/input_face.h>
#include <laminate_offset/stack/swept_form.h>
#include <laminate_offset/surface/certificate.h>
#include <laminate_offset/surface/offset_family.h>
#include <laminate_offset/surface/offset_surface.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <gp.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

using namespace laminate_offset;
using namespace test_support;

namespace
{

struct Interval
{
    double low;
    double high;

    [[nodiscard]] double farther() const { return std::max(std::abs(low), std::abs(high)); }
};

//! One-sided from the base, across it, and away from it on the other side.
constexpr Interval intervals[] = {{0.0, 2.0}, {-2.0, 2.0}, {-3.0, -1.0}};

TopoDS_Face whole(const Handle(Geom_Surface) & surface) { return BRepBuilderAPI_MakeFace(surface, 1e-7); }

//! A doubly curved panel with poles x poles poles.
TopoDS_Face panel(double size, int poles = 8)
{
    const auto height = [size](double x, double y) {
        return size * (0.1 * std::sin(2.2 * x / size) * std::cos(1.7 * y / size) + 0.04 * x * y / (size * size));
    };
    return whole(height_surface(height, size, 0.6 * size, poles, poles));
}

//! The upper side of a tapered wing; its nose has a radius of some 8 mm at the root and 5 mm at the tip.
TopoDS_Face wing()
{
    const Handle(Geom_BSplineSurface) surface = height_surface([](double, double) { return 0.0; }, 2.0, 600.0, 12, 5);
    for (int i = 1; i <= surface->NbUPoles(); ++i)
        for (int j = 1; j <= surface->NbVPoles(); ++j)
        {
            const double t = (i - 1.0) / (surface->NbUPoles() - 1), span = (j - 1.0) / (surface->NbVPoles() - 1);
            const double chord = 300.0 * (1.0 - 0.4 * span);
            surface->SetPole(i, j, gp_Pnt(chord * t * t, 600.0 * span, chord * 0.24 * t * (1.0 - t * t)));
        }
    return whole(surface);
}

TopoDS_Face rational_panel()
{
    RandomCases random;
    return whole(random_surface(random, {.spans_u = 2, .spans_v = 2, .height = 3.0, .rational = true}));
}

//! A half cylinder as a spline: rational over a weight function that the numerators of S + d N need too.
TopoDS_Face half_cylinder()
{
    return whole(GeomConvert::SurfaceToBSplineSurface(
        new Geom_RectangularTrimmedSurface(new Geom_CylindricalSurface(gp_Ax3(), 40.0), 0.0, 0.9 * M_PI, 0.0, 60.0)));
}

//! Turned about the z axis, the ellipse itself (which has a model) or a curve beside it (which has none).
TopoDS_Face turned(bool beside)
{
    Handle(Geom_Curve) profile = new Geom_Ellipse(gp_Ax2(gp_Pnt(30, 0, 0), -gp::DY(), gp::DX()), 9.0, 8.0);
    if (beside)
        profile = new Geom_OffsetCurve(profile, 2.0, gp::DY());
    return BRepBuilderAPI_MakeFace(new Geom_SurfaceOfRevolution(profile, gp::OZ()), 0.0, 1.0, 0.1, 1.2, 1e-7);
}

struct Case
{
    InputFace input;
    SurfaceAnalysis analysis;
    OffsetOptions options;
};

std::optional<Case> prepared(const TopoDS_Face &face, const Interval &interval, double tolerance)
{
    Result<InputFace> input = read_face(face);
    EXPECT_TRUE(input.ok()) << (input.ok() ? "" : input.failure().message);
    if (!input)
        return std::nullopt;
    Result<SurfaceAnalysis> analysis = analyse(input.value(), interval.farther(), tolerance);
    EXPECT_TRUE(analysis.ok()) << (analysis.ok() ? "" : analysis.failure().message);
    if (!analysis)
        return std::nullopt;
    for (const double end : {interval.low, interval.high})
        EXPECT_TRUE(check_distance(analysis.value(), input.value(), end).ok()) << "the case is wrong: " << end;
    return Case{std::move(input).value(), std::move(analysis).value(), {}};
}

Result<OffsetFamily> family_of(const Case &test, const Interval &interval, double tolerance)
{
    return fit_offset_family(test.analysis, test.input, interval.low, interval.high, tolerance, test.options);
}

//! The largest deviation from the face's own surface, at nine distances of the interval.
double largest_deviation(const TopoDS_Face &face, const OffsetFamily &family, int count)
{
    Rectangle box;
    BRepTools::UVBounds(face, box.u0, box.u1, box.v0, box.v1);
    double largest = 0.0;
    for (const double share : {0.0, 0.07, 0.21, 0.36, 0.5, 0.63, 0.79, 0.92, 1.0})
    {
        const double distance = family.low + share * (family.high - family.low);
        const Deviation seen = deviation(BRep_Tool::Surface(face), to_geom(family.at(distance)), box, distance, count);
        EXPECT_GE(seen.points, count * count / 2);
        EXPECT_GT(seen.least_cosine, 0.99);
        largest = std::max(largest, seen.largest);
    }
    return largest;
}

int pole_count(const TensorSpline &spline) { return spline.u.pole_count() * spline.v.pole_count(); }

//! The larger pole count of the two ends fitted for themselves.
int single_poles(const Case &test, const Interval &interval, double tolerance)
{
    int most = 0;
    for (const double end : {interval.low, interval.high})
    {
        const auto single = fit_offset(test.analysis, test.input, end, tolerance, test.options);
        EXPECT_TRUE(single.ok());
        if (!single)
            continue;
        const auto spline = Handle(Geom_BSplineSurface)::DownCast(single.value().geometry);
        most = std::max(most, spline->NbUPoles() * spline->NbVPoles());
    }
    return most;
}

void expect_parts_agree(const OffsetFamily &family)
{
    EXPECT_EQ(family.direction.u.knots, family.position.u.knots);
    EXPECT_EQ(family.direction.v.knots, family.position.v.knots);
    EXPECT_EQ(family.direction.rational, family.position.rational);
    ASSERT_EQ(family.direction.poles.size(), family.position.poles.size());
    for (std::size_t i = 0; i < family.direction.poles.size(); ++i)
        EXPECT_EQ(family.direction.poles[i].w(), family.position.poles[i].w());
}

//! A family within its bound, the bound within the tolerance, for hardly more poles than one of its ends.
//! \return the family if there is one
std::optional<OffsetFamily> expect_family(const TopoDS_Face &face, const Interval &interval, double tolerance,
                                          int count = 41)
{
    SCOPED_TRACE(testing::Message() << interval.low << " to " << interval.high << ", tolerance " << tolerance);
    const std::optional<Case> test = prepared(face, interval, tolerance);
    if (!test)
        return std::nullopt;
    const Result<OffsetFamily> made = family_of(*test, interval, tolerance);
    EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.failure().message);
    if (!made)
        return std::nullopt;
    const OffsetFamily &family = made.value();
    expect_parts_agree(family);
    EXPECT_EQ(family.low, interval.low);
    EXPECT_EQ(family.high, interval.high);
    const double seen = largest_deviation(face, family, count);
    EXPECT_GT(seen, 0.0);
    EXPECT_LE(seen, tolerance);
    EXPECT_LE(family.sampled_error, tolerance);
    if (family.certified_error)
    {
        EXPECT_LE(seen, *family.certified_error) << "the proven bound is none";
        EXPECT_LE(*family.certified_error, tolerance);
    }
    EXPECT_LE(pole_count(family.position), 1.3 * single_poles(*test, interval, tolerance));
    return family;
}

} // namespace

TEST(OffsetFamily, OfAPanelServesEveryDistanceOfItsInterval)
{
    int proven = 0;
    for (const Interval &interval : intervals)
        for (const double tolerance : {1e-1, 1e-3, 1e-5})
            if (const auto family = expect_family(panel(100.0), interval, tolerance))
                proven += family->certified_error ? 1 : 0;
    EXPECT_EQ(proven, 9);
}

TEST(OffsetFamily, OfAWingServesEveryDistanceOfItsInterval)
{
    int proven = 0;
    for (const Interval &interval : intervals)
        for (const double tolerance : {1e-2, 1e-4})
            if (const auto family = expect_family(wing(), interval, tolerance))
                proven += family->certified_error ? 1 : 0;
    EXPECT_EQ(proven, 6);
}

TEST(OffsetFamily, OfARationalBaseServesEveryDistanceOfItsInterval)
{
    int proven = 0;
    for (const Interval &interval : intervals)
        for (const double tolerance : {1e-2, 1e-4})
            if (const auto family = expect_family(rational_panel(), interval, tolerance))
                proven += family->certified_error ? 1 : 0;
    EXPECT_EQ(proven, 6);
}

TEST(OffsetFamily, OfARationalCylinderStandsOverTheWeightsOfItsBase)
{
    for (const Interval &interval : intervals)
    {
        const auto family = expect_family(half_cylinder(), interval, 1e-6);
        ASSERT_TRUE(family && family->certified_error);
        EXPECT_TRUE(family->position.rational);
        EXPECT_LE(pole_count(family->position), 20);
    }
}

TEST(OffsetFamily, OfAClosedTubeStaysClosed)
{
    const TopoDS_Face tube = whole(wavy_tube(60.0));
    for (const Interval &interval : intervals)
    {
        const auto family = expect_family(tube, interval, 1e-3);
        ASSERT_TRUE(family && family->certified_error);
        const Handle(Geom_BSplineSurface) made = to_geom(family->at(0.5 * (interval.low + interval.high)));
        for (int j = 0; j <= 20; ++j)
            EXPECT_LE(made->Value(0.0, 0.15 * j).Distance(made->Value(12.0, 0.15 * j)), 2.0 * *family->certified_error);
    }
}

TEST(OffsetFamily, OfAnOversampledPanelPaysForItsLightModel)
{
    const TopoDS_Face face = panel(1000.0, 50);
    for (const Interval &interval : intervals)
    {
        constexpr double tolerance = 1e-2;
        const auto test = prepared(face, interval, tolerance);
        ASSERT_TRUE(test);
        const double of_model = test->analysis.base.model_error().of_offset(interval.farther());
        EXPECT_GT(of_model, 0.0) << "the case is wrong: no model";
        const auto family = expect_family(face, interval, tolerance);
        ASSERT_TRUE(family && family->certified_error);
        EXPECT_GT(*family->certified_error, of_model);
        EXPECT_LT(pole_count(family->position), 500);
    }
}

TEST(OffsetFamily, OfASweptSurfaceIsProvenThroughItsModel)
{
    for (const Interval &interval : intervals)
    {
        const auto family = expect_family(turned(false), interval, 1e-3);
        ASSERT_TRUE(family);
        EXPECT_TRUE(family->certified_error);
    }
}

TEST(OffsetFamily, OfASurfaceWithoutSplineOrModelClaimsNoProof)
{
    for (const Interval &interval : intervals)
    {
        const auto family = expect_family(turned(true), interval, 1e-3);
        ASSERT_TRUE(family);
        EXPECT_FALSE(family->certified_error);
        EXPECT_GT(family->sampled_error, 0.0);
    }
}

TEST(OffsetFamily, WorksForEverySizeOfFace)
{
    for (const double size : {1e-3, 1e-1, 1e1, 1e3, 1e6})
        for (const Interval &interval : intervals)
        {
            const Interval scaled{0.01 * size * interval.low, 0.01 * size * interval.high};
            const auto family = expect_family(panel(size), scaled, 1e-5 * size, 21);
            EXPECT_TRUE(family && family->certified_error) << "size " << size;
        }
}

TEST(OffsetFamily, WorksForEveryWidthOfTheInterval)
{
    for (const double width : {1e-12, 1e-9, 1e-6, 1e-3, 1.0, 1e2})
    {
        const auto family = expect_family(panel(100.0), {-0.4 * width, 0.6 * width}, 1e-4, 21);
        EXPECT_TRUE(family && family->certified_error) << "width " << width;
    }
    const auto thin = expect_family(panel(100.0), {2.0, std::nextafter(2.0, 3.0)}, 1e-4, 21);
    EXPECT_TRUE(thin && thin->certified_error);
}

TEST(OffsetFamily, OfRandomSurfacesInRandomIntervals)
{
    RandomCases random;
    int proven = 0;
    for (int run = 0; run < 16; ++run)
    {
        const SurfaceKind kind{.degree_u = random.integer(2, 5),
                               .degree_v = random.integer(2, 5),
                               .spans_u = random.integer(1, 3),
                               .spans_v = random.integer(1, 3),
                               .height = 4.0,
                               .rational = run % 2 == 1};
        const TopoDS_Face face = whole(random_surface(random, kind));
        const Result<InputFace> input = read_face(face);
        ASSERT_TRUE(input.ok());
        const Result<SurfaceAnalysis> analysis = analyse(input.value(), 0.0, 1e-3);
        ASSERT_TRUE(analysis.ok());
        ASSERT_TRUE(analysis.value().negative && analysis.value().positive);
        const double from = 0.8 * analysis.value().negative->distance, to = 0.8 * analysis.value().positive->distance;
        const double one = random.uniform(from, to), other = random.uniform(from, to);
        const auto family =
            expect_family(face, {std::min(one, other), std::max(one, other)}, random.magnitude(1e-3, 1e-1), 31);
        proven += family && family->certified_error ? 1 : 0;
    }
    EXPECT_EQ(proven, 16);
}

TEST(OffsetFamily, FarFromTheOriginIsStillWithinItsBound)
{
    const Handle(Geom_Surface) far = BRep_Tool::Surface(panel(100.0));
    far->Translate(gp_Vec(1e6, -2e6, 3e5));
    const auto family = expect_family(whole(far), {-2.0, 2.0}, 1e-5);
    ASSERT_TRUE(family && family->certified_error);
}

TEST(OffsetFamily, IsNearBaseAndNormalWhereZeroIsInside)
{
    const TopoDS_Face face = panel(100.0);
    const auto family = expect_family(face, {-2.0, 2.0}, 1e-5);
    ASSERT_TRUE(family);
    EXPECT_LE(deviation(BRep_Tool::Surface(face), to_geom(family->position), {}, 0.0, 31).largest, 1e-5);
    const std::vector<double> places{0.0, 0.13, 0.5, 0.77, 1.0};
    for (const SurfaceJet &normal : family->direction.jets(places, places, 0))
        EXPECT_NEAR(normal.s.norm(), 1.0, 1e-5);
}

TEST(OffsetFamily, ThatIsShiftedIsNotProven)
{
    constexpr double tolerance = 1e-4;
    const Interval interval{-2.0, 2.0};
    const auto test = prepared(panel(100.0), interval, tolerance);
    ASSERT_TRUE(test);
    const Result<OffsetFamily> made = family_of(*test, interval, tolerance);
    ASSERT_TRUE(made.ok());
    const TensorSpline &base = *test->analysis.base.spline();
    const auto proven = [&](const OffsetFamily &family, double distance) {
        return certify({base, family.at(distance), distance, tolerance, {}}).proven;
    };
    OffsetFamily moved = made.value(), steeper = made.value();
    for (Eigen::Vector4d &pole : moved.position.poles)
        pole.z() += 3.0 * tolerance;
    for (Eigen::Vector4d &pole : steeper.direction.poles)
        pole.z() += 1.5 * tolerance;
    for (const double distance : {-2.0, -0.7, 0.0, 1.3, 2.0})
    {
        EXPECT_TRUE(proven(made.value(), distance)) << distance;
        EXPECT_FALSE(proven(moved, distance)) << distance;
    }
    EXPECT_FALSE(proven(steeper, -2.0));
    EXPECT_FALSE(proven(steeper, 2.0));
}

TEST(OffsetFamily, OfABadIntervalIsRefused)
{
    const auto test = prepared(panel(100.0), {0.0, 2.0}, 1e-3);
    ASSERT_TRUE(test);
    constexpr double infinite = std::numeric_limits<double>::infinity(), none = std::nan("");
    const auto expect_refused = [&](const Interval &interval, Status status) {
        const Result<OffsetFamily> made = family_of(*test, interval, 1e-3);
        ASSERT_FALSE(made.ok());
        EXPECT_EQ(made.failure().status, status);
        EXPECT_EQ(made.failure().stage, Stage::Options);
        EXPECT_FALSE(made.failure().message.empty());
    };
    for (const Interval &interval : {Interval{1.0, 1.0}, Interval{0.0, -0.0}, Interval{2.0, -2.0}})
        expect_refused(interval, Status::InvalidOption);
    for (const Interval &interval : {Interval{0.0, infinite}, Interval{-infinite, 0.0}, Interval{none, 1.0},
                                     Interval{0.0, none}, Interval{-1.5e308, 1.5e308}})
        expect_refused(interval, Status::InvalidDistance);
}

TEST(OffsetFamily, BelowWhatCanBeProvenIsRefusedWithItsPlace)
{
    const auto expect_refused = [](const Case &test, const Interval &interval, double tolerance) {
        SCOPED_TRACE(testing::Message() << interval.high << ", tolerance " << tolerance);
        const Result<OffsetFamily> made = family_of(test, interval, tolerance);
        ASSERT_FALSE(made.ok());
        EXPECT_EQ(made.failure().status, Status::ToleranceNotReached);
        EXPECT_EQ(made.failure().stage, Stage::Surface);
        EXPECT_TRUE(made.failure().where.has_value());
    };
    const auto flat = prepared(panel(100.0), {-2.0, 2.0}, 1e-3);
    const Handle(Geom_Surface) moved = BRep_Tool::Surface(panel(100.0));
    moved->Translate(gp_Vec(1e11, 0.0, 0.0));
    const auto far = prepared(whole(moved), {-2.0, 2.0}, 1e-3);
    ASSERT_TRUE(flat && far);
    expect_refused(*flat, {-2.0, 2.0}, 0.0);
    expect_refused(*flat, {-2.0, 2.0}, -1.0);
    expect_refused(*far, {-2.0, 2.0}, 3e-4); // below what the rounding of such coordinates may come to
}

TEST(OffsetFamily, AcrossAPlaceWithoutANormalIsRefusedWithThatPlace)
{
    // the first span in u is a single curve
    const Handle(Geom_BSplineSurface) surface =
        height_surface([](double x, double y) { return 0.02 * x * y + 1e-3 * x * x; }, 100.0, 60.0, 8, 5);
    for (int i = 2; i <= 4; ++i)
        for (int j = 1; j <= surface->NbVPoles(); ++j)
            surface->SetPole(i, j, surface->Pole(1, j));
    const Result<InputFace> input = read_face(whole(surface));
    ASSERT_TRUE(input.ok());
    const Result<SurfaceAnalysis> analysis = read_base(input.value(), 2.0, 1e-3);
    ASSERT_TRUE(analysis.ok());
    const Result<OffsetFamily> made = fit_offset_family(analysis.value(), input.value(), -2.0, 2.0, 1e-3, {});
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.failure().status, Status::SingularNormal);
    EXPECT_EQ(made.failure().stage, Stage::Surface);
    ASSERT_TRUE(made.failure().where.has_value());
    EXPECT_LE(made.failure().where->uv.X(), 0.2);
}

TEST(OffsetFamily, CanBeCancelledAtEveryCall)
{
    auto test = prepared(wing(), {-2.0, 2.0}, 1e-4);
    ASSERT_TRUE(test);
    int calls = 0;
    test->options.progress = [&calls](double fraction) {
        EXPECT_TRUE(fraction >= 0.0 && fraction <= 1.0);
        ++calls;
        return true;
    };
    ASSERT_TRUE(family_of(*test, {-2.0, 2.0}, 1e-4).ok());
    const int all = calls;
    EXPECT_GE(all, 3);
    for (int stop = 1; stop <= all; ++stop)
    {
        calls = 0;
        test->options.progress = [&calls, stop](double) { return ++calls < stop; };
        const Result<OffsetFamily> made = family_of(*test, {-2.0, 2.0}, 1e-4);
        ASSERT_FALSE(made.ok());
        EXPECT_EQ(made.failure().status, Status::Cancelled);
        EXPECT_EQ(made.failure().stage, Stage::Surface);
        EXPECT_EQ(calls, stop) << "the work went on after it was told to stop";
    }
}

//! What is reported as seen was seen: it lies below the proven bound, and denser samples find hardly more.
TEST(OffsetFamily, OfASphereReportsWhatItSaw)
{
    const Interval interval{-2.0, 3.0};
    int known = 0;
    for (const double radius : {8.0, 300.0})
        for (const Rectangle &part : {Rectangle{0.3, 2.0, -1.0, 0.8}, Rectangle{0.0, 2.0 * M_PI, -M_PI_2, M_PI_2}})
            for (const bool left_handed : {false, true})
            {
                SCOPED_TRACE(testing::Message() << radius << " to " << part.v1 << (left_handed ? " mirrored" : ""));
                gp_Ax3 frame(gp_Pnt(10, 20, 30), gp_Dir(1, 2, 3));
                if (left_handed)
                    frame.YReverse();
                const Handle(Geom_SphericalSurface) sphere = new Geom_SphericalSurface(frame, radius);
                const TopoDS_Face face = BRepBuilderAPI_MakeFace(sphere, part.u0, part.u1, part.v0, part.v1, 1e-7);
                const Result<InputFace> input = read_face(face);
                ASSERT_TRUE(input.ok());
                InputFace turned = input.value(); // a surface of revolution, which has a model
                turned.surface = swept_form(sphere);
                const Result<SurfaceAnalysis> analysis = analyse(turned, interval.farther(), 1e-4);
                ASSERT_TRUE(analysis.ok());
                const Result<OffsetFamily> made =
                    fit_offset_family(analysis.value(), input.value(), interval.low, interval.high, 1e-4, {});
                ASSERT_TRUE(made.ok()) << made.failure().message;
                const OffsetFamily &family = made.value();
                ASSERT_TRUE(family.certified_error);
                EXPECT_GT(family.sampled_error, 0.0);
                EXPECT_LT(family.sampled_error, *family.certified_error);
                double seen = 0.0;
                for (const double distance : {interval.low, interval.high})
                    seen = std::max(seen, deviation(sphere, to_geom(family.at(distance)), part, distance, 61).largest);
                EXPECT_LE(seen, *family.certified_error);
                EXPECT_LT(seen, 1.5 * family.sampled_error);
                ++known;
            }
    EXPECT_EQ(known, 8);
}
