// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The proof for edges: an upper bound of |C(t) - O(c(t))| for a curve C, a surface O and a pcurve c.
//!
//! The range is cut at the knots of C and c and where c crosses O's knots, so that f = C - O(c) is
//! analytic on each interval. There f is a polynomial of some degree n up to a known remainder e: exactly,
//! with e = 0, where all parts are polynomials, and else because |f| <= M on the Bernstein ellipse of
//! parameter rho leaves e <= 2 M rho^-n / (rho - 1). A polynomial of degree n is nowhere larger than
//! 1 / cos(pi n / (2 N)) times its largest value at N > n Chebyshev points (Ehlich & Zeller 1964; for a
//! vector, by each of its components along a fixed direction). Hence
//!     |f| <= (max over the points of |f| + e) / cos(pi n / (2 N)) + e.
//! Crossings are known up to rounding only: where c strays over a knot line, the surface and the
//! polynomial that goes on there differ by no more than their speeds times the distance. All bounds are
//! inflated for the rounding of the evaluations.
#pragma once

#include "analytic_curve.h"
#include "analytic_surface.h"

namespace laminate_offset
{

struct EdgeProof
{
    const AnalyticSurface &surface;
    const AnalyticCurve &pcurve;
    const AnalyticCurve &curve;
    double first = 0.0;
    double last = 0.0;
    double target = 0.0; //!< how small the bound has to be [mm]; finer remainders than that are not sought
};

//! \return the proven bound [mm]; infinite where nothing can be proven.
double proven_deviation(const EdgeProof &proof);

} // namespace laminate_offset
