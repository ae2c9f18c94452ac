// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The offset of a free-form base after Piegl & Tiller (CAD 31, 1999, 147-156), as Ravi Kumar et al. use it (CAD 35,
//! 2003, section 3.1): samples counted by second derivatives, chord-length parameters, interpolation, knot removal.
//!
//! - Parameters. The chord lengths between samples of S + d N, averaged over the rows, give every knot of the base, and
//!   some nodes between, a new parameter in mm. Through these nodes goes an increasing cubic spline (spline/monotone_map.h):
//!   a map that jumped in slope or curvature from sample to sample would be a roughness of the samples themselves, which no
//!   interpolant follows. Where the base's own parameter keeps within a few percent of chord length, it is scaled only.
//! - Counts. A span of length h with |O''| <= M gets n = (M h^2 / (8 e))^exponent equal parts in each direction alone
//!   (eq. 3.10 for curves). An exponent of 1/2 bounds the error of chords; an interpolant of degree p has an error of order
//!   h^(p+1), so 1/(p+1) is what keeps up with e: 4.5 million samples against some thousand for a panel at 1e-5 mm.
//!   M comes from second differences of offset points. It says nothing about the next derivatives, therefore the
//!   deviation seen between the samples corrects e until the interpolant keeps its part of the tolerance.
//! - Interpolation at the mean of each pole's knots. Where the offset is less than C^(p-1), at knots of the base, the
//!   knots take the multiplicity that it needs.
//! - Knot removal in u and v together (spline/data_reduction.h), each pole's change bounded by its part of the tolerance.
//! - Proof. With (u, v) = map(x, y), the base S(map(x, y)) is a spline of higher degree with the same normals, and the
//!   same-parameter certificate of the result against it bounds |R(x, y) - (S + d N)(map(x, y))|. The map is onto, so the
//!   bound holds for the distance between the two surfaces as sets of points, both ways.
#pragma once

#include "offset_surface.h"

namespace laminate_offset
{

struct PieglTillerOptions
{
    //! Of the interpolant. Range: 2 to 7. Default 3, which Piegl & Tiller recommend. Higher ones cost fewer samples.
    int degree = 3;
    //! Of the number of parts of a span, see above. Range: 0.05 to 0.5. Default 0: 1 / (degree + 1).
    double exponent = 0.0;
    //! Part of the tolerance for the interpolation. Range: 0.01 to 0.9. Default 0.4. Less costs samples.
    double interpolation_share = 0.4;
    //! Part of the tolerance for knot removal in both directions. Range: 0 (none) to 0.9. Default 0.55; what is left of
    //! the tolerance is for what the proof sees above the true error.
    double removal_share = 0.55;
    //! The change of poles that knot removal bounds is several times the error that it makes. So much more than its part
    //! is tried first, and less when the proof then fails. Range: 1 (a plain budget) to 16. Default 4.
    double removal_hope = 4.0;
    //! Largest difference of the base's parameter from chord length, relative in speed, that is left as it is. Range: 0 to
    //! 1. Default 0.05. With 0 every base is reparametrised, which makes the proof up to ten times dearer.
    double chord_length_slack = 0.05;
};

//! \param tolerance the bound to prove [mm].
//! \param distance along S_u x S_v [mm].
//! `certified_error` is proven over the trimmed region as in fit_offset, and empty for a base without spline and model or
//! with a degree too high to be reparametrised.
//! Refusals: SingularNormal, ToleranceNotReached, Cancelled; InvalidOption for options out of range.
Result<OffsetSurface> piegl_tiller_offset(const SurfaceAnalysis &analysis, const InputFace &input, double distance,
                                          double tolerance, const OffsetOptions &options,
                                          const PieglTillerOptions &how = {});

} // namespace laminate_offset
