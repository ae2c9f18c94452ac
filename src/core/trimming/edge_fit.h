// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A spline through one smooth curve in a handful of fits.
//!
//! A spline of degree p over n well-placed knots misses a smooth curve f by about a constant times n^-(p+1), and the
//! knots are well placed where the integral of |f^(p+1)|^(1/(p+1)) grows evenly along them (de Boor, A Practical Guide
//! to Splines, ch. XII). The derivative is estimated by the jumps of the p-th derivative of the fit before, and
//! the count by its error.
#pragma once

#include "../spline/knot_choice.h"
#include "../spline/least_squares.h"

#include <functional>
#include <optional>
#include <vector>

namespace laminate_offset
{

struct SmoothCurve
{
    //! Points at increasing parameters, one row (x, y, z) each.
    std::function<RowMatrix(const std::vector<double> &)> sample;
    //! First and last parameter, and between them those at which the curve is less than smooth; increasing.
    std::vector<double> breaks;
};

struct CurveFit
{
    KnotVector knots;
    RowMatrix poles;
    double error = 0.0; //!< largest distance seen at the samples
};

//! Degree 3 to 5, simple knots, ends interpolated.
//! \return nothing where the tolerance is not reached soon: the curve is not smooth enough to be fitted like this.
std::optional<CurveFit> smooth_fit(const SmoothCurve &curve, double tolerance);

//! For a curve that is smooth between joins, where only some derivatives or none go on. Joins get the multiplicity that
//! they need, and every interval between them as many even spans as its own error asks for.
//! Degree 5, or as low as 3 where all joins are twice differentiable; ends interpolated.
//! \param joins interior, increasing.
//! \return nothing where the tolerance is not reached soon.
std::optional<CurveFit> joined_fit(const SmoothCurve &curve, const std::vector<DataBreak> &joins, double tolerance);

} // namespace laminate_offset
