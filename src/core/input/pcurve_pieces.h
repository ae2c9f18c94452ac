// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Trimming curves cut into short pieces, each inside a box of parameters.
#pragma once

#include "input_face.h"

#include <vector>

namespace laminate_offset
{

//! The pieces of a pcurve between two parameters.
std::vector<PcurvePiece> cut_up(const Handle(Geom2d_Curve) & pcurve, double first, double last);

} // namespace laminate_offset
