// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Curves with fewer knots (data reduction by knot removal, Lyche & Morken 1987).
#pragma once

#include "../spline/least_squares.h"

namespace laminate_offset
{

struct CurvePoles
{
    KnotVector knots;
    RowMatrix poles; //!< one row a pole, x, y, z
};

//! The curve over some of its knots, with its end points kept.
//! \param tolerance [mm] that no pole's change may exceed, nor therefore the curve's.
//! \return the curve itself where no knot can go.
CurvePoles without_needless_knots(const CurvePoles &curve, double tolerance);

} // namespace laminate_offset
