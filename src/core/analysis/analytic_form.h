// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Planes, cylinders, cones, spheres and tori, also where a surface of extrusion or revolution is one.
#pragma once

#include "base_surface.h"

#include "../input/input_face.h"

#include <gp_Vec2d.hxx>

#include <optional>

namespace laminate_offset
{

//! The base as one of the five kinds, in its own parameters up to a shift.
struct AnalyticForm
{
    Handle(Geom_Surface) surface; //!< Geom_Plane, Geom_CylindricalSurface, and so on
    gp_Vec2d shift{0.0, 0.0};     //!< base parameters (u, v) are (u, v) + shift of the form
    ParameterBox box{};           //!< of the loops, in the form's parameters
    bool disguised = false;       //!< the base is written in another way, equal to the form up to rounding
    bool past_axis = false;       //!< a torus past its axis (R + r cos v < 0), as a screw's domed head is
    //! +1: S_u x S_v points outwards of the kind, as in a right-handed frame. -1: inwards, as in a left-handed one; the other
    //! way round past the axis.
    double normal_sign = 1.0;
    ModelError error{}; //!< how far the base is off the form beyond rounding
};

//! A face that oversteps its axis, or its apex, by less than this part of its diagonal ends there.
inline constexpr double axis_slack = 1e-9;

//! The form of InputFace::surface. A cone past its apex counts as the cone with the opposite angle. Extruded lines (at a
//! right angle) and circles and revolved lines and circles count where their directions and centres agree with the form to some units in the last place. A half circle that is revolved
//! about an axis beside its centre, nearer than points are told apart, counts as a sphere with an error: a centre off by e in
//! the circle's plane and by p across it moves points by |(e, p)|, and turns the normal S_u x S_v ~ (R cos v + e) n + p cos v y
//! by 4 p / (3 R) at most where R cos v >= 4 |e|. Nearer to the axis than that the surface is meant to be the sphere's pole.
//! \return nothing for any other surface.
std::optional<AnalyticForm> analytic_form(const InputFace &input);

} // namespace laminate_offset
