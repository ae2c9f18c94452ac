// SPDX-License-Identifier: LGPL-2.1-or-later
#include "parameter_periods.h"

#include <Precision.hxx>

namespace laminate_offset
{

bool ends_meet(const Geom_Surface &surface, const ParameterBox &box, bool along_u, double tolerance)
{
    constexpr int samples = 6;
    for (int i = 0; i <= samples; ++i)
    {
        const double u = box.umin + (box.umax - box.umin) * i / samples;
        const double v = box.vmin + (box.vmax - box.vmin) * i / samples;
        const gp_Pnt low = along_u ? surface.Value(box.umin, v) : surface.Value(u, box.vmin);
        const gp_Pnt high = along_u ? surface.Value(box.umax, v) : surface.Value(u, box.vmax);
        if (low.Distance(high) > tolerance)
            return false;
    }
    return true;
}

Periods periods_of(const InputFace &input, double tolerance)
{
    double u0, u1, v0, v1;
    input.surface->Bounds(u0, u1, v0, v1);
    // along the other parameter, what the face covers says enough of a surface without end
    const ParameterBox &box = input.box;
    const auto infinite = [](double bound) { return Precision::IsInfinite(bound); };
    const ParameterBox finite{infinite(u0) ? box.umin : u0, infinite(u1) ? box.umax : u1, infinite(v0) ? box.vmin : v0,
                              infinite(v1) ? box.vmax : v1};
    Periods periods;
    if (input.surface->IsUPeriodic())
        periods.u = input.surface->UPeriod();
    else if (!infinite(u0) && !infinite(u1) && ends_meet(*input.surface, finite, true, tolerance))
        periods.u = u1 - u0;
    if (input.surface->IsVPeriodic())
        periods.v = input.surface->VPeriod();
    else if (!infinite(v0) && !infinite(v1) && ends_meet(*input.surface, finite, false, tolerance))
        periods.v = v1 - v0;
    return periods;
}

} // namespace laminate_offset
