// SPDX-License-Identifier: LGPL-2.1-or-later
#include "deviation.h"

#include <GeomLProp_SLProps.hxx>

#include <algorithm>
#include <cmath>

namespace test_support
{
namespace
{

//! From 0 to 1, both included; the inner values follow no grid (multiples of the golden ratio, folded).
double spread(int i, int count)
{
    if (i == 0 || i == count - 1)
        return i == 0 ? 0.0 : 1.0;
    const double wander = std::fmod(0.6180339887498949 * i, 1.0) - 0.5;
    return (i + 0.6 * wander) / (count - 1);
}

} // namespace

Deviation deviation(const Handle(Geom_Surface) & base, const Handle(Geom_Surface) & offset, const Rectangle &rectangle,
                    double distance, int count, const gp_Vec2d &shift)
{
    Deviation result;
    GeomLProp_SLProps from(base, 1, 1e-9), onto(offset, 1, 1e-9);
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j)
        {
            const double u = rectangle.u0 + (rectangle.u1 - rectangle.u0) * spread(i, count);
            const double v = rectangle.v0 + (rectangle.v1 - rectangle.v0) * spread(j, count);
            from.SetParameters(u, v);
            if (!from.IsNormalDefined())
            {
                ++result.undefined;
                continue;
            }
            onto.SetParameters(u + shift.X(), v + shift.Y());
            const gp_Vec normal(from.Normal()); // along S_u x S_v
            const gp_Pnt exact = from.Value().Translated(distance * normal);
            result.largest = std::max(result.largest, exact.Distance(onto.Value()));
            if (onto.IsNormalDefined())
                result.least_cosine = std::min(result.least_cosine, gp_Vec(onto.Normal()).Dot(normal));
            ++result.points;
        }
    return result;
}

} // namespace test_support
