// SPDX-License-Identifier: LGPL-2.1-or-later
#include "extended_offset.h"

#include "../spline/geom_values.h"

#include <Geom_BSplineSurface.hxx>

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

//! The rectangle from whose sides the offset goes on.
ParameterBox border_of(const InputFace &input, const OffsetSurface &offset)
{
    ParameterBox box = input.box;
    const gp_Vec2d &shift = offset.parameter_shift;
    if (!Handle(Geom_BSplineSurface)::DownCast(offset.geometry).IsNull())
        offset.geometry->Bounds(box.umin, box.umax, box.vmin, box.vmax);
    else
        box = {box.umin + shift.X(), box.umax + shift.X(), box.vmin + shift.Y(), box.vmax + shift.Y()};
    return box;
}

gp_Pnt2d on_base(const OffsetSurface &offset, const gp_Pnt2d &uv)
{
    if (const auto &map = offset.parameter_map)
        return {map->u.value(uv.X()), map->v.value(uv.Y())};
    return uv.Translated(-offset.parameter_shift);
}

bool same_knots(const KnotVector &a, const KnotVector &b) { return a.degree == b.degree && a.knots == b.knots; }

//! Bound of the distance of two splines with the same knots at equal parameters: with numerators sum B_i w_i P_i, their
//! difference is that of the numerators, less the second surface's point times that of the weights, over the first's
//! weight.
double distance_bound(const TensorSpline &a, const TensorSpline &b)
{
    if (!same_knots(a.u, b.u) || !same_knots(a.v, b.v) || a.poles.size() != b.poles.size())
        return infinity;
    double apart = 0.0;
    double extent = 0.0;
    double least_weight = infinity;
    for (std::size_t i = 0; i < a.poles.size(); ++i)
    {
        const Eigen::Vector4d difference = a.poles[i] - b.poles[i];
        extent = std::max(extent, (b.poles[i].head<3>() / b.poles[i].w()).norm());
        least_weight = std::min(least_weight, a.poles[i].w());
        apart = std::max({apart, difference.head<3>().norm(), std::abs(difference.w())});
    }
    return apart * (1.0 + extent) / least_weight;
}

//! Bound of what the extension changed inside the old border [mm].
double change_inside(const InputFace &input, double distance, const Handle(Geom_Surface) & before,
                     const Handle(Geom_Surface) & after)
{
    const auto old_spline = Handle(Geom_BSplineSurface)::DownCast(before);
    if (old_spline.IsNull())
        return 0.0; // any other surface goes on as itself
    const auto inside = Handle(Geom_BSplineSurface)::DownCast(after->Copy());
    double u0, u1, v0, v1;
    old_spline->Bounds(u0, u1, v0, v1);
    inside->Segment(u0, u1, v0, v1);
    return distance_bound(from_geom(old_spline), from_geom(inside)) + rounding_of(input, distance);
}

} // namespace

Result<ExtendedOffset> extend_offset(const InputFace &input, const OffsetSurface &offset, double distance,
                                     double length)
{
    InputFace untrimmed = input;
    untrimmed.loops.clear(); // they are in the base's parameters
    untrimmed.surface = offset.geometry;
    untrimmed.base_distance = 0.0;
    untrimmed.box = border_of(input, offset);
    ExtensionOptions options;
    options.length = length;
    Result<ExtendedSurface> extended = extend_surface({untrimmed, offset.geometry}, options);
    if (!extended)
    {
        Failure failure = extended.failure();
        if (failure.where)
            failure.where = input.place(on_base(offset, failure.where->uv));
        return failure;
    }
    ExtendedOffset result{offset, extended.value().box, extended.value().sides};
    result.surface.geometry = extended.value().geometry;
    if (result.surface.certified_error)
        *result.surface.certified_error += change_inside(input, distance, offset.geometry, result.surface.geometry);
    if (result.surface.certified_error && !std::isfinite(*result.surface.certified_error))
        result.surface.certified_error.reset();
    return result;
}

} // namespace laminate_offset
