// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The curve in space of a trimming curve after Ravi Kumar, Shastry & Prakash (CAD 35, 2003, section 3.3.1).
//!
//! An isoparametric pcurve gives the surface's own curve. Any other one is cut where it or the surface is less than C1; each
//! part becomes a cubic with the end points and end derivatives of S(c(t)) (eq. 3.12, 3.13), halved until it keeps the
//! tolerance; then knots are removed. The error is proven over the whole curve (edge_certificate.h) where the paper looks
//! at four points of each piece.
#pragma once

#include "edge_curve.h"

#include <optional>

namespace laminate_offset
{

//! What decides whether a piece is near enough.
enum class PieceCheck
{
    Proven,     //!< a proven bound, or samples where nothing can be proven (default)
    FourSamples //!< the paper's: four points inside the piece; cheaper, and it misses errors between them
};

struct SpaceCurveOptions
{
    PieceCheck check = PieceCheck::Proven;
    //! Part of the tolerance that the pieces may take before knots are removed. Range: 0.05 to 1. Default 0.5.
    double piece_share = 0.5;
};

//! \param tolerance largest distance from S(c(t)) at equal parameters [mm].
//! \return nothing when the tolerance cannot be reached. The deviation is proven wherever the surface and its pcurve permit
//! a proof; with FourSamples it may exceed the tolerance.
std::optional<EdgeCurve> space_curve(const EdgeTarget &target, double tolerance, const SpaceCurveOptions &options = {});

} // namespace laminate_offset
