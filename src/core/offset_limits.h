// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! How far a face can be offset to either side before its offset folds.
#pragma once

#include "base/result.h"

#include <TopoDS_Shape.hxx>
#include <nlohmann/json_fwd.hpp>

#include <optional>

namespace laminate_offset
{

//! The end of the feasible distances on one side.
struct OffsetLimit
{
    double distance = 0.0; //!< [mm] along the face's outward normal; every distance nearer to zero is free of folds
    Where where;           //!< the place of the base face that folds first
};

//! The feasible distances on both sides; an empty side has no limit.
//!
//! Limits come from the face's own curvature inside its trimming loops: S + d N folds where d reaches a
//! radius of curvature. That distant parts of an offset meet each other is a matter of one distance and is
//! checked by offset_face.
struct OffsetLimits
{
    std::optional<OffsetLimit> negative; //!< distance <= 0
    std::optional<OffsetLimit> positive; //!< distance >= 0
    bool proven = true;                  //!< false where curvature could only be sampled: a pole, a base
                                         //!< without spline or model (an offset curve turned)
};

//! The limits of a trimmed face. Planes, cylinders, cones, spheres and tori have them in closed form; on
//! splines they are proven bounds, some 1e-3 of themselves short of the true limit. Where the search's steps run
//! out it gives away more, never less. A radius above a hundred times the face's size is of no interest and
//! may be understated.
//!
//! A face with a crease that tears its offset at one percent of the face's size has the limits that all parts
//! between its creases permit.
//! Refusals: those of the stages Input and Analysis.
Result<OffsetLimits> offset_limits(const TopoDS_Shape &shape);

//! {"status", "stage", "message", "where", "proven", "negative", "positive"}: "where" is the place of a
//! refusal, {u,v,x,y,z} or null; "negative" and "positive" are {"distance", "where"}, or null for a side
//! without a limit and in a refusal; "proven" is null in a refusal.
nlohmann::ordered_json to_json(const Result<OffsetLimits> &limits);

} // namespace laminate_offset
