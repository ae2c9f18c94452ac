// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Tensor-product B-splines as plain values, their evaluation on grids, and the way to and from
//! OpenCASCADE's Geom_BSplineSurface.
#pragma once

#include "knot_vector.h"

#include <Eigen/Core>
#include <Geom_BSplineSurface.hxx>

#include <vector>

namespace laminate_offset
{

//! A point of a surface with its partial derivatives.
struct SurfaceJet
{
    Eigen::Vector3d s;  //!< S
    Eigen::Vector3d u;  //!< S_u
    Eigen::Vector3d v;  //!< S_v
    Eigen::Vector3d uu; //!< S_uu, filled from order 2
    Eigen::Vector3d uv;
    Eigen::Vector3d vv;
};

//! A clamped, possibly rational tensor-product spline surface in 3-D.
struct TensorSpline
{
    KnotVector u;
    KnotVector v;
    std::vector<Eigen::Vector4d> poles; //!< homogeneous (w x, w y, w z, w), pole (i, j) at i * v.pole_count() + j
    bool rational = false;              //!< false: every w is 1

    [[nodiscard]] const Eigen::Vector4d &pole(int i, int j) const
    {
        return poles[static_cast<std::size_t>(i) * v.pole_count() + j];
    }

    //! Jets on the grid us x vs, jet (k, l) at k * vs.size() + l, derivatives up to `order` (0 to 2).
    [[nodiscard]] std::vector<SurfaceJet> jets(const std::vector<double> &us, const std::vector<double> &vs,
                                               int order) const;

    //! Values of the weight function on the same grid.
    [[nodiscard]] std::vector<double> weights(const std::vector<double> &us, const std::vector<double> &vs) const;
};

//! The surface's clamped, non-periodic value on its own domain; weights kept only when they differ.
TensorSpline from_geom(const Handle(Geom_BSplineSurface) & surface);

//! The same surface as OpenCASCADE's class.
Handle(Geom_BSplineSurface) to_geom(const TensorSpline &spline);

} // namespace laminate_offset
