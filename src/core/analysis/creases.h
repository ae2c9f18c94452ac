// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Creases: isoparametric lines of the base along which its unit normal jumps, so that its offset is torn. The seam of a
//! closed base may be one too, as at the trailing edge of a wing's skin.
#pragma once

#include "base_surface.h"
#include "loop_region.h"

#include "../base/result.h"
#include "../input/input_face.h"

#include <vector>

namespace laminate_offset
{

//! One crease, along the whole line u = parameter or v = parameter.
struct CreaseLine
{
    bool constant_u = false;
    double parameter = 0.0; //!< of a seam: where a cut on the other side of the tube opens it
    double angle = 0.0;     //!< largest angle between the normals of its two sides, inside the loops [rad]
    double tear = 0.0;      //!< largest distance between the offsets of its two sides, 2 |d| sin(angle / 2) [mm]
    gp_Pnt2d uv;            //!< where that is
};

//! The formally C0 knot lines and the seams whose normals tear the offset by more than half of the tolerance somewhere
//! inside the loops. Where only the parametrisation kinks, or nothing does, there is no crease.
//! \param base that of the input, perhaps its model.
//! \param distance signed along S_u x S_v [mm].
std::vector<CreaseLine> find_creases(const InputFace &input, const BaseSurface &base, const LoopRegion &region,
                                     double distance, double tolerance);

//! The larger one of the distance and of that at which the face itself stands from its surface: neither the offset
//! nor the face may be torn. \param distance signed along S_u x S_v [mm].
double farther_distance(const InputFace &input, double distance);

//! The refusal that names the worst of the creases, of which there is one at least.
Failure creased_refusal(const InputFace &input, const std::vector<CreaseLine> &creases);

//! The base over the box that a fit covers (fit_box), whose margin ends at formally C0 knot lines outside of the
//! loops: the offset need not go on smoothly over there.
BaseSurface base_beside_creases(const InputFace &input, const ModelDemand &demand);

//! The face split along the creases inside its loops, the parts in the order of their parameters. Each part is a
//! face on the base's own surface, with the location and orientation of the base; no crease goes through it, at
//! most one runs along its loops. Holes and seams stay what they are; edges that a crease cuts are cut there, and
//! an edge between two parts is the same edge in both.
//! \param distance signed along S_u x S_v [mm].
//! \return the face itself where it has no crease.
//! Refusal: KinkedSurface, where the parts do not make up the face.
Result<std::vector<InputFace>> split_at_creases(const InputFace &input, double distance, double tolerance);

} // namespace laminate_offset
