// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! How far the offsets of a creased base's parts are apart along the edges that the parts share.
#pragma once

#include "trim_loops.h"

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

//! Proven bound of the distance [mm] between the two edges that any two of the parts have for an edge of the base, at equal
//! parameters; their distance as curves is no larger. Above their true distance by half a percent for polynomial
//! edge curves, by a sixth at most for others. Nothing where an edge has no proof.
//! \param tolerance of the offset [mm].
std::optional<double> tear_width(const std::vector<OffsetPart> &parts, double tolerance);

} // namespace laminate_offset
