// SPDX-License-Identifier: LGPL-2.1-or-later
#include "routes.h"

#include "cases.h"
#include "median.h"

#include <laminate_offset/offset_face.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepOffsetAPI_MakeOffsetShape.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert_ApproxSurface.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace benchmark
{
namespace
{

using laminate_offset::OffsetResult;
using laminate_offset::Result;

constexpr double slow = 200.0; // ms from which a run is repeated less
constexpr double very_slow = 1500.0;
constexpr double long_enough = 40.0; // ms that the counted runs last together
constexpr std::size_t projected_points = 200;

void set_text(char *to, std::size_t size, const std::string &text) { to[text.copy(to, size - 1)] = '\0'; }

//! Of the whole process [ms].
double cpu_time()
{
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

//! Median times of so many runs at least, written to an outcome; quick ones go on until they are `long_enough`, and, unless it is slow, a
//! first run for threads and caches does not count.
void timed(int least_runs, const std::function<void()> &run, Outcome &outcome)
{
    std::vector<double> times, cpu_times;
    double total = 0.0;
    for (int i = 0; i <= least_runs || total < long_enough; ++i)
    {
        if (i == 1 && times.front() < slow)
        {
            times.clear();
            cpu_times.clear();
        }
        const double cpu_start = cpu_time();
        const auto start = std::chrono::steady_clock::now();
        run();
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
        cpu_times.push_back(cpu_time() - cpu_start);
        if (times.back() > very_slow || (times.back() > slow && i >= 1))
            break;
        total += times.back();
    }
    outcome.ms = median(times);
    outcome.cpu_ms = median(cpu_times);
}

//! S + d N of the base at grid points inside the loops of a face with the same parameters, where there is a normal.
struct ExactPoint
{
    gp_Pnt2d uv;
    gp_Pnt point;
};

std::vector<ExactPoint> exact_points(const TopoDS_Face &base, const TopoDS_Face &loops, double outward, int grid)
{
    double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
    BRepTools::UVBounds(loops, u0, u1, v0, v1);
    BRepTopAdaptor_FClass2d inside(loops, 1e-9);
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(base);
    const double distance = base.Orientation() == TopAbs_REVERSED ? -outward : outward;
    // beside the borders of a part, not on them: a crease has the normals of both sides
    const double inset = loops.IsSame(base) ? 0.0 : 1e-6;
    const auto between = [&](double low, double high, int i) {
        return low + (high - low) * (inset + (1.0 - 2.0 * inset) * i / grid);
    };
    std::vector<ExactPoint> points;
    for (int i = 0; i <= grid; ++i)
        for (int j = 0; j <= grid; ++j)
        {
            const gp_Pnt2d uv(between(u0, u1, i), between(v0, v1, j));
            if (inside.Perform(uv) == TopAbs_OUT)
                continue;
            gp_Pnt point;
            gp_Vec du, dv;
            surface->D1(uv.X(), uv.Y(), point, du, dv);
            const gp_Vec normal = du.Crossed(dv);
            if (du.Magnitude() > 1e-9 && dv.Magnitude() > 1e-9 &&
                normal.Magnitude() > 1e-6 * du.Magnitude() * dv.Magnitude())
                points.push_back({uv, point.Translated(normal.Normalized() * distance)});
        }
    return points;
}

//! Distance of the points to the surface, whatever its parameters; coarser, for it takes long.
double distance_to_surface(const std::vector<ExactPoint> &points, const Handle(Geom_Surface) & surface)
{
    ShapeAnalysis_Surface nearest(surface);
    const std::size_t step = std::max<std::size_t>(1, points.size() / projected_points);
    double worst = 0.0;
    for (std::size_t i = 0; i < points.size(); i += step)
    {
        nearest.ValueOfUV(points[i].point, 1e-9);
        worst = std::max(worst, nearest.Gap());
    }
    return worst;
}

double sampled_error(const TopoDS_Face &base, const TopoDS_Face &loops, const Handle(Geom_Surface) & made,
                     const Task &task)
{
    const std::vector<ExactPoint> points = exact_points(base, loops, task.distance, task.grid);
    double worst = 0.0;
    for (const ExactPoint &exact : points)
        worst = std::max(worst, exact.point.Distance(made->Value(exact.uv.X(), exact.uv.Y())));
    return worst <= task.tolerance ? worst : std::min(worst, distance_to_surface(points, made));
}

//! Judges the place of a refusal for curvature by OpenCASCADE alone.
bool folds_at(const TopoDS_Face &base, const gp_Pnt2d &uv, double distance)
{
    if (BRepTopAdaptor_FClass2d(base, 1e-6).Perform(uv) == TopAbs_OUT)
        return false;
    GeomLProp_SLProps at(BRep_Tool::Surface(base), uv.X(), uv.Y(), 2, 1e-9);
    if (!at.IsCurvatureDefined())
        return false;
    const double outward = base.Orientation() == TopAbs_REVERSED ? -distance : distance;
    return 1.0 - outward * at.MinCurvature() <= 0.0 || 1.0 - outward * at.MaxCurvature() <= 0.0;
}

void describe_surface(const Handle(Geom_Surface) & surface, Outcome &outcome)
{
    if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface))
    {
        outcome.poles_u = spline->NbUPoles();
        outcome.poles_v = spline->NbVPoles();
        outcome.degree_u = spline->UDegree();
        outcome.degree_v = spline->VDegree();
    }
}

void record(const OffsetResult &result, const TopoDS_Face &base, const Task &task, Outcome &outcome)
{
    const bool creased = result.report.faces > 1;
    outcome.made = true;
    outcome.valid = true;
    set_text(outcome.status, sizeof outcome.status, creased ? "shell" : "ok");
    outcome.certified = result.report.certified_error.has_value();
    outcome.bound = result.report.certified_error.value_or(0.0);
    for (TopExp_Explorer faces(result.shape, TopAbs_FACE); faces.More(); faces.Next())
    {
        const TopoDS_Face &part = TopoDS::Face(faces.Current());
        const Handle(Geom_Surface) surface = BRep_Tool::Surface(part);
        describe_surface(surface, outcome);
        outcome.valid = outcome.valid && BRepCheck_Analyzer(part).IsValid();
        // the parts of a creased base keep its parameters and have loops of their own
        outcome.sampled = std::max(outcome.sampled, sampled_error(base, creased ? part : base, surface, task));
    }
    for (const auto &[stage, ms] : result.report.elapsed.stages)
        outcome.stages.at(static_cast<std::size_t>(stage)) += ms;
}

//! The surface of the first face, bounded where it has no ends of its own.
Handle(Geom_Surface) offset_by_join(const TopoDS_Face &face, const Task &task)
{
    BRepOffsetAPI_MakeOffsetShape maker;
    maker.PerformByJoin(face, task.distance, task.tolerance);
    if (!maker.IsDone())
        throw std::runtime_error("BRepOffset is not done");
    TopExp_Explorer faces(maker.Shape(), TopAbs_FACE);
    if (!faces.More())
        throw std::runtime_error("BRepOffset made no face");
    const TopoDS_Face &made = TopoDS::Face(faces.Current());
    const Handle(Geom_Surface) surface = unwrapped(BRep_Tool::Surface(made));
    double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
    surface->Bounds(u0, u1, v0, v1);
    if (!Precision::IsInfinite(u0) && !Precision::IsInfinite(u1) && !Precision::IsInfinite(v0) &&
        !Precision::IsInfinite(v1))
        return surface;
    BRepTools::UVBounds(made, u0, u1, v0, v1);
    return new Geom_RectangularTrimmedSurface(surface, u0, u1, v0, v1);
}

Handle(Geom_BSplineSurface) occt_surface(const TopoDS_Face &face, const Task &task)
{
    const Handle(Geom_Surface) exact = offset_by_join(face, task);
    if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(exact))
        return spline;
    const GeomConvert_ApproxSurface approximation(exact, task.tolerance, GeomAbs_C1, GeomAbs_C1, 14, 14, 1000, 0);
    if (!approximation.HasResult())
        throw std::runtime_error("ApproxSurface has no result");
    if (!approximation.IsDone())
        throw std::runtime_error("ApproxSurface is not done");
    return approximation.Surface();
}

} // namespace

Outcome run_ours(const TopoDS_Face &face, const Task &task)
{
    laminate_offset::OffsetOptions options;
    options.distance = task.distance;
    options.tolerance = task.tolerance;
    options.method = task.method;
    Outcome outcome;
    std::optional<Result<OffsetResult>> result;
    timed(
        task.runs, [&] { result = laminate_offset::offset_face(face, options); }, outcome);
    if (result->ok())
    {
        record(result->value(), face, task, outcome);
        return outcome;
    }
    const laminate_offset::Failure &failure = result->failure();
    set_text(outcome.status, sizeof outcome.status, std::string(laminate_offset::name(failure.status)));
    set_text(outcome.message, sizeof outcome.message, failure.message);
    outcome.has_where = failure.where.has_value();
    outcome.fold_confirmed = failure.status == laminate_offset::Status::CurvatureLimit && failure.where &&
                             folds_at(face, failure.where->uv, task.distance);
    return outcome;
}

Outcome run_occt(const TopoDS_Face &face, const Task &task)
{
    Outcome outcome;
    try
    {
        Handle(Geom_BSplineSurface) surface;
        timed(
            task.runs, [&] { surface = occt_surface(face, task); }, outcome);
        outcome.made = true;
        set_text(outcome.status, sizeof outcome.status, "ok");
        describe_surface(surface, outcome);
        outcome.sampled = sampled_error(face, face, surface, task);
    }
    catch (const Standard_Failure &error)
    {
        set_text(outcome.status, sizeof outcome.status, "exception");
        set_text(outcome.message, sizeof outcome.message, error.GetMessageString());
    }
    catch (const std::runtime_error &error)
    {
        set_text(outcome.status, sizeof outcome.status, "refused");
        set_text(outcome.message, sizeof outcome.message, error.what());
    }
    return outcome;
}

} // namespace benchmark
