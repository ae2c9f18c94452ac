// SPDX-License-Identifier: LGPL-2.1-or-later
#include "knot_choice.h"

#include "row_compression.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace laminate_offset
{
namespace
{

// Samples of an interval between breaks at first.
constexpr int least_per_interval = 3;
constexpr int least_samples = 60;
// Samples that a span of the knots gets, when it needs some, beyond the poles that its own knots bring.
constexpr int spare_samples = 2;
// Part of the tolerance that the compression of the rows may use up.
constexpr double compression_share = 0.02;
// Spans are not halved below this part of the whole range.
constexpr double smallest_span = 1e-5;
// So many of the lowest-ranked knots are tried one by one before the rest is believed to be needed. What has failed is
// not tried again: a space with fewer knots elsewhere is part of the one that failed.
constexpr int last_tries = 4;
// The middle degrees win most often, and what they reach cuts the others short.
constexpr int degree_order[] = {4, 5, 3, 6, 7, 2, 1};
// Where the first degree needs more poles than this between breaks, the data is smooth and a higher degree will do with
// far fewer: that one goes first.
constexpr int most_first_poles = 64;
constexpr int smooth_degree = 6;
// A refined fit is thinned out only if that may beat the best count so far: if thinning leaves it this part of what it
// left the luckiest degree before. Polylines and parabolas, which refine without end where they do not fit at once,
// have to win as they are. Small fits cost too little to be judged.
constexpr double luckier = 0.75;
constexpr double least_part_left = 0.5;
constexpr int small_fit = 40;
constexpr int lowest_thinned_degree = 3;
// The error of n poles falls like n^-(degree + 1) on smooth data, and faster where knots go where they are needed:
// a search is left when even this part of the poles so predicted is too many.
constexpr double prediction_share = 0.25;

void add_chebyshev(double a, double b, int count, std::vector<double> &parameters)
{
    for (int k = 0; k < count; ++k)
        parameters.push_back(a + (b - a) * (0.5 * (1.0 - std::cos(M_PI * (k + 0.5) / count))));
}

//! What a knot at a break needs for splines of a degree to be no smoother there than the data.
int full_multiplicity(const DataBreak &b, int degree) { return std::clamp(degree - b.continuity, 0, degree); }

class SampledData
{
public:
    explicit SampledData(const KnotProblem &problem) : m_problem(&problem)
    {
        if (problem.fine)
        {
            take(problem.fine->pole_parameters());
            return;
        }
        std::vector<double> breaks{problem.low};
        for (const DataBreak &b : problem.breaks)
            breaks.push_back(b.parameter);
        breaks.push_back(problem.high);
        const int intervals = static_cast<int>(breaks.size()) - 1;
        take(chebyshev_parameters(breaks, std::max(least_per_interval, (least_samples + intervals - 1) / intervals)));
    }

    //! Where some span holds hardly more samples than its knots bring poles, takes more in all spans that hold few.
    void densify(const KnotVector &kv)
    {
        if (m_problem->fine)
            return;
        bool short_of_samples = false;
        std::vector<double> added;
        const std::vector<Knot> ends = kv.distinct();
        const auto poles_at = [&](std::size_t i) { return i == 0 || i + 1 == ends.size() ? 1 : ends[i].multiplicity; };
        auto from = m_parameters.begin();
        for (std::size_t i = 1; i < ends.size(); ++i)
        {
            const auto to = std::lower_bound(from, m_parameters.end(), ends[i].parameter);
            const int poles = std::max(poles_at(i - 1), poles_at(i));
            const int wanted = poles + spare_samples;
            short_of_samples = short_of_samples || to - from <= poles;
            if (to - from < wanted)
                add_chebyshev(ends[i - 1].parameter, ends[i].parameter, wanted, added);
            from = to;
        }
        if (short_of_samples)
            take(added);
    }

    //! The least-squares problem of these data over some knots.
    [[nodiscard]] std::optional<LeastSquaresFit> fit_over(const KnotVector &kv) const
    {
        return m_problem->fine ? LeastSquaresFit::make_reduction(kv, *m_problem->fine)
                               : LeastSquaresFit::make(kv, m_parameters);
    }

    [[nodiscard]] const std::vector<double> &parameters() const { return m_parameters; }
    [[nodiscard]] const CompressedRows &rows() const { return m_rows; }

private:
    //! Adds the samples at increasing parameters to those that are there, and compresses all.
    void take(const std::vector<double> &added)
    {
        const RowMatrix samples = m_problem->sample(added);
        std::vector<double> parameters(m_parameters.size() + added.size());
        RowMatrix all(static_cast<Eigen::Index>(parameters.size()), samples.cols());
        std::size_t i = 0;
        std::size_t j = 0;
        for (std::size_t k = 0; k < parameters.size(); ++k)
        {
            const bool old = j == added.size() || (i < m_parameters.size() && m_parameters[i] <= added[j]);
            parameters[k] = old ? m_parameters[i] : added[j];
            const RowMatrix &from = old ? m_samples : samples;
            all.row(static_cast<Eigen::Index>(k)) = from.row(static_cast<Eigen::Index>(old ? i++ : j++));
        }
        m_parameters = std::move(parameters);
        m_samples = std::move(all);
        m_rows = compress(m_samples, compression_share * m_problem->tolerance);
    }

    const KnotProblem *m_problem;
    std::vector<double> m_parameters;
    RowMatrix m_samples;
    CompressedRows m_rows;
};

//! One fit on given interior knots.
struct Trial
{
    std::vector<double> interior;
    KnotVector knots;
    RowMatrix poles;
    std::vector<double> errors; //!< by sample, while knots are added
    double error = 0.0;
};

class DegreeSearch
{
public:
    //! \param most_poles the search is given up above so many.
    //! \param start knots of another degree that serve it: the search starts from them.
    DegreeSearch(const KnotProblem &problem, SampledData &data, int degree, int most_poles, const KnotVector *start)
        : m_problem(problem), m_data(data), m_degree(degree), m_most_poles(most_poles), m_start(start)
    {
        for (const Knot &knot : problem.required)
        {
            const int multiplicity = std::min(degree, knot.multiplicity + degree - problem.required_degree);
            m_required.insert(m_required.end(), static_cast<std::size_t>(multiplicity), knot.parameter);
        }
    }

    std::optional<Trial> run()
    {
        std::optional<Trial> trial = refine();
        if (!trial)
            return trial;
        const double refined = trial->knots.pole_count();
        thin_out(*trial);
        m_part_left = trial->knots.pole_count() / refined;
        return trial;
    }

    //! Part of the refined fit's poles that thinning out has left.
    [[nodiscard]] double part_left() const { return m_part_left; }

private:
    //! A fit whose errors are still to be found, with the residual of the compressed rows.
    [[nodiscard]] std::optional<Trial> solve(std::vector<double> interior, RowMatrix &residual) const
    {
        Trial trial;
        trial.knots = clamped_knots(m_degree, m_problem.low, m_problem.high, interior);
        trial.interior = std::move(interior);
        const auto solver = m_data.fit_over(trial.knots);
        if (!solver)
            return std::nullopt;
        trial.poles = solver->solve(m_data.rows().factor);
        residual = solver->residual(trial.poles, m_data.rows().factor);
        return trial;
    }

    [[nodiscard]] std::optional<Trial> fit(std::vector<double> interior) const
    {
        RowMatrix residual;
        std::optional<Trial> trial = solve(std::move(interior), residual);
        if (!trial)
            return std::nullopt;
        trial->errors = m_data.rows().point_errors(residual, m_problem.tolerance);
        trial->error = *std::max_element(trial->errors.begin(), trial->errors.end());
        return trial;
    }

    //! Nothing where the tolerance is not met; such fits are left as soon as that shows.
    [[nodiscard]] std::optional<Trial> fit_within_tolerance(std::vector<double> interior) const
    {
        RowMatrix residual;
        std::optional<Trial> trial = solve(std::move(interior), residual);
        if (!trial)
            return std::nullopt;
        const std::optional<double> error = m_data.rows().largest_error(residual, m_problem.tolerance);
        if (!error)
            return std::nullopt;
        trial->error = *error;
        return trial;
    }

    //! Will the search need more poles than the best one so far leaves it? Nobody can say while breaks are left that
    //! may settle it at one blow.
    [[nodiscard]] bool hopeless(const Trial &trial) const
    {
        if (m_degree >= lowest_thinned_degree && trial.interior.size() < m_problem.breaks.size())
            return false;
        const double growth = std::pow(trial.error / m_problem.tolerance, 1.0 / (m_degree + 1));
        return prediction_share * growth * trial.knots.pole_count() > m_most_poles;
    }

    //! Raises the knot at a break to the multiplicity that the data needs; false if it has it already.
    bool raise(const Trial &trial, double parameter, std::vector<double> &added) const
    {
        const auto b = std::lower_bound(m_problem.breaks.begin(), m_problem.breaks.end(), parameter,
                                        [](const DataBreak &x, double t) { return x.parameter < t; });
        if (b == m_problem.breaks.end() || b->parameter != parameter)
            return false;
        const auto here = std::equal_range(trial.interior.begin(), trial.interior.end(), parameter);
        const auto planned = std::count(added.begin(), added.end(), parameter);
        const auto missing = full_multiplicity(*b, m_degree) - (here.second - here.first) - planned;
        added.insert(added.end(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, missing)), parameter);
        return missing > 0 || planned > 0;
    }

    //! What a failing span [a, b] gets: see choose_knots.
    void relieve(const Trial &trial, double a, double b, std::vector<double> &added) const
    {
        const double middle = 0.5 * (a + b);
        const double nothing = m_problem.low - 1.0;
        double nearest = nothing;
        for (const DataBreak &br : m_problem.breaks)
            if (br.parameter > a && br.parameter < b && full_multiplicity(br, m_degree) > 0 &&
                (nearest == nothing || std::abs(br.parameter - middle) < std::abs(nearest - middle)))
                nearest = br.parameter;
        if (nearest != nothing)
            return added.push_back(nearest);
        const bool left = raise(trial, a, added);
        const bool right = raise(trial, b, added);
        if (!left && !right && !m_problem.fine && b - a > smallest_span * (m_problem.high - m_problem.low))
            added.push_back(middle);
    }

    [[nodiscard]] std::vector<double> relief(const Trial &trial) const
    {
        std::vector<double> added;
        int last = -1;
        for (std::size_t i = 0; i < trial.errors.size(); ++i)
        {
            if (trial.errors[i] <= m_problem.tolerance)
                continue;
            const int span = trial.knots.span(m_data.parameters()[i]);
            if (span != last)
                relieve(trial, trial.knots.knots[static_cast<std::size_t>(span)],
                        trial.knots.knots[static_cast<std::size_t>(span) + 1], added);
            last = span;
        }
        return added;
    }

    //! The knots to start from: what the space has to hold, and where another degree needed knots. Where that one gave
    //! up continuity with a multiple knot, this one has no more of it.
    [[nodiscard]] std::vector<double> first_interior() const
    {
        if (!m_start)
            return m_required;
        std::vector<double> interior;
        for (const Knot &knot : m_start->distinct())
        {
            if (knot.parameter <= m_problem.low || knot.parameter >= m_problem.high)
                continue;
            const int same_continuity = std::clamp(knot.multiplicity + m_degree - m_start->degree, 1, m_degree);
            const int multiplicity = knot.multiplicity == 1 ? 1 : same_continuity;
            interior.insert(interior.end(), static_cast<std::size_t>(multiplicity), knot.parameter);
        }
        std::vector<double> joined;
        std::set_union(interior.begin(), interior.end(), m_required.begin(), m_required.end(),
                       std::back_inserter(joined));
        return joined;
    }

    //! Adds knots until the tolerance holds at every sample.
    std::optional<Trial> refine()
    {
        std::vector<double> interior = first_interior();
        while (static_cast<int>(interior.size()) + m_degree + 1 <= m_most_poles)
        {
            const KnotVector kv = clamped_knots(m_degree, m_problem.low, m_problem.high, interior);
            m_data.densify(kv);
            std::optional<Trial> trial = fit(interior);
            if (!trial || trial->error <= m_problem.tolerance)
                return trial;
            if (hopeless(*trial))
                return std::nullopt;
            const std::vector<double> added = relief(*trial);
            if (added.empty())
                return std::nullopt;
            interior.insert(interior.end(), added.begin(), added.end());
            std::sort(interior.begin(), interior.end());
        }
        return std::nullopt;
    }

    //! The smallest change of any pole that would let knot r (the last of its value) go:
    //! |sum a_j c_j| / sum |a_j|, where a spans the left null space of Boehm's insertion of that knot.
    [[nodiscard]] double removal_weight(const Trial &trial, int r) const
    {
        const std::vector<double> &t = trial.knots.knots;
        const double x = t[static_cast<std::size_t>(r)];
        const auto without = [&](int i) { return t[static_cast<std::size_t>(i < r ? i : i + 1)]; };
        int remaining = 0;
        while (t[static_cast<std::size_t>(r - 1 - remaining)] == x)
            ++remaining;
        const int first = r - 1 - m_degree;
        const int last = r - remaining;
        const auto alpha = [&](int j) {
            return j <= first ? 1.0 : (j >= last ? 0.0 : (x - without(j)) / (without(j + m_degree) - without(j)));
        };
        double a = 1.0;
        double sum = 1.0;
        Eigen::RowVectorXd change = trial.poles.row(first);
        for (int j = first; j < last; ++j)
        {
            a *= -alpha(j) / (1.0 - alpha(j + 1));
            sum += std::abs(a);
            change += a * trial.poles.row(j + 1);
        }
        const std::vector<double> &reach = m_data.rows().reach;
        const Eigen::Map<const Eigen::RowVectorXd> reaches(reach.data(), static_cast<Eigen::Index>(reach.size()));
        return change.cwiseAbs().dot(reaches) / sum;
    }

    struct Candidate
    {
        double weight = 0.0;
        std::size_t index = 0; //!< in Trial::interior
    };

    //! May one occurrence of an interior knot go?
    [[nodiscard]] bool removable(const Trial &trial, double parameter) const
    {
        const auto count = [parameter](const std::vector<double> &knots) {
            const auto range = std::equal_range(knots.begin(), knots.end(), parameter);
            return range.second - range.first;
        };
        return count(trial.interior) > count(m_required);
    }

    //! The knot that a candidate is the last occurrence of.
    [[nodiscard]] static Knot knot_at(const Trial &trial, const Candidate &candidate)
    {
        const double parameter = trial.interior[candidate.index];
        const auto range = std::equal_range(trial.interior.begin(), trial.interior.end(), parameter);
        return {parameter, static_cast<int>(range.second - range.first)};
    }

    //! One occurrence of every distinct interior knot that may go, the least needed first.
    [[nodiscard]] std::vector<Candidate> candidates(const Trial &trial, const std::vector<Knot> &needed) const
    {
        const auto is_needed = [&](std::size_t i) {
            const Knot here = knot_at(trial, {0.0, i});
            return std::any_of(needed.begin(), needed.end(), [&](const Knot &knot) {
                return knot.parameter == here.parameter && knot.multiplicity >= here.multiplicity;
            });
        };
        std::vector<Candidate> result;
        for (std::size_t i = 0; i < trial.interior.size(); ++i)
            if ((i + 1 == trial.interior.size() || trial.interior[i + 1] > trial.interior[i]) &&
                removable(trial, trial.interior[i]) && !is_needed(i))
                result.push_back({removal_weight(trial, static_cast<int>(i) + m_degree + 1), i});
        std::sort(result.begin(), result.end(), [](const auto &a, const auto &b) { return a.weight < b.weight; });
        return result;
    }

    //! Tries to do without the first `count` candidates, none of them next to another.
    [[nodiscard]] std::optional<Trial> without(const Trial &trial, const std::vector<Candidate> &order,
                                               std::size_t from, std::size_t count) const
    {
        std::vector<char> gone(trial.interior.size() + 2, 0);
        for (std::size_t k = from; k < std::min(from + count, order.size()); ++k)
        {
            const std::size_t i = order[k].index + 1;
            gone[i] = count == 1 || (!gone[i - 1] && !gone[i + 1]);
        }
        std::vector<double> interior;
        for (std::size_t i = 0; i < trial.interior.size(); ++i)
            if (!gone[i + 1])
                interior.push_back(trial.interior[i]);
        return fit_within_tolerance(std::move(interior));
    }

    //! Tries the first candidates one by one; those that cannot go are noted in `needed`.
    [[nodiscard]] std::optional<Trial> without_one(const Trial &trial, const std::vector<Candidate> &order,
                                                   std::vector<Knot> &needed) const
    {
        std::optional<Trial> thinner;
        for (std::size_t k = 0; k < std::min<std::size_t>(last_tries, order.size()) && !thinner; ++k)
        {
            thinner = without(trial, order, k, 1);
            if (!thinner)
                needed.push_back(knot_at(trial, order[k]));
        }
        return thinner;
    }

    //! Removes batches of knots, halving the batch whenever it breaks the tolerance.
    void thin_out(Trial &trial)
    {
        std::vector<Knot> needed;
        std::size_t batch = trial.interior.size() / 2;
        while (!trial.interior.empty())
        {
            const std::vector<Candidate> order = candidates(trial, needed);
            if (order.empty())
                return;
            batch = std::min(std::max<std::size_t>(batch, 1), order.size());
            std::size_t tried = batch;
            std::optional<Trial> thinner;
            while (tried > 1 && !(thinner = without(trial, order, 0, tried)))
                tried /= 2;
            if (!thinner)
                thinner = without_one(trial, order, needed);
            if (!thinner)
                return;
            trial = std::move(*thinner);
            batch = tried == batch ? 2 * batch : tried / 2;
        }
    }

    const KnotProblem &m_problem;
    SampledData &m_data;
    int m_degree;
    int m_most_poles;
    const KnotVector *m_start;
    std::vector<double> m_required; //!< interior knots, as often as this degree needs them
    double m_part_left = 1.0;
};

} // namespace

namespace
{

//! The search over all degrees that a problem admits.
class DegreeChoice
{
public:
    explicit DegreeChoice(const KnotProblem &problem) : m_problem(problem), m_data(problem) {}

    std::optional<KnotChoice> run()
    {
        const bool smooth_first = !try_degree(degree_order[0], first_poles()) && try_degree(smooth_degree);
        std::vector<int> others;
        for (const int degree : degree_order)
            if (degree != (smooth_first ? smooth_degree : degree_order[0]) || !m_best)
                others.push_back(degree);
        const std::size_t lanes = m_problem.two_at_once && m_best ? 2 : 1;
        for (std::size_t i = 0; i < others.size(); i += lanes)
            if (i + 1 < others.size() && lanes == 2)
                try_both(others[i], others[i + 1]);
            else
                try_degree(others[i]);
        return m_best;
    }

    //! At one degree, from given knots.
    std::optional<KnotChoice> run_from(const KnotVector &start)
    {
        search(start.degree, m_problem.max_poles, &start);
        return m_best;
    }

private:
    //! So many poles are tried of the first degree before a higher one.
    [[nodiscard]] int first_poles() const
    {
        int poles = most_first_poles;
        for (const DataBreak &b : m_problem.breaks)
            poles += std::max(1, degree_order[0] - b.continuity);
        return smooth_degree <= m_problem.max_degree ? poles : m_problem.max_poles;
    }

    //! What both know before is the same, so that the outcome does not depend on which is faster.
    void try_both(int first, int second)
    {
        DegreeChoice other = *this;
        tbb::parallel_invoke([&] { try_degree(first); }, [&] { other.try_degree(second); });
        if (other.m_best->knots.pole_count() < m_best->knots.pole_count())
            m_best = std::move(other.m_best);
        if (other.m_data.parameters().size() > m_data.parameters().size())
            m_data = std::move(other.m_data);
        m_part_left = std::min(m_part_left, other.m_part_left);
    }

    //! \return whether the degree reaches the tolerance.
    bool try_degree(int degree, int most_poles = std::numeric_limits<int>::max())
    {
        if (degree < std::max(m_problem.min_degree, m_problem.required_degree) || degree > m_problem.max_degree)
            return false;
        const int fewest = m_best ? m_best->knots.pole_count() : m_problem.max_poles + 1;
        if (degree + 1 >= fewest)
            return false;
        const double judged = fewest > small_fit ? std::max(least_part_left, luckier * m_part_left) : least_part_left;
        const double hope = degree < lowest_thinned_degree ? 1.0 : judged;
        const int most = m_best ? static_cast<int>(fewest / hope) : m_problem.max_poles;
        const int limit = std::min({most, most_poles, m_problem.max_poles});
        const bool reached = search(degree, limit, m_best ? &m_best->knots : nullptr);
        const KnotVector pieces = between_breaks(degree);
        const bool may_win =
            m_best && pieces.pole_count() < std::min(small_fit, m_best->knots.pole_count()); // longer ones seldom do
        return (may_win && search(degree, pieces.pole_count(), &pieces)) || reached;
    }

    //! A polynomial between any two breaks, joined as smoothly as the data is.
    [[nodiscard]] KnotVector between_breaks(int degree) const
    {
        std::vector<double> interior;
        for (const DataBreak &b : m_problem.breaks)
            interior.insert(interior.end(), static_cast<std::size_t>(full_multiplicity(b, degree)), b.parameter);
        return clamped_knots(degree, m_problem.low, m_problem.high, interior);
    }

    bool search(int degree, int most_poles, const KnotVector *start)
    {
        DegreeSearch search(m_problem, m_data, degree, most_poles, start);
        const std::optional<Trial> trial = search.run();
        if (!trial)
            return false;
        m_part_left = std::min(m_part_left, search.part_left());
        if (!m_best || trial->knots.pole_count() < m_best->knots.pole_count())
            m_best = KnotChoice{trial->knots, trial->error};
        return true;
    }

    const KnotProblem &m_problem;
    SampledData m_data;
    std::optional<KnotChoice> m_best;
    double m_part_left = 1.0;
};

} // namespace

std::optional<KnotChoice> choose_knots(const KnotProblem &problem)
{
    DegreeChoice choice(problem);
    return problem.start ? choice.run_from(*problem.start) : choice.run();
}

std::vector<double> chebyshev_parameters(const std::vector<double> &breaks, int count)
{
    std::vector<double> parameters{breaks.front()};
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        add_chebyshev(breaks[i], breaks[i + 1], count, parameters);
    parameters.push_back(breaks.back());
    return parameters;
}

std::vector<double> span_parameters(const KnotVector &kv, const std::vector<double> &breaks, int per_span,
                                    int per_interval)
{
    const std::vector<double> spans = kv.breaks();
    const std::vector<double> all = merged_breaks(spans, breaks);
    std::vector<double> parameters{all.front()};
    std::size_t begin = 0;
    for (std::size_t s = 1; s < spans.size(); ++s)
    {
        std::size_t end = begin;
        while (end + 1 < all.size() && 0.5 * (all[end] + all[end + 1]) < spans[s])
            ++end;
        const int intervals = std::max(1, static_cast<int>(end - begin));
        const int count = std::max(per_interval, (per_span + intervals - 1) / intervals);
        for (std::size_t i = begin; i < end; ++i)
            add_chebyshev(all[i], all[i + 1], count, parameters);
        begin = end;
    }
    parameters.push_back(all.back());
    return parameters;
}

} // namespace laminate_offset
