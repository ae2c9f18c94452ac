// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The one vocabulary of outcomes: every refusal of the engine is a Status at a Stage.
#pragma once

#include <string_view>

namespace laminate_offset
{

//! What became of a request. Names are part of the report format; add, never rename.
enum class Status
{
    Ok,
    NullShape,               //!< no shape was given
    NotAFace,                //!< the shape is not a single face
    InvalidFace,             //!< the face cannot be read as trimmed geometry (no surface, broken loops)
    OpenLoop,                //!< a trimming loop does not close
    ZeroArea,                //!< the face has no area to offset
    NotFinite,               //!< NaN or infinity in the geometry
    UnboundedFace,           //!< the face has no finite trimming loops
    InvalidDistance,         //!< the distance is not a finite number
    InvalidTolerance,        //!< the tolerance is not a positive finite number
    InvalidOption,           //!< another option is out of its range
    NotSupported,            //!< a case that this version declines by name
    KinkedSurface,           //!< the surface's normal jumps along a C0 knot
    SingularNormal,          //!< the normal is undefined somewhere inside the loops
    CurvatureLimit,          //!< the distance passes a radius of curvature inside the loops
    SelfIntersection,        //!< distant parts of the offset meet
    ToleranceNotReached,     //!< no admissible spline meets the tolerance
    EdgeToleranceNotReached, //!< no admissible edge curve meets the tolerance
    InvalidResult,           //!< the result failed its own validity check
    KernelError,             //!< OpenCASCADE raised an exception
    Cancelled                //!< the caller asked to stop
};

//! Where in the pipeline the outcome was decided (see PIPELINE.md).
enum class Stage
{
    Options,
    Input,
    Analysis,
    Surface,
    Extension,
    Trimming,
    Topology,
    Report
};

//! Stable identifier used in reports and by OffsetError.status, e.g. "curvature-limit".
std::string_view name(Status status);

//! Stable identifier used in reports and by OffsetError.stage, e.g. "surface".
std::string_view name(Stage stage);

//! One sentence for the user: what happened.
std::string_view sentence(Status status);

//! One sentence for the user: what to do about it.
std::string_view remedy(Status status);

} // namespace laminate_offset
