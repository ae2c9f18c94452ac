// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The part of a lay-up face that a ply covers: the face cut along the images of the ply's boundary.
//!
//! The cut is made in space by OpenCASCADE's splitter, with curves that already have pcurves on the face, so that the
//! face's own loops keep theirs. Which parts stay is read off the edges: each knows on which side of its boundary the
//! part next to it lies.
#pragma once

#include "../base/result.h"
#include "../input/input_face.h"

#include <TopoDS_Shape.hxx>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace laminate_offset
{

//! One curve of a boundary on the face.
struct BoundaryImage
{
    //! Wire, or compound of wires, whose edges have pcurves on the face's surface; without the face's location.
    TopoDS_Shape wires;
    //! The ply lies on the left of the wires' direction, seen with S_u x S_v upwards.
    bool keeps_left = true;
};

//! What a ply covers.
struct PlyRegion
{
    InputFace input; //!< the part of the face; location, orientation and normal are those of the whole face
    //! Curves that are not the face's own edges: loop and place in the loop.
    std::vector<std::pair<std::size_t, std::size_t>> cuts;
    std::string name; //!< of the boundary, for messages

    [[nodiscard]] const TrimmingCurve &cut(std::size_t k) const
    {
        return input.loops[cuts[k].first].curves[cuts[k].second];
    }
};

//! The whole face.
PlyRegion whole_region(const InputFace &input);

//! The part of the face on the kept side of all images.
//! Refusals at Stage::Trimming: NotSupported where the images do not cut the face, leave nothing, or leave several parts;
//! InvalidFace where OpenCASCADE cannot split the face.
Result<PlyRegion> cut_region(const InputFace &input, const std::vector<BoundaryImage> &images);

//! The part next to a point in local coordinates, whichever side that is; the images' own sides do not count.
//! Refusals: as above.
Result<PlyRegion> cut_region(const InputFace &input, const std::vector<BoundaryImage> &images, const gp_Pnt &kept);

} // namespace laminate_offset
