// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Areas, volumes and centres of gravity of a face, its offsets and the plies between them.
#pragma once

#include "base/result.h"
#include "stack/face_quadrature.h"
#include "stack/ply_quadrature.h"

#include <TopoDS_Shape.hxx>

#include <vector>

namespace laminate_offset
{

//! The integrals of a trimmed face of any kind (analytic, swept, spline, offset surface), where it stands. See
//! FaceIntegrals for what follows from them. At 1e-10 both rules agree on nearly every face; `relative_error` says so.
//! Refusals: those of the stage Input.
Result<FaceIntegrals> face_integrals(const TopoDS_Shape &face);

//! Area, volume and first moment of plies at varying distances over the part of a lay-up face that they cover, where it
//! stands. See integrate_plies and StackedPly.
//! Refusals: as above.
Result<std::vector<PlyIntegrals>> ply_integrals(const TopoDS_Shape &region, const std::vector<PlyLayer> &layers);

} // namespace laminate_offset
