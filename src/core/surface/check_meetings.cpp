// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check_meetings.h"

#include "../analysis/self_intersection.h"

#include <Geom_BSplineSurface.hxx>

namespace laminate_offset
{

Result<bool> check_meetings(const SurfaceAnalysis &analysis, const InputFace &input, const OffsetSurface &surface,
                            double distance, double tolerance)
{
    const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface.geometry);
    if (spline.IsNull())
        return true;
    return check_self_intersection({analysis, input, from_geom(spline), distance, tolerance});
}

} // namespace laminate_offset
