// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Does a finished offset surface meet itself inside the loops?
#pragma once

#include "offset_surface.h"

#include "../analysis/crease_sides.h"

#include <vector>

namespace laminate_offset
{

//! Refuses an offset whose distant parts meet (self_intersection.h). Analytic surfaces inside their limits do not.
//! \param distance along S_u x S_v [mm].
//! \param tolerance of the offset [mm].
//! \return true where it does not, false where the search could not settle it.
//! Refusal: SelfIntersection.
Result<bool> check_meetings(const SurfaceAnalysis &analysis, const InputFace &input, const OffsetSurface &surface,
                            double distance, double tolerance);

//! A part of a creased base.
struct AnalysedPart
{
    const InputFace &input;
    const SurfaceAnalysis &analysis;
    Handle(Geom_Surface) offset; //!< in the base's parameters; null: one is fitted
};

//! What stands between the surfaces of the base and their offsets.
enum class Between
{
    Nothing, //!< only the offsets themselves count
    Plies    //!< from the face to the offset all is filled
};

//! Refuses offsets of different parts that meet away from their common creases (part_meetings.h).
//! \param edges what the parts do at their creases (crease_sides.h). Parts that cross at a crease, and parts at an end of one
//! that does, are known to cross and are not compared.
//! \param distance along S_u x S_v [mm].
//! \return true where no parts meet or the distance is below twice the tolerance, false where the search could not settle it.
//! Refusal: SelfIntersection at stage Surface, at one of the two places, with the other in the message.
Result<bool> check_part_meetings(const std::vector<AnalysedPart> &parts, const std::vector<CreaseEdge> &edges,
                                 double distance, double tolerance, Between between);

} // namespace laminate_offset
