// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A boundary's curves moved inwards along the face: the places that lie at a given distance from the boundary, measured
//! in the surface.
//!
//! From every place of a curve a geodesic of that length starts at right angles. Its ends are fitted by a pcurve, checked
//! between its knots against further geodesics. At a corner the two curves are cut where they meet, or joined by the ends
//! of geodesics in all directions between. A fillet of a smaller radius, or a chamfer that the cuts use up, is left out, and its
//! neighbours are cut where they meet. An open curve goes on straight in the parameters up to the end of the face's
//! parameter box.
#pragma once

#include "ply_region.h"

namespace laminate_offset
{

struct BoundaryInset
{
    BoundaryImage image;
    double error = 0.0; //!< largest distance seen between the curves and geodesics' ends [mm]
};

//! \param distance towards the side that the ply keeps [mm], above zero.
//! \param tolerance largest deviation at the checked places [mm].
//! Refusals at Stage::Trimming: NotSupported where a moved curve folds in part, vanishes or crosses itself;
//! EdgeToleranceNotReached.
Result<BoundaryInset> inset_boundary(const InputFace &input, const BoundaryImage &image, double distance,
                                     double tolerance);

} // namespace laminate_offset
