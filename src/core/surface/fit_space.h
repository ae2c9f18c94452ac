// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The spline space of a fitted offset: degree and knots of both directions.
#pragma once

#include "offset_samples.h"

#include "../base/options.h"
#include "../spline/knot_vector.h"

#include <limits>
#include <optional>

namespace laminate_offset
{

struct FitSpace
{
    KnotVector u;
    KnotVector v;

    [[nodiscard]] int poles() const { return u.pole_count() * v.pole_count(); }
};

//! Few poles such that each direction alone can follow the samples of all distances to within `tolerance` [mm]. Over
//! the base's weight function the space holds that function too.
//! \param most_poles a space of more poles than that is of no use; the search is left as soon as that shows.
//! \param start where given, a space that a looser tolerance has led to: the search stays at its degrees and starts from
//! it, which costs a fraction of a search from nothing.
//! \return nothing where no admissible degree reaches the tolerance, or where a normal is missing (see the sampler).
std::optional<FitSpace> choose_space(OffsetSampler &sampler, double tolerance, const OffsetOptions &options,
                                     int most_poles = std::numeric_limits<int>::max(), const FitSpace *start = nullptr);

} // namespace laminate_offset
