// SPDX-License-Identifier: LGPL-2.1-or-later
#include "options.h"

#include <fmt/format.h>

#include <cmath>

namespace laminate_offset
{
namespace
{

Failure refusal(Status status, std::string message)
{
    return {status, Stage::Options, std::move(message), std::nullopt, std::nullopt};
}

} // namespace

std::string_view name(Method method) { return method == Method::RaviKumar ? "ravi-kumar" : "same-parameter"; }

Result<bool> check(const OffsetOptions &options)
{
    if (!std::isfinite(options.distance))
        return refusal(Status::InvalidDistance, "The distance is not a finite number; give it in millimetres.");
    if (!std::isfinite(options.tolerance) || options.tolerance <= 0.0)
        return refusal(
            Status::InvalidTolerance,
            fmt::format("The tolerance {} mm is not a positive finite number; 0.001 is usual.", options.tolerance));
    if (!std::isfinite(options.extension) || options.extension < 0.0)
        return refusal(Status::InvalidOption,
                       fmt::format("The extension {} mm must be a finite length of zero or more.", options.extension));
    if (options.max_degree < 3 || options.max_degree > 7)
        return refusal(Status::InvalidOption,
                       fmt::format("max_degree {} is out of its range 3 to 7.", options.max_degree));
    return true;
}

} // namespace laminate_offset
