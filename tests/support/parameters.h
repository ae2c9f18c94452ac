// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The same surface over other parameters.
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfReal.hxx>

namespace test_support
{

//! Every knot t becomes from + scale * t in its direction; scales are positive.
inline void move_parameters(const Handle(Geom_BSplineSurface) & surface, double from_u, double scale_u, double from_v,
                            double scale_v)
{
    TColStd_Array1OfReal u(1, surface->NbUKnots()), v(1, surface->NbVKnots());
    surface->UKnots(u);
    surface->VKnots(v);
    for (double &knot : u)
        knot = from_u + scale_u * knot;
    for (double &knot : v)
        knot = from_v + scale_v * knot;
    surface->SetUKnots(u);
    surface->SetVKnots(v);
}

} // namespace test_support
