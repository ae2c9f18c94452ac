// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Nearest points of planes, cylinders, cones, spheres and tori over a rectangle of their parameters, in closed form.
//!
//! On all of them but the plane a line or a circle (r(v), z(v)) turns about an axis. From a point at the distance rho from the
//! axis and the angle phi about it, |S(u, v) - P|^2 = (r - rho c)^2 + (z - z_P)^2 + rho^2 (1 - c^2) with c = cos(u - phi): for
//! r >= 0 the angle nearest to phi is the best one whatever v is, and v then follows in the half plane, from the point
//! (rho c, z_P). Where r may be negative (a cone past its apex), the angle nearest to the opposite of phi is tried as well.
#pragma once

#include "../input/input_face.h"
#include "nearest_search.h"

#include <optional>

namespace laminate_offset
{

//! Safe to share between threads.
class AnalyticNearest
{
public:
    //! \param box finite; directions that close on themselves may be as wide as their period, not wider.
    //! \param shift parameters (u, v) of the surface are (u, v) - shift for the caller, also in `box`.
    //! \return nothing for other kinds of surfaces, wider boxes, and boxes so small beside the surface that rounding of its
    //! frame would count.
    static std::optional<AnalyticNearest> make(const Handle(Geom_Surface) & surface, const ParameterBox &box,
                                               const gp_Vec2d &shift = {0.0, 0.0});

    //! Exact up to rounding: borders, poles, apexes and the axis included.
    [[nodiscard]] SurfaceFoot nearest(const Eigen::Vector3d &point) const;

private:
    //! An interval of angles, or of lengths.
    struct Range
    {
        double low = 0.0;
        double high = 0.0;
        Eigen::Vector2d at_low{1.0, 0.0}; //!< cosine and sine of the ends, for angles
        Eigen::Vector2d at_high{1.0, 0.0};
    };
    //! A place on a circle.
    struct Turn
    {
        double angle = 0.0;
        Eigen::Vector2d direction{1.0, 0.0}; //!< cosine and sine
    };
    struct InPlane
    {
        double v = 0.0;
        Eigen::Vector2d point{0.0, 0.0}; //!< r and z
    };

    AnalyticNearest() = default;

    [[nodiscard]] bool take_kind(const Handle(Geom_Surface) & surface);
    [[nodiscard]] bool admissible();
    static Range angles(double low, double high);
    [[nodiscard]] static Turn turned_to(const Range &range, const Eigen::Vector2d &direction);
    [[nodiscard]] InPlane on_profile(const Eigen::Vector2d &point) const;
    [[nodiscard]] SurfaceFoot on_plane(const Eigen::Vector3d &local) const;
    [[nodiscard]] SurfaceFoot turned(const Eigen::Vector3d &local, const Eigen::Vector2d &towards) const;

    enum class Kind
    {
        Plane,
        Line,
        Circle
    };
    Kind m_kind = Kind::Plane;
    bool m_two_sided = false; //!< r(v) is negative somewhere
    Eigen::Vector3d m_origin = Eigen::Vector3d::Zero();
    Eigen::Matrix3d m_frame = Eigen::Matrix3d::Identity(); //!< axes as columns
    Eigen::Vector2d m_start{0.0, 0.0};                     //!< the line's point at v = 0, the circle's centre
    Eigen::Vector2d m_along{0.0, 1.0};                     //!< of the line, of length 1
    double m_radius = 0.0;                                 //!< of the circle
    Range m_u;
    Range m_v;
    Eigen::Vector2d m_shift{0.0, 0.0};
};

} // namespace laminate_offset
