// SPDX-License-Identifier: LGPL-2.1-or-later
// Offsets with a distance that varies, judged by OpenCASCADE's evaluation at many points and by interval arithmetic: a
// bound must never lie below the truth.
#include "support/interval_oracle.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/input/input_face.h>
#include <laminate_offset/surface/variable_offset.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <GeomConvert.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

using namespace laminate_offset;
using namespace test_support;

namespace
{

TopoDS_Face whole(const Handle(Geom_Surface) & surface) { return BRepBuilderAPI_MakeFace(surface, 1e-7); }

TopoDS_Face panel()
{
    return whole(height_surface([](double x, double y) { return 40.0 * std::sin(0.006 * x) * std::cos(0.008 * y); },
                                400.0, 300.0, 8, 7));
}

//! Rational: a half cylinder as a spline.
TopoDS_Face half_cylinder()
{
    return whole(GeomConvert::SurfaceToBSplineSurface(
        new Geom_RectangularTrimmedSurface(new Geom_CylindricalSurface(gp_Ax3(), 40.0), 0.0, 0.9 * M_PI, 0.0, 60.0)));
}

//! Steps from `low` to `high` over a few spans in the middle of either direction, smooth of its own.
ScalarSpline step(const ParameterBox &box, double low, double high, double width)
{
    const auto knots = [&](double a, double b) {
        std::vector<double> interior;
        for (int i = 0; i <= 4; ++i)
            interior.push_back(a + (b - a) * (0.45 + width * i / 4.0));
        return clamped_knots(3, a, b, interior);
    };
    ScalarSpline spline{knots(box.umin, box.umax), knots(box.vmin, box.vmax), {}};
    const int half = spline.u.pole_count() / 2;
    for (int i = 0; i < spline.u.pole_count(); ++i)
        for (int j = 0; j < spline.v.pole_count(); ++j)
            spline.poles.push_back(i <= half && j <= half ? high : low);
    return spline;
}

struct Made
{
    InputFace input;
    std::optional<BaseSurface> base;
    OffsetFamily family;
    ScalarSpline distance;
    OffsetSurface surface;
};

std::optional<Made> made(const TopoDS_Face &face, double low, double high, double width, double tolerance)
{
    Made result;
    Result<InputFace> input = read_face(face);
    EXPECT_TRUE(input.ok());
    result.input = std::move(input).value();
    const Result<SurfaceAnalysis> analysis = analyse(result.input, high, tolerance);
    EXPECT_TRUE(analysis.ok());
    const OffsetOptions options;
    Result<OffsetFamily> family =
        fit_offset_family(analysis.value(), result.input, low, high, 0.5 * tolerance, options);
    EXPECT_TRUE(family.ok());
    if (!family)
        return std::nullopt;
    result.family = std::move(family).value();
    result.base.emplace(analysis.value().base);
    result.distance = step(analysis.value().base.box(), low, high, width);
    const Result<OffsetSurface> fitted =
        fit_variable_offset({result.input, result.family, result.distance, tolerance, {}, options});
    EXPECT_TRUE(fitted.ok()) << (fitted.ok() ? "" : fitted.failure().message);
    if (!fitted)
        return std::nullopt;
    result.surface = fitted.value();
    return result;
}

//! Largest |O - (S + d N)| seen with OpenCASCADE's own normals; the distance is evaluated as a surface of its own.
double seen(const Made &made, int count)
{
    const Handle(Geom_Surface) distance = to_geom(made.distance.as_surface());
    double u0, u1, v0, v1;
    made.input.surface->Bounds(u0, u1, v0, v1);
    double worst = 0.0;
    for (int k = 0; k <= count; ++k)
        for (int l = 0; l <= count; ++l)
        {
            const double u = u0 + (u1 - u0) * k / count, v = v0 + (v1 - v0) * l / count;
            GeomLProp_SLProps props(made.input.surface, u, v, 1, 1e-12);
            const gp_XYZ exact = props.Value().XYZ() + distance->Value(u, v).X() * props.Normal().XYZ();
            worst = std::max(worst, (made.surface.geometry->Value(u, v).XYZ() - exact).Modulus());
        }
    return worst;
}

} // namespace

TEST(VariableOffset, StaysWithinItsProvenBound)
{
    for (const TopoDS_Face &face : {panel(), half_cylinder()})
        for (const double sign : {1.0, -1.0})
            for (const double tolerance : {1e-1, 1e-3, 1e-5})
            {
                const double a = 0.25 * sign, b = 1.0 * sign;
                const auto result = made(face, std::min(a, b), std::max(a, b), 0.1, tolerance);
                ASSERT_TRUE(result);
                ASSERT_TRUE(result->surface.certified_error);
                const double error = seen(*result, 150);
                EXPECT_LE(*result->surface.certified_error, tolerance);
                EXPECT_LE(error, *result->surface.certified_error + 1e-10);
                EXPECT_GT(error, 0.01 * tolerance) << "the bound says little";
            }
}

TEST(VariableOffset, IntervalArithmeticFindsNoErrorAboveTheBound)
{
    RandomCases random;
    for (const double tolerance : {1e-2, 1e-4})
    {
        const auto result = made(panel(), 0.0, 2.0, 0.2, tolerance);
        ASSERT_TRUE(result);
        const TensorSpline base = from_geom(Handle(Geom_BSplineSurface)::DownCast(result->input.surface));
        const TensorSpline offset = from_geom(Handle(Geom_BSplineSurface)::DownCast(result->surface.geometry));
        double largest = 0.0;
        int decided = 0;
        for (int i = 0; i < 2000; ++i)
        {
            const double u = random.uniform(0.001, 0.999), v = random.uniform(0.001, 0.999);
            const double d = result->distance.values({u}, {v}).front();
            const Enclosure truth = enclose_deviation(base, offset, d, {u, u}, {v, v});
            decided += std::isfinite(truth.high) ? 1 : 0;
            largest = std::max(largest, truth.low);
            ASSERT_LE(truth.low, *result->surface.certified_error) << u << " " << v;
        }
        EXPECT_GT(decided, 1900);
        EXPECT_GT(largest, 0.05 * tolerance);
    }
}

TEST(VariableOffset, ADamagedFitIsNotProven)
{
    RandomCases random;
    const double tolerance = 1e-3;
    const auto result = made(panel(), 0.0, 1.0, 0.1, tolerance);
    ASSERT_TRUE(result);
    const TensorSpline good = from_geom(Handle(Geom_BSplineSurface)::DownCast(result->surface.geometry));
    const double left = tolerance - *result->family.certified_error;
    EXPECT_TRUE(certify_variable(result->family, result->distance, good, left, {}).proven);
    for (int i = 0; i < 50; ++i)
    {
        TensorSpline bad = good;
        const auto pole = static_cast<std::size_t>(random.integer(0, static_cast<int>(bad.poles.size()) - 1));
        bad.poles[pole][random.integer(0, 2)] += random.sign() * 40.0 * tolerance;
        EXPECT_FALSE(certify_variable(result->family, result->distance, bad, left, {}).proven);
        // what is not asked for does not count
        EXPECT_TRUE(certify_variable(result->family, result->distance, bad, left, [](const ParameterBox &) {
                        return false;
                    }).proven);
    }
}

TEST(VariableOffset, ADistanceOutsideTheFamilyIsRefused)
{
    auto result = made(panel(), 0.0, 1.0, 0.1, 1e-3);
    ASSERT_TRUE(result);
    result->distance.poles.front() = 1.1;
    const OffsetOptions options;
    const auto refused = fit_variable_offset({result->input, result->family, result->distance, 1e-3, {}, options});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.failure().status, Status::InvalidDistance);
    EXPECT_NE(refused.failure().message.find("1.1"), std::string::npos);
}

TEST(ScalarSpline, ASumIsTheSumOfItsPartsAndKeepsConstants)
{
    RandomCases random;
    for (int round = 0; round < 20; ++round)
    {
        ScalarSpline parts[2];
        for (ScalarSpline &part : parts)
        {
            const auto knots = [&] {
                std::vector<double> interior;
                for (int i = 0; i < random.integer(0, 6); ++i)
                    interior.push_back(random.uniform(-0.9, 1.9));
                std::sort(interior.begin(), interior.end());
                return clamped_knots(3, -1.0, 2.0, interior);
            };
            part = {knots(), knots(), {}};
            for (int i = 0; i < part.u.pole_count() * part.v.pole_count(); ++i)
                part.poles.push_back(random.uniform(-1.0, 1.0));
        }
        const ScalarSpline both = sum(parts[0], -2.5, parts[1]);
        const ScalarSpline lifted = sum(ScalarSpline::constant(3.0, -1.0, 2.0, -1.0, 2.0), 1.0, both);
        for (int i = 0; i < 50; ++i)
        {
            const double u = random.uniform(-1.0, 2.0), v = random.uniform(-1.0, 2.0);
            const double expected = parts[0].values({u}, {v})[0] - 2.5 * parts[1].values({u}, {v})[0];
            EXPECT_NEAR(both.values({u}, {v})[0], expected, 1e-12);
            EXPECT_NEAR(lifted.values({u}, {v})[0], 3.0 + expected, 1e-12);
        }
        ScalarSpline flat = parts[0];
        std::fill(flat.poles.begin(), flat.poles.end(), 0.1);
        ScalarSpline none = parts[1];
        std::fill(none.poles.begin(), none.poles.end(), 0.0);
        const auto everywhere = [](double, double, double, double) { return true; };
        EXPECT_EQ(sum(flat, 1.0, none).constant_where(everywhere), std::optional<double>(0.1));
        EXPECT_FALSE(both.constant_where(everywhere));
    }
}
