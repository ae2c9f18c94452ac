// SPDX-License-Identifier: LGPL-2.1-or-later
#include "knot_removal.h"

#include "../spline/knot_choice.h"

#include <algorithm>

namespace laminate_offset
{

CurvePoles without_needless_knots(const CurvePoles &curve, double tolerance)
{
    const KnotVector &fine = curve.knots;
    KnotProblem problem;
    problem.low = fine.front();
    problem.high = fine.back();
    for (const Knot &knot : fine.distinct())
        if (knot.parameter > fine.front() && knot.parameter < fine.back())
            problem.breaks.push_back({knot.parameter, std::max(0, fine.degree - knot.multiplicity)});
    problem.sample = [&](const std::vector<double> &) { return curve.poles; };
    problem.tolerance = tolerance;
    problem.min_degree = problem.max_degree = fine.degree;
    problem.max_poles = fine.pole_count();
    problem.fine = &fine;
    const std::optional<KnotChoice> choice = problem.breaks.empty() ? std::nullopt : choose_knots(problem);
    if (!choice || choice->knots.pole_count() >= fine.pole_count())
        return curve;
    const auto fit = LeastSquaresFit::make_reduction(choice->knots, fine);
    return fit ? CurvePoles{choice->knots, fit->solve(curve.poles)} : curve;
}

} // namespace laminate_offset
