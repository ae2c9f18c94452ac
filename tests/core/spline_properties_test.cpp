// SPDX-License-Identifier: LGPL-2.1-or-later
// Properties of spline spaces for any knots and data; RapidCheck prints its seed and shrinks what fails.
#include <laminate_offset/spline/knot_choice.h>
#include <laminate_offset/spline/least_squares.h>

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace laminate_offset;

namespace
{

//! Any degree from 1 to 9 and any interior knots on a grid, repeated up to the degree.
KnotVector any_knots()
{
    const int degree = *rc::gen::inRange(1, 10);
    const auto places = *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 64));
    std::vector<double> interior;
    for (const int place : places)
        interior.push_back(place / 64.0);
    std::sort(interior.begin(), interior.end());
    const auto too_often = [&](std::size_t i) {
        return i >= static_cast<std::size_t>(degree) && interior[i] == interior[i - static_cast<std::size_t>(degree)];
    };
    for (std::size_t i = interior.size(); i-- > 0;)
        if (too_often(i))
            interior.erase(interior.begin() + static_cast<std::ptrdiff_t>(i));
    const double low = *rc::gen::inRange(-1000, 1000) / 10.0;
    const double width = *rc::gen::inRange(1, 1000) / 10.0;
    for (double &t : interior)
        t = low + width * t;
    return clamped_knots(degree, low, low + width, interior);
}

double any_parameter(const KnotVector &kv)
{
    return kv.front() + (kv.back() - kv.front()) * (*rc::gen::inRange(0, 10001) / 10000.0);
}

RowMatrix any_poles(const KnotVector &kv)
{
    RowMatrix poles(kv.pole_count(), 3);
    for (Eigen::Index i = 0; i < poles.rows(); ++i)
        for (Eigen::Index c = 0; c < 3; ++c)
            poles(i, c) = *rc::gen::inRange(-10000, 10000) / 100.0;
    return poles;
}

RowMatrix values(const KnotVector &kv, const RowMatrix &poles, const std::vector<double> &parameters)
{
    const BasisRows rows(kv, parameters);
    RowMatrix result = RowMatrix::Zero(rows.rows(), poles.cols());
    for (int r = 0; r < rows.rows(); ++r)
        for (int i = 0; i < rows.width(); ++i)
            result.row(r) += rows.row(r)[i] * poles.row(rows.first(r) + i);
    return result;
}

} // namespace

RC_GTEST_PROP(SplineProperties, PolesAtTheGrevillePointsGiveTheParameterItself, ())
{
    const KnotVector kv = any_knots();
    RowMatrix poles(kv.pole_count(), 3);
    for (int i = 0; i < kv.pole_count(); ++i)
    {
        double sum = 0.0;
        for (int k = 1; k <= kv.degree; ++k)
            sum += kv.knots[static_cast<std::size_t>(i + k)];
        poles.row(i).setConstant(sum / kv.degree);
    }
    const double u = any_parameter(kv);
    RC_ASSERT(std::abs(values(kv, poles, {u})(0, 0) - u) <= 1e-12 * (std::abs(kv.front()) + kv.back() - kv.front()));
}

RC_GTEST_PROP(SplineProperties, ASplineStaysInTheBoxOfThePolesOfItsSpan, ())
{
    const KnotVector kv = any_knots();
    const RowMatrix poles = any_poles(kv);
    const double u = any_parameter(kv);
    const RowMatrix point = values(kv, poles, {u});
    const auto local = poles.middleRows(kv.span(u) - kv.degree, kv.degree + 1);
    for (Eigen::Index c = 0; c < 3; ++c)
    {
        RC_ASSERT(point(0, c) <= local.col(c).maxCoeff() + 1e-11);
        RC_ASSERT(point(0, c) >= local.col(c).minCoeff() - 1e-11);
    }
}

RC_GTEST_PROP(SplineProperties, LeastSquaresReproducesEverySplineOfItsSpace, ())
{
    const KnotVector kv = any_knots();
    const RowMatrix poles = any_poles(kv);
    const std::vector<double> parameters = chebyshev_parameters(kv.breaks(), kv.degree + 3);
    const auto fit = LeastSquaresFit::make(kv, parameters);
    RC_ASSERT(fit.has_value());
    const RowMatrix samples = values(kv, poles, parameters);
    RC_ASSERT(fit->residual(fit->solve(samples), samples).cwiseAbs().maxCoeff() <= 1e-9);
}

RC_GTEST_PROP(SplineProperties, ChosenKnotsFitEveryCubicSplineWithNoMorePolesThanItHas, ())
{
    const auto places = *rc::gen::unique<std::vector<int>>(rc::gen::inRange(1, 12));
    std::vector<double> interior;
    for (const int place : places)
        interior.push_back(place / 12.0);
    std::sort(interior.begin(), interior.end());
    const KnotVector kv = clamped_knots(3, 0.0, 1.0, interior);
    const RowMatrix poles = any_poles(kv);
    KnotProblem problem;
    problem.tolerance = 1e-6;
    problem.max_degree = 3;
    for (const double t : interior)
        problem.breaks.push_back({t, 2});
    problem.sample = [&](const std::vector<double> &parameters) { return values(kv, poles, parameters); };
    const auto choice = choose_knots(problem);
    RC_ASSERT(choice.has_value());
    RC_ASSERT(choice->knots.pole_count() <= kv.pole_count());
    RC_ASSERT(choice->error <= problem.tolerance);
}
