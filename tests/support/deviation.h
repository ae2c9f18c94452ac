// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The deviation of a surface from the exact offset at equal parameters, by OpenCASCADE's evaluation alone.
#pragma once

#include <Geom_Surface.hxx>
#include <gp_Vec2d.hxx>

namespace test_support
{

//! A rectangle of parameters.
struct Rectangle
{
    double u0 = 0.0, u1 = 1.0, v0 = 0.0, v1 = 1.0;
};

struct Deviation
{
    double largest = 0.0;      //!< | R((u, v) + shift) - (S + distance N)(u, v) | [mm], at equal parameters
    double least_cosine = 1.0; //!< between the normals of both
    int points = 0;            //!< compared
    int undefined = 0;         //!< without a normal of the base
};

//! Compares on count x count points that are spread irregularly over the rectangle, its border included.
//! \param distance along S_u x S_v.
Deviation deviation(const Handle(Geom_Surface) & base, const Handle(Geom_Surface) & offset, const Rectangle &rectangle,
                    double distance, int count, const gp_Vec2d &shift = gp_Vec2d(0.0, 0.0));

} // namespace test_support
