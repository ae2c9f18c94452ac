// SPDX-License-Identifier: LGPL-2.1-or-later
#include "profile_bounds.h"

#include "../spline/spline_pieces.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

constexpr int deepest = 12;
// A piece is halved until a lower bound is at least this part of the value in its middle.
constexpr double close_enough = 0.5;

Eigen::Vector3d coefficient(const Bernstein3 &a, int j)
{
    return {a[0].coefficient(0, j), a[1].coefficient(0, j), a[2].coefficient(0, j)};
}

//! Least coefficient along the direction in the middle: at most the length of the values.
double least_length(const Bernstein3 &a)
{
    const Eigen::Vector3d direction = centre(a).normalized();
    double least = std::numeric_limits<double>::infinity();
    for (int j = 0; j <= a[0].degree_v(); ++j)
        least = std::min(least, coefficient(a, j).dot(direction));
    return least;
}

void reset(Bernstein3 &a, int degree)
{
    for (Bernstein &component : a)
        component.reset(0, degree);
}

class Bounder
{
public:
    explicit Bounder(bool planar) : m_planar(planar) {}

    void cover(RationalPiece &piece, double width, int depth)
    {
        const bool radius = look_at_radius(piece, depth);
        const bool rest = look_at_derivatives(piece, width, depth);
        if (radius && rest)
            return;
        if (depth == deepest)
        {
            m_failed = true;
            return;
        }
        RationalPiece upper = piece;
        piece.halve(false, upper);
        cover(piece, 0.5 * width, depth + 1);
        if (!m_failed)
            cover(upper, 0.5 * width, depth + 1);
    }

    [[nodiscard]] std::optional<ProfileBounds> result() const
    {
        return m_failed ? std::nullopt : std::optional(m_bounds);
    }

    ProfileBounds m_bounds{std::numeric_limits<double>::infinity(), 0.0, std::numeric_limits<double>::infinity()};

private:
    //! Radii of one sign in a plane; zeros only as exact coefficients at one end.
    bool look_at_radius(const RationalPiece &piece, int depth)
    {
        const Bernstein::Range omega = piece.omega.range();
        if (!(omega.low > 0.0))
            return false;
        const int degree = piece.numerator[0].degree_v();
        Eigen::Vector3d axial = coefficient(piece.numerator, degree / 2);
        axial.z() = 0.0;
        const Eigen::Vector3d direction =
            m_planar ? Eigen::Vector3d(std::copysign(1.0, piece.numerator[0].centre()), 0.0, 0.0) : axial.normalized();
        double least = std::numeric_limits<double>::infinity();
        double largest = 0.0;
        bool zero = false;
        for (int j = 0; j <= degree; ++j)
        {
            const Eigen::Vector3d c = coefficient(piece.numerator, j);
            const double along = c.dot(direction);
            largest = std::max(largest, std::hypot(c.x(), c.y()));
            if (along == 0.0 && m_planar && (j == 0 || j == degree))
                zero = true;
            else
                least = std::min(least, along);
        }
        if (!(least > 0.0) && depth < deepest)
            return false;
        m_failed = m_failed || !(least > 0.0);
        m_bounds.touches_axis = m_bounds.touches_axis || zero;
        m_bounds.least_radius = std::min(m_bounds.least_radius, least / omega.high);
        m_bounds.largest_radius = std::max(m_bounds.largest_radius, largest / omega.low);
        m_radius = largest / omega.low;
        return true;
    }

    //! omega^2 C' = omega P' - omega' P, and for other profiles its sine.
    bool look_at_derivatives(const RationalPiece &piece, double width, int depth)
    {
        const Bernstein::Range omega = piece.omega.range();
        if (!(omega.low > 0.0))
            return false;
        RationalPiece local = piece;
        const Eigen::Vector3d middle = piece.centre();
        for (int e = 0; e < 3; ++e)
            local.numerator[static_cast<std::size_t>(e)].add_raised(-middle[e], piece.omega);
        RationalPiece slope;
        slope.omega.assign_derivative_v(local.omega);
        for (std::size_t e = 0; e < 3; ++e)
            slope.numerator[e].assign_derivative_v(local.numerator[e]);
        Bernstein3 tangent;
        Bernstein product;
        reset(tangent, local.numerator[0].degree_v() + local.omega.degree_v());
        for (std::size_t e = 0; e < 3; ++e)
        {
            assign_product(slope.numerator[e], local.omega, product);
            tangent[e].add_raised(1.0, product);
            assign_product(local.numerator[e], slope.omega, product);
            tangent[e].add_raised(-1.0, product);
        }
        const double slow = least_length(tangent) / (omega.high * omega.high * width);
        const double middle_speed = centre(tangent).norm() / std::pow(piece.omega.centre(), 2) / width;
        if (!(slow >= close_enough * middle_speed) && (depth < deepest || !(slow > 0.0)))
            return false;
        m_bounds.slowest = std::min(m_bounds.slowest, slow);
        return m_planar || look_at_sine(piece, tangent, omega, depth);
    }

    //! \param tangent omega^2 C'
    bool look_at_sine(const RationalPiece &piece, const Bernstein3 &tangent, const Bernstein::Range &omega, int depth)
    {
        Bernstein3 turn = piece.numerator; // omega times the velocity of a turn about the axis
        std::swap(turn[0], turn[1]);
        turn[0].scale(-1.0);
        turn[2].scale(0.0);
        Bernstein3 area;
        assign_cross(turn, tangent, area);
        const double fast = longest(tangent) / (omega.low * omega.low);
        const double sine = least_length(area) / std::pow(omega.high, 3) / (m_radius * fast);
        const double middle_sine = centre(area).norm() / (centre(turn).norm() * centre(tangent).norm());
        if (!(sine >= close_enough * middle_sine) && (depth < deepest || !(sine > 0.0)))
            return false;
        m_bounds.least_sine = std::min(m_bounds.least_sine, sine);
        return true;
    }

    bool m_planar;
    bool m_failed = false;
    double m_radius = 0.0;
};

} // namespace

std::optional<ProfileBounds> profile_bounds(const ProfileSpline &profile, bool planar)
{
    TensorSpline ribbon; // the profile along v, nothing along u
    ribbon.u = clamped_knots(0, 0.0, 1.0, {});
    ribbon.v = profile.knots;
    ribbon.poles = profile.poles;
    ribbon.rational = profile.rational;
    const std::vector<double> vs = profile.knots.breaks();
    SplinePieces pieces(ribbon, {0.0, 1.0}, vs);
    Bounder bounder(planar);
    RationalPiece piece;
    for (std::size_t j = 0; j + 1 < vs.size(); ++j)
    {
        pieces.cut(0, j, Eigen::Vector3d::Zero(), piece);
        bounder.cover(piece, vs[j + 1] - vs[j], 0);
    }
    return bounder.result();
}

} // namespace laminate_offset
