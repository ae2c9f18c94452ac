// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_curve_certificate.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace laminate_offset
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr int points_per_degree = 3;
constexpr int highest_degree = 400;
constexpr int deepest = 40;
constexpr int most_intervals = 4000;
constexpr int most_cells = 4;
// Rounding of a derivative: sums of (degree + 1)^2 products, each with some ten factors.
constexpr double derivative_operations = 400.0;
// |M| must not vary by more than this part of it over a piece.
constexpr double widest_turn = 0.7;

//! Numerator and weight of the base with their first derivatives on one cell.
struct HomogeneousJet
{
    Eigen::Vector4d s = Eigen::Vector4d::Zero();
    Eigen::Vector4d u = Eigen::Vector4d::Zero();
    Eigen::Vector4d v = Eigen::Vector4d::Zero();
};

class OffsetCurveProver
{
public:
    explicit OffsetCurveProver(const OffsetCurveProof &proof) : m_proof(proof), m_base(*proof.base.spline())
    {
        for (const Eigen::Vector4d &pole : m_base.poles)
        {
            m_size = std::max(m_size, pole.head<3>().norm());
            m_weights.low = std::min(m_weights.low, pole.w());
            m_weights.high = std::max(m_weights.high, pole.w());
        }
    }

    [[nodiscard]] double prove()
    {
        return largest_between(analytic_ends(m_proof.pcurve, m_proof.curve, m_proof.first, m_proof.last),
                               [this](double low, double high) { return cover(low, high, 0); });
    }

private:
    struct Weights
    {
        double low = infinity;
        double high = 0.0;
    };

    struct Spans
    {
        int low = 0;
        int high = 0;
    };

    //! How far the true pcurve may be from the values of its piece.
    [[nodiscard]] Eigen::Vector3d straying(const CurvePiece &pcurve) const
    {
        return pcurve.rounding() + Eigen::Vector3d(m_proof.slack, m_proof.slack, 0.0);
    }

    //! The non-empty spans that an interval of parameters touches.
    static Spans spans(const KnotVector &kv, double low, double high)
    {
        // the span that ends at `low` is touched too
        const double before = std::nextafter(low, -infinity);
        return {kv.span(std::max(before, kv.front())), kv.span(std::min(high, kv.back()))};
    }

    static int count(const KnotVector &kv, const Spans &spans)
    {
        int cells = 0;
        for (int s = spans.low; s <= spans.high; ++s)
            cells += kv.knots[static_cast<std::size_t>(s)] < kv.knots[static_cast<std::size_t>(s) + 1] ? 1 : 0;
        return cells;
    }

    [[nodiscard]] double cover(double a, double b, int depth)
    {
        if (depth > deepest || ++m_intervals > most_intervals)
            return infinity;
        const CurvePiece pcurve(m_proof.pcurve, a, b);
        const CurvePiece curve(m_proof.curve, a, b);
        const Eigen::Vector3d reach = pcurve.reach(1.0).total + straying(pcurve);
        const Eigen::Vector3d &middle = pcurve.middle();
        const Spans us = spans(m_base.u, middle.x() - reach.x(), middle.x() + reach.x());
        const Spans vs = spans(m_base.v, middle.y() - reach.y(), middle.y() + reach.y());
        double worst = infinity;
        if (count(m_base.u, us) * count(m_base.v, vs) <= most_cells)
            worst = over_cells(pcurve, curve, us, vs);
        if (worst <= m_proof.target)
            return worst;
        const double cut = crossing(pcurve, us, vs);
        if (!(cut > a && cut < b) || (worst < infinity && attained(pcurve, curve) > m_proof.target))
            return worst;
        const double lower = cover(a, cut, depth + 1);
        return lower < infinity ? larger_bound(lower, cover(cut, b, depth + 1)) : infinity;
    }

    [[nodiscard]] double over_cells(const CurvePiece &pcurve, const CurvePiece &curve, const Spans &us,
                                    const Spans &vs) const
    {
        double worst = 0.0;
        for (int s = us.low; s <= us.high; ++s)
            for (int t = vs.low; t <= vs.high; ++t)
                if (m_base.u.knots[static_cast<std::size_t>(s)] < m_base.u.knots[static_cast<std::size_t>(s) + 1] &&
                    m_base.v.knots[static_cast<std::size_t>(t)] < m_base.v.knots[static_cast<std::size_t>(t) + 1])
                    worst = larger_bound(worst, bound(pcurve, curve, {s, t}));
        return worst;
    }

    //! Where the pcurve crosses an inner knot line that its piece touches, else the middle.
    [[nodiscard]] double crossing_of(const CurvePiece &pcurve, int direction, const KnotVector &kv,
                                     const Spans &spans) const
    {
        const double nothing = 0.5 * (pcurve.a() + pcurve.b());
        for (int s = spans.low + 1; s <= spans.high; ++s)
        {
            const double knot = kv.knots[static_cast<std::size_t>(s)];
            double a = pcurve.a();
            double b = pcurve.b();
            const double at_a = pcurve.value(a)[direction] - knot;
            const double exact = 4.0 * straying(pcurve)[direction];
            if (!(at_a * (pcurve.value(b)[direction] - knot) < 0.0) || std::abs(at_a) <= exact ||
                std::abs(pcurve.value(b)[direction] - knot) <= exact)
                continue;
            for (int step = 0; step < 60; ++step)
            {
                const double t = 0.5 * (a + b);
                ((pcurve.value(t)[direction] - knot) * at_a > 0.0 ? a : b) = t;
            }
            return 0.5 * (a + b);
        }
        return nothing;
    }

    [[nodiscard]] double crossing(const CurvePiece &pcurve, const Spans &us, const Spans &vs) const
    {
        const double middle = 0.5 * (pcurve.a() + pcurve.b());
        const double of_u = crossing_of(pcurve, 0, m_base.u, us);
        return of_u != middle ? of_u : crossing_of(pcurve, 1, m_base.v, vs);
    }

    [[nodiscard]] HomogeneousJet jet(const Eigen::Vector3d &uv, const AnalyticSurface::Cell &cell) const
    {
        double nu[2 * (max_spline_degree + 1)];
        double nv[2 * (max_spline_degree + 1)];
        const int p = m_base.u.degree;
        const int q = m_base.v.degree;
        basis_derivatives(m_base.u, cell.span_u, uv.x(), 1, nu);
        basis_derivatives(m_base.v, cell.span_v, uv.y(), 1, nv);
        HomogeneousJet jet;
        for (int i = 0; i <= p; ++i)
        {
            Eigen::Vector4d row = Eigen::Vector4d::Zero();
            Eigen::Vector4d slope = Eigen::Vector4d::Zero();
            for (int j = 0; j <= q; ++j)
            {
                const Eigen::Vector4d &pole = m_base.pole(cell.span_u - p + i, cell.span_v - q + j);
                row += nv[j] * pole;
                slope += nv[q + 1 + j] * pole;
            }
            jet.s += nu[i] * row;
            jet.u += nu[p + 1 + i] * row;
            jet.v += nu[i] * slope;
        }
        return jet;
    }

    //! What is sampled: W = w omega, M = omega^3 S_u x S_v for a rational base, and S_u x S_v for any other.
    struct Sample
    {
        Eigen::Vector3d w;
        Eigen::Vector3d normal;
        double omega = 1.0;
        double lengths = 0.0; //!< |S_u| + |S_v|, each with its powers of omega
        double product = 0.0; //!< |S_u| |S_v|
    };

    [[nodiscard]] Sample sample(const CurvePiece &pcurve, const CurvePiece &curve, double t,
                                const AnalyticSurface::Cell &cell) const
    {
        const HomogeneousJet at = jet(pcurve.value(t), cell);
        Sample result;
        result.omega = m_base.rational ? at.s.w() : 1.0;
        result.w = result.omega * curve.value(t) - at.s.head<3>();
        Eigen::Vector3d tu = at.u.head<3>();
        Eigen::Vector3d tv = at.v.head<3>();
        if (m_base.rational)
        {
            // omega^2 S_u = omega A_u - omega_u A; their cross product has the factor omega, which divides out
            tu = at.s.w() * tu - at.u.w() * at.s.head<3>();
            tv = at.s.w() * tv - at.v.w() * at.s.head<3>();
        }
        result.normal = tu.cross(tv);
        result.lengths = tu.norm() + tv.norm();
        result.product = tu.norm() * tv.norm();
        return result;
    }

    //! Degrees of W and M along the piece; nothing where they are no polynomials.
    struct Degrees
    {
        int w = 0;
        int normal = 0;
        int omega = 0;
    };

    [[nodiscard]] std::optional<Degrees> degrees(const CurvePiece &pcurve, const CurvePiece &curve) const
    {
        int own = 0;
        for (int e = 0; e < 3; ++e)
        {
            const std::optional<int> degree = curve.degree(e, 0.0);
            if (!degree)
                return std::nullopt;
            own = std::max(own, *degree);
        }
        const std::optional<int> du = pcurve.degree(0, pcurve.rounding().x());
        const std::optional<int> dv = pcurve.degree(1, pcurve.rounding().y());
        if (!du || !dv)
            return std::nullopt;
        const int along = m_base.u.degree * *du + m_base.v.degree * *dv;
        if (m_base.rational)
            return Degrees{along + own, 4 * along, along};
        return Degrees{std::max(along, own), 2 * along, 0};
    }

    //! Bound with the polynomials of one cell on the whole piece.
    [[nodiscard]] double bound(const CurvePiece &pcurve, const CurvePiece &curve,
                               const AnalyticSurface::Cell &cell) const
    {
        const std::optional<Degrees> degree = degrees(pcurve, curve);
        if (!degree)
            return infinity;
        const int most = std::max({2 * std::max(degree->w, degree->omega), degree->w + degree->normal, degree->normal});
        if (most > highest_degree)
            return infinity;
        const int points = points_per_degree * std::max(most, 1) + 1;
        const double factor = (1.0 + 1e-9) / std::cos(M_PI * most / (2.0 * points));
        const double middle = 0.5 * (pcurve.a() + pcurve.b());
        const double half = 0.5 * (pcurve.b() - pcurve.a());
        const Sample centre = sample(pcurve, curve, middle, cell);
        const double d = m_proof.distance;
        double a = 0.0;
        double cross = 0.0;
        double turn = 0.0;
        double omega_turn = 0.0;
        double w = centre.w.norm();
        Sample widest = centre;
        for (int k = 0; k < points; ++k)
        {
            const Sample here = sample(pcurve, curve, middle + half * std::cos(M_PI * (k + 0.5) / points), cell);
            a = std::max(a, std::abs(here.w.squaredNorm() - d * d * here.omega * here.omega));
            cross = std::max(cross, here.w.cross(here.normal).norm());
            turn = std::max(turn, (here.normal - centre.normal).norm());
            omega_turn = std::max(omega_turn, std::abs(here.omega - centre.omega));
            w = std::max(w, here.w.norm());
            widest.lengths = std::max(widest.lengths, here.lengths);
            widest.product = std::max(widest.product, here.product);
        }
        const Errors errors = rounding(pcurve, curve, cell, w, widest);
        const double least = centre.normal.norm() - factor * (turn + 2.0 * errors.normal) - errors.normal;
        const double omega = centre.omega - factor * (omega_turn + 2.0 * errors.omega) - errors.omega;
        if (!(least > (1.0 - widest_turn) * centre.normal.norm()) || !(omega > 0.0))
            return infinity;
        const double tangential = factor * (cross + errors.cross) / (least * omega);
        const double spread = factor * (a + errors.a) / (omega * omega);
        return combined(tangential, spread, d * centre.w.dot(centre.normal) >= 0.0);
    }

    //! Tangential and normal part together; | |w|^2 - d^2 | <= spread.
    [[nodiscard]] double combined(double tangential, double spread, bool right_side) const
    {
        const double d = std::abs(m_proof.distance);
        const double most = std::sqrt(d * d + spread);
        const double below = spread + tangential * tangential;
        double normal = d + most;
        if (d * d > below && right_side)
            normal = std::max(spread / (d + most), below / (d + std::sqrt(d * d - below)));
        return std::hypot(tangential, normal) * (1.0 + 64.0 * epsilon);
    }

    struct Errors
    {
        double a = 0.0;
        double cross = 0.0;
        double normal = 0.0;
        double omega = 0.0;
    };

    [[nodiscard]] static double span_length(const KnotVector &kv, int span)
    {
        return kv.knots[static_cast<std::size_t>(span) + 1] - kv.knots[static_cast<std::size_t>(span)];
    }

    //! Bounds of the rounding of what is sampled, that of the parameters included: a derivative of order k of a
    //! spline of degree p on a span of length h is at most (2 p / h)^k times its poles' size.
    [[nodiscard]] Errors rounding(const CurvePiece &pcurve, const CurvePiece &curve, const AnalyticSurface::Cell &cell,
                                  double w, const Sample &widest) const
    {
        const double rate_u = 2.0 * m_base.u.degree / span_length(m_base.u, cell.span_u);
        const double rate_v = 2.0 * m_base.v.degree / span_length(m_base.v, cell.span_v);
        const Eigen::Vector3d apart = straying(pcurve);
        const double stray = rate_u * apart.x() + rate_v * apart.y();
        const double weight = m_base.rational ? m_weights.high : 1.0;
        const double reach =
            m_size + weight * (m_proof.curve.value(m_proof.first).norm() + std::abs(m_proof.distance) + w);
        const double unit = derivative_operations * epsilon + stray;
        const double of_value = unit * reach + weight * curve.rounding().norm();
        const double scale = m_base.rational ? 4.0 * m_weights.high : 1.0;
        const double of_tangent = scale * unit * std::max(rate_u, rate_v) * m_size;
        Errors errors;
        errors.omega = m_base.rational ? unit * m_weights.high : 0.0;
        errors.normal = of_tangent * widest.lengths + of_tangent * of_tangent + 16.0 * epsilon * widest.product;
        errors.cross =
            w * errors.normal + of_value * (widest.product + errors.normal) + 16.0 * epsilon * w * widest.product;
        errors.a =
            2.0 * w * of_value + of_value * of_value + 16.0 * epsilon * w * w +
            m_proof.distance * m_proof.distance * (2.0 * weight * errors.omega + 16.0 * epsilon * weight * weight);
        return errors;
    }

    //! The largest deviation at some places: where it exceeds the target, no cut helps.
    [[nodiscard]] double attained(const CurvePiece &pcurve, const CurvePiece &curve) const
    {
        constexpr int probes = 16;
        double worst = 0.0;
        for (int k = 0; k <= probes; ++k)
        {
            const double t = pcurve.a() + (pcurve.b() - pcurve.a()) * k / probes;
            const Eigen::Vector3d uv = pcurve.value(t);
            const Sample here = sample(pcurve, curve, t, m_proof.base.cell_at(uv.x(), uv.y()));
            worst = std::max(worst, (here.w / here.omega - m_proof.distance * here.normal.normalized()).norm());
        }
        return worst;
    }

    const OffsetCurveProof &m_proof;
    const TensorSpline &m_base;
    double m_size = 0.0;
    Weights m_weights;
    int m_intervals = 0;
};

} // namespace

double proven_offset_deviation(const OffsetCurveProof &proof)
{
    return proof.base.spline() ? OffsetCurveProver(proof).prove() : infinity;
}

} // namespace laminate_offset
