// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Polynomial splines that stand for (cos t, sin t) and (cosh t, sinh t) within proven errors.
//!
//! On a span with the middle m and the half width h, E(m + h s) is E(m) times exp(k h s), k = i or 1, so one
//! polynomial on [-1, 1] serves all spans. It is the Chebyshev series (its coefficients are Bessel
//! functions of h), cut off at the degree, with the last two even and odd coefficients changed so that
//! value and slope are exact at both ends: the spans join with a continuous tangent. What was left out is again a
//! Chebyshev series; at 3 K + 1 Chebyshev points a polynomial of degree K shows all but a factor cos(pi / 6) of its
//! size, and the terms past K are bounded by |J_k|, |I_k| <= (h/2)^k / k! e^(h h / 4). Rounding is added.
#pragma once

#include "knot_vector.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace laminate_offset
{

enum class ConicKind
{
    Circle,   //!< E(t) = (cos t, sin t)
    Hyperbola //!< E(t) = (cosh t, sinh t)
};

//! Bounds of |E~ - E|, |E~' - E'|, |E~'' - E''|; on a hyperbola each is divided by cosh t.
struct ConicErrors
{
    double value = 0.0;
    double slope = 0.0;
    double bend = 0.0;
};

//! One Bezier span beside the other.
struct ConicSpline
{
    KnotVector knots;
    std::vector<Eigen::Vector2d> poles;
    ConicErrors errors;
};

//! The cheapest of the admissible degrees on [a, b], a < b. A full turn closes exactly.
//! \return nothing where rounding or the number of spans forbids the errors asked for.
std::optional<ConicSpline> conic_spline(ConicKind kind, double a, double b, const ConicErrors &wanted);

} // namespace laminate_offset
