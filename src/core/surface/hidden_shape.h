// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Recognises a plane, sphere, cylinder, cone or torus from points and normals of a surface.
//!
//! What is found is a guess, however good: the caller proves it. Directions come from singular values, because a
//! product of matrices would lose half of the digits on a shallow patch:
//! - sphere: p = c + r n, a linear regression of points on normals; cylinder: the same across its axis, the
//!   direction that all normals are perpendicular to;
//! - cone: normals make a constant angle with the axis, and across it p = c + (b0 + b1 h) n;
//! - torus: its normals' lines meet the axis, which is a linear condition on the axis' coordinates (Pottmann &
//!   Randrup 1998); in the half plane of (distance from the axis, height) points regress on normals as on a circle.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace laminate_offset
{

//! Rows of points [mm] with the unit normals S_u x S_v there.
struct ShapeSamples
{
    Eigen::MatrixX3d points;
    Eigen::MatrixX3d normals;
};

struct HiddenShape
{
    enum class Kind
    {
        Plane,
        Sphere,
        Cylinder,
        Cone,
        Torus,
    };

    Kind kind = Kind::Plane;
    Eigen::Vector3d origin =
        Eigen::Vector3d::Zero(); //!< a point on the plane or the axis; the centre of sphere and torus
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(); //!< of unit length; the normal of a plane
    double radius = 0.0;  //!< sphere, cylinder, a torus' tube; positive where the normals point away from the centre
    double major = 0.0;   //!< torus only
    double axial = 0.0;   //!< cone only: the normals' constant part along the axis
    double outward = 1.0; //!< cone only: the normals' part away from the axis
};

//! All shapes whose points lie within `tolerance` [mm] of the samples, the simplest first.
std::vector<HiddenShape> recognise(const ShapeSamples &samples, double tolerance);

} // namespace laminate_offset
