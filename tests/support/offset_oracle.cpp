// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_oracle.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Extrema_GenLocateExtPS.hxx>
#include <Extrema_POnSurf.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

namespace test_support
{
namespace
{

constexpr double inside_margin = 1e-9; // of the classifier, in parameters
constexpr double told = 1.05; // an edge's tolerance is found by sampling: a little more may lie between samples

//! A face's surface with the outward normal.
class OrientedSurface
{
public:
    explicit OrientedSurface(const TopoDS_Face &face)
        : m_surface(BRep_Tool::Surface(face)), m_adaptor(m_surface), m_analysis(m_surface),
          m_sign(face.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0)
    {
    }

    gp_Pnt point(const gp_Pnt2d &uv) const { return m_surface->Value(uv.X(), uv.Y()); }

    std::optional<gp_Vec> normal(const gp_Pnt2d &uv) const
    {
        GeomLProp_SLProps local(m_surface, uv.X(), uv.Y(), 1, Precision::Confusion());
        if (!local.IsNormalDefined())
            return std::nullopt;
        return gp_Vec(local.Normal()) * m_sign;
    }

    //! From the tangents alone. OpenCASCADE's own properties state one of the many normals of a pole as if it were
    //! the only one; here there is none unless both tangents are there.
    std::optional<gp_Vec> plain_normal(const gp_Pnt2d &uv) const
    {
        gp_Pnt p;
        gp_Vec du, dv;
        m_surface->D1(uv.X(), uv.Y(), p, du, dv);
        const double smaller = std::min(du.Magnitude(), dv.Magnitude());
        const double larger = std::max(du.Magnitude(), dv.Magnitude());
        const gp_Vec cross = du.Crossed(dv);
        if (smaller <= 1e-11 * larger || cross.Magnitude() <= 1e-9 * smaller * larger)
            return std::nullopt;
        return cross.Normalized() * m_sign;
    }

    std::optional<gp_Pnt> offset_point(const gp_Pnt2d &uv, double distance) const
    {
        const auto direction = normal(uv);
        if (!direction)
            return std::nullopt;
        return point(uv).Translated(*direction * distance);
    }

    //! Principal curvatures along the outward normal (positive: the surface bends towards it).
    std::optional<std::pair<double, double>> curvatures(const gp_Pnt2d &uv) const
    {
        GeomLProp_SLProps local(m_surface, uv.X(), uv.Y(), 2, Precision::Confusion());
        if (!local.IsCurvatureDefined())
            return std::nullopt;
        return std::pair(m_sign * local.MinCurvature(), m_sign * local.MaxCurvature());
    }

    //! Parameters of the point of the surface near p: Newton from the seed, and when that stays further away
    //! than good_enough [mm] also a search over the whole surface.
    gp_Pnt2d nearest(const gp_Pnt &p, const gp_Pnt2d &seed, double good_enough) const
    {
        const gp_Pnt2d local = refined(p, seed);
        if (p.Distance(point(local)) <= good_enough)
            return local;
        const gp_Pnt2d searched = refined(p, m_analysis.ValueOfUV(p, Precision::Confusion()));
        return p.Distance(point(searched)) < p.Distance(point(local)) ? searched : local;
    }

private:
    gp_Pnt2d refined(const gp_Pnt &p, const gp_Pnt2d &seed) const
    {
        Extrema_GenLocateExtPS search(m_adaptor, Precision::PConfusion(), Precision::PConfusion());
        search.Perform(p, seed.X(), seed.Y());
        if (!search.IsDone() || search.SquareDistance() >= p.SquareDistance(point(seed)))
            return seed;
        double u = 0.0, v = 0.0;
        search.Point().Parameter(u, v);
        return {u, v};
    }

    Handle(Geom_Surface) m_surface;
    GeomAdaptor_Surface m_adaptor;
    mutable ShapeAnalysis_Surface m_analysis; // caches between searches
    double m_sign;
};

//! Calls visit(uv) for the points of a grid over the face's parameter box that lie inside the loops.
void for_each_inside(const TopoDS_Face &face, int grid, const std::function<void(const gp_Pnt2d &)> &visit)
{
    double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    BRepTopAdaptor_FClass2d classifier(face, inside_margin);
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j)
        {
            const gp_Pnt2d uv(u0 + (u1 - u0) * i / (grid - 1), v0 + (v1 - v0) * j / (grid - 1));
            if (classifier.Perform(uv) == TopAbs_IN)
                visit(uv);
        }
}

//! A distance beyond which the seeded search is checked by a global one: results are expected far below it.
double suspicious(double distance) { return 0.01 + 1e-5 * std::abs(distance); }

void measure_surface(const TopoDS_Face &base, const TopoDS_Face &result, double distance, int grid,
                     OracleReport &report)
{
    const OrientedSurface from(base), onto(result);
    BRepTopAdaptor_FClass2d result_classifier(result, inside_margin);
    for_each_inside(base, grid, [&](const gp_Pnt2d &uv) {
        const auto exact = from.offset_point(uv, distance);
        if (!exact)
        {
            ++report.undefined_normals;
            return;
        }
        ++report.points;
        report.parametric_error = std::max(report.parametric_error, exact->Distance(onto.point(uv)));
        const gp_Pnt2d image = onto.nearest(*exact, uv, suspicious(distance));
        const gp_Pnt image_point = onto.point(image);
        report.surface_error = std::max(report.surface_error, exact->Distance(image_point));
        if (result_classifier.Perform(image) == TopAbs_OUT)
            ++report.misplaced;
        const gp_Pnt2d foot = from.nearest(image_point, uv, std::abs(distance) + suspicious(distance));
        const double back = image_point.Distance(from.point(foot));
        report.converse_error = std::max(report.converse_error, std::abs(back - std::abs(distance)));
        const auto image_normal = onto.normal(image);
        const double cosine = image_normal ? image_normal->Dot(*from.normal(uv)) : -1.0;
        report.least_cosine = std::min(report.least_cosine, cosine);
    });
}

//! The edges of all loops as the face stores them, with their orientation in a forward face.
std::vector<TopoDS_Edge> stored_edges(const TopoDS_Face &face)
{
    std::vector<TopoDS_Edge> edges;
    for (TopExp_Explorer it(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next())
        edges.push_back(TopoDS::Edge(it.Current()));
    return edges;
}

int count_loops(const TopoDS_Face &face)
{
    int loops = 0;
    for (TopExp_Explorer it(face, TopAbs_WIRE); it.More(); it.Next())
        ++loops;
    return loops;
}

double largest_tolerance(const TopoDS_Face &face)
{
    double largest = 0.0;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
        largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Edge(it.Current())));
    for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More(); it.Next())
        largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Vertex(it.Current())));
    return largest;
}

//! The exact offset of one edge of the base, through its pcurve.
class ExactEdge
{
public:
    ExactEdge(const TopoDS_Face &base, const TopoDS_Edge &edge, double distance) : m_surface(base), m_distance(distance)
    {
        m_pcurve = BRep_Tool::CurveOnSurface(edge, TopoDS::Face(base.Oriented(TopAbs_FORWARD)), m_first, m_last);
        double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
        BRepTools::UVBounds(base, u0, u1, v0, v1);
        m_middle = gp_Pnt2d(0.5 * (u0 + u1), 0.5 * (v0 + v1));
        constexpr int samples = 400;
        for (int i = 0; i <= samples; ++i)
            m_samples.push_back(point(parameter(static_cast<double>(i) / samples)));
    }

    double parameter(double fraction) const { return m_first + (m_last - m_first) * fraction; }

    //! Where the surface has no normal (at a pole), the normal just beside it, towards the middle of the face's
    //! parameter box, stands in.
    gp_Pnt point(double t) const
    {
        const gp_Pnt2d uv = m_pcurve->Value(t);
        for (const double step : {0.0, 1e-7, 1e-6, 1e-5, 1e-4})
        {
            const gp_XY beside = uv.XY() + (m_middle.XY() - uv.XY()) * step;
            if (const auto normal = m_surface.plain_normal(beside))
                return m_surface.point(uv).Translated(*normal * m_distance);
        }
        throw std::runtime_error("the base has no normal near an edge");
    }

    //! Distance from q to the curve: the nearest sample, then a golden section search around it.
    double distance(const gp_Pnt &q) const
    {
        const auto nearer = [&](const gp_Pnt &a, const gp_Pnt &b) { return q.SquareDistance(a) < q.SquareDistance(b); };
        const auto best = std::min_element(m_samples.begin(), m_samples.end(), nearer) - m_samples.begin();
        const double count = static_cast<double>(m_samples.size() - 1);
        double low = parameter(std::max(0.0, (best - 1) / count)), high = parameter(std::min(1.0, (best + 1) / count));
        constexpr double golden = 0.6180339887498949;
        for (int i = 0; i < 40; ++i)
        {
            const double left = high - golden * (high - low), right = low + golden * (high - low);
            if (q.SquareDistance(point(left)) < q.SquareDistance(point(right)))
                high = right;
            else
                low = left;
        }
        return std::min(q.Distance(point(0.5 * (low + high))), q.Distance(m_samples[static_cast<size_t>(best)]));
    }

private:
    OrientedSurface m_surface;
    double m_distance;
    Handle(Geom2d_Curve) m_pcurve;
    double m_first = 0.0, m_last = 0.0;
    gp_Pnt2d m_middle;
    std::vector<gp_Pnt> m_samples;
};

//! From p to the curve between the parameters, its ends included.
double distance_to_curve(const gp_Pnt &p, const Handle(Geom_Curve) & curve, double first, double last)
{
    double least = std::min(p.Distance(curve->Value(first)), p.Distance(curve->Value(last)));
    const GeomAPI_ProjectPointOnCurve projection(p, curve, first, last);
    if (projection.NbPoints() > 0)
        least = std::min(least, projection.LowerDistance());
    return least;
}

void measure_pcurve(const TopoDS_Face &result, const TopoDS_Edge &edge, int points, OracleReport &report)
{
    double first = 0.0, last = 0.0, first2d = 0.0, last2d = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    const auto forward = TopoDS::Face(result.Oriented(TopAbs_FORWARD));
    const Handle(Geom2d_Curve) pcurve = BRep_Tool::CurveOnSurface(edge, forward, first2d, last2d);
    report.same_parameter &= BRep_Tool::SameParameter(edge) && BRep_Tool::SameRange(edge);
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(result);
    for (int i = 0; i <= points; ++i)
    {
        const double fraction = static_cast<double>(i) / points;
        const gp_Pnt2d uv = pcurve->Value(first2d + (last2d - first2d) * fraction);
        const gp_Pnt on_surface = surface->Value(uv.X(), uv.Y());
        const double gap = on_surface.Distance(curve->Value(first + (last - first) * fraction));
        report.pcurve_error = std::max(report.pcurve_error, gap);
        report.untold_pcurve_error = std::max(report.untold_pcurve_error, gap - told * BRep_Tool::Tolerance(edge));
    }
}

void measure_vertices(const ExactEdge &exact, const TopoDS_Edge &edge, OracleReport &report)
{
    const gp_Pnt first = BRep_Tool::Pnt(TopExp::FirstVertex(edge)), last = BRep_Tool::Pnt(TopExp::LastVertex(edge));
    const double start = first.Distance(exact.point(exact.parameter(0.0)));
    const double end = last.Distance(exact.point(exact.parameter(1.0)));
    report.vertex_error = std::max({report.vertex_error, start, end});
}

void measure_edge(const TopoDS_Face &base, const TopoDS_Edge &base_edge, const TopoDS_Face &result,
                  const TopoDS_Edge &edge, double distance, int points, OracleReport &report)
{
    report.orientation_kept &= base_edge.Orientation() == edge.Orientation();
    if (BRep_Tool::Degenerated(base_edge))
        return;
    ++report.compared_edges;
    const ExactEdge exact(base, base_edge, distance);
    double first = 0.0, last = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    for (int i = 0; i <= points; ++i)
    {
        const double fraction = static_cast<double>(i) / points;
        const gp_Pnt there = exact.point(exact.parameter(fraction)),
                     here = curve->Value(first + (last - first) * fraction);
        report.edge_error = std::max(report.edge_error, distance_to_curve(there, curve, first, last));
        report.edge_converse = std::max(report.edge_converse, exact.distance(here));
    }
    measure_vertices(exact, edge, report);
    measure_pcurve(result, edge, points, report);
}

void measure_edges(const TopoDS_Face &base, const TopoDS_Face &result, double distance, int points,
                   OracleReport &report)
{
    const auto base_edges = stored_edges(base), edges = stored_edges(result);
    report.base_edges = static_cast<int>(base_edges.size());
    report.edges = static_cast<int>(edges.size());
    if (base_edges.size() != edges.size())
        return;
    for (size_t i = 0; i < edges.size(); ++i)
        measure_edge(base, base_edges[i], result, edges[i], distance, points, report);
}

} // namespace

OracleReport measure_offset(const TopoDS_Face &base, const TopoDS_Face &result, double distance,
                            const OracleOptions &options)
{
    OracleReport report;
    report.base_loops = count_loops(base);
    report.loops = count_loops(result);
    report.valid = BRepCheck_Analyzer(result).IsValid();
    report.orientation_kept = base.Orientation() == result.Orientation();
    report.largest_tolerance = largest_tolerance(result);
    report.base_largest_tolerance = largest_tolerance(base);
    measure_surface(base, result, distance, options.grid, report);
    measure_edges(base, result, distance, options.edge_points, report);
    return report;
}

testing::AssertionResult confirms(const OracleReport &report, double tolerance)
{
    std::vector<std::string> faults;
    const auto within = [&](const char *what, double figure) {
        if (!(figure <= tolerance))
            faults.push_back(fmt::format("{} {} exceeds {}", what, figure, tolerance));
    };
    const auto holds = [&](const char *what, bool condition) {
        if (!condition)
            faults.emplace_back(what);
    };
    within("surface error", report.surface_error);
    within("converse surface error", report.converse_error);
    within("edge error", report.edge_error);
    within("converse edge error", report.edge_converse);
    within("vertex error", report.vertex_error);
    within("pcurve error", report.pcurve_error);
    within("largest edge or vertex tolerance",
           report.largest_tolerance <= report.base_largest_tolerance ? 0.0 : report.largest_tolerance);
    holds("hardly any point was compared", report.points >= 50);
    holds("no edge was compared", report.compared_edges > 0);
    holds("the normals differ", report.least_cosine > 0.999);
    holds("points fell outside the result's loops", report.misplaced == 0);
    holds("the number of loops changed", report.loops == report.base_loops);
    holds("the number of edges changed", report.edges == report.base_edges);
    holds("the result is not valid", report.valid);
    holds("an edge is not same-parameter", report.same_parameter);
    holds("an edge's tolerance hides a larger gap to its pcurve", report.untold_pcurve_error <= 1e-9);
    holds("an orientation changed", report.orientation_kept);
    if (faults.empty())
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << fmt::format("{} | {}", fmt::join(faults, "; "), to_text(report));
}

double least_curvature_factor(const TopoDS_Face &face, double distance, int grid)
{
    double least = std::numeric_limits<double>::infinity();
    const OrientedSurface surface(face);
    for_each_inside(face, grid, [&](const gp_Pnt2d &uv) {
        if (const auto k = surface.curvatures(uv))
            least = std::min({least, 1.0 - distance * k->first, 1.0 - distance * k->second});
    });
    return least;
}

std::string to_text(const OracleReport &r)
{
    return fmt::format("points {} surface {:.3g} converse {:.3g} parametric {:.3g} cosine {:.6f} misplaced {} "
                       "edges {}/{} loops {}/{} edge {:.3g} converse {:.3g} vertex {:.3g} pcurve {:.3g} "
                       "tolerance {:.3g} (base {:.3g}) valid {}",
                       r.points, r.surface_error, r.converse_error, r.parametric_error, r.least_cosine, r.misplaced,
                       r.edges, r.base_edges, r.loops, r.base_loops, r.edge_error, r.edge_converse, r.vertex_error,
                       r.pcurve_error, r.largest_tolerance, r.base_largest_tolerance, r.valid);
}

} // namespace test_support
