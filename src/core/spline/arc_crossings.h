// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Where plane Bezier arcs cross lines along the axes.
//!
//! An arc with positive weights is halved until its control points lie within a tenth of the tolerance of its chord, which
//! then answers for it: a point farther from both than the tolerance sees as many crossings of the one as of the other, up
//! to an even number. What depends on an arc's ends depends on nothing else, so that arcs which share their ends bit for
//! bit never lose a crossing between them.
#pragma once

#include "control_points.h"

namespace laminate_offset
{

//! How a ray meets an arc.
enum class RayMeeting
{
    Even, //!< it crosses the arc an even number of times
    Odd,
    OnArc //!< the ray's start lies on the arc within the tolerance
};

//! Of the ray from a point towards larger x.
//! \param tolerance the half axes [in x and y] of the ellipse around the point that counts as the point, above zero.
RayMeeting meet_ray(const ControlPoints &arc, const Eigen::Vector2d &point, const Eigen::Vector2d &tolerance);

//! Adds the places along the line x = value (axis 0: values of y) or y = value (axis 1: values of x) where the arc changes
//! its side of the line, each of them a point within the tolerance of the arc.
void add_crossings(const ControlPoints &arc, int axis, double value, const Eigen::Vector2d &tolerance,
                   std::vector<double> &places);

} // namespace laminate_offset
