// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Does a finished offset surface meet itself inside the loops?
#pragma once

#include "offset_surface.h"

namespace laminate_offset
{

//! Refuses an offset whose distant parts meet (self_intersection.h). Analytic surfaces inside their limits do not.
//! \param distance along S_u x S_v [mm].
//! \param tolerance of the offset [mm].
//! \return true where it does not, false where the search could not settle it.
//! Refusal: SelfIntersection.
Result<bool> check_meetings(const SurfaceAnalysis &analysis, const InputFace &input, const OffsetSurface &surface,
                            double distance, double tolerance);

} // namespace laminate_offset
