// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Stage Topology: vertices, edges, wires, the face and the shell of the offset, as a mirror of the base's.
#pragma once

#include "../base/result.h"
#include "../input/input_face.h"
#include "../surface/offset_surface.h"
#include "../trimming/trim_loops.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>

#include <vector>

namespace laminate_offset
{

//! What of a finished face is checked by BRepCheck_Analyzer.
enum class FaceCheck
{
    Whole,   //!< everything
    Topology //!< no geometry: that of curves, surfaces and vertices is proven, and the loops in parameters are those of
             //!< faces that were checked as a whole
};

//! Builds the face with the base's loops, edge order, orientations and location, then checks it.
//! A vertex of the base becomes several where an edge that is a point on the base opens up between them.
//! Vertex and edge tolerances are those that the geometry shows, never less than OpenCASCADE's
//! resolution.
//! Refusal: InvalidResult.
Result<TopoDS_Face> build_face(const InputFace &input, const OffsetSurface &surface, const TrimLoops &loops,
                               FaceCheck check = FaceCheck::Whole);

//! The shell of the offsets of a creased face's parts, with the location of the base. The parts share no edges, so the
//! shell is not connected.
TopoDS_Shell build_shell(const InputFace &input, const std::vector<TopoDS_Face> &parts);

} // namespace laminate_offset
