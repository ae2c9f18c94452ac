// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check_edges.h"

#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <fmt/format.h>

#include <algorithm>

namespace laminate_offset
{

Result<bool> check_edges(const InputFace &input, const OffsetSurface &surface, const TrimLoops &loops, double tolerance)
{
    const double error = loops.edge_error(surface.certified_error).value_or(loops.sampled_error());
    if (error <= tolerance)
        return true;
    const auto deviation = [](const OffsetEdge &edge) {
        return edge.own_parameters ? edge.offset_error.value_or(0.0) : edge.deviation.bound;
    };
    const auto worst =
        std::max_element(loops.edges.begin(), loops.edges.end(),
                         [&](const OffsetEdge &a, const OffsetEdge &b) { return deviation(a) < deviation(b); });
    const int index = static_cast<int>(worst - loops.edges.begin()) + 1;
    double first, last;
    const Handle(Geom2d_Curve) on_base =
        BRep_Tool::CurveOnSurface(TopoDS::Edge(loops.bases(index)), input.face, first, last);
    const gp_Pnt2d uv = on_base->Value(0.5 * (first + last));
    return Failure{
        Status::EdgeToleranceNotReached, Stage::Trimming,
        fmt::format(
            "The edge at the reported place is off by up to {:.3g} mm, because the base does not close there any "
            "better; loosen the tolerance or repair the base's seam.",
            error),
        input.place(uv), std::nullopt};
}

} // namespace laminate_offset
