// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Nearest points against OpenCASCADE's extrema.
#pragma once

#include "cases.h"

#include <iosfwd>

namespace benchmark
{

//! On every face, `count` random points on the surface and off it: how much farther than OpenCASCADE's nearest point
//! (of GeomAPI_ProjectPointOnSurf's solutions, and of the border curves), and how many points a second each way.
void run_nearest(const std::vector<BaseFace> &faces, int count, std::ostream &out);

} // namespace benchmark
