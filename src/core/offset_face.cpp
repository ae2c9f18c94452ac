// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_face.h"

#include "analysis/self_intersection.h"
#include "analysis/surface_analysis.h"
#include "input/input_face.h"
#include "surface/offset_surface.h"
#include "topology/build_face.h"
#include "trimming/trim_loops.h"

#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace laminate_offset
{
namespace
{

//! Runs the stages one after the other, times them, and turns OpenCASCADE's exceptions into refusals.
class Pipeline
{
public:
    explicit Pipeline(const OffsetOptions &options) : m_options(options) {}

    Result<OffsetResult> run(const TopoDS_Shape &shape)
    {
        try
        {
            return run_stages(shape);
        }
        catch (const Standard_Failure &error)
        {
            return kernel_failure(error, m_stage);
        }
    }

private:
    using Clock = std::chrono::steady_clock;

    void enter(Stage stage)
    {
        leave();
        m_stage = stage;
        m_entered = Clock::now();
    }

    void leave()
    {
        if (m_entered == Clock::time_point{})
            return;
        const std::chrono::duration<double, std::milli> spent = Clock::now() - m_entered;
        m_elapsed.stages.emplace_back(m_stage, spent.count());
        m_elapsed.total += spent.count();
        m_entered = {};
    }

    Result<OffsetResult> run_stages(const TopoDS_Shape &shape)
    {
        if (const Result<bool> checked = check(m_options); !checked)
            return checked.failure();
        enter(Stage::Input);
        const Result<InputFace> input = read_face(shape);
        if (!input)
            return input.failure();
        const double distance = input.value().from_surface(m_options.distance);
        enter(Stage::Analysis);
        const Result<SurfaceAnalysis> analysis = analyse(input.value(), distance, m_options.tolerance);
        if (!analysis)
            return analysis.failure();
        enter(Stage::Surface);
        const Result<OffsetSurface> surface = checked_surface(input.value(), analysis.value(), distance);
        if (!surface)
            return surface.failure();
        enter(Stage::Trimming);
        const Result<TrimLoops> loops = offset_loops(
            {input.value(), analysis.value().base, surface.value(), distance, edge_share * m_options.tolerance});
        if (!loops)
            return loops.failure();
        if (const Result<bool> close = check_edges(input.value(), surface.value(), loops.value()); !close)
            return close.failure();
        enter(Stage::Topology);
        const Result<TopoDS_Face> face = build_face(input.value(), surface.value(), loops.value());
        if (!face)
            return face.failure();
        leave();
        return OffsetResult{face.value(), report(input.value(), analysis.value(), surface.value(), loops.value())};
    }

    Result<OffsetSurface> checked_surface(const InputFace &input, const SurfaceAnalysis &analysis, double distance)
    {
        if (const Result<bool> feasible = check_distance(analysis, input, distance); !feasible)
            return feasible.failure();
        Result<OffsetSurface> made = offset_surface(analysis, input, distance, m_options);
        if (!made)
            return made;
        if (const Result<bool> clear = check_meetings(input, analysis, made.value(), distance); !clear)
            return clear.failure();
        return made;
    }

    Result<bool> check_meetings(const InputFace &input, const SurfaceAnalysis &analysis, const OffsetSurface &surface,
                                double distance) const
    {
        const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface.geometry);
        if (spline.IsNull())
            return true;
        return check_self_intersection({analysis, input, from_geom(spline), distance, m_options.tolerance});
    }

    //! A base whose seam closes only within its own tolerance passes that gap on to the offset's seam.
    Result<bool> check_edges(const InputFace &input, const OffsetSurface &surface, const TrimLoops &loops) const
    {
        const std::optional<double> error = loops.edge_error(surface.certified_error);
        if (!error || *error <= m_options.tolerance)
            return true;
        const auto worst =
            std::max_element(loops.edges.begin(), loops.edges.end(), [](const OffsetEdge &a, const OffsetEdge &b) {
                return a.deviation.bound < b.deviation.bound;
            });
        const gp_Pnt2d uv =
            worst->pcurve->Value(0.5 * (worst->first + worst->last)).Translated(-surface.parameter_shift);
        return Failure{
            Status::EdgeToleranceNotReached, Stage::Trimming,
            fmt::format("The edge at the reported place is off by up to {:.3g} mm, because the base does not "
                        "close there any better; loosen the tolerance or repair the base's seam.",
                        *error),
            input.place(uv), std::nullopt};
    }

    static SurfaceSummary summary(const Handle(Geom_Surface) & surface)
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

    OffsetReport report(const InputFace &input, const SurfaceAnalysis &analysis, const OffsetSurface &surface,
                        const TrimLoops &loops) const
    {
        OffsetReport report;
        report.message = sentence(Status::Ok);
        report.method = m_options.method;
        report.distance = m_options.distance;
        report.tolerance = m_options.tolerance;
        report.certified_error = surface.certified_error;
        report.sampled_error = surface.sampled_error;
        report.edge_error = loops.edge_error(surface.certified_error);
        report.sampled_edge_error = loops.sampled_error();
        report.surface = summary(surface.geometry);
        report.limits = feasible_range(analysis, input);
        report.loops = static_cast<int>(input.loops.size());
        report.edges = input.edge_count();
        report.elapsed = m_elapsed;
        return report;
    }

    const OffsetOptions &m_options;
    Stage m_stage = Stage::Options;
    Clock::time_point m_entered;
    Elapsed m_elapsed;
};

} // namespace

Result<OffsetResult> offset_face(const TopoDS_Shape &shape, const OffsetOptions &options)
{
    return Pipeline(options).run(shape);
}

} // namespace laminate_offset
