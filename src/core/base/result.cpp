// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result.h"

#include <fmt/format.h>

namespace laminate_offset
{

Failure kernel_failure(const Standard_Failure &error, Stage stage)
{
    return {Status::KernelError, stage,
            fmt::format("The geometry kernel raised {} ({}); check the base face.", error.DynamicType()->Name(),
                        error.GetMessageString()),
            std::nullopt, std::nullopt};
}

} // namespace laminate_offset
