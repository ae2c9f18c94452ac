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

enum class FaceCheck
{
    Whole, //!< BRepCheck_Analyzer's verdict
    None   //!< for members of a family: edges and vertices are proven to be near enough, and the loops in parameters,
    //!< on which all else depends, are those of two members that were checked. On a rough base, whose vertices may
    //!< hide that edges cross, every member is checked all the same
};

//! Builds the face with the base's loops, edge order, orientations and location, and checks it.
//! A vertex of the base becomes several where an edge that is a point on the base opens up between them.
//! Vertex and edge tolerances are those that the geometry shows, never less than OpenCASCADE's
//! resolution. Where that makes no valid face, because edges of the base cross inside its vertices, vertices get as much of
//! the base's vertex tolerance as it takes.
//! Refusal: InvalidResult.
Result<TopoDS_Face> build_face(const InputFace &input, const OffsetSurface &surface, const TrimLoops &loops,
                               FaceCheck check = FaceCheck::Whole);

//! The shell of the offsets of a creased face's parts, with the location of the base. The parts share no edges, so the
//! shell is not connected.
TopoDS_Shell build_shell(const InputFace &input, const std::vector<TopoDS_Face> &parts);

} // namespace laminate_offset
