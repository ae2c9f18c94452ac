// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_surface.h"

#include "certificate.h"

#include "../spline/knot_choice.h"
#include "../spline/least_squares.h"

#include <fmt/format.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace laminate_offset
{
namespace
{

// ||O - Lu Lv O|| <= ||O - Lu O|| + ||Lu|| ||O - Lv O||: each direction starts with nearly half of the
// tolerance; the measured error then says by how much to move.
constexpr double first_direction_share = 0.47;
constexpr int most_rounds = 8;
constexpr int least_rows = 12;
constexpr int spare_samples = 2;
// Places of a span at which the deviation is measured: where the certificate follows, for information only.
constexpr int checks_before_proof = 4;
constexpr int checks_without_proof = 9;

std::vector<double> row_parameters(const std::vector<double> &ends)
{
    const int intervals = static_cast<int>(ends.size()) - 1;
    return chebyshev_parameters(ends, (least_rows + intervals - 1) / intervals);
}

//! The offset of a C^k surface is C^(k-1) at its knots; a crease has been refused before, so at least C^0.
std::vector<DataBreak> data_breaks(const std::vector<SmoothnessBreak> &breaks)
{
    std::vector<DataBreak> result;
    for (const SmoothnessBreak &b : breaks)
        result.push_back({b.parameter, std::max(0, b.continuity - 1)});
    return result;
}

//! Samples of the exact offset relative to a point near the face, so that rounding scales with the
//! face and not with its distance from the origin.
class OffsetSampler
{
public:
    OffsetSampler(const BaseSurface &base, double distance) : m_base(base), m_distance(distance)
    {
        const ParameterBox &box = base.box();
        m_origin = base.jets({0.5 * (box.umin + box.umax)}, {0.5 * (box.vmin + box.vmax)}, 0).front().s;
    }

    //! One row for each u, the points of all v in it; transposed: one row for each v. Where there is no normal the
    //! points are left at zero, and the place is kept. Safe to share between threads.
    RowMatrix rows(const std::vector<double> &us, const std::vector<double> &vs, bool transposed)
    {
        std::optional<gp_Pnt2d> singular;
        const std::vector<Eigen::Vector3d> points = m_base.offset_grid(us, vs, m_distance, singular);
        if (singular)
            keep(*singular);
        const auto nu = static_cast<Eigen::Index>(us.size());
        const auto nv = static_cast<Eigen::Index>(vs.size());
        RowMatrix result = transposed ? RowMatrix::Zero(nv, 3 * nu) : RowMatrix::Zero(nu, 3 * nv);
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const Eigen::Index k = static_cast<Eigen::Index>(i) / nv;
            const Eigen::Index l = static_cast<Eigen::Index>(i) % nv;
            result.row(transposed ? l : k).segment<3>(3 * (transposed ? k : l)) = (points[i] - m_origin).transpose();
        }
        return result;
    }

    [[nodiscard]] const std::optional<gp_Pnt2d> &singular() const { return m_singular; }
    [[nodiscard]] const Eigen::Vector3d &origin() const { return m_origin; }

private:
    void keep(const gp_Pnt2d &singular)
    {
        const std::lock_guard lock(m_guard);
        m_singular = singular;
    }

    const BaseSurface &m_base;
    double m_distance;
    Eigen::Vector3d m_origin;
    std::mutex m_guard;
    std::optional<gp_Pnt2d> m_singular;
};

//! Tensor-product least squares on a grid of samples dense in both directions' spans.
std::optional<TensorSpline> tensor_fit(const BaseSurface &base, OffsetSampler &sampler, const KnotVector &u,
                                       const KnotVector &v)
{
    const auto parameters = [](const KnotVector &kv, const std::vector<double> &base_ends) {
        return span_parameters(kv, base_ends, kv.degree + 1 + spare_samples, 1);
    };
    const std::vector<double> us = parameters(u, base.interval_ends_u());
    const std::vector<double> vs = parameters(v, base.interval_ends_v());
    const auto fit_u = LeastSquaresFit::make(u, us);
    const auto fit_v = LeastSquaresFit::make(v, vs);
    if (!fit_u || !fit_v)
        return std::nullopt;
    const RowMatrix by_u = fit_u->solve(sampler.rows(us, vs, false)); // pole_u x (3 vs)
    const RowMatrix net = fit_v->solve(transposed_points(by_u));      // pole_v x (3 pole_u)
    TensorSpline spline;
    spline.u = u;
    spline.v = v;
    spline.poles.reserve(static_cast<std::size_t>(net.rows() * by_u.rows()));
    for (Eigen::Index i = 0; i < by_u.rows(); ++i)
        for (Eigen::Index j = 0; j < net.rows(); ++j)
        {
            const Eigen::Vector3d point = net.row(j).segment<3>(3 * i).transpose() + sampler.origin();
            spline.poles.emplace_back(point.x(), point.y(), point.z(), 1.0);
        }
    return spline;
}

//! Largest deviation from the exact offset between the samples of the fit; a model's error comes on top of it.
double deviation(const BaseSurface &base, const TensorSpline &spline, double distance)
{
    const int checks = base.spline() ? checks_before_proof : checks_without_proof;
    const auto us = span_parameters(spline.u, base.interval_ends_u(), checks, 1);
    const auto vs = span_parameters(spline.v, base.interval_ends_v(), checks, 1);
    std::optional<gp_Pnt2d> singular;
    const std::vector<Eigen::Vector3d> exact = base.offset_grid(us, vs, distance, singular);
    if (singular)
        return std::numeric_limits<double>::infinity();
    const std::vector<SurfaceJet> fitted = spline.jets(us, vs, 0);
    double worst = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i)
        worst = std::max(worst, (exact[i] - fitted[i].s).squaredNorm());
    return std::sqrt(worst) + base.model_error().of_offset(distance);
}

//! The certificate's bound over the trimmed region; nothing for a base that is no spline in its own parameters.
std::optional<double> proven_bound(const SurfaceAnalysis &analysis, const TensorSpline &spline, double distance,
                                   double tolerance)
{
    if (!analysis.base.spline())
        return std::nullopt;
    const auto needed = [&](const ParameterBox &box) { return analysis.region.may_touch(box); };
    const double of_model = analysis.base.model_error().of_offset(distance);
    return of_model + certify({*analysis.base.spline(), spline, distance, tolerance - of_model, needed}).bound;
}

struct DirectionChoices
{
    std::optional<KnotChoice> u;
    std::optional<KnotChoice> v;
};

//! Both directions at once: they share nothing but the base.
DirectionChoices choose_directions(const BaseSurface &base, OffsetSampler &sampler, double tolerance,
                                   const OffsetOptions &options)
{
    const ParameterBox &box = base.box();
    const std::vector<double> rows_u = row_parameters(base.interval_ends_u());
    const std::vector<double> rows_v = row_parameters(base.interval_ends_v());
    KnotProblem along_u;
    along_u.tolerance = tolerance;
    along_u.max_degree = options.max_degree;
    KnotProblem along_v = along_u;
    along_u.low = box.umin;
    along_u.high = box.umax;
    along_u.breaks = data_breaks(base.breaks_u());
    along_u.sample = [&](const std::vector<double> &us) { return sampler.rows(us, rows_v, false); };
    along_v.low = box.vmin;
    along_v.high = box.vmax;
    along_v.breaks = data_breaks(base.breaks_v());
    along_v.sample = [&](const std::vector<double> &vs) { return sampler.rows(rows_u, vs, true); };
    DirectionChoices choices;
    tbb::parallel_invoke([&] { choices.u = choose_knots(along_u); }, [&] { choices.v = choose_knots(along_v); });
    return choices;
}

Failure refusal(Status status, std::string message, std::optional<Where> where = std::nullopt)
{
    return {status, Stage::Surface, std::move(message), where, std::nullopt};
}

Failure singular_refusal(const InputFace &input, const gp_Pnt2d &uv)
{
    return refusal(Status::SingularNormal,
                   "The surface has no normal at the reported place; trim the face clear of it.", input.place(uv));
}

Failure cancellation() { return refusal(Status::Cancelled, "The computation was cancelled during the surface fit."); }

} // namespace

Result<OffsetSurface> fit_offset(const SurfaceAnalysis &analysis, const InputFace &input, double distance,
                                 double tolerance, const OffsetOptions &options)
{
    const BaseSurface &base = analysis.base;
    OffsetSampler sampler(base, distance);
    const double left = tolerance - base.model_error().of_offset(distance); // for the fit
    double share = first_direction_share;
    double closest = std::numeric_limits<double>::infinity();
    for (int round = 0; left > 0.0 && round < most_rounds; ++round)
    {
        const auto cancelled = [&](double part) {
            return options.progress && !options.progress((round + part) / most_rounds);
        };
        if (cancelled(0.0))
            return cancellation();
        const DirectionChoices choices = choose_directions(base, sampler, share * left, options);
        if (sampler.singular())
            return singular_refusal(input, *sampler.singular());
        if (!choices.u || !choices.v)
            break;
        if (cancelled(0.5))
            return cancellation();
        const std::optional<TensorSpline> spline = tensor_fit(base, sampler, choices.u->knots, choices.v->knots);
        if (!spline)
            break;
        const double seen = deviation(base, *spline, distance);
        if (cancelled(0.7))
            return cancellation();
        const std::optional<double> proven =
            seen <= tolerance ? proven_bound(analysis, *spline, distance, tolerance) : std::nullopt;
        const double error = std::max(seen, proven.value_or(0.0));
        closest = std::min(closest, error);
        if (error <= tolerance)
            return OffsetSurface{to_geom(*spline), {0.0, 0.0}, proven, seen};
        share *= std::clamp(0.9 * tolerance / error, 0.3, 0.8);
    }
    return refusal(
        Status::ToleranceNotReached,
        fmt::format("The offset surface could not be proven to be within {:.3g} mm (closest {:.3g} mm); loosen the "
                    "tolerance or allow a higher degree.",
                    tolerance, closest));
}

} // namespace laminate_offset
