// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Surfaces written exactly as tensor-product splines, in their own parameters up to a known law.
//!
//! A rational quadratic arc of half angle h with t in [0, 1] reaches the angle 2 atan(tan(h / 2) (2 t - 1)) from its
//! middle. Lines, circles, ellipses, parabolas and splines as profiles, extruded or turned, thus have an exact spline
//! whose parameters differ from the surface's by that law alone.
#pragma once

#include "../input/input_face.h"
#include "../spline/tensor_spline.h"

#include <optional>
#include <vector>

namespace laminate_offset
{

//! How one parameter of the spline belongs to the surface's own.
struct ParameterLaw
{
    std::vector<double> arcs; //!< ends of the arcs [rad], the same numbers on both sides; empty: no difference

    [[nodiscard]] double to_surface(double spline_parameter) const;
    [[nodiscard]] double to_spline(double surface_parameter) const;
};

struct ExactSpline
{
    TensorSpline spline;
    ParameterLaw u;
    ParameterLaw v;
};

//! The part of a surface over a finite box.
//! \return nothing for offset surfaces and profiles that are offset curves or hyperbolas.
std::optional<ExactSpline> exact_spline(const Handle(Geom_Surface) & surface, const ParameterBox &box);

} // namespace laminate_offset
