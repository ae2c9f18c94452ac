// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Trimming curves cut into short pieces, each inside a box of parameters.
#pragma once

#include "input_face.h"

#include <vector>

namespace laminate_offset
{

struct PcurvePiece
{
    gp_Pnt2d start;
    gp_Pnt2d end;
    ParameterBox box; //!< holds the whole piece
};

//! Appends the pieces of one trimming curve; a straight one is a single piece.
void add_pieces(const TrimmingCurve &curve, std::vector<PcurvePiece> &pieces);

} // namespace laminate_offset
