// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Area, volume and first moment of plies that lie at varying distances from a lay-up face, without a mesh.
//!
//! A ply with the bottom S + b(u,v) N and the thickness t is the set of S + x N with b <= x <= b + t. The Jacobian of that map
//! is 1 - 2 H x + K x^2 however b varies, so volume and moment are integrals of polynomials in b. The middle
//! surface S + m N, m = b + t/2, has the area element |(S_u + m N_u + m_u N) x (S_v + m N_v + m_v N)|, slopes of m included.
#pragma once

#include "../base/result.h"
#include "../input/input_face.h"

#include <gp_XYZ.hxx>

#include <vector>

namespace laminate_offset
{

struct ScalarSpline;

struct PlyLayer
{
    const ScalarSpline
        &bottom;            //!< distance from the region's surface along S_u x S_v [mm], over a box around the region
    double thickness = 0.0; //!< along S_u x S_v [mm], signed, not zero
};

struct PlyIntegrals
{
    double area = 0.0;   //!< of the middle surface [mm^2]
    double volume = 0.0; //!< [mm^3], above zero
    gp_XYZ first_moment; //!< of the position where the region stands [mm^4]
    //! Estimated, relative to the integrals' size: the difference of two Gauss rules. Not a proven bound.
    double relative_error = 0.0;
};

//! The figures of layers that cover one region, in their order. Layers at constant distances share one quadrature.
std::vector<PlyIntegrals> integrate_plies(const InputFace &region, const std::vector<PlyLayer> &layers);

} // namespace laminate_offset
