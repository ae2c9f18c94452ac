// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result.h"

#include <fmt/format.h>

#include <algorithm>

namespace laminate_offset
{

FeasibleRange tightest(const FeasibleRange &a, const FeasibleRange &b)
{
    FeasibleRange range = a;
    if (b.negative)
        range.negative = std::max(*b.negative, range.negative.value_or(*b.negative));
    if (b.positive)
        range.positive = std::min(*b.positive, range.positive.value_or(*b.positive));
    return range;
}

Failure kernel_failure(const Standard_Failure &error, Stage stage)
{
    return {Status::KernelError, stage,
            fmt::format("The geometry kernel raised {} ({}); check the base face.", error.DynamicType()->Name(),
                        error.GetMessageString()),
            std::nullopt, std::nullopt};
}

} // namespace laminate_offset
