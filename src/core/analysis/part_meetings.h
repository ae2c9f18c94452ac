// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Do the offsets of different parts of a creased base meet, far from the creases or across them?
//!
//! Looked at are the offset surfaces, or the slabs between these and other offsets of the same parts, as plies fill them.
//! Pairs of patches are searched in rounds from coarse to fine. A pair is settled
//! - when its boxes, or its extents along one of its tangents or normals, lie apart: over a patch, points differ from the
//!   middle one by no more than the derivatives' box permits;
//! - beside a crease that both parts share, when the derivatives of both sides, in coordinates along and across it, and the
//!   step from one side to the other leave only places together whose base points are as good as one;
//! - when all base points of both patches are as good as one, as where two parts touch in a corner;
//! - when neither patch touches the inside of its loops.
//! Else the longer patch is halved. As in self_intersection.h a meeting is reported only when it has been computed, with
//! base points that lie apart by a good part of the distance. Pairs that stay open to the end count as apart, and the result
//! says so.
//!
//! What parts do at their common creases themselves is judged by crease_sides.h. Where they cross there, that crossing is no
//! news, but another one is. Beside such a crease a pair is settled, too, when the slopes of both sides differ in one
//! sense all over, from the crease on: then the surfaces come upon each other along one line at most, which is the crossing at the
//! crease. A meeting that has been computed is followed to smaller distances. That of the crease shrinks into it,
//! along a part's border where it comes upon one; any other one ends on the way and is reported. So many are followed, then the
//! pair stays open.
#pragma once

#include "crease_sides.h"
#include "meeting_body.h"

#include <functional>
#include <optional>
#include <vector>

namespace laminate_offset
{

struct PartMeetingQuery
{
    std::vector<MeetingPart> parts;
    double distance = 0.0;  //!< of the far surface along S_u x S_v [mm]; below twice the tolerance nothing is examined
    double tolerance = 0.0; //!< of the offset [mm]
    std::vector<CreaseEdge> edges; //!< of two parts; empty: parts have none in common
    //! Pairs of parts that are known to cross at a crease or at an end of one; empty: none.
    std::function<bool(std::size_t, std::size_t)> cross;
};

//! Two places inside the loops of two parts that come to one point.
struct PartMeeting
{
    std::size_t first_part = 0;
    gp_Pnt2d first;
    std::size_t second_part = 0;
    gp_Pnt2d second;
};

struct PartMeetingSearch
{
    std::optional<PartMeeting> meeting;
    bool settled = true; //!< false: some pairs were still open at the end, or a base has neither spline nor model
    std::optional<PartMeeting> open; //!< places of such a pair
};

PartMeetingSearch find_part_meeting(const PartMeetingQuery &query);

} // namespace laminate_offset
