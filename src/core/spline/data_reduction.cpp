// SPDX-License-Identifier: LGPL-2.1-or-later
#include "data_reduction.h"

#include "knot_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

// Both directions add up: see the tensor fit of an offset, whose error splits alike.
constexpr double first_direction_share = 0.45;
constexpr int most_rounds = 3;
// A pole of the change is a sum of (degree + 1)^2 products of insertion weights, each a product of some 10 factors.
constexpr double change_operations = 400.0;
// Part of the spans that has to go, else the reduction is not worth its error.
constexpr double worthwhile = 0.6;

//! The poles as points relative to the first one: one row for each u pole, the points of all v poles in it.
RowMatrix pole_rows(const TensorSpline &spline, const Eigen::Vector3d &origin)
{
    const int nu = spline.u.pole_count();
    const int nv = spline.v.pole_count();
    RowMatrix rows(nu, 3 * nv);
    for (int i = 0; i < nu; ++i)
        for (int j = 0; j < nv; ++j)
            rows.row(i).segment<3>(3 * j) = (spline.pole(i, j).head<3>() - origin).transpose();
    return rows;
}

std::optional<KnotVector> fewer_knots(const KnotVector &fine, const RowMatrix &poles, double tolerance)
{
    KnotProblem problem;
    problem.low = fine.front();
    problem.high = fine.back();
    for (const Knot &knot : fine.distinct())
        if (knot.parameter > fine.front() && knot.parameter < fine.back())
            problem.breaks.push_back({knot.parameter, std::max(0, fine.degree - knot.multiplicity)});
    problem.sample = [&](const std::vector<double> &) { return poles; };
    problem.tolerance = tolerance;
    problem.min_degree = problem.max_degree = fine.degree;
    problem.max_poles = fine.pole_count();
    problem.fine = &fine;
    const std::optional<KnotChoice> choice = choose_knots(problem);
    return choice ? std::optional(choice->knots) : std::nullopt;
}

bool worth_it(const TensorSpline &spline, const KnotVector &u, const KnotVector &v)
{
    const auto spans = [](const KnotVector &a, const KnotVector &b) {
        return static_cast<double>((a.breaks().size() - 1) * (b.breaks().size() - 1));
    };
    return spans(u, v) <= worthwhile * spans(spline.u, spline.v);
}

class Reduction
{
public:
    explicit Reduction(const TensorSpline &spline)
        : m_spline(spline), m_origin(spline.poles.front().head<3>()), m_by_u(pole_rows(spline, m_origin)),
          m_by_v(transposed_points(m_by_u))
    {
    }

    std::optional<ReducedSpline> run(double tolerance)
    {
        double share = first_direction_share;
        for (int round = 0; round < most_rounds; ++round)
        {
            const auto u = fewer_knots(m_spline.u, m_by_u, share * tolerance);
            const auto v = fewer_knots(m_spline.v, m_by_v, share * tolerance);
            if (!u || !v || !worth_it(m_spline, *u, *v))
                return std::nullopt;
            std::optional<ReducedSpline> result = over(*u, *v);
            if (!result || result->largest <= tolerance)
                return result;
            share *= std::clamp(0.8 * tolerance / result->largest, 0.1, 0.8);
        }
        return std::nullopt;
    }

private:
    std::optional<ReducedSpline> over(const KnotVector &u, const KnotVector &v)
    {
        const auto fit_u = LeastSquaresFit::make_reduction(u, m_spline.u);
        const auto fit_v = LeastSquaresFit::make_reduction(v, m_spline.v);
        if (!fit_u || !fit_v)
            return std::nullopt;
        const RowMatrix net = fit_v->solve(transposed_points(fit_u->solve(m_by_u)));
        const RowMatrix inserted = -fit_v->residual(net, RowMatrix::Zero(m_by_v.rows(), net.cols()));
        const RowMatrix change = fit_u->residual(transposed_points(inserted), m_by_u);
        ReducedSpline result;
        result.spline.u = u;
        result.spline.v = v;
        const RowMatrix poles = transposed_points(net);
        for (Eigen::Index i = 0; i < poles.rows(); ++i)
            for (Eigen::Index j = 0; j + 2 < poles.cols(); j += 3)
                result.spline.poles.emplace_back(
                    (Eigen::Vector4d() << poles.row(i).segment<3>(j).transpose() + m_origin, 1.0).finished());
        result.rounding = change_operations * std::numeric_limits<double>::epsilon() *
                          (m_by_u.cwiseAbs().maxCoeff() + m_origin.cwiseAbs().maxCoeff());
        for (Eigen::Index i = 0; i < change.rows(); ++i)
            for (Eigen::Index j = 0; j + 2 < change.cols(); j += 3)
            {
                result.change.emplace_back(change.row(i).segment<3>(j).transpose());
                result.largest = std::max(result.largest, result.change.back().norm());
            }
        result.largest += std::sqrt(3.0) * result.rounding;
        return result;
    }

    const TensorSpline &m_spline;
    Eigen::Vector3d m_origin;
    RowMatrix m_by_u;
    RowMatrix m_by_v;
};

} // namespace

std::optional<ReducedSpline> reduced(const TensorSpline &spline, double tolerance)
{
    if (spline.rational)
        return std::nullopt;
    return Reduction(spline).run(tolerance);
}

} // namespace laminate_offset
