// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Many offsets of one face at once, as the surfaces of a ply stack.
#pragma once

#include "offset_face.h"
#include "stack/stack_fit.h"

#include <vector>

namespace laminate_offset
{

//! A finished stack.
struct StackResult
{
    std::vector<OffsetResult> surfaces; //!< one for each distance, in the order asked; each with its own report
    //! All fitted surfaces are members of one family: they share their knots and pcurves, and poles of surfaces and
    //! edge curves are linear in the distance.
    bool one_fit = false;
    Elapsed elapsed; //!< of the whole stack
};

//! Offsets a trimmed face by every one of `distances` [mm] along its outward normal, from one analysis and one fit
//! whose bound is proven for the whole interval of distances. Faces are made in parallel; the result does not depend
//! on the number of threads. A base whose parts are torn at creases, or whose edges change their kind with the
//! distance (the apex of a cone), is offset distance by distance.
//!
//! \param distances finite, at least one, in any order; both signs and zero are welcome. options.distance is not used.
//! \param fit Each: every surface that has to be fitted gets the fewest poles for its own distance, with a proof of its
//! own, instead of one family; the time is that of as many single offsets.
//! \return the stack, or the first refusal; nothing is made in part.
//! Refusals: those of offset_face; InvalidDistance, InvalidOption for no distance at all.
Result<StackResult> offset_stack(const TopoDS_Shape &shape, const std::vector<double> &distances,
                                 const OffsetOptions &options, StackFit fit = StackFit::Shared);

} // namespace laminate_offset
