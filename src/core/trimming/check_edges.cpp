// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check_edges.h"

#include <fmt/format.h>

#include <algorithm>

namespace laminate_offset
{

Result<bool> check_edges(const InputFace &input, const OffsetSurface &surface, const TrimLoops &loops, double tolerance)
{
    const std::optional<double> error = loops.edge_error(surface.certified_error);
    if (!error || *error <= tolerance)
        return true;
    const auto worst =
        std::max_element(loops.edges.begin(), loops.edges.end(), [](const OffsetEdge &a, const OffsetEdge &b) {
            return a.deviation.bound < b.deviation.bound;
        });
    const gp_Pnt2d uv = worst->pcurve->Value(0.5 * (worst->first + worst->last)).Translated(-surface.parameter_shift);
    return Failure{
        Status::EdgeToleranceNotReached, Stage::Trimming,
        fmt::format(
            "The edge at the reported place is off by up to {:.3g} mm, because the base does not close there any "
            "better; loosen the tolerance or repair the base's seam.",
            *error),
        input.place(uv), std::nullopt};
}

} // namespace laminate_offset
