// SPDX-License-Identifier: LGPL-2.1-or-later
// A light model keeps what its error says in point, normal and curvature, judged by dense samples.
#include "support/offset_oracle.h"
#include "support/offsets.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/analysis/curvature.h>
#include <laminate_offset/analysis/light_model.h>
#include <laminate_offset/spline/data_reduction.h>
#include <laminate_offset/spline/least_squares.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace laminate_offset;
using namespace test_support;

namespace
{

std::size_t spans(const TensorSpline &spline)
{
    return (spline.u.breaks().size() - 1) * (spline.v.breaks().size() - 1);
}

//! A smooth panel of `size` that carries poles x poles poles.
TensorSpline panel(double size, int poles, int degree = 3)
{
    const auto height = [size](double x, double y) {
        return size * (0.1 * std::sin(2.2 * x / size) * std::cos(1.7 * y / size) + 0.04 * x * y / (size * size));
    };
    return from_geom(height_surface(height, size, 0.6 * size, poles, poles, degree));
}

struct Differences
{
    double point = 0.0;
    double normal = 0.0;
    double curvature = 0.0;
};

//! The largest seen on a grid that has nothing to do with the knots of either surface.
Differences differences(const TensorSpline &a, const TensorSpline &b, int count = 157)
{
    std::vector<double> us, vs;
    for (int i = 0; i <= count; ++i)
    {
        us.push_back(a.u.front() + (a.u.back() - a.u.front()) * i / count);
        vs.push_back(a.v.front() + (a.v.back() - a.v.front()) * i / count);
    }
    const std::vector<SurfaceJet> ja = a.jets(us, vs, 2);
    const std::vector<SurfaceJet> jb = b.jets(us, vs, 2);
    Differences worst;
    for (std::size_t i = 0; i < ja.size(); ++i)
    {
        const Eigen::Vector3d na = ja[i].u.cross(ja[i].v).normalized();
        const Eigen::Vector3d nb = jb[i].u.cross(jb[i].v).normalized();
        const auto ka = principal_curvatures(ja[i]);
        const auto kb = principal_curvatures(jb[i]);
        worst.point = std::max(worst.point, (ja[i].s - jb[i].s).norm());
        worst.normal = std::max(worst.normal, (na - nb).norm());
        worst.curvature =
            std::max({worst.curvature, std::abs(ka->first - kb->first), std::abs(ka->second - kb->second)});
    }
    return worst;
}

void expect_within(const Differences &seen, const ModelError &error)
{
    EXPECT_LE(seen.point, error.point);
    EXPECT_LE(seen.normal, error.normal);
    EXPECT_LE(seen.curvature, error.curvature);
}

std::vector<double> interior_knots(const KnotVector &kv)
{
    return {kv.knots.begin() + kv.degree + 1, kv.knots.end() - kv.degree - 1};
}

} // namespace

TEST(KnotInsertion, GivesThePolesOfTheSameCurveOverFinerKnots)
{
    RandomCases random;
    for (int run = 0; run < 40; ++run)
    {
        const int degree = random.integer(1, 7);
        const KnotVector coarse = random_knots(random, degree, random.integer(1, 6), degree, -2.0, 3.0);
        std::vector<double> interior = interior_knots(coarse);
        for (int k = random.integer(0, 8); k > 0; --k)
            interior.push_back(random.uniform(-2.0, 3.0));
        std::sort(interior.begin(), interior.end());
        const KnotVector fine = clamped_knots(degree, coarse.front(), coarse.back(), interior);
        const auto fit = LeastSquaresFit::make_reduction(coarse, fine);
        ASSERT_TRUE(fit);
        const RowMatrix poles = RowMatrix::Random(coarse.pole_count(), 3);
        const RowMatrix inserted = -fit->residual(poles, RowMatrix::Zero(fine.pole_count(), 3));
        std::vector<double> ts;
        for (int i = 0; i <= 200; ++i)
            ts.push_back(-2.0 + 5.0 * i / 200);
        const BasisRows on_coarse(coarse, ts);
        const BasisRows on_fine(fine, ts);
        for (int r = 0; r <= 200; ++r)
        {
            Eigen::RowVector3d difference = Eigen::RowVector3d::Zero();
            for (int i = 0; i <= degree; ++i)
                difference += on_coarse.row(r)[i] * poles.row(on_coarse.first(r) + i) -
                              on_fine.row(r)[i] * inserted.row(on_fine.first(r) + i);
            EXPECT_LE(difference.norm(), 1e-12) << "degree " << degree << " at " << ts[static_cast<std::size_t>(r)];
        }
        EXPECT_LE((fit->solve(inserted) - poles).norm(), 1e-6 * poles.norm()) << "a coarse curve is found again";
    }
}

TEST(DataReduction, ChangesNoPlaceByMoreThanItSays)
{
    for (const double tolerance : {1e-1, 1e-3, 1e-5})
    {
        const TensorSpline base = panel(500.0, 60);
        const std::optional<ReducedSpline> result = reduced(base, tolerance);
        ASSERT_TRUE(result || tolerance < 1e-4) << tolerance;
        if (!result)
            continue;
        EXPECT_LT(spans(result->spline), spans(base));
        EXPECT_LE(result->largest, tolerance);
        const double seen = differences(base, result->spline).point;
        EXPECT_LE(seen, result->largest);
        EXPECT_GT(seen, 0.05 * result->largest) << "the bound says nothing";
    }
}

TEST(DataReduction, KeepsAClosedSurfaceClosed)
{
    constexpr int count = 60;
    TensorSpline closed = panel(500.0, count);
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j)
        {
            const double turn = i + 1 < count ? 2.0 * M_PI * i / (count - 1.0) : 0.0;
            closed.poles[static_cast<std::size_t>(i * count + j)] = {100.0 * std::cos(turn), 100.0 * std::sin(turn),
                                                                     5.0 * j, 1.0};
        }
    const std::optional<ReducedSpline> result = reduced(closed, 1e-1);
    ASSERT_TRUE(result);
    for (int j = 0; j < result->spline.v.pole_count(); ++j)
        EXPECT_EQ(result->spline.pole(0, j), result->spline.pole(result->spline.u.pole_count() - 1, j));
}

TEST(DataReduction, KeepsADentThatFewCurvesShow)
{
    constexpr int count = 80;
    const TensorSpline smooth = panel(500.0, count);
    for (int place = 1; place < count - 1; place += 7)
    {
        TensorSpline dented = smooth;
        dented.poles[static_cast<std::size_t>(place * count + count - 1 - place)].z() += 5.0;
        const DataReduction reduction(dented);
        for (const double tolerance : {1e-2, 1e-3})
        {
            const std::optional<ReducedSpline> result = reduction.within(tolerance);
            ASSERT_TRUE(result) << place;
            EXPECT_LE(result->largest, tolerance);
            EXPECT_LE(differences(dented, result->spline, 241).point, result->largest);
        }
    }
}

TEST(DataReduction, LeavesRationalSurfacesAlone)
{
    TensorSpline rational = panel(500.0, 60);
    ASSERT_TRUE(reduced(rational, 1e-1));
    rational.rational = true;
    EXPECT_FALSE(reduced(rational, 1e-1));
}

TEST(LightModel, ErrorHoldsInPointNormalAndCurvature)
{
    int models = 0;
    for (const double size : {1e-3, 1.0, 500.0, 1e6})
        for (const double share : {1e-2, 1e-4, 1e-6, 1e-8})
            for (const int degree : {3, 5})
            {
                SCOPED_TRACE(::testing::Message() << "size " << size << " share " << share << " degree " << degree);
                const TensorSpline base = panel(size, 50, degree);
                const double distance = 0.01 * size;
                const std::optional<LightModel> model = light_model(base, distance, share * size);
                if (!model)
                    continue;
                ++models;
                EXPECT_LT(spans(model->spline), spans(base));
                EXPECT_LE(model->error.of_offset(distance), 0.25 * share * size);
                const Differences seen = differences(base, model->spline);
                expect_within(seen, model->error);
                EXPECT_GT(seen.normal, 1e-3 * model->error.normal) << "the bound says nothing";
            }
    EXPECT_GE(models, 16);
}

TEST(LightModel, ErrorHoldsForSkewedSurfacesWithNeedlessKnotsAndNoise)
{
    RandomCases random;
    int models = 0;
    for (int run = 0; run < 30; ++run)
    {
        SurfaceKind kind;
        kind.degree_u = random.integer(2, 4);
        kind.degree_v = random.integer(2, 4);
        kind.jitter = random.uniform(0.0, 0.2);
        kind.height = random.magnitude(1.0, 20.0);
        const Handle(Geom_BSplineSurface) surface = random_surface(random, kind);
        for (int k = 0; k < 14; ++k)
        {
            surface->InsertUKnot(random.uniform(0.01, 0.99), 1, 1e-9);
            surface->InsertVKnot(random.uniform(0.01, 0.99), 1, 1e-9);
        }
        TensorSpline base = from_geom(surface);
        const double noise = random.magnitude(1e-12, 1e-6);
        for (Eigen::Vector4d &pole : base.poles)
            pole.z() += random.uniform(-noise, noise);
        const std::optional<LightModel> model = light_model(base, random.sign() * 0.1, random.magnitude(1e-4, 10.0));
        if (!model)
            continue;
        ++models;
        expect_within(differences(base, model->spline), model->error);
    }
    EXPECT_GE(models, 10);
}

//! Flat facets between a grid of points: rows of them flat but for noise, the others a little bent.
TensorSpline facets(double size, int poles, double bend, double noise, RandomCases &random)
{
    TensorSpline result;
    std::vector<double> interior;
    for (int i = 1; i + 1 < poles; ++i)
        interior.push_back(static_cast<double>(i) / (poles - 1));
    result.u = clamped_knots(1, 0.0, 1.0, interior);
    result.v = result.u;
    for (int i = 0; i < poles; ++i)
        for (int j = 0; j < poles; ++j)
        {
            const double x = static_cast<double>(i) / (poles - 1);
            const double y = static_cast<double>(j) / (poles - 1);
            result.poles.emplace_back(size * x + noise * random.uniform(-1, 1), 0.3 * size * x + 0.7 * size * y,
                                      size * bend * x * y + noise * random.uniform(-1, 1), 1.0);
        }
    return result;
}

TEST(LightModel, OfFlatFacetsIsOneOfFew)
{
    RandomCases random;
    for (const double size : {1.0, 500.0, 1e5})
        for (const double bend : {0.0, 0.2})
            for (const double noise : {0.0, 1e-12, 1e-9})
            {
                SCOPED_TRACE(::testing::Message() << "size " << size << " bend " << bend << " noise " << noise);
                const TensorSpline base = facets(size, 31, bend, noise * size, random);
                const std::optional<LightModel> model = light_model(base, 0.01 * size, 1e-4 * size);
                ASSERT_TRUE(model);
                EXPECT_LE(model->spline.u.pole_count() * model->spline.v.pole_count(), 4);
                expect_within(differences(base, model->spline), model->error);
            }
}

//! A wavy ribbon of many spans along and a single one across, which turns by several right angles.
TEST(LightModel, OfALongRibbonWithOneSpanAcross)
{
    for (const double size : {1.0, 500.0})
        for (const int degree : {3, 6})
            for (const bool along_u : {true, false})
            {
                SCOPED_TRACE(::testing::Message() << "size " << size << " degree " << degree << " along u " << along_u);
                TensorSpline base = panel(size, 300, degree);
                (along_u ? base.v : base.u) = clamped_knots(degree, 0.0, 1.0, {});
                (along_u ? base.u : base.v) = panel(size, 300, degree).u;
                base.poles.clear();
                for (int i = 0; i < base.u.pole_count(); ++i)
                    for (int j = 0; j < base.v.pole_count(); ++j)
                    {
                        const double along = (along_u ? i : j) / 299.0,
                                     across = static_cast<double>(along_u ? j : i) / degree;
                        base.poles.emplace_back(size * (along + 0.05 * std::cos(14.0 * along)), 0.1 * size * across,
                                                size * (0.1 * std::sin(14.0 * along) + 0.01 * across * across), 1.0);
                    }
                const std::optional<LightModel> model = light_model(base, 0.005 * size, 1e-5 * size);
                ASSERT_TRUE(model);
                EXPECT_LT(2 * spans(model->spline), spans(base));
                const Differences seen = differences(base, model->spline);
                expect_within(seen, model->error);
                EXPECT_GT(seen.normal, 1e-3 * model->error.normal) << "the bound says nothing";
            }
}

// Lofts have the knots of all their sections, whose second derivatives between them are rounding. Their model says nothing of
// curvatures, and limits are searched on the base.
TEST(LightModel, OfKnotsThatNearlyCoincideServesOffsetsAlone)
{
    for (const double gap : {1e-7, 1e-8})
    {
        SCOPED_TRACE(::testing::Message() << "gap " << gap);
        const Handle(Geom_BSplineSurface) loft = height_surface(
            [](double x, double y) { return 20.0 * std::sin(0.012 * x) + 1e-3 * y * y; }, 1000.0, 300.0, 14, 4);
        for (int k = 1; k < 80; ++k)
            for (const double beside : {0.0, gap, 2.0 * gap})
                loft->InsertUKnot(k / 80.0 + beside, 1, 1e-12);
        const TensorSpline base = from_geom(loft);
        const double distance = 2.0, tolerance = 1e-2;
        const std::optional<LightModel> model = light_model(base, distance, tolerance);
        ASSERT_TRUE(model);
        EXPECT_LT(3 * spans(model->spline), spans(base));
        EXPECT_TRUE(std::isinf(model->error.curvature));
        EXPECT_LE(model->error.of_offset(distance), 0.25 * tolerance);
        expect_within(differences(base, model->spline), model->error);
        for (const double side : {-distance, distance})
        {
            const TopoDS_Face face = BRepBuilderAPI_MakeFace(loft, 1e-6).Face();
            const auto made = offset(face, side, tolerance);
            ASSERT_TRUE(made.ok()) << why(made);
            EXPECT_LT(made.value().report.surface->poles_u, 60);
            const OracleReport seen = measure_offset(face, made.value().face(), side, {60, 60});
            EXPECT_TRUE(confirms(seen, tolerance));
            EXPECT_LE(std::max(seen.surface_error, seen.converse_error), *made.value().report.certified_error);
            const std::optional<double> limit =
                side < 0.0 ? made.value().report.limits->negative : made.value().report.limits->positive;
            ASSERT_TRUE(limit.has_value());
            EXPECT_GT(least_curvature_factor(face, *limit), 0.0) << "of the base itself";
        }
    }
}

TEST(LightModel, LeavesSmallAndSingularBasesAlone)
{
    EXPECT_FALSE(light_model(panel(500.0, 8), 5.0, 1e-1));
    TensorSpline pole = panel(500.0, 60);
    ASSERT_TRUE(light_model(pole, 5.0, 1e-1));
    for (int j = 0; j < 60; ++j)
        pole.poles[static_cast<std::size_t>(j)] = pole.poles.front();
    EXPECT_FALSE(light_model(pole, 5.0, 1e-1));
}
