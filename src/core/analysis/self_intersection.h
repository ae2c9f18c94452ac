// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Do distant parts of an offset surface meet inside the trimming loops?
//!
//! The surface itself is locally regular (the curvature limits hold), so it meets itself only at places that
//! lie apart in parameters. A tree of boxes over its Bernstein pieces is searched for such pairs. A pair of
//! rectangles is settled
//! - when their boxes, or the control points along the pieces' normals, lie apart;
//! - when the surface is one-to-one over the rectangle that holds both (PatchBounds::one_to_one): this settles
//!   neighbours, also across the seam of a closed surface, where parameters go on beyond their period;
//! - when both lie at the same side of the base that is a point (a pole, an apex), their normals differ by less than 60 degrees,
//!   and the offset has not run through that point and out on its other side by more than the tolerance.
//! Else the rectangles are halved: one with itself across the direction in which its derivatives vary more, the
//! larger of a pair across its longer side. Nearly every face is settled whole, from the poles alone.
//!
//! A meeting is only reported when it has been computed: two places inside the loops whose offset points
//! coincide to rounding, while their base points lie apart by a good part of the distance. Seams, poles and
//! neighbours have coinciding base points, so they are never taken for one. A meeting that continues one of
//! the base with itself is the base's own and is not reported either. Pairs that are still
//! open when the budget or the resolution (a part of the tolerance) is used up, without any meeting found,
//! count as apart, and the report says so: that is a closeness of the tolerance, or a surface too intricate to decide.
#pragma once

#include "surface_analysis.h"

#include "../spline/tensor_spline.h"

#include <optional>
#include <string_view>

namespace laminate_offset
{

//! The remedies that refusals of meetings name: of an offset, and of plies.
inline constexpr std::string_view smaller_distance = "use a smaller distance";
inline constexpr std::string_view fewer_plies = "lay fewer or thinner plies";

struct SelfIntersectionQuery
{
    const SurfaceAnalysis &analysis;
    const InputFace &input;
    const TensorSpline &offset; //!< in the base's parameters
    double distance = 0.0;      //!< along S_u x S_v [mm]; below twice the tolerance nothing is examined
    double tolerance = 0.0;     //!< of the offset [mm]
    std::string_view remedy = smaller_distance;
};

//! Two places inside the loops that the offset takes to one point.
struct SelfMeeting
{
    gp_Pnt2d first;
    gp_Pnt2d second;
};

struct SelfIntersectionSearch
{
    std::optional<SelfMeeting> meeting;
    bool settled = true; //!< false: some pairs were still open at the end
    int pairs = 0;       //!< pairs examined; 0 where the surface was settled whole
};

SelfIntersectionSearch find_self_intersection(const SelfIntersectionQuery &query);

//! Refuses a meeting as SelfIntersection at stage Surface, at one of its two places on the base face; the message
//! names the other.
//! \return true where there is none, false where some pairs stayed open.
Result<bool> check_self_intersection(const SelfIntersectionQuery &query);

} // namespace laminate_offset
