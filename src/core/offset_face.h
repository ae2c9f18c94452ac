// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The entry point: one trimmed face in, its offset face and report out.
#pragma once

#include "base/options.h"
#include "base/result.h"
#include "report/offset_report.h"

#include <TopoDS_Face.hxx>

namespace laminate_offset
{

//! A finished offset.
struct OffsetResult
{
    TopoDS_Face face;    //!< same loops, orientation and edge order as the base; passes BRepCheck_Analyzer
    OffsetReport report; //!< status Ok
};

//! Offsets a trimmed face by options.distance along its outward normal.
//!
//! The base is only read: its TShape is neither healed, meshed nor changed. Different faces may be
//! offset from different threads at the same time.
//!
//! \return the offset, or the first refusal of the pipeline (see PIPELINE.md). Bad geometry and
//! exceptions of OpenCASCADE become a Failure; only std::bad_alloc can escape.
Result<OffsetResult> offset_face(const TopoDS_Shape &shape, const OffsetOptions &options);

} // namespace laminate_offset
