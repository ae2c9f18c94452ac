// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The trimmed face on an extended surface.
#pragma once

#include "../base/result.h"
#include "../extension/extend_surface.h"
#include "../input/input_face.h"

#include <TopoDS_Face.hxx>

namespace laminate_offset
{

//! Rebuilds the face on the extended surface. Edges that lie along an extended side move outwards to its new end;
//! where they end at another edge, iso-curves connect the two; where two extended sides meet they meet in a new corner.
//! All other edges stay, with their curves, and so do the number, order and orientation of the loops. The count of the
//! edges that moved is written into the sides of `extended`.
//! The base's own edges and vertices are copied, never changed.
//! Refusals: NotSupported at stage Extension where no edge lies along any of the sides, InvalidResult at stage Topology.
Result<TopoDS_Face> build_extended_face(const InputFace &input, ExtendedSurface &extended);

} // namespace laminate_offset
