// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Do the trimming loops of a face bound a region of its parameter plane?
//!
//! BRepCheck_Analyzer intersects all pcurves with each other and classifies the loops by points, which takes longer than
//! all other stages of a small face together. The control points of the pcurves say the same with certainty, and
//! faster: a curve stays inside the hull of its control points, and its tangents inside the cone of their steps.
#pragma once

#include <TopoDS_Face.hxx>

namespace laminate_offset
{

//! \return true where it is proven that every loop closes, vertex by vertex, that no loop meets itself or another (but at
//! the vertices, within their tolerances), that one loop goes round anticlockwise and all others lie inside it, clockwise
//! and beside each other. False says nothing: pcurves that are no splines or conics, loops that touch and edges inside the face
//! are left to others.
bool loops_proven_simple(const TopoDS_Face &face);

} // namespace laminate_offset
