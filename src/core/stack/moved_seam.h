// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A closed face with its seam at another place, where no boundary of a ply crosses it.
//!
//! The parameters of a face that goes all round begin and end at its seam, so a curve that crosses it falls into parts, and
//! so would a ply's part of the face. Where the face is a whole band, that is, bounded by parameter lines alone, the
//! same surface can begin elsewhere. A B-spline keeps its parameters up to a period; a surface about an axis is turned, so
//! that its angle counts from the new seam.
#pragma once

#include "../input/input_face.h"

#include <TopoDS_Shape.hxx>

#include <optional>
#include <vector>

namespace laminate_offset
{

//! Has the face a seam at all?
bool has_seam(const InputFace &input);

//! The same face, with its seam moved away from curves that it cuts or that lie near them.
//! \param images wires whose edges have pcurves on the face's surface, without the face's location.
//! \param clearance that ramps beside the curves need [mm].
//! \return nothing where no seam is in the way or there is no place left for it, and where the face is no whole band on a
//! cylinder, cone, sphere or torus (about the axis, not about a torus's tube), or on a B-spline surface whose poles and
//! weights close.
std::optional<TopoDS_Face> with_moved_seam(const InputFace &input, const std::vector<TopoDS_Shape> &images,
                                           double clearance);

} // namespace laminate_offset
