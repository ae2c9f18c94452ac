// SPDX-License-Identifier: LGPL-2.1-or-later
#include "face_report.h"

namespace laminate_offset
{

OffsetReport face_report(const InputFace &input, const SurfaceAnalysis &analysis, const OffsetSurface &surface,
                         const TrimLoops &loops, const OffsetOptions &options)
{
    OffsetReport report;
    report.message = sentence(Status::Ok);
    report.method = options.method;
    report.distance = options.distance;
    report.tolerance = options.tolerance;
    report.certified_error = surface.certified_error;
    report.sampled_error = surface.sampled_error;
    report.edge_error = loops.edge_error(surface.certified_error);
    report.sampled_edge_error = loops.sampled_error();
    report.surface = summary_of(surface.geometry);
    report.limits = feasible_range(analysis, input);
    report.limits_proven = !analysis.sampled;
    report.apart = surface.apart;
    report.loops = static_cast<int>(input.loops.size());
    report.edges = input.edge_count();
    report.faces = 1;
    return report;
}

} // namespace laminate_offset
