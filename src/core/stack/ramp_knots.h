// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Where the knots of a ramp stand.
#pragma once

#include "edge_walk.h"

#include <vector>

namespace laminate_offset
{

//! Knots between low and high, as dense as the ramps beside the edges want, at the ends of zones where the density jumps.
//! \param direction 0: of u, 1: of v.
std::vector<double> ramp_knots(const EdgeWalk &walk, int direction, double low, double high);

} // namespace laminate_offset
