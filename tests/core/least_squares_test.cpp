// SPDX-License-Identifier: LGPL-2.1-or-later
// What makes a least-squares fit with interpolated ends the right one, and what the row compression promises.
#include "support/random_cases.h"

#include <laminate_offset/spline/knot_choice.h>
#include <laminate_offset/spline/least_squares.h>
#include <laminate_offset/spline/row_compression.h>

#include <Eigen/Dense>

#include <gtest/gtest.h>

using namespace laminate_offset;
using namespace test_support;

namespace
{

RowMatrix random_matrix(RandomCases &random, int rows, int columns)
{
    RowMatrix matrix(rows, columns);
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
            matrix(i, j) = random.uniform(-1.0, 1.0);
    return matrix;
}

//! The whole matrix of basis functions, one row a parameter.
Eigen::MatrixXd collocation(const KnotVector &kv, const std::vector<double> &parameters)
{
    const BasisRows rows(kv, parameters);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows.rows(), kv.pole_count());
    for (int r = 0; r < rows.rows(); ++r)
        for (int i = 0; i < rows.width(); ++i)
            matrix(r, rows.first(r) + i) = rows.row(r)[i];
    return matrix;
}

//! Calls visit(kv, parameters, random) for degrees 1 to 9 and a few knot vectors of each.
template <typename Visit> void for_fits(const Visit &visit)
{
    RandomCases random;
    for (int degree = 1; degree <= 9; ++degree)
        for (const int spans : {1, 3, 8})
        {
            SCOPED_TRACE(testing::Message() << "degree " << degree << " spans " << spans);
            const KnotVector kv = random_knots(random, degree, spans, degree, 1.0, 5.0);
            visit(kv, chebyshev_parameters(kv.breaks(), degree + 3), random);
        }
}

double longest(const RowMatrix &rows, Eigen::Index r)
{
    double result = 0.0;
    for (Eigen::Index c = 0; c + 2 < rows.cols(); c += 3)
        result = std::max(result, rows.row(r).segment<3>(c).norm());
    return result;
}

} // namespace

TEST(LeastSquares, FindsASplineOfTheSpaceAgain)
{
    for_fits([](const KnotVector &kv, const std::vector<double> &parameters, RandomCases &random) {
        const auto fit = LeastSquaresFit::make(kv, parameters);
        ASSERT_TRUE(fit.has_value());
        const RowMatrix poles = random_matrix(random, kv.pole_count(), 6);
        const RowMatrix samples = collocation(kv, parameters) * poles;
        EXPECT_LE((fit->solve(samples) - poles).cwiseAbs().maxCoeff(), 1e-8);
        EXPECT_LE(fit->residual(fit->solve(samples), samples).cwiseAbs().maxCoeff(), 1e-12);
    });
}

TEST(LeastSquares, InterpolatesTheEndsOfAnyData)
{
    for_fits([](const KnotVector &kv, const std::vector<double> &parameters, RandomCases &random) {
        const auto fit = LeastSquaresFit::make(kv, parameters);
        ASSERT_TRUE(fit.has_value());
        const RowMatrix samples = random_matrix(random, static_cast<int>(parameters.size()), 3);
        const RowMatrix residual = fit->residual(fit->solve(samples), samples);
        EXPECT_LE(residual.row(0).cwiseAbs().maxCoeff(), 1e-15);
        EXPECT_LE(residual.row(residual.rows() - 1).cwiseAbs().maxCoeff(), 1e-15);
    });
}

TEST(LeastSquares, LeavesAResidualOrthogonalToTheInnerBasis)
{
    for_fits([](const KnotVector &kv, const std::vector<double> &parameters, RandomCases &random) {
        const auto fit = LeastSquaresFit::make(kv, parameters);
        ASSERT_TRUE(fit.has_value());
        const RowMatrix samples = random_matrix(random, static_cast<int>(parameters.size()), 3);
        const RowMatrix residual = fit->residual(fit->solve(samples), samples);
        const Eigen::MatrixXd basis = collocation(kv, parameters);
        EXPECT_GT(residual.cwiseAbs().maxCoeff(), 1e-2) << "the data should not lie in the space";
        const Eigen::MatrixXd gradient = basis.middleCols(1, kv.pole_count() - 2).transpose() * residual;
        EXPECT_LE(gradient.size() == 0 ? 0.0 : gradient.cwiseAbs().maxCoeff(), 1e-9);
    });
}

TEST(LeastSquares, ResidualIsTheSampleLessTheSpline)
{
    for_fits([](const KnotVector &kv, const std::vector<double> &parameters, RandomCases &random) {
        const auto fit = LeastSquaresFit::make(kv, parameters);
        ASSERT_TRUE(fit.has_value());
        const RowMatrix samples = random_matrix(random, static_cast<int>(parameters.size()), 3);
        const RowMatrix poles = random_matrix(random, kv.pole_count(), 3);
        const Eigen::MatrixXd expected = samples - collocation(kv, parameters) * poles;
        EXPECT_LE((fit->residual(poles, samples) - expected).cwiseAbs().maxCoeff(), 1e-14);
    });
}

TEST(LeastSquares, RefusesSamplesThatDoNotDetermineThePoles)
{
    const KnotVector kv = clamped_knots(3, 0.0, 1.0, {0.25, 0.5, 0.75});
    EXPECT_FALSE(LeastSquaresFit::make(kv, {0.0, 0.3, 0.6, 1.0}).has_value()) << "fewer samples than poles";
    // enough samples, but none in the last half: the poles there hang free
    EXPECT_FALSE(LeastSquaresFit::make(kv, {0.0, 0.02, 0.05, 0.1, 0.15, 0.2, 0.22, 0.24, 1.0}).has_value());
    // all inner samples at one place
    EXPECT_FALSE(LeastSquaresFit::make(kv, {0.0, 0.6, 0.6, 0.6, 0.6, 0.6, 0.6, 0.6, 1.0}).has_value());
    EXPECT_TRUE(LeastSquaresFit::make(kv, chebyshev_parameters(kv.breaks(), 2)).has_value());
}

TEST(RowCompression, KeepsEveryPointWithinTheStatedRemainder)
{
    RandomCases random;
    int with_remainder = 0;
    for (const double accuracy : {1e-1, 1e-3, 1e-6, 1e-12})
        for (const int rank : {1, 3, 10})
        {
            const RowMatrix noise = 0.05 * accuracy * random_matrix(random, 60, 45);
            const RowMatrix samples = random_matrix(random, 60, rank) * random_matrix(random, rank, 45) + noise;
            const CompressedRows rows = compress(samples, accuracy);
            const RowMatrix left = samples - rows.factor * rows.combination;
            double worst = 0.0;
            for (Eigen::Index r = 0; r < left.rows(); ++r)
                worst = std::max(worst, longest(left, r));
            EXPECT_LE(worst, rows.remainder + 1e-13);
            EXPECT_LE(rows.remainder, accuracy);
            with_remainder += rows.remainder > 0.0 ? 1 : 0;
            EXPECT_EQ(rows.factor.cols(), rank) << "noise below the accuracy costs no rank";
        }
    EXPECT_GT(with_remainder, 6);
}

TEST(RowCompression, HasOrthonormalFactorsAndTrueReaches)
{
    RandomCases random;
    const RowMatrix samples = random_matrix(random, 40, 24);
    const CompressedRows rows = compress(samples, 1e-9);
    const Eigen::MatrixXd gram = rows.factor.transpose() * rows.factor;
    EXPECT_LE((gram - Eigen::MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff(), 1e-12);
    ASSERT_EQ(rows.reach.size(), static_cast<std::size_t>(rows.combination.rows()));
    for (Eigen::Index k = 0; k < rows.combination.rows(); ++k)
        EXPECT_NEAR(rows.reach[static_cast<std::size_t>(k)], longest(rows.combination, k), 1e-14);
}

TEST(RowCompression, PointErrorsBoundTheTrueOnesAndAreThemWhereTheyMatter)
{
    RandomCases random;
    const RowMatrix samples = random_matrix(random, 50, 30);
    const CompressedRows rows = compress(samples, 1e-2);
    RowMatrix error = random_matrix(random, 50, static_cast<int>(rows.factor.cols()));
    for (Eigen::Index r = 0; r < error.rows(); ++r)
        error.row(r) *= random.magnitude(1e-5, 1.0);
    const RowMatrix points = error * rows.combination;
    const double enough = 0.05;
    const std::vector<double> stated = rows.point_errors(error, enough);
    int exact = 0, quick = 0;
    for (Eigen::Index r = 0; r < error.rows(); ++r)
    {
        const double truth = longest(points, r), said = stated[static_cast<std::size_t>(r)];
        EXPECT_GE(said, truth);
        if (said > enough)
        {
            EXPECT_NEAR(said, truth + rows.remainder, 1e-12);
        }
        (said > enough ? exact : quick) += 1;
    }
    EXPECT_GE(exact, 5);
    EXPECT_GE(quick, 5);
}

TEST(RowCompression, OfNothingIsNothing)
{
    const CompressedRows rows = compress(RowMatrix::Zero(20, 9), 1e-6);
    EXPECT_EQ(rows.factor.cols(), 0);
    EXPECT_EQ(rows.remainder, 0.0);
}
