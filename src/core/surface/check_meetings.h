// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Does a finished offset surface meet itself inside the loops?
#pragma once

#include "offset_surface.h"

#include "../analysis/crease_sides.h"
#include "../analysis/self_intersection.h"

#include <optional>
#include <string_view>
#include <vector>

namespace laminate_offset
{

//! Refuses an offset whose distant parts meet (self_intersection.h). Analytic surfaces inside their limits do not.
//! \param distance along S_u x S_v [mm].
//! \param tolerance of the offset [mm].
//! \param remedy that a refusal names.
//! \return true where it does not, false where the search could not settle it.
//! Refusal: SelfIntersection.
Result<bool> check_meetings(const SurfaceAnalysis &analysis, const InputFace &input, const OffsetSurface &surface,
                            double distance, double tolerance, std::string_view remedy = smaller_distance);

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

//! Whether parts keep apart.
struct PartsApart
{
    bool settled = true;
    std::optional<Where> open; //!< a place that could not be settled, where there is one to name
};

//! Refuses offsets of different parts that meet away from their common creases (part_meetings.h).
//! \param edges what the parts do at their creases (crease_sides.h). Of parts that cross at a crease, and of parts at an end of
//! one that does, that crossing is known and not refused.
//! \param distance along S_u x S_v [mm].
//! \param remedy that a refusal names.
//! \return settled where no parts meet or the distance is below twice the tolerance, not settled where the search left it open.
//! Refusal: SelfIntersection at stage Surface, at one of the two places, with the other in the message.
Result<PartsApart> check_part_meetings(const std::vector<AnalysedPart> &parts, const std::vector<CreaseEdge> &edges,
                                       double distance, double tolerance, Between between, std::string_view remedy);

} // namespace laminate_offset
