// SPDX-License-Identifier: LGPL-2.1-or-later
#include "projection.h"

#include <laminate_offset/project_curve.h>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ostream>

namespace benchmark
{
namespace
{

constexpr double tolerance = 1e-3;
constexpr int samples = 200;

struct Totals
{
    int edges = 0, refused = 0, unproven = 0, wrong = 0, off_surface = 0, split = 0, poles = 0;
    double worst = 0.0, slowest = 0.0, seconds = 0.0;
};

//! Largest distance at samples between the edge's curve and the surface along the pcurve.
double sampled(const TopoDS_Shape &wire, const TopoDS_Face &face)
{
    double worst = 0.0;
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(wire, TopAbs_EDGE, edges);
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    for (int i = 1; i <= edges.Extent(); ++i)
    {
        const TopoDS_Edge edge = TopoDS::Edge(edges(i));
        double first, last, first2, last2;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
        const Handle(Geom2d_Curve) pcurve = BRep_Tool::CurveOnSurface(edge, face, first2, last2);
        if (pcurve.IsNull())
            return 1e100;
        for (int k = 0; k <= samples; ++k)
        {
            const double t = first + (last - first) * k / samples;
            const gp_Pnt2d uv = pcurve->Value(t);
            worst = std::max(worst, curve->Value(t).Distance(surface->Value(uv.X(), uv.Y())));
        }
    }
    return worst;
}

void project_edge(const BaseFace &base, int number, const TopoDS_Edge &edge, bool all, Totals &totals,
                  std::ostream &out)
{
    using namespace laminate_offset;
    ++totals.edges;
    const auto start = std::chrono::steady_clock::now();
    const Result<CurveProjection> result = project_curve(base.face, edge, {tolerance, Outside::Clip});
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    totals.seconds += took;
    totals.slowest = std::max(totals.slowest, took);
    const std::string name = fmt::format("{} edge {}", base.name, number);
    if (!result)
    {
        ++totals.refused;
        out << fmt::format("{:<60} REFUSED {}\n", name, result.failure().message) << std::flush;
        return;
    }
    const CurveProjection &image = result.value();
    const double seen = sampled(image.wire, base.face);
    const bool proven = image.certified_error && *image.certified_error <= tolerance;
    const bool wrong = !(seen <= (image.certified_error ? *image.certified_error : tolerance) + 1e-9);
    const bool off = std::any_of(image.edges.begin(), image.edges.end(), [](const auto &e) { return !e.on_surface; });
    totals.unproven += proven ? 0 : 1;
    totals.wrong += wrong ? 1 : 0;
    totals.off_surface += off ? 1 : 0;
    totals.split += image.edges.size() > 1 ? 1 : 0;
    totals.worst = std::max(totals.worst, image.certified_error.value_or(0.0));
    if (all || !proven || wrong)
        out << fmt::format("{:<60} {} pieces {} certified {:.2e} seen {:.2e} off {:.2e}{}{} {:.1f} ms\n", name,
                           proven ? "proven" : "UNPROVEN", image.edges.size(), image.certified_error.value_or(-1.0),
                           seen, image.distance, off ? " own curve" : "", wrong ? " WRONG" : "", 1e3 * took)
            << std::flush;
}

} // namespace

void run_projection(const std::vector<BaseFace> &faces, bool all, std::ostream &out)
{
    Totals totals;
    for (const BaseFace &base : faces)
    {
        TopTools_IndexedMapOfShape edges;
        TopExp::MapShapes(base.face, TopAbs_EDGE, edges);
        for (int i = 1; i <= edges.Extent(); ++i)
            if (!BRep_Tool::Degenerated(TopoDS::Edge(edges(i))))
                project_edge(base, i, TopoDS::Edge(edges(i)), all, totals, out);
    }
    out << fmt::format(
        "{} edges put back onto {} faces at {} mm: {} refused, {} not proven, {} farther than proven at {} "
        "samples; {} got a curve of their own, {} in several pieces; worst proven {:.2e} mm; {:.2f} s, "
        "slowest {:.0f} ms\n",
        totals.edges, faces.size(), tolerance, totals.refused, totals.unproven, totals.wrong, samples,
        totals.off_surface, totals.split, totals.worst, totals.seconds, 1e3 * totals.slowest);
}

} // namespace benchmark
