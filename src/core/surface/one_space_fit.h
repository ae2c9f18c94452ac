// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The exact offsets at one distance or more, fitted in one spline space within a tolerance.
#pragma once

#include "../analysis/surface_analysis.h"
#include "../base/options.h"
#include "../base/result.h"
#include "../input/input_face.h"
#include "../spline/tensor_spline.h"

#include <functional>
#include <optional>
#include <vector>

namespace laminate_offset
{

struct OneSpaceRequest
{
    const SurfaceAnalysis &analysis;
    const InputFace &input;
    std::vector<double> distances; //!< at least one, along S_u x S_v [mm]
    double tolerance = 0.0;        //!< [mm], of every spline
    const OffsetOptions &options;
    //! What the use of the splines adds to their error [mm], paid from the tolerance; empty: nothing.
    std::function<double(const std::vector<TensorSpline> &)> surcharge;
};

struct OneSpaceFit
{
    std::vector<TensorSpline> splines;     //!< one for each distance, on the same knots and weights
    std::optional<double> certified_error; //!< proven bound of |O - (S + d N)| of all [mm], the surcharge included
    double sampled_error = 0.0;            //!< largest deviation seen [mm], the surcharge included
};

//! Few poles such that the offsets at all distances are within the tolerance. The bound is proven over the trimmed
//! region (certificate.h) where the base is a spline in its own parameters or has a model; else it is checked at a
//! dense set of samples.
//! Refusals: SingularNormal, ToleranceNotReached, Cancelled.
Result<OneSpaceFit> fit_in_one_space(const OneSpaceRequest &request);

} // namespace laminate_offset
