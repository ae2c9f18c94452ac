// SPDX-License-Identifier: LGPL-2.1-or-later
#include "edge_certificate.h"

#include "../spline/vector_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
// Part of the target that a remainder, or a knot line that is strayed over, may take.
constexpr double remainder_share = 1e-4;
constexpr double straying_share = 1e-3;
// Formal degrees up to this are taken as they are; a higher one may well be needless.
constexpr int low_degree = 10;
constexpr int highest_degree = 90;
constexpr double ellipses[] = {1.5, 2.0, 3.0, 4.0, 6.0, 9.0, 14.0, 22.0};
// Chebyshev points for each degree: 1 / cos(pi / 6) = 1.155.
constexpr int points_per_degree = 3;
constexpr int deepest = 48;
constexpr int most_intervals = 5000;
constexpr double nearest_cut = 1e-6;
// A pcurve may leave the surface's domain by this part of it: the last polynomials go on there. Beyond that nothing is known
// of the surface's own error, and nothing is proven.
constexpr double admissible_overhang = 1e-9;

//! The polynomial that f is up to a remainder.
struct Approximation
{
    int degree = std::numeric_limits<int>::max();
    double remainder = infinity;
};

class EdgeProver
{
public:
    explicit EdgeProver(const EdgeProof &proof) : m_proof(proof) {}

    [[nodiscard]] double prove()
    {
        return largest_between(analytic_ends(m_proof.pcurve, m_proof.curve, m_proof.first, m_proof.last),
                               [this](double low, double high) { return cover(low, high, 0); });
    }

private:
    struct Interval
    {
        CurvePiece pcurve;
        CurvePiece curve;
        CurveReach reach;
        CurveRange range;
        AnalyticSurface::Cell cell;
        double speed[2];    //!< of the surface
        double straying[2]; //!< how far the pcurve may go over the cell's ends, times the speed [mm]
    };

    [[nodiscard]] Interval interval(double a, double b) const
    {
        Interval result{CurvePiece(m_proof.pcurve, a, b), CurvePiece(m_proof.curve, a, b), {}, {}, {}, {}, {}};
        const Eigen::Vector3d &middle = result.pcurve.middle();
        result.reach = result.pcurve.reach(1.0);
        result.range = result.pcurve.range();
        const Eigen::Vector3d &slack = result.pcurve.rounding();
        result.cell = m_proof.surface.cell_at(middle.x(), middle.y());
        for (int direction = 0; direction < 2; ++direction)
        {
            result.speed[direction] = m_proof.surface.speed(direction, std::abs(middle.y()) + result.reach.total.y());
            const AnalyticSurface::Ends ends = m_proof.surface.ends(result.cell, direction);
            const double over = slack[direction] + std::max({-slack[direction], ends.low - result.range.low[direction],
                                                             result.range.high[direction] - ends.high});
            result.straying[direction] = straying_bound(over, ends) * result.speed[direction];
        }
        return result;
    }

    //! Both the surface and the polynomial of the cell, which goes on, move away from the knot line.
    static double straying_bound(double over, const AnalyticSurface::Ends &ends)
    {
        if (over == 0.0)
            return 0.0;
        const double growth = 1.0 + 2.0 * over / (ends.high - ends.low);
        return over * (1.0 + std::pow(growth, max_spline_degree));
    }

    //! Bound over [a, b]; halves it where that is needed.
    [[nodiscard]] double cover(double a, double b, int depth)
    {
        if (depth > deepest || ++m_intervals > most_intervals)
            return infinity;
        const Interval here = interval(a, b);
        if (overhang({here.pcurve.middle(), here.pcurve.middle()}) > 0.0)
            return infinity;
        const bool hangs_over = overhang(here.range) > 0.0;
        const double straying = here.straying[0] + here.straying[1];
        const Eigen::Vector3d &slack = here.pcurve.rounding();
        const bool strays = straying > std::max(straying_share * m_proof.target,
                                                8.0 * (here.speed[0] * slack.x() + here.speed[1] * slack.y()));
        const Approximation approximation = strays || hangs_over ? Approximation{} : approximate(here);
        if (approximation.degree <= highest_degree)
            return bound(here, approximation) + straying;
        const double middle = strays ? crossing(here) : 0.5 * (a + b);
        if (!(middle > a && middle < b))
            return infinity;
        const double lower = cover(a, middle, depth + 1);
        return lower < infinity ? larger_bound(lower, cover(middle, b, depth + 1)) : infinity;
    }

    //! How far a box reaches out of the surface's domain beyond what is admissible.
    [[nodiscard]] double overhang(const CurveRange &box) const
    {
        double over = 0.0;
        for (int direction = 0; direction < 2; ++direction)
        {
            const AnalyticSurface::Ends domain = m_proof.surface.domain(direction);
            const double outside = std::max(domain.low - box.low[direction], box.high[direction] - domain.high);
            over = std::max(over, outside - admissible_overhang * (domain.high - domain.low));
        }
        return over;
    }

    //! Where the pcurve crosses the knot line that it strays over the most, else the middle.
    [[nodiscard]] double crossing(const Interval &here) const
    {
        const int direction = here.straying[0] >= here.straying[1] ? 0 : 1;
        const AnalyticSurface::Ends ends = m_proof.surface.ends(here.cell, direction);
        const bool below = ends.low - here.range.low[direction] > here.range.high[direction] - ends.high;
        const double knot = below ? ends.low : ends.high;
        const auto height = [&](double t) { return here.pcurve.value(t)[direction] - knot; };
        double a = here.pcurve.a();
        double b = here.pcurve.b();
        double at_a = height(a);
        double at_b = height(b);
        if (!(at_a * at_b < 0.0))
            return 0.5 * (a + b);
        const double exact = 4.0 * here.pcurve.rounding()[direction];
        double t = 0.5 * (a + b);
        for (int step = 0; step < 60; ++step)
        {
            const double secant = a + (b - a) * at_a / (at_a - at_b); // every third step halves, come what may
            t = step % 3 == 2 ? 0.5 * (a + b) : secant;
            const double at_t = height(t);
            if (std::abs(at_t) <= exact)
                break;
            (at_t * at_a > 0.0 ? a : b) = t;
            (at_t * at_a > 0.0 ? at_a : at_b) = at_t;
        }
        // an end that lies on the knot line already is no place to cut
        const double from_end = std::min(t - here.pcurve.a(), here.pcurve.b() - t);
        return from_end > nearest_cut * (here.pcurve.b() - here.pcurve.a()) ? t
                                                                            : 0.5 * (here.pcurve.a() + here.pcurve.b());
    }

    [[nodiscard]] Approximation approximate(const Interval &here) const
    {
        const Eigen::Vector3d &slack = here.pcurve.rounding();
        const std::optional<int> along =
            m_proof.surface.composed_degree(here.pcurve.degree(0, slack.x()), here.pcurve.degree(1, slack.y()));
        std::optional<int> own = 0;
        for (int e = 0; e < 3 && own; ++e)
        {
            const std::optional<int> degree = here.curve.degree(e, 0.0);
            own = degree ? std::optional<int>(std::max(*own, *degree)) : std::nullopt;
        }
        Approximation best;
        if (along && own)
            best = {std::max(*along, *own), 0.0};
        if (best.degree <= low_degree)
            return best;
        const double small = remainder_share * m_proof.target;
        const AnalyticSurface::Patch patch = m_proof.surface.patch(here.cell, here.pcurve.middle(), here.reach);
        for (const double rho : ellipses)
        {
            const double size = m_proof.surface.growth(patch, here.pcurve.reach(rho)) +
                                (own ? 0.0 : here.curve.reach(rho).total.norm());
            const double degrees = std::ceil(std::log(2.0 * size / ((rho - 1.0) * small)) / std::log(rho));
            if (!(degrees < best.degree))
                continue;
            const int degree = std::max({0, own.value_or(0), static_cast<int>(degrees)});
            if (degree < best.degree)
                best = {degree, small};
        }
        return best;
    }

    [[nodiscard]] double bound(const Interval &here, const Approximation &approximation) const
    {
        const int groups = points_per_degree * approximation.degree / lanes + 1;
        const int points = groups * lanes;
        const double middle = 0.5 * (here.pcurve.a() + here.pcurve.b());
        const double half = 0.5 * (here.pcurve.b() - here.pcurve.a());
        const AnalyticSurface::OnCell surface(m_proof.surface, here.cell);
        using Rows = Eigen::Array<double, lanes, 3>;
        Rows uv, in_space, on_surface;
        Eigen::Array<double, lanes, 1> t;
        double square = 0.0;
        for (int group = 0; group < groups; ++group)
        {
            for (int k = 0; k < lanes; ++k)
                t[k] = middle + half * std::cos(M_PI * (group * lanes + k + 0.5) / points);
            here.pcurve.lane_values(t.data(), uv.data());
            here.curve.lane_values(t.data(), in_space.data());
            surface.lane_values(uv.data(), uv.data() + lanes, on_surface.data());
            const Eigen::Array<double, lanes, 1> squares = (in_space - on_surface).square().rowwise().sum();
            square = larger_bound(square, squares.maxCoeff<Eigen::PropagateNaN>());
        }
        const Eigen::Vector3d &slack = here.pcurve.rounding();
        const double uv_rounding = here.speed[0] * slack.x() + here.speed[1] * slack.y();
        const double rounding = m_proof.surface.rounding(std::abs(here.pcurve.middle().y()) + here.reach.total.y()) +
                                here.curve.rounding().norm();
        const double remainder = approximation.remainder + 3.0 * uv_rounding;
        const double factor = (1.0 + 1e-9) / std::cos(M_PI * approximation.degree / (2.0 * points));
        return factor * (std::sqrt(square) + rounding + remainder) + remainder + rounding;
    }

    const EdgeProof &m_proof;
    int m_intervals = 0;
};

} // namespace

double proven_deviation(const EdgeProof &proof) { return EdgeProver(proof).prove(); }

} // namespace laminate_offset
