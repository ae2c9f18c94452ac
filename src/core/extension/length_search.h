// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Arc lengths, and the parameter up to which something has to go on to reach one.
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace laminate_offset
{

//! A mirrored or continued part may be so many times as long in parameters as what it continues.
inline constexpr double longest_extension = 16.0;

//! Integral of `speed` over [breaks.front(), breaks.back()], Gauss' rule between the breaks.
double arc_length(const std::function<double(double)> &speed, const std::vector<double> &breaks);

//! The increment at which `length_of` is `length`, to 1e-9 of it: secant steps in logarithms from `start`, kept in a
//! bracket. \param length_of increasing; may have no value, which ends the search.
//! \return nothing where there is none up to `largest`.
std::optional<double> increment_for(const std::function<std::optional<double>(double)> &length_of, double length,
                                    double start, double largest);

} // namespace laminate_offset
