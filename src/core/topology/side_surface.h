// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The surface of the straight lines between two edge curves at equal parameters: the side of a ply.
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

#include <optional>

namespace laminate_offset
{

//! A side surface and where its two curves lie on it, each with its own parameter.
struct SideSurface
{
    Handle(Geom_Surface) surface;
    Handle(Geom2d_Curve) low;
    Handle(Geom2d_Curve) high;
    //! The surface's own normal is opposite to (along the curves) x (from low to high).
    bool flipped = false;
    //! A plane in which the curves lie round each other: closed ones bound a ring without a seam.
    bool ring = false;
    //! Proven bounds of how far the curves keep from the surface at equal parameters [mm]; 0, but for rounding, where no
    //! spline stands for a curve.
    double low_error = 0.0;
    double high_error = 0.0;
};

//! A plane, cylinder or cone where the curves are lines or circles that allow one, an extrusion where one curve is the
//! other one moved, else a B-spline of degree 1 across, on the knots of both, in which a spline stands for a circle or an
//! ellipse.
//! \return nothing for curves of other kinds that differ.
std::optional<SideSurface> side_surface(const Handle(Geom_Curve) & low, const Handle(Geom_Curve) & high, double first,
                                        double last);

} // namespace laminate_offset
