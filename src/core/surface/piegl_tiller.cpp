// SPDX-License-Identifier: LGPL-2.1-or-later
#include "piegl_tiller.h"

#include "certificate.h"
#include "offset_samples.h"

#include "../spline/data_reduction.h"
#include "../spline/knot_choice.h"
#include "../spline/least_squares.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace laminate_offset
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int most_rounds = 12;
constexpr int most_parts = 500;
constexpr int most_poles = 400000;
constexpr int checks_per_span = 3;
// A row of samples shorter than this part of the longest, at a collapsed side, still gives its span some length.
constexpr double least_step = 1e-3;
// The map to chord length has at least so many pieces, to follow a parametrisation that is uneven inside a span.
constexpr int least_intervals = 12;
constexpr double all_knots_may_stay = 1.0;
// A removal whose two directions add up to more than was asked for is repeated with half of it.
constexpr int removal_attempts = 4;
// Rectangles of the proof are mapped to the base's parameters with a margin above rounding.
constexpr double map_margin = 1e-12;

//! One direction: spans of the base, cut at nodes, with samples between these.
struct Direction
{
    std::vector<double> nodes;   //!< the base's parameters; all ends of spans are among them
    std::vector<int> continuity; //!< of the base at each node
    std::vector<int> span;       //!< of each interval between nodes
    std::vector<double> samples; //!< `steps` steps in every interval
    int steps = 0;

    Direction(const std::vector<double> &ends, const std::vector<SmoothnessBreak> &breaks, int degree)
        : steps(2 * (degree + 1))
    {
        const int spans = static_cast<int>(ends.size()) - 1;
        const int parts = (least_intervals + spans - 1) / spans;
        for (int i = 0; i < spans; ++i)
            for (int k = 0; k < parts; ++k)
            {
                const auto at = static_cast<std::size_t>(i);
                nodes.push_back(k == 0 ? ends[at] : ends[at] + (ends[at + 1] - ends[at]) * k / parts);
                continuity.push_back(k == 0 && i > 0 ? breaks[at - 1].continuity : max_spline_degree);
                span.push_back(i);
            }
        nodes.push_back(ends.back());
        continuity.push_back(max_spline_degree);
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
            for (int k = 0; k < steps; ++k)
                samples.push_back(nodes[i] + (nodes[i + 1] - nodes[i]) * k / steps);
        samples.push_back(nodes.back());
    }
};

//! Points by (sample of this direction, sample of the other one).
using PointAt = std::function<Eigen::Vector3d(std::size_t, std::size_t)>;

std::vector<double> mean_steps(const Direction &direction, std::size_t rows, const PointAt &point)
{
    std::vector<double> steps(direction.samples.size() - 1, 0.0);
    for (std::size_t k = 0; k < steps.size(); ++k)
        for (std::size_t row = 0; row < rows; ++row)
            steps[k] += (point(k + 1, row) - point(k, row)).norm() / static_cast<double>(rows);
    const double longest = *std::max_element(steps.begin(), steps.end());
    for (double &step : steps)
        step = std::max(step, least_step * longest);
    return steps;
}

//! Slopes that make the cubics between nodes a, ..., b twice continuously differentiable, those at a and b given.
void smooth_slopes(std::vector<MonotoneMap::Node> &nodes, std::size_t a, std::size_t b)
{
    const auto count = static_cast<Eigen::Index>(b - a) - 1;
    if (count < 1)
        return;
    const auto length = [&](std::size_t i) { return nodes[i + 1].parameter - nodes[i].parameter; };
    const auto rise = [&](std::size_t i) { return (nodes[i + 1].value - nodes[i].value) / length(i); };
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd right(count);
    for (Eigen::Index k = 0; k < count; ++k)
    {
        const std::size_t i = a + 1 + static_cast<std::size_t>(k);
        const double before = 1.0 / length(i - 1);
        const double after = 1.0 / length(i);
        matrix(k, k) = 2.0 * (before + after);
        right(k) = 3.0 * (before * rise(i - 1) + after * rise(i));
        if (k > 0)
            matrix(k, k - 1) = before;
        else
            right(k) -= before * nodes[a].slope_after;
        if (k + 1 < count)
            matrix(k, k + 1) = after;
        else
            right(k) -= after * nodes[b].slope_before;
    }
    const Eigen::VectorXd slopes = matrix.partialPivLu().solve(right);
    for (Eigen::Index k = 0; k < count; ++k)
    {
        MonotoneMap::Node &node = nodes[a + 1 + static_cast<std::size_t>(k)];
        node.slope_before = node.slope_after = slopes(k);
    }
}

//! Chord length to the base's parameter.
MonotoneMap chord_length_map(const Direction &direction, std::size_t rows, const PointAt &point, double slack)
{
    const std::vector<double> steps = mean_steps(direction, rows, point);
    const std::vector<double> &at = direction.samples;
    const auto slope = [&](std::size_t k) { return (at[k + 1] - at[k]) / steps[k]; };
    const double mean = (at.back() - at.front()) / std::accumulate(steps.begin(), steps.end(), 0.0);
    bool near_linear = true;
    for (std::size_t k = 0; k < steps.size(); ++k)
        near_linear = near_linear && std::abs(slope(k) / mean - 1.0) <= slack;
    std::vector<MonotoneMap::Node> nodes;
    double length = 0.0;
    for (std::size_t i = 0; i < direction.nodes.size(); ++i)
    {
        const std::size_t k = i * static_cast<std::size_t>(direction.steps);
        // slopes at the ends of the two intervals, from those in the middle of the two steps beside them
        const double before = i == 0 ? 0.0 : 1.5 * slope(k - 1) - 0.5 * slope(k - 2);
        const double after = k + 1 == at.size() ? before : 1.5 * slope(k) - 0.5 * slope(k + 1);
        const double parameter = near_linear ? (at[k] - at.front()) / mean : length;
        nodes.push_back({parameter, direction.nodes[i], i == 0 ? after : before, after});
        for (std::size_t j = k; j < k + static_cast<std::size_t>(direction.steps) && j < steps.size(); ++j)
            length += steps[j];
    }
    if (near_linear)
        return MonotoneMap::linear(nodes);
    std::size_t start = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i)
        if (i + 1 == nodes.size() || direction.continuity[i] < 1)
        {
            smooth_slopes(nodes, start, i);
            start = i;
        }
    return MonotoneMap(std::move(nodes));
}

//! |O''| of every interval in the new parameters: the largest second divided difference.
std::vector<double> bends(const Direction &direction, const MonotoneMap &map, std::size_t rows, const PointAt &point)
{
    std::vector<double> parameters;
    for (const double value : direction.samples)
        parameters.push_back(map.parameter(value));
    std::vector<double> result(direction.nodes.size() - 1, 0.0);
    for (std::size_t i = 0; i < result.size(); ++i)
        for (int k = 1; k < direction.steps; ++k)
            for (std::size_t row = 0; row < rows; ++row)
            {
                const std::size_t m = i * static_cast<std::size_t>(direction.steps) + static_cast<std::size_t>(k);
                const double h0 = parameters[m] - parameters[m - 1];
                const double h1 = parameters[m + 1] - parameters[m];
                const Eigen::Vector3d second =
                    2.0 / (h0 + h1) *
                    ((point(m + 1, row) - point(m, row)) / h1 - (point(m, row) - point(m - 1, row)) / h0);
                result[i] = std::max(result[i], second.norm());
            }
    return result;
}

//! Knots for the interpolation: a span of length h in n = (M h^2 / (8 accuracy))^exponent parts (eq. 3.10), each of its
//! intervals in its share of them.
KnotVector interpolation_knots(const Direction &direction, const MonotoneMap &map, const std::vector<double> &bend,
                               double accuracy, int degree, double exponent)
{
    const std::vector<double> &ends = map.parameters();
    std::vector<double> spans(static_cast<std::size_t>(direction.span.back()) + 1, 0.0);
    for (std::size_t i = 0; i < bend.size(); ++i)
        spans[static_cast<std::size_t>(direction.span[i])] += ends[i + 1] - ends[i];
    std::vector<double> interior;
    for (std::size_t i = 0; i < bend.size(); ++i)
    {
        const double span = spans[static_cast<std::size_t>(direction.span[i])];
        const double length = ends[i + 1] - ends[i];
        const double wanted = std::ceil(std::pow(bend[i] * span * span / (8.0 * accuracy), exponent) * length / span);
        const int parts = static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(most_parts)));
        for (int k = 1; k < parts; ++k)
            interior.push_back(ends[i] + length * k / parts);
        if (i + 1 == bend.size())
            break;
        // the offset of a C^k base is C^(k-1), and no smoother than the map
        const int smooth = std::min(direction.continuity[i + 1] - 1, map.continuity(i + 1));
        interior.insert(interior.end(), static_cast<std::size_t>(degree - std::clamp(smooth, 0, degree - 1)),
                        ends[i + 1]);
    }
    return clamped_knots(degree, ends.front(), ends.back(), interior);
}

std::vector<double> interpolation_parameters(const KnotVector &kv)
{
    std::vector<double> parameters = kv.pole_parameters();
    parameters.front() = kv.front();
    parameters.back() = kv.back();
    return parameters;
}

std::vector<double> mapped(const MonotoneMap &map, const std::vector<double> &parameters)
{
    std::vector<double> values;
    for (const double parameter : parameters)
        values.push_back(map.value(parameter));
    return values;
}

class PieglTiller
{
public:
    PieglTiller(const SurfaceAnalysis &analysis, const InputFace &input, double distance, double tolerance,
                const OffsetOptions &options, const PieglTillerOptions &how)
        : m_analysis(analysis), m_base(analysis.base), m_input(input), m_distance(distance), m_tolerance(tolerance),
          m_options(options), m_how(how), m_sampler(m_base, {distance}, Denominator::One),
          m_u(m_base.interval_ends_u(), m_base.breaks_u(), how.degree),
          m_v(m_base.interval_ends_v(), m_base.breaks_v(), how.degree)
    {
    }

    Result<OffsetSurface> run()
    {
        if (!sample())
            return singular_refusal(*m_sampler.singular());
        const double left = m_tolerance - m_base.model_error().of_offset(m_distance);
        double share = 1.0;
        for (int round = 0; left > 0.0 && round < most_rounds; ++round)
        {
            const std::optional<TensorSpline> full = interpolate(share * m_how.interpolation_share * left, round);
            if (m_sampler.singular())
                return singular_refusal(*m_sampler.singular());
            if (m_cancelled)
                return cancellation();
            if (!full)
                break;
            for (double hope = m_how.removal_hope;; hope = std::max(1.0, 0.5 * hope))
            {
                const TensorSpline light = fewer_knots(*full, hope * share * m_how.removal_share * left);
                const ErrorAt seen = deviation(light);
                const ErrorAt proven = seen.error <= m_tolerance && m_reparametrised ? bound(light, left) : seen;
                if (proven.error <= m_tolerance)
                    return result(light, seen, proven);
                if (proven.error < m_closest.error)
                    m_closest = proven;
                if (cancelled(round))
                    return cancellation();
                if (hope <= 1.0)
                    break;
            }
            share *= 0.6;
        }
        return unreached();
    }

private:
    struct ErrorAt
    {
        double error = infinity;
        gp_Pnt2d uv; //!< the base's parameters
    };

    //! Offset points of every span, the map to chord length, and the second derivatives in it.
    bool sample()
    {
        const RowMatrix rows = m_sampler.rows(m_distance, m_u.samples, m_v.samples, false);
        if (m_sampler.singular())
            return false;
        const PointAt along_u = [&](std::size_t k, std::size_t l) -> Eigen::Vector3d {
            return rows.row(static_cast<Eigen::Index>(k)).segment<3>(3 * static_cast<Eigen::Index>(l)).transpose();
        };
        const PointAt along_v = [&](std::size_t l, std::size_t k) { return along_u(k, l); };
        const double slack = m_how.chord_length_slack;
        m_map = std::make_shared<const ParameterMap>(
            ParameterMap{chord_length_map(m_u, m_v.samples.size(), along_u, slack),
                         chord_length_map(m_v, m_u.samples.size(), along_v, slack)});
        m_bends_u = bends(m_u, m_map->u, m_v.samples.size(), along_u);
        m_bends_v = bends(m_v, m_map->v, m_u.samples.size(), along_v);
        const std::optional<TensorSpline> &base = m_base.spline();
        if (base && base->u.degree * m_map->u.degree() <= max_spline_degree &&
            base->v.degree * m_map->v.degree() <= max_spline_degree)
            m_reparametrised = reparametrised(*base, *m_map);
        return true;
    }

    //! An interpolant that was seen to keep the accuracy between its samples; m_parts remembers by how much the
    //! count of eq. 3.10 had to be raised.
    std::optional<TensorSpline> interpolate(double accuracy, int first_round)
    {
        const double exponent = m_how.exponent > 0.0 ? m_how.exponent : 1.0 / (m_how.degree + 1.0);
        for (int round = first_round; round < most_rounds; ++round)
        {
            // each direction alone takes half of it: ||O - Lu Lv O|| <= ||O - Lu O|| + ||Lu|| ||O - Lv O||
            const double each = 0.5 * m_finer * accuracy;
            const KnotVector u = interpolation_knots(m_u, m_map->u, m_bends_u, each, m_how.degree, exponent);
            const KnotVector v = interpolation_knots(m_v, m_map->v, m_bends_v, each, m_how.degree, exponent);
            if (static_cast<double>(u.pole_count()) * v.pole_count() > most_poles)
                return std::nullopt;
            std::optional<TensorSpline> spline = interpolant(u, v);
            if (!spline)
                return std::nullopt;
            const ErrorAt seen = deviation(*spline, false);
            if (seen.error <= accuracy)
                return spline;
            m_closest = seen.error < m_closest.error ? seen : m_closest;
            m_finer *= std::clamp(0.7 * accuracy / seen.error, 1e-3, 0.7);
            m_cancelled = cancelled(round);
            if (m_cancelled)
                return std::nullopt;
        }
        return std::nullopt;
    }

    std::optional<TensorSpline> interpolant(const KnotVector &u, const KnotVector &v)
    {
        const std::vector<double> us = interpolation_parameters(u);
        const std::vector<double> vs = interpolation_parameters(v);
        const auto fit_u = LeastSquaresFit::make(u, us);
        const auto fit_v = LeastSquaresFit::make(v, vs);
        if (!fit_u || !fit_v)
            return std::nullopt;
        // S + d N (eq. 3.1) at the places that the interpolant's parameters belong to
        const RowMatrix rows = m_sampler.rows(m_distance, mapped(m_map->u, us), mapped(m_map->v, vs), false);
        const RowMatrix net = fit_v->solve(transposed_points(fit_u->solve(rows)));
        TensorSpline spline{u, v, {}, false};
        spline.poles.reserve(static_cast<std::size_t>(net.size() / 3));
        for (Eigen::Index i = 0; i < net.cols(); i += 3)
            for (Eigen::Index j = 0; j < net.rows(); ++j)
            {
                const Eigen::Vector3d point = net.row(j).segment<3>(i).transpose() + m_sampler.origin();
                spline.poles.emplace_back(point.x(), point.y(), point.z(), 1.0);
            }
        return spline;
    }

    static TensorSpline fewer_knots(const TensorSpline &spline, double tolerance)
    {
        if (!(tolerance > 0.0))
            return spline;
        for (int attempt = 0; attempt < removal_attempts; ++attempt, tolerance *= 0.5)
            if (const auto light = reduced(spline, tolerance, all_knots_may_stay))
                return light->spline;
        return spline;
    }

    //! The largest deviation seen from the exact offset at places that belong together.
    [[nodiscard]] ErrorAt deviation(const TensorSpline &spline, bool with_model = true) const
    {
        const auto us = span_parameters(spline.u, m_map->u.parameters(), checks_per_span, 1);
        const auto vs = span_parameters(spline.v, m_map->v.parameters(), checks_per_span, 1);
        const std::vector<double> base_us = mapped(m_map->u, us);
        const std::vector<double> base_vs = mapped(m_map->v, vs);
        std::optional<gp_Pnt2d> singular;
        const std::vector<Eigen::Vector3d> exact = m_base.offset_grid(base_us, base_vs, m_distance, singular);
        if (singular)
            return {infinity, *singular};
        const std::vector<SurfaceJet> made = spline.jets(us, vs, 0);
        ErrorAt worst{0.0, {}};
        for (std::size_t i = 0; i < exact.size(); ++i)
            if (const double error = (exact[i] - made[i].s).norm(); !(error <= worst.error))
                worst = {std::isnan(error) ? infinity : error,
                         gp_Pnt2d(base_us[i / vs.size()], base_vs[i % vs.size()])};
        if (with_model)
            worst.error += m_base.model_error().of_offset(m_distance);
        return worst;
    }

    //! A rectangle of the result's parameters in those of the base.
    [[nodiscard]] ParameterBox base_box(const ParameterBox &box) const
    {
        const auto margin = [](const MonotoneMap &map) {
            return map_margin * (std::abs(map.values().back()) + std::abs(map.values().front()));
        };
        const double mu = margin(m_map->u);
        const double mv = margin(m_map->v);
        return {m_map->u.value(box.umin) - mu, m_map->u.value(box.umax) + mu, m_map->v.value(box.vmin) - mv,
                m_map->v.value(box.vmax) + mv};
    }

    [[nodiscard]] ErrorAt bound(const TensorSpline &spline, double target) const
    {
        const auto needed = [&](const ParameterBox &box) { return m_analysis.region.may_touch(base_box(box)); };
        const Certificate certificate = certify({*m_reparametrised, spline, m_distance, target, needed,
                                                 reparametrisation_operations(*m_base.spline()) + m_base.rounding()});
        const ParameterBox worst = base_box(certificate.worst);
        return {certificate.bound + m_base.model_error().of_offset(m_distance),
                gp_Pnt2d(0.5 * (worst.umin + worst.umax), 0.5 * (worst.vmin + worst.vmax))};
    }

    [[nodiscard]] OffsetSurface result(const TensorSpline &spline, const ErrorAt &seen, const ErrorAt &proven) const
    {
        OffsetSurface made;
        made.geometry = to_geom(spline);
        if (m_reparametrised)
            made.certified_error = proven.error;
        made.sampled_error = seen.error;
        made.parameter_map = m_map;
        return made;
    }

    [[nodiscard]] bool cancelled(int round) const
    {
        return m_options.progress && !m_options.progress(static_cast<double>(round) / most_rounds);
    }

    [[nodiscard]] static Failure cancellation()
    {
        return {Status::Cancelled, Stage::Surface, "The computation was cancelled during the surface's interpolation.",
                std::nullopt, std::nullopt};
    }

    [[nodiscard]] Failure singular_refusal(const gp_Pnt2d &uv) const
    {
        return {Status::SingularNormal, Stage::Surface,
                "The surface has no normal at the reported place; trim the face clear of it.", m_input.place(uv),
                std::nullopt};
    }

    [[nodiscard]] Failure unreached() const
    {
        const bool known = std::isfinite(m_closest.error);
        const ParameterBox &box = m_base.box();
        const gp_Pnt2d middle(0.5 * (box.umin + box.umax), 0.5 * (box.vmin + box.vmax));
        return {
            Status::ToleranceNotReached, Stage::Surface,
            fmt::format("The interpolated offset could not be proven to be within {:.3g} mm{}; loosen the tolerance "
                        "or use the method same-parameter.",
                        m_tolerance,
                        known ? fmt::format(" (closest {:.3g} mm, at the reported place)", m_closest.error) : ""),
            m_input.place(known ? m_closest.uv : middle), std::nullopt};
    }

    const SurfaceAnalysis &m_analysis;
    const BaseSurface &m_base;
    const InputFace &m_input;
    double m_distance;
    double m_tolerance;
    const OffsetOptions &m_options;
    const PieglTillerOptions &m_how;
    OffsetSampler m_sampler;
    Direction m_u;
    Direction m_v;
    std::shared_ptr<const ParameterMap> m_map;
    std::vector<double> m_bends_u;
    std::vector<double> m_bends_v;
    std::optional<TensorSpline> m_reparametrised; //!< the base in the result's parameters
    double m_finer = 1.0;                         //!< how much finer than asked the samples had to be counted so far
    ErrorAt m_closest;
    bool m_cancelled = false;
};

Failure option_refusal(std::string message)
{
    return {Status::InvalidOption, Stage::Options, std::move(message), std::nullopt, std::nullopt};
}

} // namespace

Result<OffsetSurface> piegl_tiller_offset(const SurfaceAnalysis &analysis, const InputFace &input, double distance,
                                          double tolerance, const OffsetOptions &options, const PieglTillerOptions &how)
{
    if (how.degree < 2 || how.degree > 7)
        return option_refusal(fmt::format("The interpolant's degree {} is out of its range 2 to 7.", how.degree));
    if (how.exponent != 0.0 && !(how.exponent >= 0.05 && how.exponent <= 0.5))
        return option_refusal(
            fmt::format("The exponent {} of the sample count is out of its range 0.05 to 0.5.", how.exponent));
    if (!(how.interpolation_share >= 0.01 && how.interpolation_share <= 0.9) || !(how.removal_share >= 0.0) ||
        how.interpolation_share + how.removal_share > 1.0 || !(how.removal_hope >= 1.0))
        return option_refusal(
            "The parts of the tolerance must be positive and add up to 1 at most, and removal_hope be 1 or more.");
    return PieglTiller(analysis, input, distance, tolerance, options, how).run();
}

} // namespace laminate_offset
