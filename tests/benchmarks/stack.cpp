// SPDX-License-Identifier: LGPL-2.1-or-later
#include "stack.h"

#include "child_process.h"
#include "median.h"

#include "support/data_files.h"

#include <laminate_offset/offset_stack.h>
#include <laminate_offset/ply_solids.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace benchmark
{
namespace
{

using namespace laminate_offset;

constexpr double thickness = 0.125; // mm of a ply
constexpr double tolerance = 1e-3;  // mm
constexpr int runs = 7;
constexpr int grid = 80;
constexpr double limit_s = 300.0;

double median_ms(const std::function<void()> &work)
{
    std::vector<double> times;
    for (int i = 0; i <= runs; ++i)
    {
        const auto start = std::chrono::steady_clock::now();
        work();
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    times.erase(times.begin()); // threads and caches
    return median(std::move(times));
}

OffsetOptions options()
{
    OffsetOptions result;
    result.tolerance = tolerance;
    result.distance = thickness;
    return result;
}

//! Bottom and top of all plies.
std::vector<double> levels(int plies)
{
    std::vector<double> all;
    for (int ply = 0; ply <= plies; ++ply)
        all.push_back(thickness * ply);
    return all;
}

//! Largest difference between neighbours' distance at equal parameters inside the loops and the thickness [mm].
double neighbour_error(const StackResult &stack)
{
    double worst = 0.0;
    double u0, u1, v0, v1;
    const TopoDS_Face first = stack.surfaces.front().face();
    BRepTools::UVBounds(first, u0, u1, v0, v1);
    BRepTopAdaptor_FClass2d inside(first, 1e-9);
    for (int i = 0; i <= grid; ++i)
        for (int j = 0; j <= grid; ++j)
        {
            const gp_Pnt2d uv(u0 + (u1 - u0) * i / grid, v0 + (v1 - v0) * j / grid);
            if (inside.Perform(uv) == TopAbs_OUT)
                continue;
            gp_Pnt below = BRep_Tool::Surface(first)->Value(uv.X(), uv.Y());
            for (std::size_t k = 1; k < stack.surfaces.size(); ++k)
            {
                const gp_Pnt above = BRep_Tool::Surface(stack.surfaces[k].face())->Value(uv.X(), uv.Y());
                worst = std::max(worst, std::abs(below.Distance(above) - thickness));
                below = above;
            }
        }
    return worst;
}

Outcome one_ply(const TopoDS_Face &face)
{
    Outcome outcome;
    outcome.ms = median_ms([&] { outcome.made = offset_face(face, options()).ok(); });
    return outcome;
}

Outcome plies(const TopoDS_Face &face, int count)
{
    Outcome outcome;
    std::optional<Result<StackResult>> made;
    outcome.ms = median_ms([&] { made = offset_stack(face, levels(count), options()); });
    if (!made->ok())
        return outcome;
    const std::vector<OffsetResult> &surfaces = made->value().surfaces;
    outcome.made = true;
    outcome.certified = std::all_of(surfaces.begin(), surfaces.end(), [](const OffsetResult &one) {
        return one.report.certified_error.value_or(1.0) <= tolerance &&
               one.report.edge_error.value_or(1.0) <= tolerance;
    });
    outcome.valid = std::all_of(surfaces.begin(), surfaces.end(),
                                [](const OffsetResult &one) { return BRepCheck_Analyzer(one.shape).IsValid(); });
    outcome.sampled = neighbour_error(made->value());
    outcome.poles_u = surfaces.front().report.surface->poles_u;
    outcome.poles_v = surfaces.front().report.surface->poles_v;
    return outcome;
}

Outcome solids(const TopoDS_Face &face, int count)
{
    Outcome outcome;
    const Result<StackResult> stack = offset_stack(face, levels(count), options());
    if (!stack)
        return outcome;
    std::vector<TopoDS_Shape> faces;
    std::vector<SolidSpan> spans;
    for (const OffsetResult &surface : stack.value().surfaces)
    {
        if (!faces.empty())
            spans.push_back({faces.size() - 1, faces.size()});
        faces.push_back(surface.shape);
    }
    outcome.ms = median_ms([&] { outcome.made = ply_solids(faces, spans).ok(); });
    return outcome;
}

Outcome by_occt(const TopoDS_Face &face, int count)
{
    Outcome total;
    total.made = true;
    for (int ply = 1; ply <= count; ++ply)
    {
        const Outcome one = run_occt(face, {thickness * ply, tolerance, runs, 2});
        total.ms += one.ms;
        total.made = total.made && one.made;
    }
    return total;
}

void measure_panel(const std::string &name, const TopoDS_Face &face, std::ostream &out)
{
    const ChildResult one = run_in_child([&] { return one_ply(face); }, limit_s);
    const ChildResult sixteen = run_in_child([&] { return plies(face, 16); }, limit_s);
    const ChildResult occt = run_in_child([&] { return by_occt(face, 16); }, limit_s);
    const ChildResult many = run_in_child([&] { return plies(face, 200); }, limit_s);
    const ChildResult solid = run_in_child([&] { return solids(face, 16); }, limit_s);
    const auto line = [&](const char *what, const ChildResult &of) {
        out << fmt::format("{:10} {:9.2f} ms  {:7.2f} x one ply  {:7.3f} x OpenCASCADE  peak {:6.1f} MiB  {}\n", what,
                           of.outcome.ms, of.outcome.ms / one.outcome.ms, of.outcome.ms / occt.outcome.ms, of.peak_mib,
                           of.outcome.made ? "made" : "REFUSED");
    };
    out << name << ", plies of " << thickness << " mm at " << tolerance << " mm\n";
    line("one ply", one);
    line("16 plies", sixteen);
    line("OCCT, 16", occt);
    line("200 plies", many);
    line("16 solids", solid);
    for (const auto &[what, of] : {std::pair{"16", sixteen}, {"200", many}})
        out << fmt::format("  {} plies: {}x{} poles, {}, {}, neighbours' distance off by {:.2g} mm at most\n", what,
                           of.outcome.poles_u, of.outcome.poles_v,
                           of.outcome.certified ? "all certified" : "NOT CERTIFIED",
                           of.outcome.valid ? "all valid" : "NOT VALID", of.outcome.sampled);
}

} // namespace

void run_stacks(std::ostream &out)
{
    for (const char *name :
         {"derived_D150_fuselage_2p3m_1hole_6curves.step", "derived_D150_fuselage_3p4m_2holes_9curves.step"})
        if (const auto path = test_support::find_data_file(name))
            measure_panel(name, test_support::read_faces(*path).front(), out);
        else
            out << test_support::missing_data_message(name) << "\n";
}

} // namespace benchmark
