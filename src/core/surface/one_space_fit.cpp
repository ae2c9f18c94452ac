// SPDX-License-Identifier: LGPL-2.1-or-later
#include "one_space_fit.h"

#include "certificate.h"
#include "fit_space.h"
#include "offset_samples.h"

#include "../spline/knot_choice.h"
#include "../spline/least_squares.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

// ||O - Lu Lv O|| <= ||O - Lu O|| + ||Lu|| ||O - Lv O||: each direction starts with a little more than half of the
// tolerance; the measured error then says by how much to move.
constexpr double first_direction_share = 0.55;
constexpr int most_rounds = 8;
// Proofs that leave more than this part of the least bound before: rounding, on spans too narrow for the size of the face, keeps the proof
// from coming any closer.
constexpr double in_vain = 0.95;
constexpr int most_rounds_in_vain = 2;
// A fit seen to take less than this part of the tolerance has been searched too closely. A wider search aims at what
// proofs hold with ease, since one that fails costs more than all the rest.
constexpr double close_share = 0.5;
constexpr double easily_proven_share = 0.8;
constexpr double widest = 2.5;      // times the tolerance before
constexpr double worth_less = 0.95; // part of the poles that a wider search has to leave
// A next round that needs more than this times the poles of the one before has outgrown its degrees.
constexpr double most_growth = 1.2;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int any_poles = std::numeric_limits<int>::max();
constexpr int spare_samples = 2;
// Places of a span at which the deviation is measured: where the certificate follows, for information only.
constexpr int checks_before_proof = 4;
constexpr int checks_without_proof = 9;

//! A grid dense in the spans of both directions, with the fits over it.
struct FitGrid
{
    std::vector<double> us;
    std::vector<double> vs;
    std::optional<LeastSquaresFit> fit_u;
    std::optional<LeastSquaresFit> fit_v;

    FitGrid(const BaseSurface &base, const KnotVector &u, const KnotVector &v)
        : us(span_parameters(u, base.interval_ends_u(), u.degree + 1 + spare_samples, 1)),
          vs(span_parameters(v, base.interval_ends_v(), v.degree + 1 + spare_samples, 1)),
          fit_u(LeastSquaresFit::make(u, us)), fit_v(LeastSquaresFit::make(v, vs))
    {
    }

    //! Poles (v pole x (3 u poles)) of the tensor-product fit to one row for each u.
    [[nodiscard]] RowMatrix solve(const RowMatrix &rows) const
    {
        return fit_v->solve(transposed_points(fit_u->solve(rows)));
    }
};

//! The poles of one distance; `weights` holds the weight of pole (i, j) at (j, 3 i).
std::vector<Eigen::Vector4d> homogeneous(const RowMatrix &net, const RowMatrix &weights, const Eigen::Vector3d &origin)
{
    std::vector<Eigen::Vector4d> poles;
    poles.reserve(static_cast<std::size_t>(net.size() / 3));
    for (Eigen::Index i = 0; i < net.cols(); i += 3)
        for (Eigen::Index j = 0; j < net.rows(); ++j)
        {
            const double w = weights(j, i);
            const Eigen::Vector3d point = net.row(j).segment<3>(i).transpose() + w * origin;
            poles.emplace_back(point.x(), point.y(), point.z(), w);
        }
    return poles;
}

//! Tensor-product least squares at every distance; a weight function is in the space of the fit and comes out exactly,
//! but for rounding. \return nothing where the samples do not determine the poles.
std::vector<TensorSpline> tensor_fits(OffsetSampler &sampler, const FitSpace &space)
{
    const FitGrid grid(sampler.base(), space.u, space.v);
    if (!grid.fit_u || !grid.fit_v)
        return {};
    const bool rational = sampler.denominator() == Denominator::BaseWeight;
    const RowMatrix weights =
        rational ? grid.solve(sampler.weight_rows(grid.us, grid.vs))
                 : RowMatrix::Ones(space.v.pole_count(), 3 * static_cast<Eigen::Index>(space.u.pole_count()));
    std::vector<TensorSpline> splines;
    for (const double distance : sampler.distances())
    {
        const RowMatrix net = grid.solve(sampler.rows(distance, grid.us, grid.vs, false));
        splines.push_back({space.u, space.v, homogeneous(net, weights, sampler.origin()), rational});
    }
    return splines;
}

//! An error bound, or an error seen, and where it is largest.
struct ErrorAt
{
    double error = 0.0;
    gp_Pnt2d uv;
};

//! Largest deviation from the exact offset between the samples of the fit; a model's error comes on top of it.
ErrorAt deviation(const BaseSurface &base, const TensorSpline &spline, double distance)
{
    const int checks = base.spline() ? checks_before_proof : checks_without_proof;
    const auto us = span_parameters(spline.u, base.interval_ends_u(), checks, 1);
    const auto vs = span_parameters(spline.v, base.interval_ends_v(), checks, 1);
    std::optional<gp_Pnt2d> singular;
    const std::vector<Eigen::Vector3d> exact = base.offset_grid(us, vs, distance, singular);
    if (singular)
        return {infinity, *singular};
    const std::vector<SurfaceJet> fitted = spline.jets(us, vs, 0);
    double worst = 0.0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < exact.size(); ++i)
        if (const double square = (exact[i] - fitted[i].s).squaredNorm(); !(square <= worst))
        {
            if (std::isnan(square))
                return {infinity, gp_Pnt2d(us[i / vs.size()], vs[i % vs.size()])};
            worst = square;
            at = i;
        }
    return {std::sqrt(worst) + base.model_error().of_offset(distance),
            gp_Pnt2d(us[at / vs.size()], vs[at % vs.size()])};
}

//! The certificate's bound over the trimmed region of a base that is a spline in its own parameters.
ErrorAt proven_bound(const SurfaceAnalysis &analysis, const TensorSpline &spline, double distance, double tolerance,
                     bool settle)
{
    const auto needed = [&](const ParameterBox &box) { return analysis.region.may_touch(box); };
    const double of_model = analysis.base.model_error().of_offset(distance);
    const Certificate certificate = certify(
        {*analysis.base.spline(), spline, distance, tolerance - of_model, needed, analysis.base.rounding(), settle});
    const ParameterBox &worst = certificate.worst;
    return {of_model + certificate.bound, gp_Pnt2d(0.5 * (worst.umin + worst.umax), 0.5 * (worst.vmin + worst.vmax))};
}

bool same(const FitSpace &a, const FitSpace &b)
{
    return a.u.degree == b.u.degree && a.v.degree == b.v.degree && a.u.knots == b.u.knots && a.v.knots == b.v.knots;
}

const ErrorAt &larger(const ErrorAt &a, const ErrorAt &b) { return b.error > a.error ? b : a; }

class OneSpaceFitter
{
public:
    explicit OneSpaceFitter(const OneSpaceRequest &request)
        : m_request(request), m_base(request.analysis.base), m_options(request.options),
          m_plain(m_base, request.distances, Denominator::One)
    {
        if (m_base.spline() && m_base.spline()->rational)
            m_rational.emplace(m_base, request.distances, Denominator::BaseWeight);
    }

    Result<OneSpaceFit> run()
    {
        double left = m_request.tolerance; // for the fit
        for (const double distance : m_request.distances)
            left = std::min(left, m_request.tolerance - m_base.model_error().of_offset(distance));
        double share = first_direction_share;
        int rounds_in_vain = 0; // of those that came to a proof
        double least_bound = infinity;
        std::optional<FitSpace> space_before;
        for (int round = 0; left > 0.0 && round < most_rounds; ++round)
        {
            if (cancelled(round, 0.0))
                return cancellation();
            std::optional<FitSpace> space = choose(share * left, space_before);
            if (m_plain.singular())
                return singular_refusal();
            if (!space)
                break;
            if (cancelled(round, 0.5))
                return cancellation();
            std::optional<Attempt> attempt = fit_over(std::move(*space));
            if (!attempt)
                break;
            if (cancelled(round, 0.7))
                return cancellation();
            if (std::optional<OneSpaceFit> lighter = with_fewer_poles(*attempt, share * left))
                return std::move(*lighter);
            const bool worth_proving = attempt->seen.error <= m_request.tolerance && m_base.spline();
            const ErrorAt worst = worth_proving ? proven_error(*attempt) : attempt->seen;
            if (worst.error <= m_request.tolerance)
                return std::move(attempt->fit);
            if (worth_proving)
            {
                rounds_in_vain = worst.error > in_vain * least_bound ? rounds_in_vain + 1 : 0;
                least_bound = std::min(least_bound, worst.error);
            }
            if (!m_closest || worst.error < m_closest->error)
                m_closest = worst;
            if (rounds_in_vain >= most_rounds_in_vain)
                break;
            if (attempt->extra >= m_request.tolerance) // a closer fit would not help
                break;
            share *= std::clamp(0.9 * m_request.tolerance / worst.error, 0.3, 0.8);
            if (worth_proving)
                m_unproven = attempt->space;
            space_before = std::move(attempt->space);
        }
        return unreached();
    }

private:
    //! The fits over one space.
    struct Attempt
    {
        FitSpace space;
        OneSpaceFit fit;
        double extra = 0.0; //!< what the caller adds to every error
        ErrorAt seen;       //!< largest deviation between the samples, `extra` included
    };

    //! \return nothing where the samples do not determine the poles.
    [[nodiscard]] std::optional<Attempt> fit_over(FitSpace space) const
    {
        Attempt attempt{std::move(space), {}, 0.0, {}};
        attempt.fit.splines = tensor_fits(*m_sampler, attempt.space);
        if (attempt.fit.splines.empty())
            return std::nullopt;
        attempt.extra = m_request.surcharge ? m_request.surcharge(attempt.fit.splines) : 0.0;
        attempt.seen = seen_error(attempt.fit, attempt.extra);
        return attempt;
    }

    //! Where an attempt is much closer than it needs to be, what a wider tolerance of both directions leads to from its
    //! knots, if that takes fewer poles and is proven.
    //! \param tolerance of the search that has led to the attempt.
    [[nodiscard]] std::optional<OneSpaceFit> with_fewer_poles(const Attempt &close, double tolerance) const
    {
        if (!m_base.spline() || !(close.seen.error < close_share * m_request.tolerance))
            return std::nullopt;
        const double widening = std::min(widest, easily_proven_share * m_request.tolerance / close.seen.error);
        std::optional<FitSpace> space =
            choose_space(*m_sampler, widening * tolerance, m_options, any_poles, &close.space);
        if (!space || space->poles() > worth_less * close.space.poles() || (m_unproven && same(*space, *m_unproven)))
            return std::nullopt;
        std::optional<Attempt> wider = fit_over(std::move(*space));
        if (!wider || wider->seen.error > easily_proven_share * m_request.tolerance)
            return std::nullopt;
        const bool proven = proven_error(*wider, true).error <= m_request.tolerance;
        return proven ? std::optional<OneSpaceFit>(std::move(wider->fit)) : std::nullopt;
    }

    //! The largest deviation of all distances between the samples of the fit.
    [[nodiscard]] ErrorAt seen_error(OneSpaceFit &fit, double extra) const
    {
        ErrorAt seen;
        for (std::size_t k = 0; k < fit.splines.size(); ++k)
            seen = larger(seen, deviation(m_base, fit.splines[k], m_request.distances[k]));
        seen.error += extra;
        fit.sampled_error = seen.error;
        return seen;
    }

    //! The largest proven bound of all distances.
    //! \param settle stop at the first rectangle that misses the tolerance: the bound is infinite then.
    ErrorAt proven_error(Attempt &attempt, bool settle = false) const
    {
        OneSpaceFit &fit = attempt.fit;
        const double target = m_request.tolerance - attempt.extra;
        ErrorAt proven;
        for (std::size_t k = 0; k < fit.splines.size() && proven.error <= m_request.tolerance; ++k)
            proven = larger(proven,
                            proven_bound(m_request.analysis, fit.splines[k], m_request.distances[k], target, settle));
        proven.error += attempt.extra;
        fit.certified_error = proven.error;
        return proven;
    }

    //! A rational base over its own weight function, and over one if that takes no more poles; what wins is kept to.
    //! \param before the space of the round before, which was not close enough.
    std::optional<FitSpace> choose(double tolerance, const std::optional<FitSpace> &before)
    {
        if (before)
        {
            const std::optional<FitSpace> closer = choose_space(*m_sampler, tolerance, m_options, any_poles, &*before);
            if (closer && closer->poles() <= most_growth * before->poles())
                return closer;
            const std::optional<FitSpace> afresh = choose_space(*m_sampler, tolerance, m_options);
            return afresh && (!closer || afresh->poles() <= closer->poles()) ? afresh : closer;
        }
        m_sampler = &m_plain;
        if (!m_rational)
            return choose_space(m_plain, tolerance, m_options);
        const std::optional<FitSpace> rational = choose_space(*m_rational, tolerance, m_options);
        if (!rational)
            return choose_space(m_plain, tolerance, m_options);
        const std::optional<FitSpace> plain = choose_space(m_plain, tolerance, m_options, rational->poles());
        if (plain && plain->poles() <= rational->poles())
            return plain;
        m_sampler = &*m_rational;
        return rational;
    }

    [[nodiscard]] bool cancelled(int round, double part) const
    {
        return m_options.progress && !m_options.progress((round + part) / most_rounds);
    }

    [[nodiscard]] static Failure cancellation()
    {
        return {Status::Cancelled, Stage::Surface, "The computation was cancelled during the surface fit.",
                std::nullopt, std::nullopt};
    }

    [[nodiscard]] Failure singular_refusal() const
    {
        return {Status::SingularNormal, Stage::Surface,
                "The surface has no normal at the reported place; trim the face clear of it.",
                m_request.input.place(*m_plain.singular()), std::nullopt};
    }

    [[nodiscard]] Failure unreached() const
    {
        const ParameterBox &box = m_base.box();
        const ErrorAt closest =
            m_closest.value_or(ErrorAt{infinity, gp_Pnt2d(0.5 * (box.umin + box.umax), 0.5 * (box.vmin + box.vmax))});
        const std::string reached = std::isfinite(closest.error)
                                        ? fmt::format("closest {:.3g} mm, at the reported place", closest.error)
                                        : "no bound was found at the reported place";
        return {Status::ToleranceNotReached, Stage::Surface,
                fmt::format("The offset surface could not be proven to be within {:.3g} mm ({}); loosen the "
                            "tolerance or allow a higher degree.",
                            m_request.tolerance, reached),
                m_request.input.place(closest.uv), std::nullopt};
    }

    const OneSpaceRequest &m_request;
    const BaseSurface &m_base;
    const OffsetOptions &m_options;
    OffsetSampler m_plain;
    std::optional<OffsetSampler> m_rational;
    OffsetSampler *m_sampler = nullptr;
    std::optional<ErrorAt> m_closest;
    std::optional<FitSpace> m_unproven; //!< the last space whose fit could not be proven
};

} // namespace

Result<OneSpaceFit> fit_in_one_space(const OneSpaceRequest &request) { return OneSpaceFitter(request).run(); }

} // namespace laminate_offset
