// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Edge curves on the knots of another one, so that the two combine linearly.
#pragma once

#include "edge_curve.h"

#include <Geom_BSplineCurve.hxx>

namespace laminate_offset
{

//! Neither periodic nor with open ends.
bool clamped(const Geom_BSplineCurve &curve);

//! Do two curves have the same degree, knots and weights?
bool on_same_knots(const Geom_BSplineCurve &a, const Geom_BSplineCurve &b);

//! The curve on the knots and weights of `pattern`, a clamped one, that fits samples of the target; null where there is
//! none. How near it comes is up to the caller to prove.
Handle(Geom_BSplineCurve) through_samples(const Geom_BSplineCurve &pattern, const EdgeTarget &target);

} // namespace laminate_offset
