// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The middle of measured values.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

namespace benchmark
{

//! Of an even number of values the mean of the two in the middle; no number where there are none.
inline double median(std::vector<double> values)
{
    if (values.empty())
        return std::numeric_limits<double>::quiet_NaN();
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

} // namespace benchmark
