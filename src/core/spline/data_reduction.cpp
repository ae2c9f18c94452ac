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
// So many curves of the net choose the knots at first. What the choice does to all is found out afterwards.
constexpr Eigen::Index enough_curves = 24;

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

std::optional<KnotVector> fewer_knots(const KnotVector &fine, const RowMatrix &poles, double tolerance,
                                      const KnotVector *start)
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
    problem.start = start;
    const std::optional<KnotChoice> choice = choose_knots(problem);
    return choice ? std::optional(choice->knots) : std::nullopt;
}

bool worth_it(const TensorSpline &spline, const KnotVector &u, const KnotVector &v, double worthwhile)
{
    const auto spans = [](const KnotVector &a, const KnotVector &b) {
        return static_cast<double>((a.breaks().size() - 1) * (b.breaks().size() - 1));
    };
    return spans(u, v) <= worthwhile * spans(spline.u, spline.v);
}

//! Some of the columns of points, the first and the last among them.
RowMatrix some_curves(const RowMatrix &points, Eigen::Index count)
{
    const Eigen::Index all = points.cols() / 3;
    RowMatrix result(points.rows(), 3 * count);
    for (Eigen::Index k = 0; k < count; ++k)
        result.middleCols<3>(3 * k) = points.middleCols<3>(3 * (k * (all - 1) / (count - 1)));
    return result;
}

} // namespace

DataReduction::DataReduction(const TensorSpline &spline, double worthwhile) : m_spline(spline), m_worthwhile(worthwhile)
{
    if (spline.rational)
        return;
    m_origin = spline.poles.front().head<3>();
    m_by_u = pole_rows(spline, m_origin);
    m_by_v = transposed_points(m_by_u);
    m_rounding = change_operations * std::numeric_limits<double>::epsilon() *
                 (m_by_u.cwiseAbs().maxCoeff() + m_origin.cwiseAbs().maxCoeff());
}

std::optional<ReducedSpline> DataReduction::within(double tolerance, const ReducedSpline *looser) const
{
    if (m_spline.rational)
        return std::nullopt;
    double share = first_direction_share;
    for (int round = 0; round < most_rounds; ++round)
    {
        const bool all = m_by_u.rows() <= enough_curves && m_by_v.rows() <= enough_curves;
        std::optional<ReducedSpline> result = attempt(share * tolerance, all, looser);
        if (!all && result && result->largest > tolerance)
            result = attempt(share * tolerance, true, looser);
        if (!result || result->largest <= tolerance)
            return result; // what is not worth it for some curves is not worth it for all
        share *= std::clamp(0.8 * tolerance / result->largest, 0.1, 0.8);
    }
    return std::nullopt;
}

std::optional<ReducedSpline> DataReduction::attempt(double tolerance, bool all_curves,
                                                    const ReducedSpline *looser) const
{
    const auto knots = [&](const KnotVector &fine, const RowMatrix &points, const KnotVector *start) {
        const bool all = all_curves || points.cols() <= 3 * enough_curves;
        return fewer_knots(fine, all ? points : some_curves(points, enough_curves), tolerance, start);
    };
    const auto u = knots(m_spline.u, m_by_u, looser ? &looser->spline.u : nullptr);
    const auto v = u ? knots(m_spline.v, m_by_v, looser ? &looser->spline.v : nullptr) : std::nullopt;
    if (!u || !v || !worth_it(m_spline, *u, *v, m_worthwhile))
        return std::nullopt;
    return over(*u, *v);
}

std::optional<ReducedSpline> DataReduction::over(const KnotVector &u, const KnotVector &v) const
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
    result.rounding = m_rounding;
    result.change.reserve(m_spline.poles.size());
    double square = 0.0;
    for (Eigen::Index i = 0; i < change.rows(); ++i)
        for (Eigen::Index j = 0; j + 2 < change.cols(); j += 3)
        {
            result.change.emplace_back(change.row(i).segment<3>(j).transpose());
            square = std::max(square, result.change.back().squaredNorm());
        }
    result.largest = std::sqrt(square) + std::sqrt(3.0) * m_rounding;
    return result;
}

std::optional<ReducedSpline> reduced(const TensorSpline &spline, double tolerance, double worthwhile)
{
    return DataReduction(spline, worthwhile).within(tolerance);
}

} // namespace laminate_offset
