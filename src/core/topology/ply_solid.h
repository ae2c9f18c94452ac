// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Solids between faces that are trimmed alike, as those of a ply stack are.
#pragma once

#include "../base/result.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Solid.hxx>

#include <cstddef>
#include <vector>

namespace laminate_offset
{

//! Which two faces a solid lies between.
struct SolidSpan
{
    std::size_t low = 0;  //!< index of the face at the lower distance along the outward normal
    std::size_t high = 0; //!< index of the face at the higher distance; not `low`
};

//! One solid for each span, all closed, valid and with their normals outwards. Top and bottom are copies of the faces
//! themselves, one copy of each for all solids: neighbours share the face, the lower one as it is and the upper one
//! reversed, so that nothing lies between them. The sides are the straight lines between points of equal parameters
//! (side_surface.h), a face for each edge; seams and edges that are points have none. All edges are shared.
//!
//! The solids are made in parallel; the result does not depend on the number of threads. The faces given are only read.
//! \param faces offsets of one face, or others with the same loops: edge k of one belongs to edge k of all, with the
//! same parameter range, and points of equal parameters lie opposite each other.
//! Refusals, at stage Topology: NotSupported where faces do not belong together or a side has no surface, InvalidResult.
Result<std::vector<TopoDS_Solid>> make_solids(const std::vector<TopoDS_Face> &faces,
                                              const std::vector<SolidSpan> &spans);

} // namespace laminate_offset
