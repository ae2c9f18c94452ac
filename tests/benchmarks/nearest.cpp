// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nearest.h"

#include <laminate_offset/nearest_point.h>

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <TopoDS.hxx>
#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <ostream>
#include <random>

namespace benchmark
{
namespace
{

constexpr unsigned seed = 7;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Domain
{
    Handle(Geom_Surface) surface;
    double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
};

//! The face's parameter box as the product takes it.
Domain domain_of(const TopoDS_Face &face)
{
    Domain d{unwrapped(BRep_Tool::Surface(face))};
    BRepTools::UVBounds(face, d.u0, d.u1, d.v0, d.v1);
    double u0, u1, v0, v1;
    d.surface->Bounds(u0, u1, v0, v1);
    if (!d.surface->IsUPeriodic())
    {
        d.u0 = std::max(d.u0, u0);
        d.u1 = std::min(d.u1, u1);
    }
    if (!d.surface->IsVPeriodic())
    {
        d.v0 = std::max(d.v0, v0);
        d.v1 = std::min(d.v1, v1);
    }
    return d;
}

//! Every second point lies on the surface, the others in its box made twice as large.
std::vector<gp_Pnt> random_points(const Domain &d, int count)
{
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto on_surface = [&] {
        const double s = unit(engine);
        return d.surface->Value(d.u0 + (d.u1 - d.u0) * s, d.v0 + (d.v1 - d.v0) * unit(engine));
    };
    Bnd_Box box;
    for (int i = 0; i < 400; ++i)
        box.Add(on_surface());
    const double large = 0.5 * std::sqrt(box.SquareExtent());
    const gp_XYZ low = box.CornerMin().XYZ();
    const gp_XYZ high = box.CornerMax().XYZ();
    std::vector<gp_Pnt> points;
    for (int i = 0; i < count; ++i)
    {
        if (i % 2 == 0)
        {
            points.push_back(on_surface());
            continue;
        }
        gp_XYZ p;
        for (int e = 1; e <= 3; ++e)
            p.SetCoord(e, low.Coord(e) - 0.5 * large + (high.Coord(e) - low.Coord(e) + large) * unit(engine));
        points.emplace_back(p);
    }
    return points;
}

template <typename Work> double seconds(const Work &work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

//! Least distance to the border curves and corners.
class Border
{
public:
    explicit Border(const Domain &d)
    {
        for (const double u : {d.u0, d.u1})
            add(d.surface->UIso(u), d.v0, d.v1);
        for (const double v : {d.v0, d.v1})
            add(d.surface->VIso(v), d.u0, d.u1);
        for (const double u : {d.u0, d.u1})
            for (const double v : {d.v0, d.v1})
                m_corners.push_back(d.surface->Value(u, v));
    }

    double distance(const gp_Pnt &p)
    {
        double best = infinity;
        for (const gp_Pnt &corner : m_corners)
            best = std::min(best, corner.Distance(p));
        for (GeomAPI_ProjectPointOnCurve &curve : m_curves)
        {
            curve.Perform(p);
            if (curve.NbPoints() > 0)
                best = std::min(best, curve.LowerDistance());
        }
        return best;
    }

private:
    void add(const Handle(Geom_Curve) & curve, double first, double last)
    {
        m_curves.emplace_back();
        m_curves.back().Init(curve, first, last);
    }

    std::vector<gp_Pnt> m_corners;
    std::vector<GeomAPI_ProjectPointOnCurve> m_curves;
};

struct Row
{
    double ours_s = 0.0;
    double ours_one_core_s = 0.0;
    double occt_s = 0.0;
    double excess = -infinity; //!< ours beyond OpenCASCADE's best, part of the diagonal
    double gain = -infinity;   //!< the other way round
    bool refused = false;
};

Row compare_face(const BaseFace &base, int count)
{
    using namespace laminate_offset;
    const TopoDS_Face face = TopoDS::Face(base.face.Located(TopLoc_Location()));
    const Domain d = domain_of(face);
    const std::vector<gp_Pnt> points = random_points(d, count);
    Row row;
    Result<std::vector<NearestPoint>> ours = std::vector<NearestPoint>{};
    row.ours_s = seconds([&] { ours = nearest_points(face, points); });
    if (!ours)
    {
        row.refused = true;
        return row;
    }
    tbb::task_arena(1).execute([&] { row.ours_one_core_s = seconds([&] { ours = nearest_points(face, points); }); });
    std::vector<double> theirs(points.size(), infinity);
    row.occt_s = seconds([&] {
        GeomAPI_ProjectPointOnSurf projector;
        projector.Init(d.surface, d.u0, d.u1, d.v0, d.v1);
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            projector.Perform(points[i]);
            if (projector.NbPoints() > 0)
                theirs[i] = projector.LowerDistance();
        }
    });
    Border border(d);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const double best = std::min(theirs[i], border.distance(points[i]));
        row.excess = std::max(row.excess, (ours.value()[i].distance - best) / base.diagonal);
        row.gain = std::max(row.gain, (best - ours.value()[i].distance) / base.diagonal);
    }
    return row;
}

} // namespace

void run_nearest(const std::vector<BaseFace> &faces, int count, std::ostream &out)
{
    Row total;
    int slow = 0, far = 0, refused = 0;
    double least_ratio = infinity;
    out << fmt::format("nearest points, {} a face; points a second: all cores, one core, OpenCASCADE (one core)\n",
                       count);
    for (const BaseFace &base : faces)
    {
        const Row row = compare_face(base, count);
        if (row.refused)
        {
            ++refused;
            out << fmt::format("{:<55} refused\n", base.name);
            continue;
        }
        const double ratio = row.occt_s / row.ours_s;
        out << fmt::format("{:<55} {:9.0f} {:9.0f} {:9.0f}  ratio {:6.1f} ({:5.1f} on one core)  excess {:9.2e}  gain "
                           "{:8.2e}{}\n",
                           base.name, count / row.ours_s, count / row.ours_one_core_s, count / row.occt_s, ratio,
                           row.occt_s / row.ours_one_core_s, row.excess, row.gain, row.excess > 1e-9 ? "  TOO FAR" : "")
            << std::flush;
        total.ours_s += row.ours_s;
        total.ours_one_core_s += row.ours_one_core_s;
        total.occt_s += row.occt_s;
        total.excess = std::max(total.excess, row.excess);
        least_ratio = std::min(least_ratio, ratio);
        slow += ratio < 10.0 ? 1 : 0;
        far += row.excess > 1e-9 ? 1 : 0;
    }
    out << fmt::format(
        "{} faces, {} refused, {} too far, {} below 10 times the speed; worst excess {:.2e} of the diagonal; "
        "ratio {:.1f} in all ({:.1f} on one core), {:.1f} at least\n",
        faces.size(), refused, far, slow, total.excess, total.occt_s / total.ours_s,
        total.occt_s / total.ours_one_core_s, least_ratio);
}

} // namespace benchmark
