// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A lower bound of a polynomial along a valley: for points that are as far from a whole curve of a patch.
//!
//! There h = |N - w P|^2 - m^2 w^2 is (all but) the same along a curve of the patch, its valley, and grows across it. Its
//! coefficients fall below its values by the square of a part's width, so that they prove a slack s only on parts as narrow
//! as sqrt(s): 1e5 of them along the valley. But where h_vv >= c > 0 on the part, for every line v = a(u) inside of it
//!   h(u, v) >= h(u, a) + h_v(u, a) (v - a) + c (v - a)^2 / 2 >= h(u, a) - h_v(u, a)^2 / (2 c).
//! The right side is a polynomial in u. With a the chord between the valley's places at both ends, its first term is too
//! large by what the second one takes off, but for the variation of h_vv: the error falls with the fifth power of the
//! part's length, and a few dozen parts do. Where h falls towards a side of the part all along, that side is the line, and
//! nothing is taken off. The same with u and v exchanged.
#pragma once

#include "../spline/bernstein.h"

namespace laminate_offset
{

//! What a value along the valley rounds by, as a part of the largest coefficient.
//! \param degree of h, the higher one.
double valley_rounding(int degree);

//! Is h(u, v) + lift >= 0 all over the unit square, as seen along its valley?
//! \param across_v the valley runs along u, else along v.
//! \param curvature lower bound of h_vv (h_uu) over the square, above zero; to a hundredth.
//! \param lift holds valley_rounding() times the largest coefficient, too; what else rounds is counted here.
//! \return false where that is not proven.
bool valley_is_above(const Bernstein &h, double lift, bool across_v, double curvature);

} // namespace laminate_offset
