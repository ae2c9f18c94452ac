// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The edges of all members of an offset family at once: C_d = C_low + (d - low) / (high - low) (C_high - C_low).
//!
//! Surface and curve are linear in d, so C_d - O_d(c) is too, and its length is convex in d: what is proven at both
//! ends bounds every member between them, place by place. Poles and pcurves are shared, and a member costs one linear
//! combination of poles.
#pragma once

#include "trim_loops.h"

#include <optional>

namespace laminate_offset
{

//! Two members of a family of offset surfaces on the same knots and weights, and their distances along S_u x S_v [mm].
struct FamilyEnds
{
    const OffsetSurface &at_low;
    const OffsetSurface &at_high;
    double low = 0.0;
    double high = 0.0; //!< above `low`
};

//! The edges at both ends, curve by curve on the same knots and weights.
struct LoopFamily
{
    TrimLoops at_low;
    TrimLoops at_high;
    double low = 0.0;
    double high = 0.0;

    //! The edges at a distance of [low, high], with bounds that hold for all of them.
    [[nodiscard]] TrimLoops at(double distance) const;
};

//! \param tolerance largest deviation of an edge curve from its member's surface [mm].
//! \return nothing where the two ends' edges are not of one kind (a point that opens up, no spline), so that every
//! member needs edges of its own. Refusal: EdgeToleranceNotReached.
Result<std::optional<LoopFamily>> loop_family(const InputFace &input, const BaseSurface &base, const FamilyEnds &ends,
                                              double tolerance);

} // namespace laminate_offset
