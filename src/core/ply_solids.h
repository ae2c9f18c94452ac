// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The solids of a ply stack: single plies, plies of one material together, the whole laminate.
#pragma once

#include "base/result.h"
#include "topology/ply_solid.h"

#include <TopoDS_Shape.hxx>

#include <vector>

namespace laminate_offset
{

//! A valid, closed solid with its normals outwards for each span between two faces of a stack (offset_stack), the faces
//! counted from 0. Spans may overlap: the plies, the materials and the whole laminate can be asked for at once. See
//! make_solids.
//! Refusals: NotAFace for what is no single face (the shell of a creased base), NotSupported, InvalidOption,
//! InvalidResult; nothing is made in part.
Result<std::vector<TopoDS_Solid>> ply_solids(const std::vector<TopoDS_Shape> &faces,
                                             const std::vector<SolidSpan> &spans);

} // namespace laminate_offset
