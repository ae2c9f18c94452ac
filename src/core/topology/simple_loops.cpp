// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simple_loops.h"

#include "../spline/control_points.h"

#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace laminate_offset
{
namespace
{

// Halvings of a piece, and comparisons of one face, before the question is left open.
constexpr int deepest = 24;
constexpr int most_comparisons = 20000;
// A loop of fewer pieces has two that meet at both their ends.
constexpr std::size_t least_pieces = 3;
constexpr int area_rounds = 6;
// A step of the surface's parameters counts this much more than its speed at the place says: steps along both parameters
// may add up, by sqrt(2), and speeds change beside the place, but on a plane.
constexpr double cautious_speed = 2.0;
constexpr double plane_speed = 1.42;
// Of control points that were cut some dozen times, as a part of the largest coordinate.
constexpr double rounding = 1e-12;

using Points = std::vector<Eigen::Vector2d>;

//! A Bezier piece of a pcurve, along its loop.
struct Arc
{
    ControlPoints weighted;
    Points points; //!< the same without weights
    Eigen::AlignedBox2d box;

    explicit Arc(ControlPoints controls) : weighted(std::move(controls))
    {
        points.reserve(weighted.size());
        for (const Eigen::Vector3d &p : weighted)
        {
            points.emplace_back(p.head<2>() / p.z());
            box.extend(points.back());
        }
    }

    [[nodiscard]] const Eigen::Vector2d &start() const { return points.front(); }
    [[nodiscard]] const Eigen::Vector2d &end() const { return points.back(); }

    [[nodiscard]] std::pair<Arc, Arc> halves() const
    {
        ControlPoints rest = weighted;
        Arc before(cut_off(rest, 0.5));
        return {std::move(before), Arc(std::move(rest))};
    }

    //! Does it always move on in the direction of its chord? Its tangents are positive combinations of the steps.
    [[nodiscard]] bool runs_on() const
    {
        const Eigen::Vector2d chord = end() - start();
        for (std::size_t k = 0; k + 1 < points.size(); ++k)
            if (!((points[k + 1] - points[k]).dot(chord) > 0.0))
                return false;
        return true;
    }
};

//! Is there a gap wider than `least` between two hulls, along a direction of length 1?
bool apart_along(const Arc &a, const Arc &b, const Eigen::Vector2d &direction, double least)
{
    const auto range = [&](const Points &points) {
        std::pair<double, double> ends{std::numeric_limits<double>::infinity(),
                                       -std::numeric_limits<double>::infinity()};
        for (const Eigen::Vector2d &p : points)
        {
            ends.first = std::min(ends.first, p.dot(direction));
            ends.second = std::max(ends.second, p.dot(direction));
        }
        return ends;
    };
    const auto of_a = range(a.points);
    const auto of_b = range(b.points);
    return of_a.second + least < of_b.first || of_b.second + least < of_a.first;
}

bool hulls_apart(const Arc &a, const Arc &b, double least)
{
    if ((a.box.min().array() > b.box.max().array() + least).any() ||
        (b.box.min().array() > a.box.max().array() + least).any())
        return true;
    const auto across = [](const Arc &arc) -> Eigen::Vector2d {
        const Eigen::Vector2d chord = arc.end() - arc.start();
        return Eigen::Vector2d(-chord.y(), chord.x()).normalized();
    };
    return apart_along(a, b, across(a), least) || apart_along(a, b, across(b), least);
}

//! The directions in which the other control points are seen from one end.
Points seen_from(const Eigen::Vector2d &end, const Points &points)
{
    Points directions;
    directions.reserve(points.size());
    for (const Eigen::Vector2d &p : points)
        if (const double distance = (p - end).norm(); distance > 0.0)
            directions.emplace_back((p - end) / distance);
    return directions;
}

//! One trimming loop in scaled parameters, with the gap that is admissible before each arc.
struct Loop
{
    std::vector<Arc> arcs;
    std::vector<double> gaps;

    void reserve(std::size_t count)
    {
        arcs.reserve(count);
        gaps.reserve(count);
    }
};

class LoopProver
{
public:
    explicit LoopProver(std::vector<Loop> loops) : m_loops(std::move(loops))
    {
        for (const Loop &loop : m_loops)
            for (const Arc &arc : loop.arcs)
                m_least_gap =
                    std::max({m_least_gap, arc.box.min().cwiseAbs().maxCoeff(), arc.box.max().cwiseAbs().maxCoeff()});
        m_least_gap *= rounding;
    }

    bool prove()
    {
        for (Loop &loop : m_loops)
            if (!cut_to_run_on(loop) || !meets_itself_at_joints_only(loop))
                return false;
        for (std::size_t i = 0; i < m_loops.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                for (const Arc &a : m_loops[i].arcs)
                    for (const Arc &b : m_loops[j].arcs)
                        if (!separate(a, b, 0))
                            return false;
        return nested();
    }

private:
    //! Halves arcs until each runs on along its chord.
    static bool cut_to_run_on(Loop &loop)
    {
        Loop cut;
        cut.reserve(loop.arcs.size());
        const int least_depth = loop.arcs.size() < least_pieces ? 2 : 0;
        for (std::size_t i = 0; i < loop.arcs.size(); ++i)
            if (!add_running(std::move(loop.arcs[i]), loop.gaps[i], least_depth, 0, cut))
                return false;
        loop = std::move(cut);
        return true;
    }

    static bool add_running(Arc arc, double gap, int least_depth, int depth, Loop &cut)
    {
        if (depth > deepest)
            return false;
        if (depth >= least_depth && arc.runs_on())
        {
            cut.arcs.push_back(std::move(arc));
            cut.gaps.push_back(gap);
            return true;
        }
        auto [before, after] = arc.halves();
        return add_running(std::move(before), gap, least_depth, depth + 1, cut) &&
               add_running(std::move(after), 0.0, least_depth, depth + 1, cut);
    }

    bool meets_itself_at_joints_only(const Loop &loop)
    {
        const std::size_t n = loop.arcs.size();
        for (std::size_t i = 0; i < n; ++i)
        {
            const std::size_t next = (i + 1) % n;
            if (!meet_at_joint(loop.arcs[i], loop.arcs[next], loop.gaps[next], 0))
                return false;
            for (std::size_t j = 0; j < i; ++j)
                if (j + 1 != i && (i + 1) % n != j && !separate(loop.arcs[i], loop.arcs[j], 0))
                    return false;
        }
        return true;
    }

    //! Two arcs that have nothing in common.
    bool separate(const Arc &a, const Arc &b, int depth)
    {
        if (hulls_apart(a, b, m_least_gap))
            return true;
        if (depth > deepest || ++m_comparisons > most_comparisons)
            return false;
        const bool halve_a = a.box.sizes().maxCoeff() > b.box.sizes().maxCoeff();
        const auto [before, after] = (halve_a ? a : b).halves();
        const Arc &whole = halve_a ? b : a;
        return separate(before, whole, depth + 1) && separate(after, whole, depth + 1);
    }

    //! Arc b goes on where arc a ends, and they have nothing in common but what lies as near to the joint as its gap.
    bool meet_at_joint(const Arc &a, const Arc &b, double gap, int depth)
    {
        if (parted_by_line(a, b, gap))
            return true;
        if (depth > deepest || ++m_comparisons > most_comparisons)
            return false;
        const auto [a1, a2] = a.halves();
        const auto [b1, b2] = b.halves();
        return meet_at_joint(a2, b1, gap, depth + 1) && separate(a1, b1, 0) && separate(a1, b2, 0) &&
               separate(a2, b2, 0);
    }

    //! Both hulls lie on different sides of a line through the joint, at an angle of sine s or more to it: where
    //! they stand apart by delta at the joint, they can only meet within delta / s of it.
    static bool parted_by_line(const Arc &a, const Arc &b, double gap)
    {
        const Points back = seen_from(a.end(), a.points);
        const Points on = seen_from(b.start(), b.points);
        Eigen::Vector2d direction = Eigen::Vector2d::Zero();
        for (const Eigen::Vector2d &d : back)
            direction -= d / static_cast<double>(back.size());
        for (const Eigen::Vector2d &d : on)
            direction += d / static_cast<double>(on.size());
        if (!(direction.norm() > 0.0))
            return false;
        direction.normalize();
        double sine = 1.0;
        for (const Eigen::Vector2d &d : back)
            sine = std::min(sine, -d.dot(direction));
        for (const Eigen::Vector2d &d : on)
            sine = std::min(sine, d.dot(direction));
        constexpr double least_sine = 1e-9; // well above rounding
        return sine > least_sine && (b.start() - a.end()).norm() <= gap * sine;
    }

    //! One loop anticlockwise, all others clockwise, inside it and beside each other.
    bool nested()
    {
        std::size_t outer = m_loops.size();
        for (std::size_t i = 0; i < m_loops.size(); ++i)
        {
            const std::optional<double> area = signed_area(m_loops[i].arcs);
            if (!area || (*area > 0.0 && outer < m_loops.size()))
                return false;
            if (*area > 0.0)
                outer = i;
        }
        if (outer == m_loops.size())
            return false;
        for (std::size_t i = 0; i < m_loops.size(); ++i)
            for (std::size_t j = 0; j < m_loops.size(); ++j)
                if (i != j && i != outer && inside(m_loops[j], m_loops[i].arcs.front().start()) != (j == outer))
                    return false;
        return true;
    }

    //! The area by the chords, once it outweighs all that may lie between arcs and chords.
    static std::optional<double> signed_area(std::vector<Arc> arcs)
    {
        for (int round = 0; round < area_rounds; ++round)
        {
            double area = 0.0;
            double doubt = 0.0;
            const Eigen::Vector2d origin = arcs.front().start();
            for (const Arc &arc : arcs)
            {
                const Eigen::Vector2d a = arc.start() - origin;
                const Eigen::Vector2d b = arc.end() - origin;
                area += 0.5 * (a.x() * b.y() - a.y() * b.x());
                doubt += arc.points.size() > 2 ? arc.box.volume() : 0.0;
            }
            if (std::abs(area) > doubt)
                return area;
            std::vector<Arc> finer;
            finer.reserve(2 * arcs.size());
            for (const Arc &arc : arcs)
            {
                auto [before, after] = arc.halves();
                finer.push_back(std::move(before));
                finer.push_back(std::move(after));
            }
            arcs = std::move(finer);
        }
        return std::nullopt;
    }

    //! Does a ray from the point to the right cross the loop an odd number of times? Nothing where that stays open.
    static std::optional<bool> inside(const Loop &loop, const Eigen::Vector2d &point)
    {
        bool odd = false;
        double from = loop.arcs.back().end().y();
        for (const Arc &arc : loop.arcs)
        {
            const std::optional<bool> crossed = crosses(arc, from, point, 0);
            if (!crossed)
                return std::nullopt;
            odd = odd != *crossed;
            from = arc.end().y();
        }
        return odd;
    }

    //! \param from height of the arc before at its end, so that no ray slips through a gap.
    static std::optional<bool> crosses(const Arc &arc, double from, const Eigen::Vector2d &point, int depth)
    {
        const bool changes_side = (from > point.y()) != (arc.end().y() > point.y());
        if (arc.box.min().y() > point.y() || arc.box.max().y() < point.y() || arc.box.min().x() > point.x())
            return changes_side;
        if (arc.box.max().x() < point.x())
            return false;
        if (depth > deepest)
            return std::nullopt;
        const auto [before, after] = arc.halves();
        const std::optional<bool> first = crosses(before, from, point, depth + 1);
        const std::optional<bool> second = crosses(after, before.end().y(), point, depth + 1);
        return first && second ? std::optional<bool>(*first != *second) : std::nullopt;
    }

    std::vector<Loop> m_loops;
    double m_least_gap = 0.0;
    int m_comparisons = 0;
};

//! Reads the loops of a face, in parameters scaled to its size in space.
class LoopReader
{
public:
    explicit LoopReader(const TopoDS_Face &face)
        : m_face(TopoDS::Face(face.Located(TopLoc_Location()).Oriented(TopAbs_FORWARD))),
          m_surface(BRep_Tool::Surface(m_face)), m_caution(is_affine(m_surface) ? plane_speed : cautious_speed)
    {
    }

    std::optional<std::vector<Loop>> read()
    {
        std::vector<std::vector<PlainEdge>> wires;
        for (TopoDS_Iterator it(m_face); it.More(); it.Next())
        {
            if (it.Value().ShapeType() != TopAbs_WIRE || !read_wire(it.Value(), wires.emplace_back()))
                return std::nullopt;
        }
        for (int direction = 0; direction < 2; ++direction)
            if (!(m_speeds[direction] > 0.0))
                return std::nullopt;
        const Eigen::Vector2d scale = m_speeds / m_edge_count;
        std::vector<Loop> loops;
        for (std::vector<PlainEdge> &wire : wires)
        {
            chain(wire, scale);
            if (!closed(wire))
                return std::nullopt;
            loops.push_back(scaled(wire, scale));
        }
        return loops;
    }

private:
    //! An edge along its loop, in the surface's parameters.
    struct PlainEdge
    {
        std::vector<ControlPoints> pieces;
        Eigen::Vector2d start;
        Eigen::Vector2d end;
        TopoDS_Vertex first;
        TopoDS_Vertex last;
        Eigen::Vector2d speed; //!< of the surface at the start
    };

    //! Is the surface an affine map of its parameters, up to rounding?
    static bool is_affine(const Handle(Geom_Surface) & surface)
    {
        if (!Handle(Geom_Plane)::DownCast(surface).IsNull())
            return true;
        const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface);
        if (spline.IsNull() || spline->NbUPoles() != 2 || spline->NbVPoles() != 2 || spline->IsURational() ||
            spline->IsVRational())
            return false;
        const gp_XYZ a = spline->Pole(2, 1).XYZ() - spline->Pole(1, 1).XYZ();
        const gp_XYZ b = spline->Pole(1, 2).XYZ() - spline->Pole(1, 1).XYZ();
        const gp_XYZ twist = spline->Pole(2, 2).XYZ() - spline->Pole(1, 1).XYZ() - a - b;
        constexpr double least_twist = 1e-4; // of a side: far less than plane_speed leaves
        return twist.Modulus() <= least_twist * std::min(a.Modulus(), b.Modulus());
    }

    bool read_wire(const TopoDS_Shape &wire, std::vector<PlainEdge> &edges)
    {
        for (TopoDS_Iterator it(wire); it.More(); it.Next())
        {
            std::optional<PlainEdge> edge = read_edge(TopoDS::Edge(it.Value()));
            if (!edge)
                return false;
            m_speeds += edge->speed;
            ++m_edge_count;
            edges.push_back(std::move(*edge));
        }
        return !edges.empty();
    }

    std::optional<PlainEdge> read_edge(const TopoDS_Edge &edge) const
    {
        const bool reversed = edge.Orientation() == TopAbs_REVERSED;
        if (!reversed && edge.Orientation() != TopAbs_FORWARD)
            return std::nullopt;
        double first, last;
        const Handle(Geom2d_Curve) pcurve = BRep_Tool::CurveOnSurface(edge, m_face, first, last);
        PlainEdge result;
        result.first = TopExp::FirstVertex(edge, true);
        result.last = TopExp::LastVertex(edge, true);
        if (pcurve.IsNull() || result.first.IsNull() || result.last.IsNull())
            return std::nullopt;
        result.pieces = bezier_pieces(pcurve, first, last);
        if (result.pieces.empty() || !positive_weights(result.pieces))
            return std::nullopt;
        if (reversed)
        {
            std::reverse(result.pieces.begin(), result.pieces.end());
            for (ControlPoints &piece : result.pieces)
                std::reverse(piece.begin(), piece.end());
        }
        result.start = result.pieces.front().front().hnormalized();
        result.end = result.pieces.back().back().hnormalized();
        gp_Pnt point;
        gp_Vec along_u, along_v;
        m_surface->D1(result.start.x(), result.start.y(), point, along_u, along_v);
        result.speed = {along_u.Magnitude(), along_v.Magnitude()};
        return result;
    }

    //! Puts every edge behind the one that it goes on from.
    static void chain(std::vector<PlainEdge> &edges, const Eigen::Vector2d &scale)
    {
        for (std::size_t i = 0; i + 1 < edges.size(); ++i)
        {
            const Eigen::Vector2d end = edges[i].end;
            const auto gap = [&](const PlainEdge &edge) {
                return (edge.start - end).cwiseProduct(scale).squaredNorm();
            };
            const auto next = edges.begin() + static_cast<std::ptrdiff_t>(i) + 1;
            std::iter_swap(next, std::min_element(next, edges.end(), [&](const PlainEdge &a, const PlainEdge &b) {
                               return gap(a) < gap(b);
                           }));
        }
    }

    //! Does every edge start from the vertex at which the one before it ends?
    static bool closed(const std::vector<PlainEdge> &edges)
    {
        for (std::size_t i = 0; i < edges.size(); ++i)
            if (!edges[i].last.IsSame(edges[(i + 1) % edges.size()].first))
                return false;
        return true;
    }

    [[nodiscard]] Loop scaled(const std::vector<PlainEdge> &edges, const Eigen::Vector2d &scale) const
    {
        Loop loop;
        std::size_t count = 0;
        for (const PlainEdge &edge : edges)
            count += edge.pieces.size();
        loop.reserve(count);
        for (const PlainEdge &edge : edges)
        {
            const double stretch = m_caution * edge.speed.cwiseQuotient(scale).maxCoeff();
            double gap = stretch > 0.0 ? BRep_Tool::Tolerance(edge.first) / stretch : 0.0;
            for (ControlPoints piece : edge.pieces)
            {
                for (Eigen::Vector3d &p : piece)
                    p.head<2>().array() *= scale.array();
                loop.gaps.push_back(gap);
                loop.arcs.emplace_back(std::move(piece));
                gap = 0.0;
            }
        }
        return loop;
    }

    const TopoDS_Face m_face;
    const Handle(Geom_Surface) m_surface;
    const double m_caution;
    Eigen::Vector2d m_speeds = Eigen::Vector2d::Zero(); //!< sum over all edges
    int m_edge_count = 0;
};

} // namespace

bool loops_proven_simple(const TopoDS_Face &face)
{
    std::optional<std::vector<Loop>> loops = LoopReader(face).read();
    return loops && !loops->empty() && LoopProver(std::move(*loops)).prove();
}

} // namespace laminate_offset
