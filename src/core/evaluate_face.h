// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Points, outward normals and principal curvatures of a face at given parameters, and whether they lie inside its loops.
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
    bool inside = false; //!< inside the trimming loops, or on them within 1e-10 of their size in u and v
};

//! Evaluates the surface of a face, also outside its loops.
//! Refusals: those of the stage Input; InvalidOption for a parameter that is no finite number; SingularNormal.
Result<std::vector<FacePoint>> evaluate_face(const TopoDS_Shape &face, const std::vector<gp_Pnt2d> &uv);

//! The principal curvatures of a face at a place [1/mm], positive where the face bends towards its outward normal: an offset by d
//! folds there where d > 0 and 1 - d highest <= 0, or where d < 0 and 1 - d lowest <= 0.
struct FaceCurvatures
{
    double lowest = 0.0;
    double highest = 0.0;
};

//! Evaluates the curvatures of a face, also outside its loops. At a pole, where they depend on the way there, those of a place
//! beside it, by a thousandth of the face's parameter box; NaN where that has none either.
//! Refusals: those of the stage Input; InvalidOption for a parameter that is no finite number.
Result<std::vector<FaceCurvatures>> face_curvatures(const TopoDS_Shape &face, const std::vector<gp_Pnt2d> &uv);

} // namespace laminate_offset
