// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! How far the offsets of a creased base's parts are apart along the edges that the parts share.
#pragma once

#include "trim_loops.h"

#include "../base/crease_kind.h"

#include <optional>
#include <vector>

namespace laminate_offset
{

//! One part of a creased base, offset.
struct OffsetPart
{
    const OffsetSurface &surface;
    const TrimLoops &loops;
};

struct Tear
{
    //! Proven bound of the distance [mm] between the two edges that the parts have for an edge of the base, at equal
    //! parameters; their distance as curves is no larger. Above their true distance by half a percent for polynomial
    //! edge curves, by a sixth at most for others. Nothing where an edge has no proof.
    std::optional<double> width;
    //! Nothing where the parts keep within the tolerance of each other.
    std::optional<CreaseKind> kind;
};

//! The largest tear between any two of the parts.
//! \param tolerance what is no wider than half of this [mm] is neither a gap nor an overlap.
Tear measure_tear(const std::vector<OffsetPart> &parts, double tolerance);

} // namespace laminate_offset
