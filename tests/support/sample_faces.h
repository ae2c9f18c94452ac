// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Faces made in memory, so that tests run without any model file. Lengths in mm.
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Face.hxx>

#include <functional>

namespace test_support
{

//! Spline surface of the degree in both directions over [0, 1] x [0, 1] with poles_u x poles_v poles
//! (x, y, height(x, y)) on a regular grid over size_u x size_v, centred on the origin.
Handle(Geom_BSplineSurface) height_surface(const std::function<double(double, double)> &height, double size_u,
                                           double size_v, int poles_u, int poles_v, int degree = 3);

//! A tube round the z axis whose radius varies smoothly by 8 percent, as a spline of degree 3, periodic in u.
Handle(Geom_BSplineSurface) wavy_tube(double radius);

//! A rectangle of parameters as four edges. They may hang over the ends of the surface's domain, and two may coincide in
//! space without knowing it.
TopoDS_Face rectangle_on(const Handle(Geom_Surface) & surface, double u0, double u1, double v0, double v1);

//! A doubly curved spline panel of 800 x 500 with an elliptic hole: 2 loops, 5 edges, normal upwards (+z).
//! Its radii of curvature are above 300 on both sides.
TopoDS_Face panel_with_hole();

//! The same points with the opposite outward normal.
TopoDS_Face reversed(const TopoDS_Face &face);

//! The face under a location that turns and moves it.
TopoDS_Face located(const TopoDS_Face &face);

//! Part of a sphere about the origin, radians; the outward normal points away from the centre.
TopoDS_Face sphere_patch(double radius);

} // namespace test_support
