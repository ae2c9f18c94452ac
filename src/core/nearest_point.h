// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The points of a face that are nearest to given points (Ravi Kumar, Shastry & Prakash 2003, 3.3.2).
#pragma once

#include "base/result.h"

#include <TopoDS_Shape.hxx>

#include <vector>

namespace laminate_offset
{

//! A point of a face.
struct NearestPoint
{
    gp_Pnt2d uv;           //!< in the parameters of the face's surface
    gp_Pnt point;          //!< where the face stands [mm]
    double distance = 0.0; //!< to the point that was asked for [mm], not negative
};

//! For each point the nearest point of the face, in the same order. Among several that are equally near, any one.
//!
//! A distance is never larger than the least one by more than 1e-11 of the surface's size or, far away, 1e-14 of the
//! distance. Borders, poles and seams count;
//! on a seam either side's parameters may come back. Works on all cores; the face is only read.
//! \param points coordinates [mm] where the face stands.
//! \param trimmed false: the surface over the face's parameter box (FreeCAD's ParameterRange); true: the inside of the loops and the
//! loops themselves, which are searched through samples.
//! Refusals: those of the stage Input; NotSupported for offset surfaces of free-form surfaces; InvalidOption
//! for a coordinate that is no finite number, or a distance that would be none.
Result<std::vector<NearestPoint>> nearest_points(const TopoDS_Shape &face, const std::vector<gp_Pnt> &points,
                                                 bool trimmed = false);

} // namespace laminate_offset
