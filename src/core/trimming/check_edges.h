// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Are the finished edges within the tolerance?
#pragma once

#include "trim_loops.h"

namespace laminate_offset
{

//! A base whose seam closes only within its own tolerance passes that gap on to the offset's seam, which is refused
//! where it exceeds the user's tolerance [mm].
//! Refusal: EdgeToleranceNotReached.
Result<bool> check_edges(const InputFace &input, const OffsetSurface &surface, const TrimLoops &loops,
                         double tolerance);

} // namespace laminate_offset
