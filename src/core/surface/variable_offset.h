// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Offsets whose distance varies over the parameters: O(u,v) near S(u,v) + d(u,v) N(u,v) with a spline d.
//!
//! The proof needs nothing new about normals. A family (offset_family.h) keeps |(S^ + x N^) - (S + x N)| below its bound
//! for every x of its interval, place by place, so also for x = d(u,v), whatever d is, as long as its values stay in
//! that interval; they do where its poles do. S^ + d N^ is a (rational) polynomial between the merged knots, of
//! which O is a fit: the Bernstein coefficients of O - (S^ + d N^) bound the rest.
//!
//! With D = S + d N, (D_u x D_v) . N = ((S + x N)_u x (S + x N)_v) . N at x = d, since d_u N and d_v N drop out: where all
//! constant distances between the ends of the interval are inside the curvature limits, D does not fold, however steep d is.
#pragma once

#include "certificate.h"
#include "offset_family.h"
#include "offset_surface.h"

#include "../spline/scalar_spline.h"

namespace laminate_offset
{

struct VariableOffsetRequest
{
    const InputFace &input;
    const OffsetFamily &family;   //!< over the same parameters as `distance`
    const ScalarSpline &distance; //!< along S_u x S_v [mm]; its poles inside [family.low, family.high]
    double tolerance = 0.0;       //!< [mm], the family's own bound included
    RectangleFilter needed;       //!< where the bound has to hold; empty: everywhere
    const OffsetOptions &options;
};

//! A proven bound [mm] of |O - (S^ + d N^)| over the needed rectangles.
//! \param target the search for a smaller bound ends there [mm].
Certificate certify_variable(const OffsetFamily &family, const ScalarSpline &distance, const TensorSpline &offset,
                             double target, const RectangleFilter &needed);

//! A B-spline in the base's parameters within the tolerance of S + d N, with degree and knots chosen for few poles.
//! `certified_error` is empty only where the family has none.
//! Refusals: ToleranceNotReached, Cancelled; InvalidDistance for a pole of `distance` outside the family's interval.
Result<OffsetSurface> fit_variable_offset(const VariableOffsetRequest &request);

} // namespace laminate_offset
