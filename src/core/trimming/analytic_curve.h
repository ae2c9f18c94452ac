// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Curves as piecewise analytic functions with bounds in the complex plane.
//!
//! A piece over [a, b] knows how far its values stray from the value in the middle, for real parameters
//! and on the Bernstein ellipse of parameter rho: foci a and b, sum of the half axes rho (b - a) / 2.
//! Approximation theory turns such a bound into the degree of a polynomial that is as good as the
//! function (edge_certificate.h).
#pragma once

#include "../spline/knot_vector.h"

#include <Eigen/Core>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace laminate_offset
{

class AnalyticCurve;

//! Where a curve goes from the middle of an interval, in each coordinate.
struct CurveReach
{
    Eigen::Vector3d total; //!< bound of |value(z) - middle|; infinite where a weight function might vanish
    Eigen::Vector3d chord; //!< part of it that is the image of the ellipse under a linear function of half length
                           //!< `chord`: it grows by `stretch` and no more
    double stretch = 1.0;  //!< (rho + 1 / rho) / 2
};

//! The least and largest value of each coordinate.
struct CurveRange
{
    Eigen::Vector3d low;
    Eigen::Vector3d high;
};

//! A curve on an interval where it is one analytic function.
class CurvePiece
{
public:
    CurvePiece(const AnalyticCurve &curve, double a, double b);

    [[nodiscard]] double a() const { return m_a; }
    [[nodiscard]] double b() const { return m_b; }
    [[nodiscard]] const Eigen::Vector3d &middle() const { return m_middle; }

    //! The function that the curve is here; t may lie a little outside.
    [[nodiscard]] Eigen::Vector3d value(double t) const;

    //! The same at `lanes` parameters at once (vector_kernels.h); rows x, y, z.
    void lane_values(const double *t, double *rows) const;

    //! How far the curve strays for parameters inside the ellipse; rho = 1 is the interval itself.
    [[nodiscard]] CurveReach reach(double rho) const;

    //! Bounds of the coordinates over the interval, up to rounding(): a curve that runs away from its end does not
    //! reach beyond it, as a bound about the middle would have it.
    [[nodiscard]] CurveRange range() const;

    //! Degree of the polynomial that one coordinate is up to `slack`; nothing where it is none.
    [[nodiscard]] std::optional<int> degree(int coordinate, double slack) const;

    //! Bound of the rounding of value() in each coordinate.
    [[nodiscard]] const Eigen::Vector3d &rounding() const { return m_rounding; }

private:
    void prepare_spline();
    void prepare_power();
    void fill_coefficients();
    void prepare_conic();
    [[nodiscard]] CurveReach conic_reach(double rho) const;
    [[nodiscard]] CurveRange arc_range() const;

    const AnalyticCurve *m_curve;
    double m_a;
    double m_b;
    int m_span = 0;
    int m_degree = 0; //!< of the Bernstein coefficients
    std::array<Eigen::Vector4d, max_spline_degree + 1> m_coefficients;
    std::array<Eigen::Vector4d, max_spline_degree + 1> m_scaled; //!< the same of a spline, times its binomials
    Eigen::Vector3d m_middle;
    Eigen::Vector3d m_rounding;
};

//! A curve in space, or a pcurve (u, v, 0), over a range of its parameter.
class AnalyticCurve
{
public:
    //! \return nothing for a curve that is not piecewise a (rational) polynomial or a conic.
    static std::optional<AnalyticCurve> make(const Handle(Geom_Curve) & curve, double first, double last);
    static std::optional<AnalyticCurve> make(const Handle(Geom2d_Curve) & curve, double first, double last);
    AnalyticCurve(KnotVector knots, std::vector<Eigen::Vector4d> poles, bool rational);
    //! a0 + a1 t + a2 t^2
    static AnalyticCurve power(const Eigen::Vector3d &a0, const Eigen::Vector3d &a1, const Eigen::Vector3d &a2);
    //! a0 + cos t a1 + sin t a2
    static AnalyticCurve circular(const Eigen::Vector3d &a0, const Eigen::Vector3d &a1, const Eigen::Vector3d &a2);
    //! a0 + cosh t a1 + sinh t a2
    static AnalyticCurve hyperbolic(const Eigen::Vector3d &a0, const Eigen::Vector3d &a1, const Eigen::Vector3d &a2);
    //! A curve that stays at one point.
    static AnalyticCurve point(const Eigen::Vector3d &place);

    //! Parameters between which the curve is analytic, and perhaps some more; not its ends, behind which it goes on as
    //! the same function.
    [[nodiscard]] const std::vector<double> &breaks() const { return m_breaks; }
    [[nodiscard]] Eigen::Vector3d value(double t) const;

private:
    friend class CurvePiece;
    enum class Kind
    {
        Spline,
        Power,
        Circular,
        Hyperbolic
    };

    AnalyticCurve(Kind kind, const Eigen::Vector3d &a0, const Eigen::Vector3d &a1, const Eigen::Vector3d &a2)
        : m_kind(kind), m_a0(a0), m_a1(a1), m_a2(a2)
    {
    }
    [[nodiscard]] Eigen::Vector3d value_on(int span, double t) const;

    Kind m_kind = Kind::Spline;
    KnotVector m_knots;
    std::vector<Eigen::Vector4d> m_poles; //!< homogeneous
    bool m_rational = false;
    std::vector<double> m_breaks;
    Eigen::Vector3d m_a0 = Eigen::Vector3d::Zero();
    Eigen::Vector3d m_a1 = Eigen::Vector3d::Zero();
    Eigen::Vector3d m_a2 = Eigen::Vector3d::Zero();
};

//! The range [first, last] cut where the curve is no longer the same analytic function; increasing, with both ends.
std::vector<double> analytic_ends(const AnalyticCurve &a, double first, double last);
//! The same where one of two curves is not.
std::vector<double> analytic_ends(const AnalyticCurve &a, const AnalyticCurve &b, double first, double last);

//! The larger of two bounds; one that is no number stays so.
inline double larger_bound(double a, double b) { return std::isnan(a) || a > b ? a : b; }

//! The largest of what `cover` (low, high) gives between neighbouring ends; infinite as soon as one is.
template <class Cover> double largest_between(const std::vector<double> &ends, const Cover &cover)
{
    double worst = 0.0;
    for (std::size_t i = 0; i + 1 < ends.size() && worst < std::numeric_limits<double>::infinity(); ++i)
        if (ends[i + 1] > ends[i])
            worst = larger_bound(worst, cover(ends[i], ends[i + 1]));
    return worst;
}

} // namespace laminate_offset
