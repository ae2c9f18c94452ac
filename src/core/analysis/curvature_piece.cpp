// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curvature_piece.h"

#include "curvature.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
// Relative inflation of the fine bound for rounding: its products have some 10^3 terms.
constexpr double rounding = 1e-11;

// Length of a side against the piece below which it is a point.
constexpr double collapsed_length = 1e-7;

const std::pair<double, double> unbounded{-infinity, infinity};

//! Farthest coefficient from a point: a bound of the spread of the values.
double spread(const Bernstein3 &a, const Eigen::Vector3d &point)
{
    double largest = 0.0;
    for (int i = 0; i <= a[0].degree_u(); ++i)
        for (int j = 0; j <= a[0].degree_v(); ++j)
        {
            const Eigen::Vector3d c(a[0].coefficient(i, j), a[1].coefficient(i, j), a[2].coefficient(i, j));
            largest = std::max(largest, (c - point).squaredNorm());
        }
    return std::sqrt(largest);
}

//! Range of a.n over the coefficients.
Bernstein::Range along(const Bernstein3 &a, const Eigen::Vector3d &n)
{
    Bernstein::Range range{infinity, -infinity};
    for (int i = 0; i <= a[0].degree_u(); ++i)
        for (int j = 0; j <= a[0].degree_v(); ++j)
        {
            const double c =
                a[0].coefficient(i, j) * n.x() + a[1].coefficient(i, j) * n.y() + a[2].coefficient(i, j) * n.z();
            range.low = std::min(range.low, c);
            range.high = std::max(range.high, c);
        }
    return range;
}

struct Interval
{
    double low = 0.0;
    double high = 0.0;

    friend Interval operator+(const Interval &a, const Interval &b) { return {a.low + b.low, a.high + b.high}; }
    friend Interval operator*(double s, const Interval &a)
    {
        return s >= 0.0 ? Interval{s * a.low, s * a.high} : Interval{s * a.high, s * a.low};
    }
    [[nodiscard]] Interval widened(double by) const { return {low - by, high + by}; }
    [[nodiscard]] double size() const { return std::max(std::abs(low), std::abs(high)); }
};

//! x / omega for omega between two positive weights.
Interval divided(const Bernstein::Range &x, const Bernstein::Range &omega)
{
    return {x.low / (x.low < 0.0 ? omega.low : omega.high), x.high / (x.high < 0.0 ? omega.high : omega.low)};
}

//! Eigenvalue bounds of a symmetric matrix of intervals.
std::pair<double, double> eigenvalues(const Interval &l, const Interval &m, const Interval &n)
{
    const double half = std::max(std::abs(l.high - n.low), std::abs(n.high - l.low)) / 2.0;
    const double off = std::hypot(half, m.size());
    return {0.5 * (l.low + n.low) - off, 0.5 * (l.high + n.high) + off};
}

//! Generalised eigenvalues of (II, J): roots of det(II - k J) = 0 for positive definite J.
std::pair<double, double> pencil(const std::array<double, 3> &ii, const std::array<double, 3> &j)
{
    const double det = j[0] * j[2] - j[1] * j[1];
    if (!(j[0] > 0.0) || !(det > 1e-12 * j[0] * j[2]))
        return unbounded;
    // frame in which J is the identity, by Cholesky
    const double a = std::sqrt(j[0]);
    const double b = j[1] / a;
    const double c = std::sqrt(j[2] - b * b);
    const double l = ii[0] / (a * a);
    const double m = (ii[1] - b / a * ii[0]) / (a * c);
    const double n = (ii[2] - 2.0 * b / a * ii[1] + b * b / (a * a) * ii[0]) / (c * c);
    const double off = std::hypot(0.5 * (l - n), m);
    return {0.5 * (l + n) - off, 0.5 * (l + n) + off};
}

} // namespace

void CurvaturePieceBounder::move_to_centre(const RationalPiece &piece)
{
    m_piece = piece;
    const Eigen::Vector3d point = piece.centre();
    for (int e = 0; e < 3; ++e)
        m_piece.numerator[static_cast<std::size_t>(e)].add_raised(-point[e], piece.omega);
}

void CurvaturePieceBounder::assign(const RationalPiece &piece)
{
    move_to_centre(piece);
    assign_derivative_u(m_piece, m_u);
    assign_derivative_v(m_piece, m_v);
    assign_derivative_u(m_u, m_uu);
    assign_derivative_v(m_u, m_uv);
    assign_derivative_v(m_v, m_vv);
}

std::optional<std::pair<double, double>> CurvaturePieceBounder::at_centre() const
{
    const double w = m_piece.omega.centre();
    SurfaceJet jet;
    jet.s.setZero();
    jet.u = centre(m_u.numerator) / w;
    jet.v = centre(m_v.numerator) / w;
    if (std::min(jet.u.norm(), jet.v.norm()) < m_resolution)
        return std::nullopt;
    jet.uu = (centre(m_uu.numerator) - 2.0 * m_u.omega.centre() * jet.u) / w;
    jet.uv = (centre(m_uv.numerator) - m_u.omega.centre() * jet.v - m_v.omega.centre() * jet.u) / w;
    jet.vv = (centre(m_vv.numerator) - 2.0 * m_v.omega.centre() * jet.v) / w;
    return principal_curvatures(jet);
}

bool CurvaturePieceBounder::below_resolution() const
{
    const double shorter =
        std::sqrt(std::min(centre(m_u.numerator).squaredNorm(), centre(m_v.numerator).squaredNorm()));
    return shorter / m_piece.omega.centre() < m_resolution;
}

bool CurvaturePieceBounder::has_collapsed_side(const RationalPiece &piece)
{
    const int m = piece.numerator[0].degree_u();
    const int n = piece.numerator[0].degree_v();
    const auto point = [&](int i, int j) -> Eigen::Vector3d {
        const double w = piece.rational() ? piece.omega.coefficient(i, j) : 1.0;
        return Eigen::Vector3d(piece.numerator[0].coefficient(i, j), piece.numerator[1].coefficient(i, j),
                               piece.numerator[2].coefficient(i, j)) /
               w;
    };
    const double size = (point(0, 0) - point(m, n)).norm() + (point(m, 0) - point(0, n)).norm();
    const auto collapsed = [&](int i0, int j0, int di, int dj, int count) {
        for (int k = 1; k <= count; ++k)
            if ((point(i0 + k * di, j0 + k * dj) - point(i0, j0)).norm() > collapsed_length * size)
                return false;
        return true;
    };
    return collapsed(0, 0, 1, 0, m) || collapsed(0, n, 1, 0, m) || collapsed(0, 0, 0, 1, n) || collapsed(m, 0, 0, 1, n);
}

bool CurvaturePieceBounder::varies_more_along_u() const
{
    const double lu = centre(m_u.numerator).norm();
    const double lv = centre(m_v.numerator).norm();
    // |S_uu| / |S_u| + |S_uv| / |S_v| against |S_uv| / |S_u| + |S_vv| / |S_v|, without the quotients
    const double uv = longest(m_uv.numerator);
    const double along_u = longest(m_uu.numerator) * lv + uv * lu;
    const double along_v = uv * lv + longest(m_vv.numerator) * lu;
    return along_u != along_v ? along_u > along_v : lu >= lv;
}

std::pair<double, double> CurvaturePieceBounder::rough() const
{
    const Bernstein::Range omega = m_piece.omega.range();
    if (omega.low <= 0.0)
        return unbounded;
    const double w = m_piece.omega.centre();
    const Eigen::Vector3d su = centre(m_u.numerator) / w;
    const Eigen::Vector3d sv = centre(m_v.numerator) / w;
    const Eigen::Vector3d cross = su.cross(sv);
    const double lu = su.norm();
    if (!(cross.norm() > 1e-9 * lu * sv.norm()))
        return unbounded;
    const Eigen::Vector3d n0 = cross.normalized();
    // T1 = x S_u, T2 = y S_u + z S_v are orthonormal at the centre
    const double x = 1.0 / lu;
    const double z = lu / cross.norm();
    const double y = -z * su.dot(sv) / (lu * lu);
    const double weight_spread = std::max(1.0 / omega.low - 1.0 / w, 1.0 / w - 1.0 / omega.high);
    const double reach = longest(m_piece.numerator) / omega.low;
    const double height = along(m_piece.numerator, n0).size() / omega.low;
    const auto first_spread = [&](const RationalPiece &d, const Eigen::Vector3d &at) {
        return spread(d.numerator, at * w) / w + longest(d.numerator) * weight_spread +
               reach * d.omega.range().size() / omega.low;
    };
    const auto first_height = [&](const RationalPiece &d) {
        return (along(d.numerator, n0).size() + height * d.omega.range().size()) / omega.low;
    };
    const double ru = first_spread(m_u, su);
    const double rv = first_spread(m_v, sv);
    const double rho = std::hypot(x * ru, std::abs(y) * ru + z * rv);
    if (rho >= 0.9)
        return unbounded;
    const double hu = first_height(m_u);
    const double hv = first_height(m_v);
    const double tilt = std::hypot(x * hu, std::abs(y) * hu + z * hv) / (1.0 - rho);
    // S_ab . n, from S_ab = (P_ab - omega_a S_b - omega_b S_a - omega_ab S) / omega
    const auto second = [&](const RationalPiece &d, double wa, double wb, double sa, double sb, double ha, double hb) {
        const double wab = d.omega.range().size();
        const double flat = (wa * hb + wb * ha + wab * height) / omega.low;
        const double size = (longest(d.numerator) + wa * sb + wb * sa + wab * reach) / omega.low;
        return divided(along(d.numerator, n0), omega).widened(flat + size * tilt);
    };
    const double wu = m_u.omega.range().size();
    const double wv = m_v.omega.range().size();
    const double size_u = su.norm() + ru;
    const double size_v = sv.norm() + rv;
    const Interval uu = second(m_uu, wu, wu, size_u, size_u, hu, hu);
    const Interval uv = second(m_uv, wu, wv, size_u, size_v, hu, hv);
    const Interval vv = second(m_vv, wv, wv, size_v, size_v, hv, hv);
    const std::pair<double, double> k =
        eigenvalues(x * x * uu, x * y * uu + x * z * uv, y * y * uu + 2.0 * y * z * uv + z * z * vv);
    const double narrow = (1.0 - rho) * (1.0 - rho);
    const double wide = (1.0 + rho) * (1.0 + rho);
    return {k.first / (k.first < 0.0 ? narrow : wide), k.second / (k.second > 0.0 ? narrow : wide)};
}

//! (omega^2 S_a) . (omega^2 S_b) (M . n0)
void CurvaturePieceBounder::weighted_first(const Bernstein3 &a, const Bernstein3 &b, Bernstein &out)
{
    assign_dot(a, b, m_scalar);
    assign_product(m_scalar, m_height, out);
}

//! omega^2 (omega P_ab - omega_ab P) . M, which is omega^4 S_ab . M
void CurvaturePieceBounder::weighted_second(const RationalPiece &d, Bernstein &out)
{
    if (!m_piece.rational())
        return assign_dot(d.numerator, m_tangents.normal(), out);
    assign_dot(d.numerator, m_tangents.normal(), m_scalar);
    assign_product(m_scalar, m_piece.omega, m_sum);
    assign_dot(m_piece.numerator, m_tangents.normal(), m_scalar);
    assign_product(m_scalar, d.omega, m_product);
    m_sum.add_raised(-1.0, m_product);
    assign_product(m_sum, m_square, out);
}

std::pair<double, double> CurvaturePieceBounder::fine()
{
    m_tangents.assign(m_piece);
    m_tangents.find_tangents(m_piece);
    m_tangents.assign_height(m_height);
    const Bernstein3 &qu = m_tangents.tangent_u();
    const Bernstein3 &qv = m_tangents.tangent_v();
    assign_product(m_piece.omega, m_piece.omega, m_square);
    weighted_first(qu, qu, m_first[0]);
    weighted_first(qu, qv, m_first[1]);
    weighted_first(qv, qv, m_first[2]);
    weighted_second(m_uu, m_second[0]);
    weighted_second(m_uv, m_second[1]);
    weighted_second(m_vv, m_second[2]);
    return widest_pencil();
}

//! The most extreme eigenvalues over all coefficients, which have to be of one degree.
std::pair<double, double> CurvaturePieceBounder::widest_pencil()
{
    int m = 0;
    int n = 0;
    for (const auto *form : {&m_first, &m_second})
        for (const Bernstein &entry : *form)
        {
            m = std::max(m, entry.degree_u());
            n = std::max(n, entry.degree_v());
        }
    for (auto *form : {&m_first, &m_second})
        for (Bernstein &entry : *form)
        {
            if (entry.degree_u() == m && entry.degree_v() == n)
                continue;
            m_scalar = entry;
            entry.reset(m, n);
            entry.add_raised(1.0, m_scalar);
        }
    std::pair<double, double> widest{0.0, 0.0};
    for (int i = 0; i <= m; ++i)
        for (int j = 0; j <= n; ++j)
        {
            // the binomials of a scaled coefficient cancel in the quotient
            const auto at = [&](const std::array<Bernstein, 3> &form) {
                return std::array{form[0].scaled(i, j), form[1].scaled(i, j), form[2].scaled(i, j)};
            };
            const std::pair<double, double> k = pencil(at(m_second), at(m_first));
            const double slack = rounding * std::max(std::abs(k.first), std::abs(k.second));
            widest = {std::min(widest.first, k.first - slack), std::max(widest.second, k.second + slack)};
        }
    return widest;
}

} // namespace laminate_offset
