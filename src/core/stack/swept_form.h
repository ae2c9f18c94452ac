// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Planes, cylinders, cones, spheres and tori as swept surfaces with the same parameters.
#pragma once

#include <Geom_Surface.hxx>

namespace laminate_offset
{

//! A plane as an extruded line, any of the others as a turned line or circle, point by point at equal parameters; other
//! surfaces as they are. Swept surfaces have spline models (analysis/swept_model.h), which a variable offset needs.
Handle(Geom_Surface) swept_form(const Handle(Geom_Surface) & surface);

} // namespace laminate_offset
