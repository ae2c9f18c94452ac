// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The offset of a trimming curve along the surface normal after Ravi Kumar, Shastry & Prakash (CAD 35, 2003, section 3.3),
//! made without the offset surface.
//!
//! The curve in space (space_curve.h) is looked at in its Bezier pieces. At 2 (p + 1) places of each, the second derivative
//! of its offset is taken as that of a planar curve, in the plane of the tangent t and the surface normal n, whose normal
//! is N = t x n (eq. 3.11). With M the largest of them times the square of the piece's length, the piece gets
//!     n = (M / (8 e))^exponent
//! samples (eq. 3.10, where `pow` is the index of the root). An exponent of 1/2 is right for chords; for an interpolant of
//! degree p the error is of order p + 1, hence 1 / (p + 1), as for surfaces (surface/piegl_tiller.h). The samples lie on
//! S(c(t)) + d N(c(t)) itself: the parameter on the surface is known, and no point needs to be inverted.
//!
//! The curve keeps the pcurve's parameter, so that the edge of the base, that of the offset and its pcurve belong together at
//! equal parameters. The error is proven (offset_curve_certificate.h).
#pragma once

#include "edge_curve.h"

#include "../analysis/base_surface.h"

#include <optional>

namespace laminate_offset
{

struct OffsetCurveOptions
{
    //! Of the interpolant. Range: 2 to 7. Default 3.
    int degree = 3;
    //! Of eq. 3.10. Range: 0.05 to 0.5. Default 0: 1 / (degree + 1).
    double exponent = 0.0;
    //! Part of the tolerance for the interpolation, the rest is for knot removal. Range: 0.05 to 0.95. Default 0.4.
    double interpolation_share = 0.4;
};

//! The base of an offset curve.
struct OffsetCurveBase
{
    const EdgeTarget &target;   //!< the pcurve on the base's spline, or on the base where it has none
    const BaseSurface &surface; //!< the same base
    double distance = 0.0;      //!< along S_u x S_v [mm]
};

//! Deviation of a curve with the pcurve's parameters from the exact offset S(c(t)) + d N(c(t)), proven wherever that is
//! possible.
//! \param target how small the bound has to be [mm].
Deviation offset_deviation(const OffsetCurveBase &base, const Handle(Geom_Curve) & curve, double target);

//! \param tolerance largest distance from the exact offset at equal parameters [mm].
//! \return nothing when the tolerance cannot be reached, or where the surface has no normal along the curve.
std::optional<EdgeCurve> offset_trimming_curve(const OffsetCurveBase &base, double tolerance,
                                               const OffsetCurveOptions &options = {});

} // namespace laminate_offset
