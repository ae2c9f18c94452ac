// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Moves about on a face's surface, along geodesics.
#pragma once

#include "../input/input_face.h"

#include <Eigen/Dense>
#include <Geom_Surface.hxx>

namespace laminate_offset
{

class GeodesicWalker
{
public:
    explicit GeodesicWalker(const InputFace &input);

    [[nodiscard]] const Handle(Geom_Surface) & surface() const { return m_surface; }

    [[nodiscard]] Eigen::Vector3d point(const Eigen::Vector2d &uv) const;

    //! The direction in space as a speed in the parameters.
    [[nodiscard]] Eigen::Vector2d in_parameters(const Eigen::Vector2d &uv, const Eigen::Vector3d &direction) const;

    //! A speed in the parameters in space, and the unit normal.
    [[nodiscard]] Eigen::Vector3d in_space(const Eigen::Vector2d &uv, const Eigen::Vector2d &speed,
                                           Eigen::Vector3d &normal) const;

    //! The end of the geodesic that starts in a direction of length 1 (classical Runge-Kutta steps).
    //! \param length [mm].
    [[nodiscard]] Eigen::Vector2d geodesic(const Eigen::Vector2d &from, const Eigen::Vector3d &direction,
                                           double length) const;

private:
    [[nodiscard]] Eigen::Vector2d bend(const Eigen::Vector2d &x, const Eigen::Vector2d &v) const;

    Handle(Geom_Surface) m_surface;
};

} // namespace laminate_offset
