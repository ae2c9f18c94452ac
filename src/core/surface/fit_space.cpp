// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fit_space.h"

#include "../spline/knot_choice.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace laminate_offset
{
namespace
{

constexpr int least_rows = 12;
// A direction with far fewer breaks than the other costs little and, with few poles, errs between rows: it looks at more
// of them. An even number would pass over the middle of every interval.
constexpr int rows_for_few_breaks = 3;
constexpr std::size_t far_fewer = 4; // so many times
constexpr int fewest_poles = 2;      // of a direction
// Weights that differ by no more than this relatively are one constant.
constexpr double same_weight = 1e-14;

std::vector<double> row_parameters(const std::vector<double> &ends, int per_interval)
{
    const int intervals = static_cast<int>(ends.size()) - 1;
    return chebyshev_parameters(ends, std::max(per_interval, (least_rows + intervals - 1) / intervals));
}

//! The offset of a C^k surface is C^(k-1) at its knots; a crease has been refused before, so at least C^0.
std::vector<DataBreak> data_breaks(const std::vector<SmoothnessBreak> &breaks)
{
    std::vector<DataBreak> result;
    for (const SmoothnessBreak &b : breaks)
        result.push_back({b.parameter, std::max(0, b.continuity - 1)});
    return result;
}

//! Do the weights vary along u (or along v)?
bool weights_vary(const TensorSpline &spline, bool along_u)
{
    for (int i = 0; i < spline.u.pole_count(); ++i)
        for (int j = 0; j < spline.v.pole_count(); ++j)
        {
            const double first = (along_u ? spline.pole(0, j) : spline.pole(i, 0)).w();
            if (std::abs(spline.pole(i, j).w() - first) > same_weight * first)
                return true;
        }
    return false;
}

//! The space has to hold the weight function.
void require(const KnotVector &kv, KnotProblem &problem)
{
    problem.required_degree = kv.degree;
    for (const Knot &knot : kv.distinct())
        if (knot.parameter > kv.front() && knot.parameter < kv.back())
            problem.required.push_back(knot);
}

//! Numerators may be off by the tolerance times the weight below them.
void fit_over_weight(const TensorSpline &base, KnotProblem &along_u, KnotProblem &along_v)
{
    double smallest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector4d &pole : base.poles)
        smallest = std::min(smallest, pole.w());
    along_u.tolerance *= smallest;
    along_v.tolerance *= smallest;
    if (weights_vary(base, true))
        require(base.u, along_u);
    if (weights_vary(base, false))
        require(base.v, along_v);
}

using Choices = std::pair<std::optional<KnotChoice>, std::optional<KnotChoice>>;

//! Both directions at once: they share nothing but the base.
Choices choose_both(const KnotProblem &along_u, const KnotProblem &along_v)
{
    Choices choices;
    tbb::parallel_invoke([&] { choices.first = choose_knots(along_u); },
                         [&] { choices.second = choose_knots(along_v); });
    return choices;
}

//! The direction with fewer breaks first: what it takes limits the other one, which costs more.
Choices choose_both(KnotProblem along_u, KnotProblem along_v, int most_poles)
{
    Choices choices;
    const bool u_first = along_u.breaks.size() <= along_v.breaks.size();
    KnotProblem &problem = u_first ? along_u : along_v;
    KnotProblem &other = u_first ? along_v : along_u;
    problem.max_poles = std::min(problem.max_poles, most_poles / fewest_poles);
    std::optional<KnotChoice> first = choose_knots(problem);
    if (!first)
        return choices;
    other.max_poles = std::min(other.max_poles, most_poles / first->knots.pole_count());
    std::optional<KnotChoice> second = choose_knots(other);
    return u_first ? Choices{std::move(first), std::move(second)} : Choices{std::move(second), std::move(first)};
}

} // namespace

std::optional<FitSpace> choose_space(OffsetSampler &sampler, double tolerance, const OffsetOptions &options,
                                     int most_poles, const FitSpace *start)
{
    const BaseSurface &base = sampler.base();
    const ParameterBox &box = base.box();
    const std::size_t intervals_u = base.interval_ends_u().size() - 1;
    const std::size_t intervals_v = base.interval_ends_v().size() - 1;
    const bool few_u = far_fewer * intervals_u <= intervals_v;
    const bool few_v = far_fewer * intervals_v <= intervals_u;
    const std::vector<double> rows_u = row_parameters(base.interval_ends_u(), few_v ? rows_for_few_breaks : 1);
    const std::vector<double> rows_v = row_parameters(base.interval_ends_v(), few_u ? rows_for_few_breaks : 1);
    KnotProblem along_u;
    along_u.tolerance = tolerance;
    along_u.max_degree = options.max_degree;
    KnotProblem along_v = along_u;
    along_u.low = box.umin;
    along_u.high = box.umax;
    along_u.breaks = data_breaks(base.breaks_u());
    along_u.sample = [&](const std::vector<double> &us) { return sampler.joined_rows(us, rows_v, false); };
    along_v.low = box.vmin;
    along_v.high = box.vmax;
    along_v.breaks = data_breaks(base.breaks_v());
    along_v.sample = [&](const std::vector<double> &vs) { return sampler.joined_rows(rows_u, vs, true); };
    along_u.start = start ? &start->u : nullptr;
    along_v.start = start ? &start->v : nullptr;
    along_u.two_at_once = few_v; // the other direction leaves a thread free
    along_v.two_at_once = few_u;
    if (sampler.denominator() == Denominator::BaseWeight)
        fit_over_weight(*base.spline(), along_u, along_v);
    const auto [u, v] = most_poles < std::numeric_limits<int>::max() ? choose_both(along_u, along_v, most_poles)
                                                                     : choose_both(along_u, along_v);
    if (!u || !v || sampler.singular())
        return std::nullopt;
    return FitSpace{u->knots, v->knots};
}

} // namespace laminate_offset
