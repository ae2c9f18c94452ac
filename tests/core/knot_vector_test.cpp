// SPDX-License-Identifier: LGPL-2.1-or-later
// B-spline basis functions: what defines them, and OpenCASCADE's values of them.
#include "support/random_cases.h"

#include <laminate_offset/spline/knot_vector.h>
#include <laminate_offset/spline/vector_kernels.h>

#include <BSplCLib.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <math_Matrix.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace laminate_offset;
using namespace test_support;

namespace
{

constexpr int highest_degree = 9;

//! Parameters inside every span, every knot and both ends.
std::vector<double> telling_parameters(const KnotVector &kv)
{
    std::vector<double> result = kv.breaks();
    const std::vector<double> breaks = result;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        for (const double x : {0.013, 0.31, 0.5, 0.77, 0.999})
            result.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * x);
    return result;
}

bool is_knot(const KnotVector &kv, double u)
{
    return std::find(kv.knots.begin(), kv.knots.end(), u) != kv.knots.end();
}

TColStd_Array1OfReal flat(const KnotVector &kv)
{
    TColStd_Array1OfReal knots(1, static_cast<int>(kv.knots.size()));
    for (int i = 1; i <= knots.Length(); ++i)
        knots(i) = kv.knots[static_cast<std::size_t>(i) - 1];
    return knots;
}

//! Calls visit(kv, random) for knot vectors of every degree, with and without repeated knots.
template <typename Visit> void for_knot_vectors(const Visit &visit)
{
    RandomCases random;
    for (int degree = 1; degree <= highest_degree; ++degree)
        for (const int spans : {1, 2, 7})
            for (const int repeated : {1, degree})
            {
                SCOPED_TRACE(testing::Message()
                             << "degree " << degree << " spans " << spans << " repeated " << repeated);
                visit(random_knots(random, degree, spans, repeated, -2.5, 4.0), random);
            }
}

Handle(Geom_BSplineCurve) random_curve(const KnotVector &kv, RandomCases &random)
{
    TColgp_Array1OfPnt poles(1, kv.pole_count());
    for (int i = 1; i <= poles.Length(); ++i)
        poles(i) = gp_Pnt(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9));
    const std::vector<Knot> distinct = kv.distinct();
    TColStd_Array1OfReal knots(1, static_cast<int>(distinct.size()));
    TColStd_Array1OfInteger multiplicities(1, knots.Length());
    for (int i = 1; i <= knots.Length(); ++i)
    {
        knots(i) = distinct[static_cast<std::size_t>(i) - 1].parameter;
        multiplicities(i) = distinct[static_cast<std::size_t>(i) - 1].multiplicity;
    }
    return new Geom_BSplineCurve(poles, knots, multiplicities, kv.degree);
}

} // namespace

TEST(KnotVector, TheSpanHoldsItsParameterAndIsNeverEmpty)
{
    for_knot_vectors([](const KnotVector &kv, RandomCases &) {
        for (const double u : telling_parameters(kv))
        {
            const auto s = static_cast<std::size_t>(kv.span(u));
            EXPECT_LT(kv.knots[s], kv.knots[s + 1]) << u;
            EXPECT_LE(kv.knots[s], u);
            EXPECT_LE(u, kv.knots[s + 1]);
            EXPECT_TRUE(u < kv.knots[s + 1] || u == kv.back());
        }
        EXPECT_EQ(kv.span(kv.front() - 1.0), kv.degree);
        EXPECT_EQ(kv.span(kv.back() + 1.0), kv.span(kv.back()));
    });
}

TEST(KnotVector, DistinctKnotsAndTheirMultiplicitiesMakeUpTheVector)
{
    for_knot_vectors([](const KnotVector &kv, RandomCases &) {
        std::vector<double> again;
        for (const Knot &knot : kv.distinct())
            again.insert(again.end(), static_cast<std::size_t>(knot.multiplicity), knot.parameter);
        EXPECT_EQ(again, kv.knots);
        EXPECT_EQ(kv.distinct().front().multiplicity, kv.degree + 1);
        EXPECT_EQ(kv.distinct().back().multiplicity, kv.degree + 1);
        EXPECT_EQ(kv.pole_count(), static_cast<int>(kv.knots.size()) - kv.degree - 1);
    });
}

TEST(KnotVector, MergedBreaksAreBothListsOnce)
{
    const std::vector<double> merged = merged_breaks({0.0, 0.25, 0.5, 1.0}, {0.0, 0.5 + 1e-14, 0.75, 1.0});
    EXPECT_EQ(merged, (std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0}));
    EXPECT_EQ(merged_breaks({0.0, 1.0}, {0.0, 0.5, 0.5 + 1e-9, 1.0}).size(), 4u) << "different knots were taken as one";
    EXPECT_TRUE(merged_breaks({}, {}).empty());
}

TEST(Basis, IsAPartitionOfUnityWithoutNegativeValues)
{
    for_knot_vectors([](const KnotVector &kv, RandomCases &) {
        std::vector<double> values(static_cast<std::size_t>(kv.degree) + 1);
        for (const double u : telling_parameters(kv))
        {
            basis_values(kv, kv.span(u), u, values.data());
            double sum = 0.0;
            for (const double value : values)
            {
                EXPECT_GE(value, -1e-15) << u;
                sum += value;
            }
            EXPECT_NEAR(sum, 1.0, 1e-14) << u;
        }
        basis_values(kv, kv.span(kv.front()), kv.front(), values.data());
        EXPECT_DOUBLE_EQ(values.front(), 1.0) << "the first pole is not the start";
        basis_values(kv, kv.span(kv.back()), kv.back(), values.data());
        EXPECT_DOUBLE_EQ(values.back(), 1.0) << "the last pole is not the end";
    });
}

TEST(Basis, DerivativesSumToZeroAndVanishAboveTheDegree)
{
    for_knot_vectors([](const KnotVector &kv, RandomCases &) {
        const int order = kv.degree + 2, width = kv.degree + 1;
        std::vector<double> rows(static_cast<std::size_t>((order + 1) * width));
        for (const double u : telling_parameters(kv))
        {
            basis_derivatives(kv, kv.span(u), u, order, rows.data());
            for (int k = 1; k <= order; ++k)
            {
                double sum = 0.0, largest = 0.0;
                for (int i = 0; i < width; ++i)
                {
                    sum += rows[static_cast<std::size_t>(k * width + i)];
                    largest = std::max(largest, std::abs(rows[static_cast<std::size_t>(k * width + i)]));
                }
                EXPECT_LE(std::abs(sum), 1e-11 * largest) << "order " << k << " at " << u;
                EXPECT_EQ(largest == 0.0, k > kv.degree) << "order " << k;
            }
        }
    });
}

TEST(Basis, DerivativesAreTheDifferencesOfTheOrderBelow)
{
    int compared = 0;
    for_knot_vectors([&](const KnotVector &kv, RandomCases &) {
        const int width = kv.degree + 1, order = std::min(3, kv.degree);
        std::vector<double> here(static_cast<std::size_t>((order + 1) * width)), before = here, after = here;
        for (const double u : telling_parameters(kv))
        {
            const int s = kv.span(u);
            const double step =
                1e-6 * (kv.knots[static_cast<std::size_t>(s) + 1] - kv.knots[static_cast<std::size_t>(s)]);
            basis_derivatives(kv, s, u, order, here.data());
            // the pieces are polynomials: they may be followed past the ends of their span
            basis_derivatives(kv, s, u - step, order, before.data());
            basis_derivatives(kv, s, u + step, order, after.data());
            for (int k = 1; k <= order; ++k)
                for (int i = 0; i < width; ++i)
                {
                    const auto at = static_cast<std::size_t>(k * width + i),
                               below = at - static_cast<std::size_t>(width);
                    double scale = 0.0;
                    for (int j = 0; j < width; ++j)
                        scale = std::max(scale, std::abs(here[static_cast<std::size_t>(k * width + j)]));
                    EXPECT_NEAR((after[below] - before[below]) / (2.0 * step), here[at], 1e-6 * scale + 1e-9);
                    ++compared;
                }
        }
    });
    EXPECT_GT(compared, 10000);
}

TEST(Basis, EqualsThatOfOpenCascade)
{
    int compared = 0;
    for_knot_vectors([&](const KnotVector &kv, RandomCases &) {
        constexpr int order = 2;
        const int width = kv.degree + 1;
        const TColStd_Array1OfReal knots = flat(kv);
        std::vector<double> rows(static_cast<std::size_t>((order + 1) * width));
        math_Matrix reference(1, order + 1, 1, width);
        for (const double u : telling_parameters(kv))
        {
            if (is_knot(kv, u))
                continue; // between pieces that are not smooth, either side may be meant
            int first = 0;
            ASSERT_EQ(BSplCLib::EvalBsplineBasis(std::min(order, kv.degree), width, knots, u, first, reference), 0);
            basis_derivatives(kv, kv.span(u), u, order, rows.data());
            EXPECT_EQ(first - 1, kv.span(u) - kv.degree);
            for (int k = 0; k <= std::min(order, kv.degree); ++k)
                for (int i = 0; i < width; ++i, ++compared)
                    EXPECT_NEAR(rows[static_cast<std::size_t>(k * width + i)], reference(k + 1, i + 1),
                                1e-12 * std::pow(kv.degree * 10.0, k));
        }
    });
    EXPECT_GT(compared, 3000);
}

TEST(Basis, SumsToTheCurvesOfOpenCascadeWithAllTheirDerivatives)
{
    for_knot_vectors([](const KnotVector &kv, RandomCases &random) {
        const Handle(Geom_BSplineCurve) curve = random_curve(kv, random);
        std::vector<double> parameters = telling_parameters(kv);
        std::erase_if(parameters, [&](double u) { return is_knot(kv, u) && u != kv.front() && u != kv.back(); });
        constexpr int order = 3;
        const BasisRows rows(kv, parameters, order);
        ASSERT_EQ(rows.rows(), static_cast<int>(parameters.size()));
        for (int r = 0; r < rows.rows(); ++r)
            for (int k = 0; k <= order; ++k)
            {
                gp_XYZ sum(0.0, 0.0, 0.0);
                for (int i = 0; i < rows.width(); ++i)
                    sum += rows.row(r, k)[i] * curve->Pole(rows.first(r) + i + 1).XYZ();
                const double u = parameters[static_cast<std::size_t>(r)];
                const gp_XYZ expected = k == 0 ? curve->Value(u).XYZ() : curve->DN(u, k).XYZ();
                EXPECT_LE((sum - expected).Modulus(), 1e-11 * (1.0 + expected.Modulus()))
                    << "order " << k << " at " << u;
            }
    });
}

TEST(Basis, ManyParametersAtOnceGiveTheValuesOfEach)
{
    for_knot_vectors([](const KnotVector &kv, RandomCases &random) {
        const std::vector<double> breaks = kv.breaks();
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        {
            std::array<double, lanes> u;
            for (double &x : u)
                x = random.uniform(breaks[i], breaks[i + 1]);
            const int span = kv.span(0.5 * (breaks[i] + breaks[i + 1]));
            SpanBasis basis;
            basis.reset(kv.knots.data() + span, kv.degree);
            std::vector<double> rows(static_cast<std::size_t>(lanes * (kv.degree + 1)));
            basis.lane_values(kv.degree, u.data(), rows.data());
            for (std::size_t k = 0; k < u.size(); ++k)
            {
                std::vector<double> values(static_cast<std::size_t>(kv.degree) + 1);
                basis_values(kv, span, u[k], values.data());
                for (std::size_t j = 0; j < values.size(); ++j)
                    EXPECT_NEAR(rows[j * lanes + k], values[j], 1e-14);
            }
        }
    });
}

TEST(Basis, AtARepeatedKnotThePieceOnItsRightCounts)
{
    const KnotVector kv = clamped_knots(3, 0.0, 2.0, {1.0, 1.0, 1.0});
    const BasisRows at(kv, {1.0}, 1), right(kv, {1.0 + 1e-9}, 1);
    ASSERT_EQ(at.first(0), right.first(0));
    for (int i = 0; i < at.width(); ++i)
    {
        EXPECT_NEAR(at.row(0, 0)[i], right.row(0, 0)[i], 1e-8);
        EXPECT_NEAR(at.row(0, 1)[i], right.row(0, 1)[i], 1e-7);
    }
    EXPECT_DOUBLE_EQ(at.row(0, 0)[0], 1.0) << "a C0 knot has a pole of its own";
}
