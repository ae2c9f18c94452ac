// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Values of OpenCASCADE's geometry as the numerics here take them.
#pragma once

#include "knot_vector.h"

#include <Eigen/Core>
#include <gp_XYZ.hxx>

namespace laminate_offset
{

inline Eigen::Vector3d vector(const gp_XYZ &p) { return {p.X(), p.Y(), p.Z()}; }

//! Cutting a periodic curve or surface may move its parameters by whole periods: back to [low, high].
void realign(KnotVector &kv, double low, double high);

} // namespace laminate_offset
