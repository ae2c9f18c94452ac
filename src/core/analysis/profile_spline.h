// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A profile curve as a spline in its own parameters, exact or within proven errors.
#pragma once

#include "../spline/conic_functions.h"

#include <Geom_Curve.hxx>

#include <functional>
#include <optional>
#include <vector>

namespace laminate_offset
{

//! Conic about its centre: C(t) = P + E_1(t) x + E_2(t) y.
struct ConicFrame
{
    ConicKind kind = ConicKind::Circle;
    Eigen::Vector3d centre;
    Eigen::Vector3d x;
    Eigen::Vector3d y;
};

struct ProfileSpline
{
    KnotVector knots;
    std::vector<Eigen::Vector4d> poles; //!< homogeneous (w x, w y, w z, w)
    bool rational = false;
    std::optional<ConicFrame> conic; //!< empty: the profile is exact up to rounding
    ConicErrors errors;              //!< of the conic's functions
};

//! Splines, Bezier curves, lines, parabolas, circles, ellipses and hyperbolas, trimmed or not, on [low, high].
//! \param wanted of a conic whose axes are x and y; called only where it is needed.
//! \return nothing for other curves, and where the errors cannot be had.
std::optional<ProfileSpline> profile_spline(const Handle(Geom_Curve) & profile, double low, double high,
                                            const std::function<ConicErrors(const ConicFrame &)> &wanted);

} // namespace laminate_offset
