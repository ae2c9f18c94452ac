// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! On which side of its curves the inside of a boundary lies.
#pragma once

#include "../base/result.h"
#include "../input/input_face.h"

#include <TopoDS_Shape.hxx>

#include <vector>

namespace laminate_offset
{

//! The wires of a shape: of a face all, of a compound those of its parts; edges that hang together make a wire.
std::vector<TopoDS_Wire> boundary_wires(const TopoDS_Shape &shape);

//! For each wire whether the inside of all of them together lies on its left, seen with S_u x S_v upwards; a closed
//! wire inside an odd number of others bounds a hole. An image that closes in the parameters decides there; where the face
//! cuts a wire off, its area in space and the face's normals along it do.
//! \param wires where the face stands.
//! \param images of the wires on the face (BoundaryImage::wires), in their directions.
//! Refusals at Stage::Options: InvalidOption for a wire that is open, goes round a closed face, or turns its edge to the
//! face so that no side is its inside.
Result<std::vector<bool>> inside_is_left(const InputFace &input, const std::vector<TopoDS_Wire> &wires,
                                         const std::vector<TopoDS_Shape> &images);

} // namespace laminate_offset
