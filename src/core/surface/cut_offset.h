// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A part of a face on the offset surface of the whole.
#pragma once

#include "offset_surface.h"

#include "../input/input_face.h"

namespace laminate_offset
{

//! The offset surface of a whole face for a part of that face: a B-spline in the base's own parameters is cut to the box that
//! a fit of the part covers, anything else is kept as it is. The errors are those of the whole, and the rounding of the cut.
//! \param distance of the offset from the face [mm].
OffsetSurface cut_to(const InputFace &part, const OffsetSurface &whole, double distance);

} // namespace laminate_offset
