// SPDX-License-Identifier: LGPL-2.1-or-later
// Chosen knots keep their promise between the samples too, and do not cost poles that the data does not need.
#include "support/random_cases.h"

#include <laminate_offset/spline/knot_choice.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace laminate_offset;
using namespace test_support;

namespace
{

// The tolerance holds at the samples of the search. Between them, and for a fit to other samples, a little more may be
// seen; the stages that use the knots measure again and ask for less where they must.
constexpr double between_samples = 2.0;

using Curve = std::function<Eigen::Vector3d(double)>;

KnotProblem problem_of(const std::vector<Curve> &curves, double low, double high, double tolerance)
{
    KnotProblem problem;
    problem.low = low;
    problem.high = high;
    problem.tolerance = tolerance;
    problem.sample = [curves](const std::vector<double> &parameters) {
        RowMatrix rows(static_cast<Eigen::Index>(parameters.size()), 3 * static_cast<Eigen::Index>(curves.size()));
        for (std::size_t i = 0; i < parameters.size(); ++i)
            for (std::size_t c = 0; c < curves.size(); ++c)
                rows.row(static_cast<Eigen::Index>(i)).segment<3>(3 * static_cast<Eigen::Index>(c)) =
                    curves[c](parameters[i]).transpose();
        return rows;
    };
    return problem;
}

//! Largest error of the least-squares spline on the knots, at places that have nothing to do with its samples.
double independent_error(const KnotProblem &problem, const KnotVector &knots)
{
    std::vector<double> breaks = knots.breaks();
    for (const DataBreak &b : problem.breaks)
        breaks = merged_breaks(breaks, {problem.low, b.parameter, problem.high});
    const std::vector<double> fitted_at = chebyshev_parameters(breaks, knots.degree + 4);
    const auto fit = LeastSquaresFit::make(knots, fitted_at);
    if (!fit)
        return HUGE_VAL;
    const RowMatrix poles = fit->solve(problem.sample(fitted_at));
    std::vector<double> dense;
    constexpr int count = 4999;
    for (int i = 0; i <= count; ++i)
        dense.push_back(problem.low + (problem.high - problem.low) * i / count);
    const RowMatrix exact = problem.sample(dense);
    const BasisRows rows(knots, dense);
    double worst = 0.0;
    for (int r = 0; r < rows.rows(); ++r)
    {
        Eigen::RowVectorXd here = -exact.row(r);
        for (int i = 0; i < rows.width(); ++i)
            here += rows.row(r)[i] * poles.row(rows.first(r) + i);
        for (Eigen::Index c = 0; c + 2 < here.size(); c += 3)
            worst = std::max(worst, here.segment<3>(c).norm());
    }
    return worst;
}

int multiplicity_at(const KnotVector &knots, double parameter)
{
    for (const Knot &knot : knots.distinct())
        if (std::abs(knot.parameter - parameter) < 1e-9)
            return knot.multiplicity;
    return 0;
}

Eigen::Vector3d helix(double t) { return {30.0 * std::cos(t), 20.0 * std::sin(1.3 * t), 5.0 * t}; }
Eigen::Vector3d bump(double t) { return {40.0 * t, 8.0 / (1.0 + 25.0 * t * t), std::exp(-t)}; }

//! Smooth but with a corner at t = 1.
Eigen::Vector3d cornered(double t) { return {20.0 * t, 6.0 * std::abs(t - 1.0) * std::cos(t), std::sin(t)}; }

//! A cubic with one knot at t = 0.5, where its third derivative jumps.
Eigen::Vector3d two_cubics(double t)
{
    const double late = std::max(0.0, t - 0.5);
    return {t, 2.0 * t * t * t - t + 9.0 * late * late * late, 1.0 - t * t};
}

} // namespace

TEST(KnotChoice, KeepsTheToleranceBetweenTheSamples)
{
    for (const double tolerance : {1e-1, 1e-3, 1e-5, 1e-7})
    {
        SCOPED_TRACE(tolerance);
        const KnotProblem problem = problem_of({helix, bump}, -2.0, 5.0, tolerance);
        const auto choice = choose_knots(problem);
        ASSERT_TRUE(choice.has_value());
        EXPECT_LE(choice->error, tolerance);
        EXPECT_LE(independent_error(problem, choice->knots), between_samples * tolerance);
        EXPECT_GT(independent_error(problem, choice->knots), 1e-3 * tolerance) << "far more poles than needed";
        EXPECT_EQ(choice->knots.front(), -2.0);
        EXPECT_EQ(choice->knots.back(), 5.0);
    }
}

TEST(KnotChoice, TighterTolerancesCostMorePoles)
{
    int before = 0;
    for (const double tolerance : {1.0, 1e-2, 1e-4, 1e-6, 1e-8})
    {
        const auto choice = choose_knots(problem_of({helix, bump}, -2.0, 5.0, tolerance));
        ASSERT_TRUE(choice.has_value());
        EXPECT_GE(choice->knots.pole_count(), before);
        before = choice->knots.pole_count();
    }
    EXPECT_GT(before, 20);
}

TEST(KnotChoice, GoesOnFromWhatALooserToleranceHasLedTo)
{
    for (const double tolerance : {1e-2, 1e-4, 1e-6})
    {
        SCOPED_TRACE(tolerance);
        KnotProblem problem = problem_of({helix, bump}, -2.0, 5.0, tolerance);
        const auto looser = choose_knots(problem);
        ASSERT_TRUE(looser.has_value());
        problem.tolerance = 0.7 * tolerance;
        const auto afresh = choose_knots(problem);
        problem.start = &looser->knots;
        const auto further = choose_knots(problem);
        ASSERT_TRUE(afresh.has_value());
        ASSERT_TRUE(further.has_value());
        EXPECT_EQ(further->knots.degree, looser->knots.degree);
        EXPECT_LE(independent_error(problem, further->knots), between_samples * problem.tolerance);
        EXPECT_LE(further->knots.pole_count(), 1.2 * afresh->knots.pole_count());
    }
}

TEST(KnotChoice, FindsASplineOfFewKnotsAmongManyBreaks)
{
    KnotProblem problem = problem_of({two_cubics}, 0.0, 1.0, 1e-9);
    for (int i = 1; i < 32; ++i)
        problem.breaks.push_back({i / 32.0, i % 3});
    const auto choice = choose_knots(problem);
    ASSERT_TRUE(choice.has_value());
    EXPECT_EQ(choice->knots.degree, 3);
    EXPECT_EQ(choice->knots.pole_count(), 5) << "one cubic with one simple knot has five poles";
    EXPECT_EQ(multiplicity_at(choice->knots, 0.5), 1);
    EXPECT_LE(independent_error(problem, choice->knots), between_samples * 1e-9);
}

TEST(KnotChoice, NeedsNoKnotForAPolynomial)
{
    const Curve quintic = [](double t) { return Eigen::Vector3d(t, std::pow(t, 5) - t * t, 3.0 - std::pow(t, 4)); };
    KnotProblem problem = problem_of({quintic}, -1.0, 2.0, 1e-8);
    for (int i = 0; i < 9; ++i)
        problem.breaks.push_back({-0.7 + 0.3 * i, 1});
    const auto choice = choose_knots(problem);
    ASSERT_TRUE(choice.has_value());
    EXPECT_EQ(choice->knots.degree, 5);
    EXPECT_EQ(choice->knots.pole_count(), 6);
}

//! Of degree 5 and C3 at two places, with more of degree 5 than degree 4 can follow with as few poles.
TEST(KnotChoice, FindsOnePolynomialBetweenAnyTwoBreaks)
{
    const auto power = [](double x, int n) { return x > 0.0 ? std::pow(x, n) : 0.0; };
    const Curve pieces = [power](double t) {
        return Eigen::Vector3d(t + 3.0 * std::pow(t, 5),
                               40.0 * power(t - 1.0 / 3.0, 4) - 90.0 * power(t - 2.0 / 3.0, 5),
                               std::pow(t, 4) - 60.0 * power(t - 2.0 / 3.0, 4));
    };
    for (const double tolerance : {1e-4, 1e-6, 1e-8})
    {
        SCOPED_TRACE(tolerance);
        KnotProblem problem = problem_of({pieces}, 0.0, 1.0, tolerance);
        problem.breaks = {{1.0 / 3.0, 3}, {2.0 / 3.0, 3}};
        const auto choice = choose_knots(problem);
        ASSERT_TRUE(choice.has_value());
        EXPECT_LE(choice->knots.pole_count(), 10);
    }
}

TEST(KnotChoice, CarriesADeclaredCornerExactly)
{
    KnotProblem problem = problem_of({cornered}, 0.0, 3.0, 1e-6);
    problem.breaks = {{1.0, 0}};
    const auto choice = choose_knots(problem);
    ASSERT_TRUE(choice.has_value());
    EXPECT_EQ(multiplicity_at(choice->knots, 1.0), choice->knots.degree) << "a corner is a C0 knot";
    EXPECT_LE(independent_error(problem, choice->knots), between_samples * 1e-6);
    EXPECT_LT(choice->knots.pole_count(), 40);
}

TEST(KnotChoice, KeepsToTheDegreesThatAreAllowed)
{
    for (int low = 1; low <= 7; ++low)
        for (int high = low; high <= 7; high += 3)
        {
            KnotProblem problem = problem_of({helix}, 0.0, 4.0, 1e-4);
            problem.min_degree = low;
            problem.max_degree = high;
            const auto choice = choose_knots(problem);
            ASSERT_TRUE(choice.has_value()) << low << ".." << high;
            EXPECT_GE(choice->knots.degree, low);
            EXPECT_LE(choice->knots.degree, high);
            EXPECT_LE(independent_error(problem, choice->knots), between_samples * 1e-4);
        }
}

TEST(KnotChoice, AWiderChoiceOfDegreesNeverCostsPoles)
{
    int before = 1 << 20;
    for (const int high : {3, 4, 5, 6, 7})
    {
        KnotProblem problem = problem_of({helix, bump}, -2.0, 5.0, 1e-5);
        problem.max_degree = high;
        const auto choice = choose_knots(problem);
        ASSERT_TRUE(choice.has_value());
        EXPECT_LE(choice->knots.pole_count(), before);
        before = choice->knots.pole_count();
    }
}

TEST(KnotChoice, SaysWhenNoAdmissibleSplineReachesTheTolerance)
{
    KnotProblem few = problem_of({helix, bump}, -2.0, 5.0, 1e-9);
    few.max_poles = 12;
    EXPECT_FALSE(choose_knots(few).has_value());
    const Curve torn = [](double t) { return Eigen::Vector3d(t, t < 0.3 ? 0.0 : 1.0, 0.0); };
    EXPECT_FALSE(choose_knots(problem_of({torn}, 0.0, 1.0, 1e-3)).has_value()) << "a jump fits no continuous spline";
}

TEST(KnotChoice, ResultsDoNotDependOnTheScaleOfTheParameters)
{
    const KnotProblem unit = problem_of({helix}, 0.0, 4.0, 1e-5);
    const auto reference = choose_knots(unit);
    ASSERT_TRUE(reference.has_value());
    for (const double scale : {1e-6, 1e-3, 1e3, 1e6})
    {
        const Curve stretched = [scale](double t) { return helix(t / scale); };
        const auto choice = choose_knots(problem_of({stretched}, 0.0, 4.0 * scale, 1e-5));
        ASSERT_TRUE(choice.has_value()) << scale;
        EXPECT_EQ(choice->knots.pole_count(), reference->knots.pole_count()) << scale;
    }
}

TEST(ChebyshevParameters, IncreaseHoldTheEndsAndFillEveryInterval)
{
    const std::vector<double> parameters = chebyshev_parameters({-1.0, 0.5, 4.0}, 7);
    ASSERT_EQ(parameters.size(), 16u);
    EXPECT_EQ(parameters.front(), -1.0);
    EXPECT_EQ(parameters.back(), 4.0);
    EXPECT_TRUE(std::is_sorted(parameters.begin(), parameters.end()));
    EXPECT_EQ(std::adjacent_find(parameters.begin(), parameters.end()), parameters.end());
    EXPECT_EQ(std::count_if(parameters.begin(), parameters.end(), [](double t) { return t > -1.0 && t < 0.5; }), 7);
}
