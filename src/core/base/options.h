// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! What a caller may ask for. Every option states its unit, range, default and cost.
#pragma once

#include "result.h"

#include <functional>
#include <string_view>

namespace laminate_offset
{

//! Route from the base face to its offset.
enum class Method
{
    SameParameter, //!< fit in the base's own parameters; trimming curves are kept unchanged (default)
    RaviKumar      //!< Ravi Kumar, Shastry, Prakash, CAD 35 (2003) 411-420
};

std::string_view name(Method method);

//! Called from time to time with a fraction in [0, 1]; return false to cancel.
using Progress = std::function<bool(double)>;

struct OffsetOptions
{
    //! Signed distance [mm] along the face's outward normal, the face's orientation included.
    //! Range: any finite number. Default 0. No influence on cost.
    double distance = 0.0;

    //! Largest deviation [mm] of the result from the exact offset. Range: > 0. Default 1e-3.
    //! A decade costs about 2 to 3 times the poles.
    double tolerance = 1e-3;

    //! Route. Default SameParameter.
    Method method = Method::SameParameter;

    //! Arc length [mm] by which the result is extended past its four sides, G1 and by the mean rule. Range: >= 0.
    //! Default 0: no extension. SameParameter extends the finished face as extend_face does: edges along a side move
    //! outwards, other edges stay. RaviKumar extends the surface alone, as the paper does: the loops stay where they are,
    //! with new pcurves on the extended surface. What lies past the base's edges is the offset of nothing: errors and limits in the report
    //! are those of the rest. A face torn along creases, or with a closed direction, is refused.
    double extension = 0.0;

    //! Highest degree of the fitted surface in either direction. Range: 3 to 7. Default 7.
    //! A lower degree suits downstream tools and usually costs poles.
    int max_degree = 7;

    //! Progress and cancellation. Default none. It may be called from any thread.
    Progress progress;
};

//! Checks the ranges above. \return Ok value true, or a Failure at Stage::Options.
Result<bool> check(const OffsetOptions &options);

} // namespace laminate_offset
