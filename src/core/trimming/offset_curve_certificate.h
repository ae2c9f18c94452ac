// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The proof for an edge curve that is made without an offset surface: an upper bound of |C(t) - (S + d N)(c(t))|.
//!
//! The certificate of surfaces (surface/certificate.h) along a curve: with w = C - S(c) and M = (S_u x S_v)(c),
//!     |w_t| = |w x M| / |M|,  |w_n| in [sqrt(d^2 + min a - |w_t|^2), sqrt(d^2 + max a)],  a = w.w - d^2,
//! and the side of w_n, which is read at one place, holds while |w_n| does not vanish. Between the knots of C and c, on one
//! cell of S, all three are polynomials of known degree after multiplication with the weight function. Such a polynomial is
//! nowhere larger than 1 / cos(pi / 6) times its largest value at three Chebyshev points a degree (edge_certificate.h);
//! the same, applied to M - M(middle), bounds |M| from below. Where a piece of the pcurve strays over a knot line by
//! rounding or by a slack, the bound is proven with the polynomials of both cells on the whole piece, one of which is the right one.
#pragma once

#include "analytic_curve.h"
#include "analytic_surface.h"

namespace laminate_offset
{

struct OffsetCurveProof
{
    const AnalyticSurface &base; //!< a spline
    const AnalyticCurve &pcurve; //!< on the base
    const AnalyticCurve &curve;
    double first = 0.0;
    double last = 0.0;
    double distance = 0.0; //!< along S_u x S_v [mm]
    double slack = 0.0;    //!< the true pcurve may be so far from `pcurve`, in u and in v
    double target = 0.0;   //!< how small the bound has to be [mm]
};

//! \return the proven bound [mm]; infinite where nothing can be proven, as for a pcurve or a curve that is no
//! polynomial, or at a pole of the base.
double proven_offset_deviation(const OffsetCurveProof &proof);

} // namespace laminate_offset
