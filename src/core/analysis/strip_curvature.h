// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The search of curvature.h in one parameter, for surfaces whose curvature depends on one parameter only.
//!
//! The loops of a face hold the whole range of that parameter between its least and largest value on them, since
//! the inside is connected. So the curvatures over this range, on any line of the other parameter, are those of the
//! face.
#pragma once

#include "curvature.h"

namespace laminate_offset
{

CurvatureExtremes strip_extremes(const CurvatureStrip &strip, const LoopRegion &region, const CurvatureSearch &search);

} // namespace laminate_offset
