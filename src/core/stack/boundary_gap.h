// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! How far a boundary's curves stand from the face that they are dropped onto.
#pragma once

#include "../analysis/loop_region.h"
#include "../base/result.h"
#include "../input/input_face.h"

#include <Geom_Curve.hxx>
#include <TopoDS_Shape.hxx>

#include <optional>
#include <vector>

namespace laminate_offset
{

//! A curve and its image, over the same parameters and without the face's location.
struct DroppedCurve
{
    Handle(Geom_Curve) curve;
    Handle(Geom2d_Curve) image; //!< in the face's parameters
    double first = 0.0;
    double last = 0.0;
};

struct BoundaryGap
{
    double distance = 0.0;      //!< [mm]
    std::optional<Where> where; //!< on the face; empty where no image lies inside the face's loops
};

//! The largest distance seen between curves and their images. Only places inside the face's loops count, since what
//! lies beside the face bounds nothing.
//! \param inside of the face.
BoundaryGap boundary_gap(const InputFace &input, const LoopRegion &inside, const std::vector<DroppedCurve> &curves);

//! The distance up to which a boundary counts as near the face: a quarter of its own size or of the face's, whichever is
//! less, 1 mm at least [mm].
double usual_gap(const InputFace &input, const TopoDS_Shape &boundary);

} // namespace laminate_offset
