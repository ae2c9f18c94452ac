// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geom_values.h"

#include <cmath>

namespace laminate_offset
{

void realign(KnotVector &kv, double low, double high)
{
    const double shift = 0.5 * (low + high) - 0.5 * (kv.front() + kv.back());
    if (std::abs(shift) <= 0.1 * (high - low))
        return;
    for (double &t : kv.knots)
        t += shift;
}

} // namespace laminate_offset
