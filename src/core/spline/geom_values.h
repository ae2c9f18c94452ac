// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Values of OpenCASCADE's geometry as the numerics here take them.
#pragma once

#include "knot_vector.h"

#include <Eigen/Core>
#include <gp_XYZ.hxx>
#include <utility>

namespace laminate_offset
{

inline Eigen::Vector3d vector(const gp_XYZ &p) { return {p.X(), p.Y(), p.Z()}; }

//! The knots of a Geom_BSplineCurve or Geom2d_BSplineCurve, each as often as it counts.
template <class Curve> KnotVector knots_of(const Curve &curve)
{
    KnotVector kv;
    kv.degree = curve.Degree();
    for (int i = 1; i <= curve.NbKnots(); ++i)
        kv.knots.insert(kv.knots.end(), static_cast<std::size_t>(curve.Multiplicity(i)), curve.Knot(i));
    return kv;
}

//! Where to cut a periodic curve or surface. OpenCASCADE takes another piece, off by millimetres, where an end misses the
//! period's own by rounding: such an end is that one, and what is as long as the period is one period.
std::pair<double, double> period_cut(double low, double high, double first, double last);

//! Cutting a periodic curve or surface may move its parameters by whole periods: back to [low, high].
void realign(KnotVector &kv, double low, double high);

} // namespace laminate_offset
