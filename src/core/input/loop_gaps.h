// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Where the curves of a trimming loop follow each other without meeting exactly in the surface's parameters.
//!
//! The end of each curve belongs to the start of one other, since a loop runs through its curves one way. What the inside of
//! a loop is depends on it: any other pairing crosses every line an even number of times too, but encloses something else.
//! Vertices say which ends belong together; where several curves start from one vertex (on both sides of a seam, or where
//! a loop touches itself), and where none does, the nearest start is taken. Gaps are measured as parts of the loops' box in
//! each direction, since u and v may be an angle and a length.
#pragma once

#include "input_face.h"

#include <cstddef>
#include <vector>

namespace laminate_offset
{

//! The places of the parameters where a curve of a loop starts and ends, in the loop's sense.
struct CurveEnds
{
    gp_Pnt2d start;
    gp_Pnt2d end;
};

//! From the end of one curve to the start of the next one.
struct LoopGap
{
    gp_Pnt2d from;
    gp_Pnt2d to;
    //! Too wide for a straight line to close the loop: more than a thousandth of the loops' box, and not one point of space
    //! either, as along the collapsed side at a pole. A seam edge is missing, for instance. read_face() refuses such a loop.
    bool jump = false;
};

//! The ends of the curves of a loop that bound the face, in the loop's order, as their pieces have them.
std::vector<CurveEnds> curve_ends(const TrimmingLoop &loop);

//! The number of the curve that follows each curve of the loop that bounds the face, counted in the loop's order.
//! \param ends of those curves, in the loop's order.
std::vector<std::size_t> following_curves(const InputFace &input, const TrimmingLoop &loop,
                                          const std::vector<CurveEnds> &ends);

//! One gap for each curve of the loop that bounds the face, in the loop's order; `from` and `to` may be equal.
//! \param ends of those curves, in the loop's order.
std::vector<LoopGap> loop_gaps(const InputFace &input, const TrimmingLoop &loop, const std::vector<CurveEnds> &ends);

} // namespace laminate_offset
