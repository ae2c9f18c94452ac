// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The solids of a stack on a face with creases, where its offsets are torn into parts.
#pragma once

#include "offset_face.h"

#include "topology/ply_solid.h"

#include <TopoDS_Shape.hxx>

#include <vector>

namespace laminate_offset
{

//! For each span between two of the distances, one solid for each part of the face between its creases, in the order of the
//! parts. The face is split where its farthest offset is torn, and every part is stacked by itself, so the parts are the
//! same at all distances. At a crease that opens, nothing lies between the parts' solids; where parts would cross each other
//! nothing is made.
//! \param distances finite, along the face's outward normal [mm]; options.distance is not used.
//! \param spans count the distances from 0.
//! Refusals: those of offset_stack and make_solids; KinkedSurface where parts cross at a crease, with its place, and where
//! the face cannot be split; SelfIntersection where plies of different parts run into each other elsewhere;
//! NotSupported where it cannot be settled whether they do.
Result<std::vector<std::vector<TopoDS_Solid>>> creased_ply_solids(const TopoDS_Shape &face,
                                                                  const std::vector<double> &distances,
                                                                  const std::vector<SolidSpan> &spans,
                                                                  const OffsetOptions &options);

} // namespace laminate_offset
