// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The entry point: one trimmed face in, its offset and report out.
#pragma once

#include "base/options.h"
#include "base/result.h"
#include "report/offset_report.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <string_view>

namespace laminate_offset
{

//! A finished offset.
struct OffsetResult
{
    //! A face with the loops, orientation and edge order of the base; it passes BRepCheck_Analyzer. Where creases
    //! tear the base's offset by more than half of the tolerance: a shell of one such face for every part of the base
    //! between its creases. Each passes the check; the shell as a whole is not connected, since its parts do not
    //! share edges.
    TopoDS_Shape shape;
    OffsetReport report; //!< status Ok

    //! The face. \pre report.faces is 1.
    [[nodiscard]] TopoDS_Face face() const;
};

//! Offsets a trimmed face by options.distance along its outward normal.
//!
//! The base is only read: its TShape is neither healed, meshed nor changed. Different faces may be
//! offset from different threads at the same time.
//!
//! \return the offset, or the first refusal of the pipeline (see PIPELINE.md). Bad geometry and
//! exceptions of OpenCASCADE become a Failure; only std::bad_alloc can escape.
Result<OffsetResult> offset_face(const TopoDS_Shape &shape, const OffsetOptions &options);

//! As above, for what is more than an offset: where distant parts meet, the refusal names this remedy in place of a smaller
//! distance.
Result<OffsetResult> offset_face(const TopoDS_Shape &shape, const OffsetOptions &options,
                                 std::string_view meeting_remedy);

} // namespace laminate_offset
