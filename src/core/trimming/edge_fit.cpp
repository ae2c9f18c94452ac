// SPDX-License-Identifier: LGPL-2.1-or-later
#include "edge_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace laminate_offset
{
namespace
{

constexpr int lowest_degree = 3;
constexpr int highest_degree = 5;
constexpr int first_spans = 8;
constexpr int most_poles = 400;
constexpr int most_fits = 9;
// Samples beyond the degree in every span, and at least in every interval between breaks.
constexpr int spare_samples = 3;
constexpr int samples_per_interval = 2;
// Of a curve with breaks, samples that serve many fits: their evaluation costs more than a fit.
constexpr int common_samples_per_interval = 3;
// Counts move by the error's law and a little more, or by this factor at most; below the last one they are not worth
// another fit.
constexpr double cautious = 1.02;
constexpr double fastest_growth = 3.0;
constexpr double least_gain = 0.95;
// A search among counts that another degree needs is given up at errors above this many tolerances.
constexpr double hopeful = 4.0;
// A curve whose error does not fall by this order at least is not smooth enough.
constexpr double least_order = 3.0;
// No part of the range gets knots more thinly than this part of the average.
constexpr double least_density = 0.1;

//! Counts of spans that are known to be too few and to be enough, with the errors there in tolerances.
struct SpanBracket
{
    int degree = 0;
    int too_few = 0;
    int enough = 0; //!< 0: not known yet
    double excess_of_few = 0.0;
    double excess_of_enough = 0.0;

    void add(int spans, double excess)
    {
        (excess <= 1.0 ? enough : too_few) = spans;
        (excess <= 1.0 ? excess_of_enough : excess_of_few) = excess;
        if (enough > 0 && order() > 2.0 * (degree + 1)) // knots were badly placed when the lower count failed
            too_few = 0;
    }

    //! The count to try after this one: by the law of the error, and between two counts by the law that they show.
    [[nodiscard]] int next(int spans, double excess) const
    {
        const double wanted = std::ceil(cautious * std::pow(excess, 1.0 / (degree + 1)) * spans);
        if (enough == 0)
            return static_cast<int>(std::clamp(wanted, spans + 1.0, fastest_growth * spans));
        if (excess <= 1.0)
            return std::max(static_cast<int>(wanted), too_few + 1);
        const double between = std::ceil(cautious * std::pow(excess, 1.0 / std::max(order(), 1.0)) * spans);
        return static_cast<int>(std::min(between, 0.5 * (too_few + enough + 1)));
    }

private:
    //! The power of the count that the error falls by from one to the other; 0 where only one is known.
    [[nodiscard]] double order() const
    {
        return too_few == 0 || enough == 0
                   ? 0.0
                   : std::log(excess_of_few / excess_of_enough) / std::log(static_cast<double>(enough) / too_few);
    }
};

//! The fit over some knots, with the distance at every sample.
struct Sampled
{
    CurveFit fit;
    Eigen::VectorXd off;
};

//! Samples of a curve at some parameters.
struct Samples
{
    std::vector<double> parameters;
    RowMatrix points;

    //! Does every span of the knots hold enough of them?
    [[nodiscard]] bool serve(const KnotVector &knots) const
    {
        const std::vector<double> ends = knots.breaks();
        auto from = parameters.begin();
        for (std::size_t i = 1; i < ends.size(); ++i)
        {
            const auto to = std::lower_bound(from, parameters.end(), ends[i]);
            if (to - from < knots.degree + 1 + spare_samples)
                return false;
            from = to;
        }
        return !parameters.empty();
    }
};

std::optional<Sampled> fit_over(const Samples &samples, KnotVector knots)
{
    const auto solver = LeastSquaresFit::make(knots, samples.parameters);
    if (!solver)
        return std::nullopt;
    Sampled result;
    result.fit.knots = std::move(knots);
    result.fit.poles = solver->solve(samples.points);
    result.off = solver->residual(result.fit.poles, samples.points).rowwise().norm();
    result.fit.error = result.off.maxCoeff();
    return result;
}

//! Samples dense in the spans of the knots and between breaks.
Samples dense_samples(const SmoothCurve &curve, const KnotVector &knots)
{
    Samples samples;
    samples.parameters = span_parameters(knots, curve.breaks, knots.degree + 1 + spare_samples, samples_per_interval);
    samples.points = curve.sample(samples.parameters);
    return samples;
}

class SmoothFitter
{
public:
    SmoothFitter(const SmoothCurve &curve, double tolerance) : m_curve(curve), m_tolerance(tolerance)
    {
        if (curve.breaks.size() <= 2)
            return;
        m_samples.parameters = chebyshev_parameters(curve.breaks, common_samples_per_interval);
        m_samples.points = curve.sample(m_samples.parameters);
    }

    std::optional<CurveFit> run()
    {
        for (int degree = lowest_degree; degree <= highest_degree; ++degree)
            if (auto plain = fit(degree, {}); plain && plain->error <= m_tolerance)
                return plain;
        std::optional<CurveFit> best = spread(highest_degree, most_poles, nullptr);
        for (int degree = highest_degree - 1; best && degree >= lowest_degree; --degree)
        {
            std::optional<CurveFit> lower = spread(degree, best->knots.pole_count(), &*best);
            if (!lower)
                break; // a still lower degree would need more poles again
            best = std::move(lower);
        }
        return best;
    }

private:
    [[nodiscard]] std::optional<CurveFit> fit(int degree, const std::vector<double> &interior)
    {
        const KnotVector knots = clamped_knots(degree, m_curve.breaks.front(), m_curve.breaks.back(), interior);
        if (!m_samples.serve(knots))
            m_samples = dense_samples(m_curve, knots);
        std::optional<Sampled> made = fit_over(m_samples, knots);
        return made ? std::optional<CurveFit>(std::move(made->fit)) : std::nullopt;
    }

    //! Fits with more or fewer knots, each time better placed, until the count fits the tolerance.
    //! \param bar as many poles are too many.
    //! \param guide a fit of another degree: its knots tell where many are needed, and the search begins right below the bar.
    [[nodiscard]] std::optional<CurveFit> spread(int p, int bar, const CurveFit *guide)
    {
        std::optional<CurveFit> best;
        const int most = bar - 1 - p;
        int spans = guide ? most : first_spans;
        SpanBracket bracket{p};
        double admissible = guide ? hopeful * m_tolerance : std::numeric_limits<double>::infinity();
        std::vector<double> density(1, 1.0);
        std::vector<double> breaks{m_curve.breaks.front(), m_curve.breaks.back()};
        if (guide)
        {
            density = knot_density(*guide);
            breaks = guide->knots.breaks();
        }
        for (int i = 0; i < most_fits && spans >= 1 && spans <= most; ++i)
        {
            std::optional<CurveFit> trial = fit(p, even_knots(breaks, density, spans));
            if (!trial)
                return best;
            const double excess = trial->error / m_tolerance;
            density = knot_density(*trial);
            breaks = trial->knots.breaks();
            bracket.add(spans, excess);
            if (excess > 1.0 && trial->error > admissible && !best)
                return best;
            const int next = bracket.next(spans, excess);
            if (excess <= 1.0)
                best = std::move(trial);
            else if (i > 0 || guide)
                admissible = trial->error * std::pow(static_cast<double>(spans) / next, least_order);
            if (best && next > least_gain * bracket.enough)
                return best;
            spans = next;
        }
        return best;
    }

    //! |f^(p+1)|^(1/(p+1)) in every span, up to a factor.
    [[nodiscard]] static std::vector<double> knot_density(const CurveFit &fit)
    {
        const int p = fit.knots.degree;
        const std::vector<double> &t = fit.knots.knots;
        RowMatrix derivative = fit.poles;
        for (int r = 1; r <= p; ++r)
            for (int i = 0; i + r < fit.poles.rows(); ++i)
            {
                const auto k = static_cast<std::size_t>(i);
                const double width = t[k + static_cast<std::size_t>(p) + 1] - t[k + static_cast<std::size_t>(r)];
                derivative.row(i) = ((p - r + 1) / width * (derivative.row(i + 1) - derivative.row(i))).eval();
            }
        const std::vector<double> x = fit.knots.breaks();
        std::vector<double> density(x.size() - 1, 0.0);
        for (std::size_t j = 1; j + 1 < x.size(); ++j)
        {
            const auto row = static_cast<Eigen::Index>(j);
            const double jump = (derivative.row(row) - derivative.row(row - 1)).norm() / (x[j + 1] - x[j - 1]);
            density[j - 1] += jump;
            density[j] += jump;
        }
        double total = 0.0;
        for (std::size_t j = 0; j < density.size(); ++j)
        {
            density[j] = std::pow(density[j], 1.0 / (p + 1));
            total += density[j] * (x[j + 1] - x[j]);
        }
        const double least = least_density * total / (x.back() - x.front());
        for (double &d : density)
            d = total > 0.0 ? std::max(d, least) : 1.0;
        return density;
    }

    //! Interior knots between which the density's integral is the same everywhere.
    [[nodiscard]] static std::vector<double> even_knots(const std::vector<double> &breaks,
                                                        const std::vector<double> &density, int spans)
    {
        double total = 0.0;
        for (std::size_t j = 0; j < density.size(); ++j)
            total += density[j] * (breaks[j + 1] - breaks[j]);
        std::vector<double> knots;
        std::size_t j = 0;
        double before = 0.0;
        for (int k = 1; k < spans; ++k)
        {
            const double wanted = total * k / spans;
            while (j + 1 < density.size() && before + density[j] * (breaks[j + 1] - breaks[j]) < wanted)
            {
                before += density[j] * (breaks[j + 1] - breaks[j]);
                ++j;
            }
            knots.push_back(breaks[j] + (wanted - before) / density[j]);
        }
        return knots;
    }

    const SmoothCurve &m_curve;
    double m_tolerance;
    Samples m_samples; //!< of the last fit that needed more of them
};

constexpr int most_joined_poles = 2000;
constexpr double fastest_split = 4.0;

//! The degree at which the smoothest joins are simple knots: where all are smooth, a higher one would bring poles only.
int joined_degree(const std::vector<DataBreak> &joins)
{
    int degree = lowest_degree;
    bool rough = false;
    for (const DataBreak &join : joins)
    {
        degree = std::max(degree, join.continuity + 1);
        rough = rough || join.continuity < lowest_degree - 1;
    }
    return rough ? highest_degree : std::min(degree, highest_degree);
}

//! The space with so many even spans in each interval between joins.
KnotVector joined_knots(int degree, const std::vector<double> &ends, const std::vector<DataBreak> &joins,
                        const std::vector<int> &spans)
{
    std::vector<double> interior;
    for (std::size_t i = 0; i < spans.size(); ++i)
    {
        for (int k = 1; k < spans[i]; ++k)
            interior.push_back(ends[i] + (ends[i + 1] - ends[i]) * k / spans[i]);
        if (i < joins.size())
            interior.insert(interior.end(), static_cast<std::size_t>(std::max(0, degree - joins[i].continuity)),
                            joins[i].parameter);
    }
    return clamped_knots(degree, ends.front(), ends.back(), interior);
}

//! Gives every interval that misses the tolerance more spans, by the law of its error. False where none does.
bool split_further(const std::vector<double> &errors, double tolerance, int degree, std::vector<int> &spans)
{
    bool split = false;
    for (std::size_t i = 0; i < spans.size(); ++i)
    {
        if (errors[i] <= tolerance)
            continue;
        const double law = std::pow(errors[i] / tolerance, 1.0 / (degree + 1));
        const double wanted = std::min(cautious * law, fastest_split) * spans[i];
        spans[i] = std::max(spans[i] + 1, static_cast<int>(std::ceil(wanted)));
        split = true;
    }
    return split;
}

} // namespace

std::optional<CurveFit> smooth_fit(const SmoothCurve &curve, double tolerance)
{
    return SmoothFitter(curve, tolerance).run();
}

std::optional<CurveFit> joined_fit(const SmoothCurve &curve, const std::vector<DataBreak> &joins, double tolerance)
{
    std::vector<double> ends{curve.breaks.front()};
    for (const DataBreak &join : joins)
        ends.push_back(join.parameter);
    ends.push_back(curve.breaks.back());
    const int degree = joined_degree(joins);
    std::vector<int> spans(ends.size() - 1, 1);
    for (int i = 0; i < most_fits; ++i)
    {
        KnotVector knots = joined_knots(degree, ends, joins, spans);
        if (knots.pole_count() > most_joined_poles)
            return std::nullopt;
        const Samples samples = dense_samples(curve, knots);
        std::optional<Sampled> made = fit_over(samples, std::move(knots));
        if (!made)
            return std::nullopt;
        std::vector<double> errors(spans.size(), 0.0);
        std::size_t interval = 0;
        for (std::size_t k = 0; k < samples.parameters.size(); ++k)
        {
            while (interval + 1 < errors.size() && samples.parameters[k] > ends[interval + 1])
                ++interval;
            errors[interval] = std::max(errors[interval], made->off[static_cast<Eigen::Index>(k)]);
        }
        if (!split_further(errors, tolerance, degree, spans))
            return std::move(made->fit);
    }
    return std::nullopt;
}

} // namespace laminate_offset
