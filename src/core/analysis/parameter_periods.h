// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The periods of closed surfaces, whether OpenCASCADE calls them periodic or not.
#pragma once

#include "../input/input_face.h"

namespace laminate_offset
{

//! Shifts that continue the parameters across a seam.
struct Periods
{
    double u = 0.0; //!< 0: not closed
    double v = 0.0;
};

//! \param tolerance ends that are no farther apart at seven places [mm] are a seam.
Periods periods_of(const InputFace &input, double tolerance);

//! Do the two ends of one parameter of a finite box show the same curve within the tolerance [mm], at seven places?
bool ends_meet(const Geom_Surface &surface, const ParameterBox &box, bool along_u, double tolerance);

} // namespace laminate_offset
