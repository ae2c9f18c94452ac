// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_surface.h"

#include "piegl_tiller.h"

#include <Geom_BSplineSurface.hxx>

#include <cmath>

namespace laminate_offset
{
namespace
{

// A single piece of degree 2 both ways has so many: no fit of a curved surface has fewer, a flat one hardly.
constexpr int few_poles = 9;
// Rational pieces of this degree without a redundant knot: fits were measured to need 2 to 30 times their poles.
constexpr int conic_degree = 2;

// Of the tolerance, for a surface with parameters of its own: its edges are made without it, so that they lie apart from it
// by its error, and their proof shows up to 15.5 percent more than that.
constexpr double reparametrised_share = 0.8;

int pole_count(const Handle(Geom_Surface) & surface)
{
    const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface);
    return spline.IsNull() ? 0 : spline->NbUPoles() * spline->NbVPoles();
}

//! Can no fit have fewer poles?
bool smallest(const OffsetSurface &exact)
{
    const auto spline = Handle(Geom_BSplineSurface)::DownCast(exact.geometry);
    return pole_count(spline) <= few_poles || ((spline->IsURational() || spline->IsVRational()) &&
                                               spline->UDegree() <= conic_degree && spline->VDegree() <= conic_degree);
}

//! The base surface's own geometry, as small as it is at hand. A periodic one is cut to where the loops are.
Handle(Geom_Surface) own_geometry(const InputFace &input)
{
    const Handle(Geom_Surface) &surface = input.surface;
    const auto copy = Handle(Geom_Surface)::DownCast(surface->Copy());
    const BaseSurface base(surface, fit_box(input)); // that of the analysis may be a light model
    if (!base.spline())
        return copy;
    const Handle(Geom_Surface) cut = to_geom(*base.spline());
    const bool as_it_is = surface->IsKind(STANDARD_TYPE(Geom_BSplineSurface)) && !surface->IsUPeriodic() &&
                          !surface->IsVPeriodic() && pole_count(copy) <= pole_count(cut);
    return as_it_is ? copy : cut;
}

//! The base itself is its own offset to within the distance.
OffsetSurface base_itself(const InputFace &input, double distance)
{
    OffsetSurface result;
    result.geometry = own_geometry(input);
    result.certified_error = std::abs(distance) + rounding_of(input, distance);
    return result;
}

//! The base itself where that is near enough and has fewer poles than the best so far.
std::optional<OffsetSurface> or_base(std::optional<OffsetSurface> best, const SurfaceAnalysis &analysis,
                                     const InputFace &input, double distance, double tolerance)
{
    if (!analysis.base.spline() || analysis.base.strip() || std::abs(distance) > tolerance)
        return best; // a swept surface is no spline itself
    OffsetSurface same = base_itself(input, distance);
    const bool near = *same.certified_error <= tolerance;
    if (near && (!best || pole_count(same.geometry) < pole_count(best->geometry)))
        return same;
    return best;
}

} // namespace

Result<OffsetSurface> offset_surface(const SurfaceAnalysis &analysis, const InputFace &input, double distance,
                                     const OffsetOptions &options)
{
    if (std::optional<OffsetSurface> exact = exact_offset(input, distance, options.tolerance))
        return *std::move(exact);
    if (distance == 0.0)
        return base_itself(input, distance);
    const double tolerance = surface_share * options.tolerance;
    std::optional<OffsetSurface> ready = hidden_offset(analysis, distance, tolerance);
    if (ready && smallest(*ready))
        return *std::move(ready);
    if (options.method == Method::RaviKumar)
        return ready
                   ? *std::move(ready)
                   : piegl_tiller_offset(analysis, input, distance, reparametrised_share * options.tolerance, options);
    ready = or_base(std::move(ready), analysis, input, distance, tolerance);
    Result<OffsetSurface> fitted = fit_offset(analysis, input, distance, tolerance, options);
    if (!ready)
        return fitted;
    if (!fitted.ok())
        return fitted.failure().status == Status::Cancelled ? fitted : *std::move(ready);
    return pole_count(fitted.value().geometry) < pole_count(ready->geometry) ? fitted : *std::move(ready);
}

} // namespace laminate_offset
