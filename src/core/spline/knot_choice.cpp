// SPDX-License-Identifier: LGPL-2.1-or-later
#include "knot_choice.h"

#include "row_compression.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace laminate_offset
{
namespace
{

// Samples in an interval: more than the poles that degree 7 can place there.
constexpr int samples_per_interval = 10;
constexpr int least_samples = 60;
// Part of the tolerance that the compression of the rows may use up.
constexpr double compression_share = 0.02;
// Spans are not halved below this part of the whole range.
constexpr double smallest_span = 1e-5;
// So many of the lowest-ranked knots are tried one by one before the rest is believed to be needed.
constexpr int last_tries = 4;

class SampledData
{
public:
    explicit SampledData(const KnotProblem &problem) : m_problem(problem)
    {
        std::vector<double> breaks{problem.low};
        for (const DataBreak &b : problem.breaks)
            breaks.push_back(b.parameter);
        breaks.push_back(problem.high);
        const int intervals = static_cast<int>(breaks.size()) - 1;
        take(breaks, std::max(samples_per_interval, (least_samples + intervals - 1) / intervals));
    }

    //! Takes new samples so dense that every span of the knots holds enough of them.
    void densify(const KnotVector &kv)
    {
        m_breaks = merged_breaks(m_breaks, kv.breaks());
        take(m_breaks, samples_per_interval);
    }

    //! Does every span hold more samples than the degree?
    [[nodiscard]] bool dense_enough(const KnotVector &kv) const
    {
        const std::vector<double> spans = kv.breaks();
        auto from = m_parameters.begin();
        for (std::size_t i = 1; i < spans.size(); ++i)
        {
            const auto to = std::lower_bound(from, m_parameters.end(), spans[i]);
            if (to - from <= kv.degree)
                return false;
            from = to;
        }
        return true;
    }

    [[nodiscard]] const std::vector<double> &parameters() const { return m_parameters; }
    [[nodiscard]] const CompressedRows &rows() const { return m_rows; }

private:
    void take(const std::vector<double> &breaks, int count)
    {
        m_breaks = breaks;
        m_parameters = chebyshev_parameters(breaks, count);
        m_rows = compress(m_problem.sample(m_parameters), compression_share * m_problem.tolerance);
    }

    const KnotProblem &m_problem;
    std::vector<double> m_breaks;
    std::vector<double> m_parameters;
    CompressedRows m_rows;
};

//! One fit on given interior knots.
struct Trial
{
    std::vector<double> interior;
    KnotVector knots;
    RowMatrix poles;
    std::vector<double> errors; //!< by sample
    double error = 0.0;
};

class DegreeSearch
{
public:
    DegreeSearch(const KnotProblem &problem, SampledData &data, int degree)
        : m_problem(problem), m_data(data), m_degree(degree)
    {
    }

    std::optional<Trial> run()
    {
        std::optional<Trial> trial = refine();
        if (trial)
            thin_out(*trial);
        return trial;
    }

private:
    [[nodiscard]] std::optional<Trial> fit(std::vector<double> interior) const
    {
        Trial trial;
        trial.knots = clamped_knots(m_degree, m_problem.low, m_problem.high, interior);
        trial.interior = std::move(interior);
        const auto solver = LeastSquaresFit::make(trial.knots, m_data.parameters());
        if (!solver)
            return std::nullopt;
        const CompressedRows &rows = m_data.rows();
        trial.poles = solver->solve(rows.factor);
        trial.errors = rows.point_errors(solver->residual(trial.poles, rows.factor), m_problem.tolerance);
        trial.error = *std::max_element(trial.errors.begin(), trial.errors.end());
        return trial;
    }

    [[nodiscard]] std::vector<double> starting_knots() const
    {
        std::vector<double> interior;
        for (const DataBreak &b : m_problem.breaks)
            interior.insert(interior.end(), static_cast<std::size_t>(std::clamp(m_degree - b.continuity, 0, m_degree)),
                            b.parameter);
        return interior;
    }

    //! The middles of the spans that hold a sample out of tolerance.
    [[nodiscard]] std::vector<double> middles_of_failing_spans(const Trial &trial) const
    {
        std::vector<double> middles;
        int last = -1;
        for (std::size_t i = 0; i < trial.errors.size(); ++i)
        {
            if (trial.errors[i] <= m_problem.tolerance)
                continue;
            const int span = trial.knots.span(m_data.parameters()[i]);
            const double a = trial.knots.knots[static_cast<std::size_t>(span)];
            const double b = trial.knots.knots[static_cast<std::size_t>(span) + 1];
            if (span != last && b - a > smallest_span * (m_problem.high - m_problem.low))
                middles.push_back(0.5 * (a + b));
            last = span;
        }
        return middles;
    }

    //! Halves failing spans until the tolerance holds at every sample.
    std::optional<Trial> refine()
    {
        std::vector<double> interior = starting_knots();
        while (static_cast<int>(interior.size()) + m_degree + 1 <= m_problem.max_poles)
        {
            const KnotVector kv = clamped_knots(m_degree, m_problem.low, m_problem.high, interior);
            if (!m_data.dense_enough(kv))
                m_data.densify(kv);
            std::optional<Trial> trial = fit(interior);
            if (!trial || trial->error <= m_problem.tolerance)
                return trial;
            const std::vector<double> middles = middles_of_failing_spans(*trial);
            if (middles.empty())
                return std::nullopt;
            interior.insert(interior.end(), middles.begin(), middles.end());
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

    //! One occurrence of every distinct interior knot, the least needed first.
    [[nodiscard]] std::vector<Candidate> candidates(const Trial &trial) const
    {
        std::vector<Candidate> result;
        for (std::size_t i = 0; i < trial.interior.size(); ++i)
            if (i + 1 == trial.interior.size() || trial.interior[i + 1] > trial.interior[i])
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
        std::optional<Trial> thinner = fit(std::move(interior));
        if (thinner && thinner->error > m_problem.tolerance)
            thinner.reset();
        return thinner;
    }

    //! Removes batches of knots, halving the batch whenever it breaks the tolerance.
    void thin_out(Trial &trial)
    {
        std::size_t batch = trial.interior.size() / 2;
        while (!trial.interior.empty())
        {
            const std::vector<Candidate> order = candidates(trial);
            std::optional<Trial> thinner;
            for (batch = std::min(std::max<std::size_t>(batch, 1), order.size()); batch > 1 && !thinner; batch /= 2)
                thinner = without(trial, order, 0, batch);
            for (std::size_t k = 0; k < std::min<std::size_t>(last_tries, order.size()) && !thinner; ++k)
                thinner = without(trial, order, k, 1);
            if (!thinner)
                return;
            trial = std::move(*thinner);
            batch = std::max<std::size_t>(batch * 2, 1);
        }
    }

    const KnotProblem &m_problem;
    SampledData &m_data;
    int m_degree;
};

} // namespace

std::optional<KnotChoice> choose_knots(const KnotProblem &problem)
{
    SampledData data(problem);
    std::optional<KnotChoice> best;
    for (int degree = problem.min_degree; degree <= problem.max_degree; ++degree)
    {
        const std::optional<Trial> trial = DegreeSearch(problem, data, degree).run();
        if (!trial)
            continue;
        const int poles = trial->knots.pole_count();
        const bool fewer = !best || poles < best->knots.pole_count();
        const bool closer = best && poles == best->knots.pole_count() && trial->error < best->error;
        if (fewer || closer)
            best = KnotChoice{trial->knots, trial->error};
    }
    return best;
}

std::vector<double> chebyshev_parameters(const std::vector<double> &breaks, int count)
{
    std::vector<double> parameters{breaks.front()};
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        for (int k = 0; k < count; ++k)
        {
            const double x = 0.5 * (1.0 - std::cos(M_PI * (k + 0.5) / count));
            parameters.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * x);
        }
    parameters.push_back(breaks.back());
    return parameters;
}

} // namespace laminate_offset
