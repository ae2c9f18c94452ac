// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The inside of a face's loops as a sum of strips in the surface's parameters, none of which crosses a knot line.
#pragma once

#include "../input/input_face.h"

#include <vector>

namespace laminate_offset
{

//! A strip's extent in u at one of its values of v.
struct StripRow
{
    double v = 0.0;
    double left = 0.0;
    double right = 0.0;
    double speed = 0.0; //!< dv for a step of the strip's parameter y
};

//! The region between the knot line u = left and a curve, run through by y from 0 to 1: a piece of a pcurve, or the
//! next knot line.
struct FaceStrip
{
    Handle(Geom2d_Curve) pcurve; //!< null: straight from `start` to `end`
    double first = 0.0;
    double last = 0.0;
    gp_Pnt2d start;
    gp_Pnt2d end;
    double left = 0.0;
    double sign = 1.0; //!< with which the strip counts

    [[nodiscard]] StripRow row(double y) const;
};

//! The strips of a face, by Green's theorem: the integral of f over the inside is that of F dv along the loops, F being
//! the integral of f over u from the box's left side. Where it runs through whole intervals between knots, those parts
//! are gathered to rectangles, each of which counts once.
//! \param us, vs where f is less smooth, increasing, with the ends of a box around the loops.
std::vector<FaceStrip> face_strips(const InputFace &input, const std::vector<double> &us,
                                   const std::vector<double> &vs);

} // namespace laminate_offset
