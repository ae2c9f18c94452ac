// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The offset surface made larger on its four sides before it is trimmed (Ravi Kumar, Shastry & Prakash, CAD 35, 2003,
//! section 3.2), so that images of offset trimming curves do not end at its border.
#pragma once

#include "../input/input_face.h"
#include "../surface/offset_surface.h"
#include "extend_surface.h"

namespace laminate_offset
{

struct ExtendedOffset
{
    //! In the parameters of the offset that was extended. The certified error has the rounding of the extension added, and is
    //! empty where that is not known.
    OffsetSurface surface;
    ParameterBox box; //!< its sides
    std::vector<ExtendedSide> sides;
};

//! Extends an offset surface, G1 and by the mean rule. A spline goes on from its own border; any other surface from
//! the rectangle that holds the loops.
//! \param input of the base; messages name its places.
//! \param length of the extension [mm].
//! \param distance of the offset along S_u x S_v [mm].
//! Refusals: those of extend_surface.
Result<ExtendedOffset> extend_offset(const InputFace &input, const OffsetSurface &offset, double distance,
                                     double length);

} // namespace laminate_offset
