// SPDX-License-Identifier: LGPL-2.1-or-later
#include "extend_face.h"

#include "extension/extend_surface.h"
#include "input/input_face.h"
#include "topology/extended_face.h"

#include <chrono>

namespace laminate_offset
{
namespace
{

Result<ExtensionResult> extend(const TopoDS_Shape &shape, const ExtensionOptions &options, Stage &stage)
{
    const auto started = std::chrono::steady_clock::now();
    stage = Stage::Input;
    const Result<InputFace> input = read_face(shape);
    if (!input)
        return input.failure();
    if (input.value().base_distance != 0.0)
        return Failure{Status::NotSupported, Stage::Extension,
                       "The face lies on an offset surface, which has no poles to extend; offset it by 0 mm first, "
                       "which makes it a spline.",
                       input.value().place(input.value().loops.front().curves.front().pieces.front().start),
                       std::nullopt};
    stage = Stage::Extension;
    Result<ExtendedSurface> surface = extend_surface({input.value(), input.value().surface}, options);
    if (!surface)
        return surface.failure();
    stage = Stage::Topology;
    const Result<TopoDS_Face> face = build_extended_face(input.value(), surface.value());
    if (!face)
        return face.failure();
    ExtensionReport report = extension_report(surface.value(), options);
    report.elapsed_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - started).count();
    return ExtensionResult{face.value(), std::move(report)};
}

} // namespace

Result<ExtensionResult> extend_face(const TopoDS_Shape &shape, const ExtensionOptions &options)
{
    if (const Result<bool> checked = check(options); !checked)
        return checked.failure();
    Stage stage = Stage::Input;
    try
    {
        return extend(shape, options, stage);
    }
    catch (const Standard_Failure &error)
    {
        return kernel_failure(error, stage);
    }
}

} // namespace laminate_offset
