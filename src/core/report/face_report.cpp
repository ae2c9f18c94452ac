// SPDX-License-Identifier: LGPL-2.1-or-later
#include "face_report.h"

#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>

namespace laminate_offset
{
namespace
{

SurfaceSummary summary(const Handle(Geom_Surface) & surface)
{
    SurfaceSummary result;
    switch (GeomAdaptor_Surface(surface).GetType())
    {
    case GeomAbs_Plane: result.type = "plane"; break;
    case GeomAbs_Cylinder: result.type = "cylinder"; break;
    case GeomAbs_Cone: result.type = "cone"; break;
    case GeomAbs_Sphere: result.type = "sphere"; break;
    case GeomAbs_Torus: result.type = "torus"; break;
    case GeomAbs_SurfaceOfRevolution: result.type = "revolution"; break;
    case GeomAbs_SurfaceOfExtrusion: result.type = "extrusion"; break;
    default: result.type = "bspline"; break;
    }
    if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface))
    {
        result.degree_u = spline->UDegree();
        result.degree_v = spline->VDegree();
        result.poles_u = spline->NbUPoles();
        result.poles_v = spline->NbVPoles();
        result.rational = spline->IsURational() || spline->IsVRational();
    }
    return result;
}

} // namespace

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
    report.surface = summary(surface.geometry);
    report.limits = feasible_range(analysis, input);
    report.loops = static_cast<int>(input.loops.size());
    report.edges = input.edge_count();
    report.faces = 1;
    return report;
}

} // namespace laminate_offset
