// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Stage Extension: a surface made larger past the sides of a rectangle of its parameters (Ravi Kumar, Shastry,
//! Prakash, CAD 35 (2003) 411-420, section 3.2).
//!
//! Inside the rectangle the surface keeps its parameters and, to rounding, its points. Three ways, by kind of surface:
//! - a spline is cut at the side and goes on from there by mirrored poles or as its last polynomial piece
//!   (pole_lines.h), whatever it had past that side before;
//! - a surface swept along or about an axis goes on as itself in the sweep, and by its extended profile across it;
//! - any other surface goes on as itself.
//!
//! How far the parameter goes is found on eight iso-curves with equal spacing over the rectangle, its ends included:
//! the mean of the straight extensions' parameters (eq. 3.9) is the start of a search that ends when the arc lengths
//! of the extended iso-curves themselves meet the length asked for.
#pragma once

#include "../base/extension_options.h"
#include "../input/input_face.h"

#include <Geom_Surface.hxx>

#include <vector>

namespace laminate_offset
{

//! What became of one side.
struct ExtendedSide
{
    Side side = Side::UMin;
    double parameter = 0.0;   //!< where the surface ends now
    double mean_length = 0.0; //!< over the eight iso-curves [mm]
    double shortest = 0.0;    //!< of the eight [mm]
    double longest = 0.0;     //!< of the eight [mm]
    double join_angle = 0.0;  //!< largest angle seen between the iso-curves' tangents on both sides of the join [rad]
    int moved_edges = 0;      //!< edges of the face along this side that moved outwards with it; see extend_face.h
};

struct ExtendedSurface
{
    Handle(Geom_Surface) geometry;
    ParameterBox box;                //!< the rectangle with its extended sides
    std::vector<ExtendedSide> sides; //!< in the order in which they were extended
};

//! What is extended, and how the result is placed for messages.
struct SurfaceToExtend
{
    const InputFace &input;       //!< gives places for refusals, and the face's size
    Handle(Geom_Surface) surface; //!< in the parameters of input.surface
};

//! Extends the surface past the sides of input.box.
//! Refusals at stage Extension:
//! - SelfIntersection: the sides of a direction to be extended meet (a closed surface), the extension would fold, pass
//!   a pole or an apex, go round more than once or meet another part of the surface. Folds and meetings are searched
//!   for at samples and by a tree of patches (extension_check.h);
//! - SingularNormal: the side is a point, or the surface's derivative across it vanishes;
//! - NotSupported: the surface has no continuation there, or not by this length.
Result<ExtendedSurface> extend_surface(const SurfaceToExtend &base, const ExtensionOptions &options);

} // namespace laminate_offset
