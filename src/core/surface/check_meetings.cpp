// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check_meetings.h"

#include "../analysis/self_intersection.h"

#include <Geom_BSplineSurface.hxx>

namespace laminate_offset
{

Result<bool> check_meetings(const SurfaceAnalysis &analysis, const InputFace &input, const OffsetSurface &surface,
                            double distance, double tolerance)
{
    Handle(Geom_Surface) geometry = surface.geometry;
    if (surface.parameter_map) // the search runs in the base's parameters: on a fit that is as near to the exact offset
    {
        const Result<OffsetSurface> fitted = fit_offset(analysis, input, distance, tolerance, OffsetOptions());
        if (!fitted)
            return fitted.failure();
        geometry = fitted.value().geometry;
    }
    const auto spline = Handle(Geom_BSplineSurface)::DownCast(geometry);
    if (spline.IsNull())
        return true;
    return check_self_intersection({analysis, input, from_geom(spline), distance, tolerance});
}

} // namespace laminate_offset
