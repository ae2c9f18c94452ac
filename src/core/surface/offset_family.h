// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! All offsets between two distances at once: the base's points and its unit normals in one spline space, so that every
//! distance of a ply stack costs one linear combination of poles.
//!
//! The deviation (S^ + d N^) - (S + d N) = (S^ - S) + d (N^ - N) of a family is linear in d, so its length is convex in
//! d and largest at one of the two ends, place by place. A bound of both ends therefore bounds every distance between.
#pragma once

#include "../analysis/surface_analysis.h"
#include "../base/options.h"
#include "../base/result.h"
#include "../input/input_face.h"
#include "../spline/tensor_spline.h"

#include <optional>

namespace laminate_offset
{

//! S^ and N^ on the same knots and the same weights, in the parameters of the base. Distances are from
//! InputFace::surface along S_u x S_v [mm].
struct OffsetFamily
{
    TensorSpline position;  //!< S^ [mm]; near the base at low <= 0 <= high, else only a part of S^ + d N^
    TensorSpline direction; //!< N^, without a unit; its weights are those of S^
    double low = 0.0;       //!< least distance served [mm]
    double high = 0.0;      //!< largest distance served [mm], above `low`
    std::optional<double> certified_error; //!< proven bound of |at(d) - (S + d N)| for all d of [low, high] [mm]
    double sampled_error = 0.0;            //!< largest deviation seen at either end [mm], rounding included

    //! S^ + distance * N^, with its rounding inside the bounds above.
    //! \param distance of [low, high]; nothing is known of any other.
    [[nodiscard]] TensorSpline at(double distance) const;
};

//! A family within `tolerance` [mm] of the exact offsets at all distances of [low, high], with degree and knots chosen
//! for few poles. `certified_error` is proven over the trimmed region where the base is a spline in its own parameters
//! or has a model, and empty for any other base. Both signs and zero are welcome in the interval; a single distance is
//! fitted by fit_offset.
//! \param analysis best made for the larger of |low| and |high|: its model error at that distance is paid from the
//! tolerance. That both ends are inside its limits (check_distance) is up to the caller.
//! \param low, high along S_u x S_v [mm], finite, low < high.
//! Refusals: InvalidDistance for ends that are not finite, InvalidOption for low >= high, both at Stage::Options; at
//! Stage::Surface SingularNormal, ToleranceNotReached, Cancelled.
Result<OffsetFamily> fit_offset_family(const SurfaceAnalysis &analysis, const InputFace &input, double low, double high,
                                       double tolerance, const OffsetOptions &options);

} // namespace laminate_offset
