// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Points and outward normals of a face at given parameters, and whether they lie inside its loops.
#pragma once

#include "base/result.h"

#include <TopoDS_Shape.hxx>
#include <gp_Vec.hxx>

#include <vector>

namespace laminate_offset
{

//! A place of a face, where the face stands.
struct FacePoint
{
    gp_Pnt point;        //!< [mm]
    gp_Vec normal;       //!< outward, of length 1; at a pole its limit
    bool inside = false; //!< inside the trimming loops; next to a loop the chord of a short piece decides
};

//! Evaluates the surface of a face, also outside its loops.
//! Refusals: those of the stage Input; InvalidOption for a parameter that is no finite number; SingularNormal.
Result<std::vector<FacePoint>> evaluate_face(const TopoDS_Shape &face, const std::vector<gp_Pnt2d> &uv);

} // namespace laminate_offset
