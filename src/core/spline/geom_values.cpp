// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geom_values.h"

#include <cmath>

namespace laminate_offset
{

std::pair<double, double> period_cut(double low, double high, double first, double last)
{
    constexpr double rounding = 1e-9;
    const double period = last - first;
    const auto snapped = [&](double t) {
        const double turns = std::round((t - first) / period);
        const double end = turns == 1.0 ? last : first + turns * period;
        return std::abs(t - end) <= rounding * period ? end : t;
    };
    low = snapped(low);
    high = snapped(high);
    if (std::abs(high - low - period) <= rounding * period)
        high = low == first ? last : low + period;
    return {low, high};
}

void realign(KnotVector &kv, double low, double high)
{
    const double shift = 0.5 * (low + high) - 0.5 * (kv.front() + kv.back());
    if (std::abs(shift) <= 0.1 * (high - low))
        return;
    for (double &t : kv.knots)
        t += shift;
}

} // namespace laminate_offset
