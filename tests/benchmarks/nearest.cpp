// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nearest.h"

#include <laminate_offset/nearest_point.h>

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Extrema_ExtPS.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <deque>
#include <fstream>
#include <limits>
#include <map>
#include <ostream>
#include <random>
#include <sstream>

namespace benchmark
{
namespace
{

constexpr unsigned seed = 7;
constexpr double too_far = 1e-9; // part of the diagonal
constexpr std::size_t most_hasty_points = 2000;
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

//! What a piece of work takes by the clock on the wall, and of the calling thread's own time, which neither a busy machine
//! nor a halted run adds to.
struct Time
{
    double wall_s = 0.0;
    double thread_s = 0.0;
};

double thread_seconds()
{
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <typename Work> Time time_of(const Work &work)
{
    const auto start = std::chrono::steady_clock::now();
    const double thread_start = thread_seconds();
    work();
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
            thread_seconds() - thread_start};
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
    std::deque<GeomAPI_ProjectPointOnCurve> m_curves; // which must stay where they are: they point into themselves
};

struct Row
{
    Time ours;
    Time ours_one_core;
    Time occt;
    int hasty_points = 0;
    Time hasty;           //!< OpenCASCADE's fastest way, for some of the points
    int hasty_missed = 0; //!< of these, points that it puts farther away than the nearest one by 1e-9 of the diagonal
    double excess = -infinity; //!< ours beyond OpenCASCADE's best, part of the diagonal
    double gain = -infinity;   //!< the other way round
    bool refused = false;

    [[nodiscard]] double ratio() const { return occt.wall_s / ours.wall_s; }
    [[nodiscard]] double ratio_one_core() const { return occt.thread_s / ours_one_core.thread_s; }
};

//! As GeomAPI_ProjectPointOnSurf does it by default: minima and maxima by Newton's steps from a grid.
constexpr std::pair<Extrema_ExtFlag, Extrema_ExtAlgo> careful{Extrema_ExtFlag_MINMAX, Extrema_ExtAlgo_Grad};
//! Minima only, with a tree of boxes: several times as fast on splines, but it misses the nearest point of some.
constexpr std::pair<Extrema_ExtFlag, Extrema_ExtAlgo> hasty{Extrema_ExtFlag_MIN, Extrema_ExtAlgo_Tree};

std::vector<double> occt_distances(const Domain &d, const std::vector<gp_Pnt> &points,
                                   const std::pair<Extrema_ExtFlag, Extrema_ExtAlgo> &how)
{
    const GeomAdaptor_Surface adaptor(d.surface, d.u0, d.u1, d.v0, d.v1);
    Extrema_ExtPS extrema;
    extrema.SetFlag(how.first);
    extrema.SetAlgo(how.second);
    extrema.Initialize(adaptor, d.u0, d.u1, d.v0, d.v1, Precision::PConfusion(), Precision::PConfusion());
    std::vector<double> distances(points.size(), infinity);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        extrema.Perform(points[i]);
        for (int k = 1; extrema.IsDone() && k <= extrema.NbExt(); ++k)
            distances[i] = std::min(distances[i], std::sqrt(extrema.SquareDistance(k)));
    }
    return distances;
}

Row compare_face(const BaseFace &base, int count)
{
    using namespace laminate_offset;
    const TopoDS_Face face = TopoDS::Face(base.face.Located(TopLoc_Location()));
    const Domain d = domain_of(face);
    const std::vector<gp_Pnt> points = random_points(d, count);
    Row row;
    Result<std::vector<NearestPoint>> ours = nearest_points(face, points); // threads start, and memory is taken
    row.ours = time_of([&] { ours = nearest_points(face, points); });
    if (!ours)
    {
        row.refused = true;
        return row;
    }
    tbb::task_arena(1).execute([&] { row.ours_one_core = time_of([&] { ours = nearest_points(face, points); }); });
    std::vector<double> theirs;
    std::vector<double> by_haste;
    row.occt = time_of([&] { theirs = occt_distances(d, points, careful); });
    const std::size_t stride = (points.size() + most_hasty_points - 1) / most_hasty_points;
    std::vector<gp_Pnt> some;
    for (std::size_t i = 0; i < points.size(); i += stride)
        some.push_back(points[i]);
    row.hasty_points = static_cast<int>(some.size());
    row.hasty = time_of([&] { by_haste = occt_distances(d, some, hasty); });
    Border border(d);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const double in_haste = i % stride == 0 ? by_haste[i / stride] : theirs[i];
        const double best = std::min({theirs[i], in_haste, border.distance(points[i])});
        row.hasty_missed += in_haste > best + too_far * base.diagonal && i % stride == 0 ? 1 : 0;
        row.excess = std::max(row.excess, (ours.value()[i].distance - best) / base.diagonal);
        row.gain = std::max(row.gain, (best - ours.value()[i].distance) / base.diagonal);
    }
    return row;
}

//! The finished faces of a run, in a file that is whole after every line.
class Table
{
public:
    Table(std::filesystem::path file, int count) : m_file(std::move(file)), m_count(count)
    {
        std::ifstream in(m_file);
        for (std::string line; std::getline(in, line);)
            if (!in.eof()) // a line without an end was being written when the run ended
                read(line);
        in.close();
        std::filesystem::path fresh = m_file;
        fresh += ".new";
        std::ofstream out(fresh);
        out << "face,points,refused,all_cores_s,all_cores_thread_s,one_core_s,one_core_thread_s,occt_s,occt_thread_s,"
               "hasty_points,hasty_s,hasty_thread_s,hasty_missed,excess,gain\n";
        for (const auto &[name, row] : m_rows)
            write(out, name, row);
        out.close();
        std::filesystem::rename(fresh, m_file);
    }

    [[nodiscard]] const Row *find(const std::string &name) const
    {
        const auto found = m_rows.find(name);
        return found == m_rows.end() ? nullptr : &found->second;
    }

    void add(const std::string &name, const Row &row)
    {
        std::ofstream out(m_file, std::ios::app);
        write(out, name, row);
        m_rows[name] = row;
    }

private:
    void read(std::string line)
    {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream fields(line);
        std::string name;
        Row row;
        int points = 0;
        std::string excess, gain; // "-inf" where there is none, which streams do not read as a number
        fields >> name >> points >> row.refused >> row.ours.wall_s >> row.ours.thread_s >> row.ours_one_core.wall_s >>
            row.ours_one_core.thread_s >> row.occt.wall_s >> row.occt.thread_s >> row.hasty_points >>
            row.hasty.wall_s >> row.hasty.thread_s >> row.hasty_missed >> excess >> gain;
        if (!fields || points != m_count)
            return;
        row.excess = std::strtod(excess.c_str(), nullptr);
        row.gain = std::strtod(gain.c_str(), nullptr);
        m_rows[name] = row;
    }

    void write(std::ostream &out, const std::string &name, const Row &row) const
    {
        out << fmt::format("{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{},{:.6g},{:.6g},{},{:.6g},{:.6g}\n",
                           name, m_count, row.refused ? 1 : 0, row.ours.wall_s, row.ours.thread_s,
                           row.ours_one_core.wall_s, row.ours_one_core.thread_s, row.occt.wall_s, row.occt.thread_s,
                           row.hasty_points, row.hasty.wall_s, row.hasty.thread_s, row.hasty_missed, row.excess,
                           row.gain)
            << std::flush;
    }

    std::filesystem::path m_file;
    int m_count;
    std::map<std::string, Row> m_rows;
};

struct Totals
{
    Row sum;
    int slow = 0, slow_one_core = 0, far = 0, refused = 0;
    double least_ratio = infinity;

    void add(const Row &row, int count)
    {
        if (row.refused)
        {
            ++refused;
            return;
        }
        for (const auto part : {&Row::ours, &Row::ours_one_core, &Row::occt})
        {
            (sum.*part).wall_s += (row.*part).wall_s;
            (sum.*part).thread_s += (row.*part).thread_s;
        }
        sum.hasty.thread_s += row.hasty.thread_s * count / row.hasty_points; // as if it were all points
        sum.excess = std::max(sum.excess, row.excess);
        least_ratio = std::min(least_ratio, row.ratio());
        slow += row.ratio() < 10.0 ? 1 : 0;
        slow_one_core += row.ratio_one_core() < 10.0 ? 1 : 0;
        far += row.excess > too_far ? 1 : 0;
    }
};

void print(const std::string &name, const Row &row, int count, std::ostream &out)
{
    if (row.refused)
        out << fmt::format("{:<55} refused\n", name) << std::flush;
    else
        out << fmt::format("{:<55} {:9.0f} {:9.0f} {:9.0f} {:9.0f}  ratio {:6.1f} ({:5.1f} on one core)  missed {:5} "
                           " excess {:9.2e}  gain {:8.2e}{}\n",
                           name, count / row.ours.wall_s, count / row.ours_one_core.thread_s, count / row.occt.thread_s,
                           row.hasty_points / row.hasty.thread_s, row.ratio(), row.ratio_one_core(), row.hasty_missed,
                           row.excess, row.gain, row.excess > too_far ? "  TOO FAR" : "")
            << std::flush;
}

} // namespace

void run_nearest(std::vector<BaseFace> faces, int count, const std::optional<std::filesystem::path> &table,
                 std::ostream &out)
{
    std::stable_sort(faces.begin(), faces.end(),
                     [](const BaseFace &a, const BaseFace &b) { return a.poles < b.poles; });
    std::optional<Table> kept;
    if (table)
        kept.emplace(*table, count);
    Totals totals;
    out << fmt::format(
        "nearest points, {} a face; points a second: all cores, one core, OpenCASCADE (one core); the last two "
        "by processor time\n",
        count);
    for (const BaseFace &base : faces)
    {
        const Row *known = kept ? kept->find(base.name) : nullptr;
        const Row row = known ? *known : compare_face(base, count);
        if (kept && !known)
            kept->add(base.name, row);
        print(base.name, row, count, out);
        totals.add(row, count);
    }
    out << fmt::format(
        "{} faces, {} refused, {} too far, {} below 10 times the speed ({} on one core); worst excess {:.2e} of the "
        "diagonal; ratio {:.1f} in all ({:.1f} on one core, {:.1f} to OpenCASCADE in haste), {:.1f} at least\n",
        faces.size(), totals.refused, totals.far, totals.slow, totals.slow_one_core, totals.sum.excess,
        totals.sum.ratio(), totals.sum.ratio_one_core(), totals.sum.hasty.thread_s / totals.sum.ours_one_core.thread_s,
        totals.least_ratio);
}

} // namespace benchmark
