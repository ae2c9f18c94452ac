// SPDX-License-Identifier: LGPL-2.1-or-later
#include "variable_offset.h"

#include "../spline/knot_choice.h"
#include "../spline/spline_pieces.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace laminate_offset
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();
// Rounding of a piece's coefficients: some 160 operations of extraction and halving, and sums of a few hundred products
// for d N^, all relative to the largest coordinates that take part.
constexpr double operations = 1024.0;
constexpr int most_halvings = 12;
// As in a fit of one distance: each direction starts with a little more than half of the tolerance.
constexpr double first_direction_share = 0.55;
constexpr int most_rounds = 8;
constexpr int spare_samples = 2;
constexpr int least_rows = 12;
constexpr int rows_per_interval = 2;

//! W = omega O - (S^ + d N^) on one rectangle; omega is the family's weight function.
struct DifferencePiece
{
    RationalPiece difference;
    double rounding = 0.0; //!< bound of the rounding of W / omega [mm]

    double prove(double target, int depth = 0)
    {
        const Bernstein::Range weights = difference.omega.range();
        if (!(weights.low > 0.0))
            return infinity;
        const double bound = longest(difference.numerator) / weights.low * (1.0 + 8.0 * epsilon) + rounding;
        if (bound <= target || depth >= most_halvings || difference.centre().norm() > target)
            return bound;
        DifferencePiece upper{{}, rounding};
        difference.halve(depth % 2 == 0, upper.difference);
        const double first = prove(target, depth + 1);
        if (first > target)
            return bound;
        const double second = upper.prove(target, depth + 1);
        return second > target ? bound : std::max(first, second);
    }
};

//! Cuts the family, the distance and the fit along their merged knots.
class DifferenceCutter
{
public:
    DifferenceCutter(const OffsetFamily &family, const TensorSpline &distance, const TensorSpline &offset)
        : m_us(merged_breaks(merged_breaks(family.position.u.breaks(), distance.u.breaks()), offset.u.breaks())),
          m_vs(merged_breaks(merged_breaks(family.position.v.breaks(), distance.v.breaks()), offset.v.breaks())),
          m_position(family.position, m_us, m_vs), m_direction(family.direction, m_us, m_vs),
          m_distance(distance, m_us, m_vs), m_offset(offset, m_us, m_vs)
    {
    }

    [[nodiscard]] std::size_t count_u() const { return m_us.size() - 1; }
    [[nodiscard]] std::size_t count_v() const { return m_vs.size() - 1; }
    [[nodiscard]] ParameterBox box(std::size_t i, std::size_t j) const
    {
        return {m_us[i], m_us[i + 1], m_vs[j], m_vs[j + 1]};
    }

    DifferencePiece cut(std::size_t i, std::size_t j)
    {
        const Eigen::Vector3d origin = m_offset.near_point(i, j);
        m_position.cut(i, j, origin, m_s);
        m_direction.cut(i, j, Eigen::Vector3d::Zero(), m_n);
        m_distance.cut(i, j, Eigen::Vector3d::Zero(), m_d);
        m_offset.cut(i, j, origin, m_o);
        DifferencePiece piece;
        piece.difference.omega = m_s.omega;
        const Bernstein &d = m_d.numerator[0];
        for (std::size_t e = 0; e < 3; ++e)
        {
            assign_product(m_o.numerator[e], m_s.omega, m_weighted);
            assign_product(d, m_n.numerator[e], m_lifted);
            Bernstein &w = piece.difference.numerator[e];
            const Bernstein *const parts[] = {&m_weighted, &m_lifted, &m_s.numerator[e]};
            int m = 0;
            int n = 0;
            for (const Bernstein *part : parts)
            {
                m = std::max(m, part->degree_u());
                n = std::max(n, part->degree_v());
            }
            w.reset(m, n);
            w.add_raised(1.0, m_weighted);
            w.add_raised(-1.0, m_lifted);
            w.add_raised(-1.0, m_s.numerator[e]);
        }
        const Bernstein::Range weights = m_s.omega.range();
        const double size = std::max({longest(m_s.numerator), longest(m_o.numerator) * weights.high,
                                      origin.norm() * weights.high, d.range().size() * longest(m_n.numerator)});
        piece.rounding = operations * epsilon * size / weights.low * (weights.high / weights.low);
        return piece;
    }

private:
    std::vector<double> m_us;
    std::vector<double> m_vs;
    SplinePieces m_position;
    SplinePieces m_direction;
    SplinePieces m_distance;
    SplinePieces m_offset;
    RationalPiece m_s, m_n, m_d, m_o;
    Bernstein m_weighted, m_lifted;
};

//! Breaks of two splines, with the lower continuity where they share one.
std::vector<DataBreak> breaks_of(const KnotVector &a, const KnotVector &b)
{
    std::vector<DataBreak> breaks;
    for (const KnotVector *kv : {&a, &b})
        for (const SmoothnessBreak &at : spline_breaks(*kv))
            breaks.push_back({at.parameter, at.continuity});
    std::sort(breaks.begin(), breaks.end(), [](const DataBreak &x, const DataBreak &y) {
        return x.parameter != y.parameter ? x.parameter < y.parameter : x.continuity < y.continuity;
    });
    const double same = 1e-12 * (a.back() - a.front());
    std::vector<DataBreak> merged;
    for (const DataBreak &at : breaks)
        if (merged.empty() || at.parameter - merged.back().parameter > same)
            merged.push_back(at);
        else
            merged.back().continuity = std::min(merged.back().continuity, at.continuity);
    return merged;
}

class VariableFitter
{
public:
    explicit VariableFitter(const VariableOffsetRequest &request)
        : m_request(request), m_distance(request.distance),
          m_ends_u(merged_breaks(request.family.position.u.breaks(), request.distance.u.breaks())),
          m_ends_v(merged_breaks(request.family.position.v.breaks(), request.distance.v.breaks()))
    {
        m_origin = points({m_ends_u.front()}, {m_ends_v.front()}).front();
    }

    Result<OffsetSurface> run()
    {
        const OffsetFamily &family = m_request.family;
        if (m_distance.low() < family.low || m_distance.high() > family.high)
            return Failure{Status::InvalidDistance, Stage::Surface,
                           fmt::format("The distance runs from {} to {} mm and leaves its family's interval from {} to "
                                       "{} mm; fit the family for all of it.",
                                       m_distance.low(), m_distance.high(), family.low, family.high),
                           std::nullopt, std::nullopt};
        const double of_family = family.certified_error.value_or(family.sampled_error);
        const double left = m_request.tolerance - of_family;
        double share = first_direction_share;
        double closest = infinity;
        for (int round = 0; left > 0.0 && round < most_rounds; ++round)
        {
            if (m_request.options.progress && !m_request.options.progress(static_cast<double>(round) / most_rounds))
                return Failure{Status::Cancelled, Stage::Surface,
                               "The computation was cancelled during a fit over ramps.", std::nullopt, std::nullopt};
            const std::optional<TensorSpline> spline = fitted(share * left);
            if (!spline)
                break;
            const Certificate proof = certify_variable(family, m_distance, *spline, left, m_request.needed);
            if (proof.proven)
                return surface(*spline, of_family + proof.bound);
            m_worst = proof.worst;
            closest = std::min(closest, of_family + proof.bound);
            share *= std::clamp(0.9 * left / proof.bound, 0.3, 0.8);
        }
        return unreached(closest);
    }

private:
    [[nodiscard]] OffsetSurface surface(const TensorSpline &spline, double bound) const
    {
        OffsetSurface result;
        result.geometry = to_geom(spline);
        (m_request.family.certified_error ? result.certified_error : result.sampled_error) = bound;
        return result;
    }

    //! S^ + d N^ on a grid.
    [[nodiscard]] std::vector<Eigen::Vector3d> points(const std::vector<double> &us,
                                                      const std::vector<double> &vs) const
    {
        const std::vector<SurfaceJet> s = m_request.family.position.jets(us, vs, 0);
        const std::vector<SurfaceJet> n = m_request.family.direction.jets(us, vs, 0);
        const std::vector<double> d = m_distance.values(us, vs);
        std::vector<Eigen::Vector3d> result(s.size());
        for (std::size_t i = 0; i < s.size(); ++i)
            result[i] = s[i].s + d[i] * n[i].s;
        return result;
    }

    //! The same relative to the origin, one row for each u, or transposed for each v.
    [[nodiscard]] RowMatrix rows(const std::vector<double> &us, const std::vector<double> &vs, bool transposed) const
    {
        const std::vector<Eigen::Vector3d> all = points(us, vs);
        const auto nu = static_cast<Eigen::Index>(us.size());
        const auto nv = static_cast<Eigen::Index>(vs.size());
        RowMatrix result(transposed ? nv : nu, 3 * (transposed ? nu : nv));
        for (Eigen::Index k = 0; k < nu; ++k)
            for (Eigen::Index l = 0; l < nv; ++l)
                result.row(transposed ? l : k).segment<3>(3 * (transposed ? k : l)) =
                    (all[static_cast<std::size_t>(k * nv + l)] - m_origin).transpose();
        return result;
    }

    [[nodiscard]] static std::vector<double> row_parameters(const std::vector<double> &ends)
    {
        const int intervals = static_cast<int>(ends.size()) - 1;
        return chebyshev_parameters(ends, std::max(rows_per_interval, (least_rows + intervals - 1) / intervals));
    }

    [[nodiscard]] std::optional<KnotChoice> choose(bool along_u, double tolerance) const
    {
        const KnotVector &of_family = along_u ? m_request.family.position.u : m_request.family.position.v;
        const std::vector<double> lines = row_parameters(along_u ? m_ends_v : m_ends_u);
        KnotProblem problem;
        problem.low = of_family.front();
        problem.high = of_family.back();
        problem.breaks = breaks_of(of_family, along_u ? m_distance.u : m_distance.v);
        problem.sample = [&](const std::vector<double> &at) {
            return along_u ? rows(at, lines, false) : rows(lines, at, true);
        };
        problem.tolerance = tolerance;
        problem.max_degree = m_request.options.max_degree;
        return choose_knots(problem);
    }

    //! Knots of each direction on its own, then one tensor-product least-squares solve.
    [[nodiscard]] std::optional<TensorSpline> fitted(double tolerance) const
    {
        std::optional<KnotChoice> u;
        std::optional<KnotChoice> v;
        tbb::parallel_invoke([&] { u = choose(true, tolerance); }, [&] { v = choose(false, tolerance); });
        if (!u || !v)
            return std::nullopt;
        const auto us = span_parameters(u->knots, m_ends_u, u->knots.degree + 1 + spare_samples, 1);
        const auto vs = span_parameters(v->knots, m_ends_v, v->knots.degree + 1 + spare_samples, 1);
        const auto fit_u = LeastSquaresFit::make(u->knots, us);
        const auto fit_v = LeastSquaresFit::make(v->knots, vs);
        if (!fit_u || !fit_v)
            return std::nullopt;
        const RowMatrix net = fit_v->solve(transposed_points(fit_u->solve(rows(us, vs, false))));
        TensorSpline spline{u->knots, v->knots, {}, false};
        spline.poles.reserve(static_cast<std::size_t>(net.size() / 3));
        for (Eigen::Index i = 0; i < net.cols(); i += 3)
            for (Eigen::Index j = 0; j < net.rows(); ++j)
            {
                const Eigen::Vector3d point = net.row(j).segment<3>(i).transpose() + m_origin;
                spline.poles.emplace_back(point.x(), point.y(), point.z(), 1.0);
            }
        return spline;
    }

    [[nodiscard]] Failure unreached(double closest) const
    {
        const gp_Pnt2d uv(0.5 * (m_worst.umin + m_worst.umax), 0.5 * (m_worst.vmin + m_worst.vmax));
        const std::string reached =
            std::isfinite(closest) ? fmt::format("closest {:.3g} mm", closest) : "no bound found";
        return {Status::ToleranceNotReached, Stage::Surface,
                fmt::format("The surface over the ramps could not be proven to be within {:.3g} mm ({}); loosen the "
                            "tolerance, allow a higher degree or make the ramps longer.",
                            m_request.tolerance, reached),
                m_request.input.place(uv), std::nullopt};
    }

    const VariableOffsetRequest &m_request;
    const ScalarSpline &m_distance;
    std::vector<double> m_ends_u;
    std::vector<double> m_ends_v;
    Eigen::Vector3d m_origin;
    ParameterBox m_worst;
};

} // namespace

Certificate certify_variable(const OffsetFamily &family, const ScalarSpline &distance, const TensorSpline &offset,
                             double target, const RectangleFilter &needed)
{
    const TensorSpline lifted = distance.as_surface();
    const DifferenceCutter pattern(family, lifted, offset);
    Certificate certificate;
    std::mutex guard;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pattern.count_u()), [&](const auto &range) {
        DifferenceCutter cutter = pattern;
        Certificate here;
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            for (std::size_t j = 0; j < cutter.count_v(); ++j)
            {
                if (needed && !needed(cutter.box(i, j)))
                    continue;
                const double bound = cutter.cut(i, j).prove(target);
                if (!(bound <= here.bound)) // also where it is no number
                    here = {std::isnan(bound) ? infinity : bound, false, cutter.box(i, j)};
            }
        const std::lock_guard lock(guard);
        if (here.bound > certificate.bound)
            certificate = here;
    });
    certificate.proven = certificate.bound <= target;
    return certificate;
}

Result<OffsetSurface> fit_variable_offset(const VariableOffsetRequest &request)
{
    return VariableFitter(request).run();
}

} // namespace laminate_offset
