// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! What the surfaces of two parts can have in common beside a crease at which both parts end.
//!
//! Their derivatives over the two patches, in coordinates across and along the crease, bound every step on them. So the
//! step from one surface to the other at the crease tells how far from it places can come to one point. Where both are heights over one
//! plane whose slopes across the crease differ in one sense all over, they come upon each other once at most for each place along.
#pragma once

#include "meeting_body.h"

namespace laminate_offset
{

//! Two patches beside a crease, in coordinates in which the part with the lower parameters comes first.
struct CreaseNeighbours
{
    MeetingBody &lower;
    MeetingBody &upper;
    ParameterBox before; //!< the patch of the lower part, continued to the crease and along the other one
    ParameterBox after;  //!< the same of the upper part, in the upper part's parameters
    bool constant_u = false;
};

//! Of places of two patches beside a crease that come to one point, no more than this lies between the base points.
double farthest_base_points(const CreaseNeighbours &pair);

//! Do two patches beside a crease at which the surfaces cross come upon each other along one line at most, which is the
//! crossing at the crease?
bool cross_once(const CreaseNeighbours &pair);

} // namespace laminate_offset
