// SPDX-License-Identifier: LGPL-2.1-or-later
#include "parameter_periods.h"

#include <Precision.hxx>

#include <array>

namespace laminate_offset
{
namespace
{

//! Do the two ends of one parameter show the same curve within the tolerance?
bool ends_meet(const Geom_Surface &surface, const std::array<double, 4> &bounds, bool along_u, double tolerance)
{
    constexpr int samples = 6;
    const auto [u0, u1, v0, v1] = bounds;
    if (Precision::IsInfinite(along_u ? u0 : v0) || Precision::IsInfinite(along_u ? u1 : v1))
        return false;
    for (int i = 0; i <= samples; ++i)
    {
        const double s = static_cast<double>(i) / samples;
        const double u = u0 + s * (u1 - u0);
        const double v = v0 + s * (v1 - v0);
        const double gap = along_u ? surface.Value(u0, v).Distance(surface.Value(u1, v))
                                   : surface.Value(u, v0).Distance(surface.Value(u, v1));
        if (gap > tolerance)
            return false;
    }
    return true;
}

} // namespace

Periods periods_of(const InputFace &input, double tolerance)
{
    double u0, u1, v0, v1;
    input.surface->Bounds(u0, u1, v0, v1);
    // along the other parameter, what the face covers says enough of a surface without end
    const ParameterBox &box = input.box;
    const auto finite = [](double bound, double own) { return Precision::IsInfinite(bound) ? own : bound; };
    Periods periods;
    if (input.surface->IsUPeriodic())
        periods.u = input.surface->UPeriod();
    else if (ends_meet(*input.surface, {u0, u1, finite(v0, box.vmin), finite(v1, box.vmax)}, true, tolerance))
        periods.u = u1 - u0;
    if (input.surface->IsVPeriodic())
        periods.v = input.surface->VPeriod();
    else if (ends_meet(*input.surface, {finite(u0, box.umin), finite(u1, box.umax), v0, v1}, false, tolerance))
        periods.v = v1 - v0;
    return periods;
}

} // namespace laminate_offset
