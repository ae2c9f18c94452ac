// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The offset surfaces of all distances of a stack, from one fit where the base needs a fit.
#pragma once

#include "../surface/offset_surface.h"
#include "stack_fit.h"

#include <vector>

namespace laminate_offset
{

//! Where a stack's surfaces are.
struct StackDistances
{
    std::vector<double> all; //!< along S_u x S_v [mm], in any order, at least one
    double low = 0.0;        //!< least of them
    double high = 0.0;       //!< largest of them

    explicit StackDistances(std::vector<double> distances);
};

//! One surface for each distance. All are exact, of one kind, where the base permits; else all are S^ + d N^ of one
//! family (surface/offset_family.h), on the same knots, so that poles and edge curves combine linearly.
struct StackSurfaces
{
    std::vector<OffsetSurface> surfaces; //!< in the order of the distances
    bool one_family = false;

    //! That of one of the distances.
    [[nodiscard]] const OffsetSurface &at(const StackDistances &distances, double distance) const;
};

//! Refusals: CurvatureLimit, SelfIntersection, for the distance that is out of reach; those of fit_offset_family.
//! \param analysis made for the farthest distance.
//! \param fit Each: surfaces that have to be fitted are fitted one by one, and are no family.
Result<StackSurfaces> stack_surfaces(const SurfaceAnalysis &analysis, const InputFace &input,
                                     const StackDistances &distances, const OffsetOptions &options,
                                     StackFit fit = StackFit::Shared);

} // namespace laminate_offset
