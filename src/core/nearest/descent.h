// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Newton's iteration for eq. 3.14 of the paper on one patch, kept inside a rectangle.
#pragma once

#include "patch_leaf.h"

namespace laminate_offset
{

struct LeafFoot
{
    double x = 0.5;
    double y = 0.5;
    Eigen::Vector3d point{0.0, 0.0, 0.0}; //!< relative to the tree's origin
    double square = 0.0;                  //!< squared distance [mm^2]
    double least = 0.0;                   //!< if convex: no point of the rectangle has a lower square [mm^2]
};

//! Downhill from (x, y) to a local minimum of the distance from p over the rectangle.
//! \param convex the squared distance is known to be convex there: stops once `least` has reached `limit` [mm^2].
LeafFoot descend(const PatchLeaf &leaf, const Eigen::Vector3d &p, const UnitBox &box, double x, double y, bool convex,
                 double limit);

} // namespace laminate_offset
