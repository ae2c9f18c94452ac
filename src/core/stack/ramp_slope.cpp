// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ramp_slope.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace laminate_offset
{
namespace
{

constexpr int slope_samples = 6; // steps of a span in which slopes are looked at

//! Is the share one number on the span that begins at a place?
bool level_on(const ScalarSpline &share, double u, double v)
{
    const int first_u = share.u.span(u) - share.u.degree;
    const int first_v = share.v.span(v) - share.v.degree;
    for (int i = first_u; i <= first_u + share.u.degree; ++i)
        for (int j = first_v; j <= first_v + share.v.degree; ++j)
            if (share.pole(i, j) != share.pole(first_u, first_v))
                return false;
    return true;
}

//! From the first derivatives of a surface and of a number over its parameters.
double slope(const SurfaceJet &surface, const SurfaceJet &number)
{
    const double e = surface.u.squaredNorm(), f = surface.u.dot(surface.v), g = surface.v.squaredNorm();
    const double a = number.u.x(), b = number.v.x();
    return std::sqrt(std::max(0.0, (g * a * a - 2.0 * f * a * b + e * b * b) / (e * g - f * f)));
}

//! The steepest one of the places of a grid in one span that are inside.
SteepPlace steepest_in(const BaseSurface &base, const TensorSpline &share, const LoopRegion &inside,
                       const ParameterBox &span)
{
    std::vector<double> us, vs;
    for (int i = 0; i <= slope_samples; ++i)
    {
        us.push_back(span.umin + (span.umax - span.umin) * i / slope_samples);
        vs.push_back(span.vmin + (span.vmax - span.vmin) * i / slope_samples);
    }
    const std::vector<SurfaceJet> places = base.jets(us, vs, 1);
    const std::vector<SurfaceJet> values = share.jets(us, vs, 1);
    SteepPlace steepest;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        const gp_Pnt2d uv(us[i / vs.size()], vs[i % vs.size()]);
        const double here = slope(places[i], values[i]);
        if (here > steepest.slope && inside.contains(uv))
            steepest = {here, uv};
    }
    return steepest;
}

} // namespace

std::vector<SteepPlace> steep_places(const BaseSurface &base, const ScalarSpline &share, const LoopRegion &inside,
                                     double least)
{
    const std::vector<double> us = share.u.breaks();
    const std::vector<double> vs = share.v.breaks();
    const TensorSpline values = share.as_surface();
    std::vector<SteepPlace> places;
    for (std::size_t k = 0; k + 1 < us.size(); ++k)
        for (std::size_t l = 0; l + 1 < vs.size(); ++l)
        {
            const ParameterBox span{us[k], us[k + 1], vs[l], vs[l + 1]};
            if (level_on(share, us[k], vs[l]) || !inside.may_touch(span))
                continue;
            const SteepPlace here = steepest_in(base, values, inside, span);
            if (here.slope > least)
                places.push_back(here);
        }
    return places;
}

SteepPlace steepest_place(const BaseSurface &base, const ScalarSpline &share, const LoopRegion &inside)
{
    SteepPlace steepest;
    for (const SteepPlace &place : steep_places(base, share, inside, 0.0))
        if (place.slope > steepest.slope)
            steepest = place;
    return steepest;
}

double slope_at(const BaseSurface &base, const TensorSpline &share, const gp_Pnt2d &uv)
{
    return slope(base.jets({uv.X()}, {uv.Y()}, 1).front(), share.jets({uv.X()}, {uv.Y()}, 1).front());
}

} // namespace laminate_offset
