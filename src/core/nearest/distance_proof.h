// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The safe way round Newton's iteration: a patch is halved until every part is proven to hold nothing nearer, or has
//! one minimum only (nearest_search.h has the argument).
#pragma once

#include "descent.h"

#include <functional>

namespace laminate_offset
{

struct DistanceProof
{
    const PatchLeaf &leaf;
    const Eigen::Vector3d &p;
    double least = 0.0; //!< no point of the patch is nearer [mm]
    //! Empty where all of the patch counts. Else: false only if nothing in the rectangle does; the border of what counts is
    //! known to be no nearer than `reachable` at first, so that only minima inside of it are of interest.
    std::function<bool(const UnitBox &)> touches;
};

//! \param reachable distance below which a point is of interest [mm]; falls as points are offered.
//! \param offer is told every local minimum.
void prove_distance(const DistanceProof &proof, const std::function<double()> &reachable,
                    const std::function<void(const LeafFoot &)> &offer);

} // namespace laminate_offset
