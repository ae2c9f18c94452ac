// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A trimmed face made larger past its sides.
#pragma once

#include "base/extension_options.h"
#include "base/result.h"
#include "report/extension_report.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

namespace laminate_offset
{

struct ExtensionResult
{
    TopoDS_Face face;       //!< passes BRepCheck_Analyzer; loops and orientation of the base
    ExtensionReport report; //!< status Ok
};

//! Extends a trimmed face past the sides of the rectangle that holds it in its surface's parameters
//! (extension/extend_surface.h has the method).
//!
//! Edges that lie along an extended side move outwards with it, along iso-curves of the extended surface. All other
//! edges, holes among them, stay where they are. The base is only read.
//! Refusals: those of extend_surface; NotSupported where no edge lies along an extended side, or where the base is an
//! offset surface; those of read_face; InvalidOption. Exceptions of OpenCASCADE become a Failure.
Result<ExtensionResult> extend_face(const TopoDS_Shape &shape, const ExtensionOptions &options);

} // namespace laminate_offset
