// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Edges and wires of images, on the face's own surface.
#pragma once

#include "curve_image.h"

#include <TopoDS_Shape.hxx>

namespace laminate_offset
{

struct ImagePart
{
    ImagePiece piece;
    bool reversed = false;    //!< the given edge runs against its curve
    Handle(Geom_Curve) given; //!< the curve that it is an image of; null where it is of none
    bool clipped = false;     //!< of a part of that curve only
};

//! Leaves out what a clipped curve has left at the border of the surface: pieces shorter than `tolerance` [mm]. One that
//! hangs together with others at both ends stays unless these still do without it.
std::vector<ImagePart> without_slivers(const std::vector<ImagePart> &parts, double tolerance);

//! The parts in their order as a wire, or as a compound of wires where they do not all hang together, with the
//! location of the face. Parts whose ends are within `tolerance` [mm] share a vertex.
TopoDS_Shape image_wires(const InputFace &input, const std::vector<ImagePart> &parts, double tolerance);

} // namespace laminate_offset
