// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The report of one finished face from the results of the stages.
#pragma once

#include "offset_report.h"

#include "../analysis/surface_analysis.h"
#include "../input/input_face.h"
#include "../surface/offset_surface.h"
#include "../trimming/trim_loops.h"

namespace laminate_offset
{

//! Everything but the elapsed times.
OffsetReport face_report(const InputFace &input, const SurfaceAnalysis &analysis, const OffsetSurface &surface,
                         const TrimLoops &loops, const OffsetOptions &options);

} // namespace laminate_offset
