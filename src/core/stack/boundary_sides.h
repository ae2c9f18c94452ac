// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! On which side of its curves the inside of a boundary lies.
#pragma once

#include "../input/input_face.h"

#include <TopoDS_Shape.hxx>

#include <optional>
#include <vector>

namespace laminate_offset
{

//! The wires of a shape: of a face all, of a compound those of its parts; edges that hang together make a wire.
std::vector<TopoDS_Wire> boundary_wires(const TopoDS_Shape &shape);

//! For each wire whether the inside of all of them together lies on its left, seen with S_u x S_v upwards; a closed
//! wire inside an odd number of others bounds a hole. Empty where a wire is open or encloses nothing.
//! \param wires where the face stands.
std::vector<bool> inside_is_left(const InputFace &input, const std::vector<TopoDS_Wire> &wires);

} // namespace laminate_offset
