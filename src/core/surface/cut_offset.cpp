// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cut_offset.h"

#include "../analysis/base_surface.h"

#include <Geom_BSplineSurface.hxx>

#include <algorithm>

namespace laminate_offset
{

OffsetSurface cut_to(const InputFace &part, const OffsetSurface &whole, double distance)
{
    const bool moved = whole.parameter_map || whole.parameter_shift.Magnitude() > 0.0;
    const auto spline = Handle(Geom_BSplineSurface)::DownCast(whole.geometry);
    if (moved || spline.IsNull() || spline->IsUPeriodic() || spline->IsVPeriodic())
        return whole;
    double u0, u1, v0, v1;
    spline->Bounds(u0, u1, v0, v1);
    const ParameterBox box = fit_box(part);
    const auto cut = Handle(Geom_BSplineSurface)::DownCast(spline->Copy());
    cut->Segment(std::max(u0, box.umin), std::min(u1, box.umax), std::max(v0, box.vmin), std::min(v1, box.vmax));
    OffsetSurface made = whole;
    made.geometry = cut;
    if (made.certified_error)
        *made.certified_error += rounding_of(part, distance);
    return made;
}

} // namespace laminate_offset
