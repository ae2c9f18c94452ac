// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boundary_inset.h"

#include "geodesic_walker.h"
#include "path_fit.h"
#include "path_part.h"

#include "../projection/image_wire.h"

#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace laminate_offset
{
namespace
{

// No place of a moved curve may be nearer to the boundary than that, as a part of the shortest move of one of its own
// places: distances are measured in space, to chords.
constexpr double nearest_share = 0.97;

using Vector2 = Eigen::Vector2d;

Failure refusal(const InputFace &input, Status status, const Vector2 &uv, std::string message)
{
    return {status, Stage::Trimming, std::move(message), input.place({uv.x(), uv.y()}), std::nullopt};
}

//! An edge's pcurve in its wire's direction, over [0, 1].
struct EdgePath
{
    Handle(Geom2d_Curve) pcurve;
    double start = 0.0;
    double end = 1.0;

    [[nodiscard]] Vector2 operator()(double t) const
    {
        const gp_Pnt2d p = pcurve->Value(start + t * (end - start));
        return {p.X(), p.Y()};
    }
    [[nodiscard]] Vector2 slope(double t) const
    {
        gp_Pnt2d p;
        gp_Vec2d d;
        pcurve->D1(start + t * (end - start), p, d);
        return Vector2(d.X(), d.Y()) * (end - start);
    }
};

//! One wire of the boundary.
class WireInset
{
public:
    WireInset(const InputFace &input, const GeodesicWalker &walker, const TopoDS_Shape &wire, bool to_left,
              double distance, double tolerance)
        : m_input(input), m_walker(walker), m_sign(to_left ? 1.0 : -1.0), m_distance(distance), m_tolerance(tolerance)
    {
        for (TopoDS_Iterator it(wire); it.More(); it.Next())
            m_edges.push_back(path_of(TopoDS::Edge(it.Value())));
        const Eigen::Vector3d start = walker.point(m_edges.front()(0.0)), end = walker.point(m_edges.back()(1.0));
        m_closed = (start - end).norm() <= 10.0 * tolerance;
    }

    Result<std::vector<ImagePart>> parts(double &error)
    {
        if (const std::optional<Failure> folded = find_folded())
            return *folded;
        if (const std::optional<Failure> open = join_what_is_left())
            return *open;
        if (const std::optional<Failure> lost = vanished())
            return *lost;
        if (!m_closed)
            reach_borders();
        if (const std::optional<Failure> crossed = crossing())
            return *crossed;
        std::vector<ImagePart> result;
        for (const PathPart &part : m_parts)
        {
            const std::optional<ImagePiece> piece = fitted_piece(m_walker, part, m_tolerance);
            if (!piece)
                return refusal(m_input, Status::EdgeToleranceNotReached, part.at(0.5),
                               "The curve moved inwards could not be fitted; loosen the tolerance or smooth the "
                               "boundary.");
            error = std::max(error, piece->distance);
            result.push_back({*piece, false, {}, false});
        }
        return result;
    }

private:
    [[nodiscard]] EdgePath path_of(const TopoDS_Edge &edge) const
    {
        double first = 0.0;
        double last = 0.0;
        const Handle(Geom2d_Curve) pcurve = BRep_Tool::CurveOnSurface(edge, m_input.face, first, last);
        if (edge.Orientation() == TopAbs_REVERSED)
            std::swap(first, last);
        return {pcurve, first, last};
    }

    //! Along the curve, of length 1.
    [[nodiscard]] Eigen::Vector3d tangent(const EdgePath &edge, double t, Eigen::Vector3d &normal) const
    {
        return m_walker.in_space(edge(t), edge.slope(t), normal).normalized();
    }

    //! The end of the geodesic to the side, turned by an angle towards the curve's direction.
    [[nodiscard]] Vector2 moved(const EdgePath &edge, double t, double angle) const
    {
        Eigen::Vector3d normal;
        const Eigen::Vector3d along = tangent(edge, t, normal);
        const Eigen::Vector3d side = m_sign * normal.cross(along);
        return m_walker.geodesic(edge(t), std::cos(angle) * side + std::sin(angle) * along, m_distance);
    }

    //! Moved past its radius of curvature a curve runs backwards. One that does so all along, such as a fillet, is left
    //! out; one that does so in part is refused.
    [[nodiscard]] std::optional<Failure> find_folded()
    {
        m_left_out.assign(m_edges.size(), false);
        for (std::size_t k = 0; k < m_edges.size(); ++k)
        {
            int backwards = 0;
            Vector2 where = m_edges[k](0.5);
            for (int i = 0; i < polygon_points; ++i)
            {
                const double t = static_cast<double>(i) / polygon_points, next = t + 1.0 / polygon_points;
                const Eigen::Vector3d own = m_walker.point(m_edges[k](next)) - m_walker.point(m_edges[k](t));
                const Eigen::Vector3d step =
                    m_walker.point(moved(m_edges[k], next, 0.0)) - m_walker.point(moved(m_edges[k], t, 0.0));
                if (own.dot(step) > 0.0)
                    continue;
                ++backwards;
                where = m_edges[k](t);
            }
            if (backwards > 0 && backwards < polygon_points)
                return bends_too_sharply(where);
            m_left_out[k] = backwards > 0;
        }
        return std::nullopt;
    }

    [[nodiscard]] Failure bends_too_sharply(const Vector2 &where) const
    {
        return refusal(m_input, Status::NotSupported, where,
                       fmt::format("It cannot be moved inwards by {:.4g} mm, since it bends more sharply there; take a "
                                   "smaller distance.",
                                   m_distance));
    }

    //! Cuts and bridges the moved curves. One of which nothing is left between its neighbours, such as a chamfer, is left
    //! out, and its neighbours are cut where they meet.
    [[nodiscard]] std::optional<Failure> join_what_is_left()
    {
        for (;;)
        {
            m_parts.clear();
            m_sources.clear();
            for (std::size_t k = 0; k < m_edges.size(); ++k)
                if (!m_left_out[k])
                {
                    m_parts.push_back({[this, edge = m_edges[k]](double t) { return moved(edge, t, 0.0); }});
                    m_sources.push_back(k);
                }
            if (m_parts.empty() || (!m_closed && m_left_out.front()))
                return bends_too_sharply(m_edges.front()(0.5));
            if (!m_closed && m_left_out.back())
                return bends_too_sharply(m_edges.back()(0.5));
            const auto left_out = std::count(m_left_out.begin(), m_left_out.end(), true);
            std::vector<PathPart> joined;
            if (const std::optional<Failure> open = join(joined))
                return open;
            for (std::size_t k = 0; k < m_parts.size(); ++k)
                if (m_parts[k].last <= m_parts[k].first)
                    m_left_out[m_sources[k]] = true;
            if (std::count(m_left_out.begin(), m_left_out.end(), true) > left_out)
                continue;
            m_parts = std::move(joined);
            return std::nullopt;
        }
    }

    //! Does the boundary turn towards the side to which it is moved where one edge ends and the next begins?
    [[nodiscard]] bool turns_inwards(std::size_t before, std::size_t after) const
    {
        return m_sign * corner_angle(before, after) > 0.0;
    }

    //! From the one's direction at its end to the other's at its start, to the left.
    [[nodiscard]] double corner_angle(std::size_t before, std::size_t after) const
    {
        Eigen::Vector3d normal;
        const Eigen::Vector3d from = tangent(m_edges[before], 1.0, normal);
        const Eigen::Vector3d to = tangent(m_edges[after], 0.0, normal);
        return std::atan2(from.cross(to).dot(normal), from.dot(to));
    }

    [[nodiscard]] double length_of(const EdgePath &edge) const
    {
        double length = 0.0;
        for (int i = 0; i < polygon_points; ++i)
            length += (m_walker.point(edge((i + 1.0) / polygon_points)) -
                       m_walker.point(edge(static_cast<double>(i) / polygon_points)))
                          .norm();
        return length;
    }

    //! The least distance in space between a place of the boundary and where it is moved [mm].
    [[nodiscard]] double shortest_move() const
    {
        double shortest = m_distance;
        for (const EdgePath &edge : m_edges)
            for (int i = 0; i <= polygon_points; ++i)
            {
                const double t = static_cast<double>(i) / polygon_points;
                shortest = std::min(shortest, (m_walker.point(moved(edge, t, 0.0)) - m_walker.point(edge(t))).norm());
            }
        return shortest;
    }

    //! Moved too far, a closed wire turns inside out, and parts of any wire come too near to where it was.
    [[nodiscard]] std::optional<Failure> vanished() const
    {
        std::vector<PathPart> edges;
        for (const EdgePath &edge : m_edges)
            edges.push_back({edge});
        const std::vector<Vector2> own = traced(edges);
        const std::vector<Vector2> moved = traced(m_parts);
        bool lost = m_closed && !(turning(own) * turning(moved) > 0.0);
        const double nearest = nearest_share * shortest_move();
        std::vector<Eigen::Vector3d> places;
        for (const Vector2 &uv : own)
            places.push_back(m_walker.point(uv));
        for (std::size_t i = 0; i < moved.size() && !lost; ++i)
            for (std::size_t k = 0; k + 1 < places.size() && !lost; ++k)
                lost = distance(m_walker.point(moved[i]), places[k], places[k + 1]) < nearest;
        if (!lost)
            return std::nullopt;
        return refusal(m_input, Status::NotSupported, own.front(),
                       fmt::format("Moved by {:.4g} mm it turns inside out, or nothing is left of it; take a smaller "
                                   "distance.",
                                   m_distance));
    }

    //! Twice the area to the left.
    static double turning(const std::vector<Vector2> &points)
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const Vector2 a = points[i] - points[0], b = points[(i + 1) % points.size()] - points[0];
            sum += a.x() * b.y() - a.y() * b.x();
        }
        return sum;
    }

    //! Of a point from a segment.
    static double distance(const Eigen::Vector3d &point, const Eigen::Vector3d &a, const Eigen::Vector3d &b)
    {
        const Eigen::Vector3d along = b - a;
        const double length = along.squaredNorm();
        const double t = length > 0.0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0.0;
        return (point - a - t * along).norm();
    }

    //! Cuts or bridges the moved curves at corners. Where they would have to be cut but do not meet, the shorter one is marked
    //! to be left out.
    //! \param joined becomes the curves with the bridges between them.
    [[nodiscard]] std::optional<Failure> join(std::vector<PathPart> &joined)
    {
        const std::size_t count = m_parts.size();
        std::vector<std::optional<PathPart>> bridges(count);
        for (std::size_t k = 0; k < count; ++k)
        {
            const std::size_t next = (k + 1) % count;
            if (next == 0 && !m_closed)
                continue;
            const Eigen::Vector3d gap = m_walker.point(m_parts[k].path(1.0)) - m_walker.point(m_parts[next].path(0.0));
            if (gap.norm() <= m_tolerance || cut_where_they_cross(m_parts[k], m_parts[next]))
                continue;
            const std::size_t after = (m_sources[k] + 1) % m_edges.size();
            if (after != m_sources[next])
                return bends_too_sharply(m_edges[after](0.5));
            if (turns_inwards(m_sources[k], after))
                m_left_out[length_of(m_edges[m_sources[k]]) < length_of(m_edges[after]) ? m_sources[k] : after] = true;
            else
                bridges[k] = bridge(m_sources[k], after);
        }
        for (std::size_t k = 0; k < count; ++k)
        {
            joined.push_back(m_parts[k]);
            if (bridges[k])
                joined.push_back(*bridges[k]);
        }
        return std::nullopt;
    }

    //! The ends of the geodesics from a corner, from one curve's direction to the other's.
    [[nodiscard]] PathPart bridge(std::size_t before, std::size_t after) const
    {
        // turning the curve's direction to the left turns its left side backwards
        const double sweep = -m_sign * corner_angle(before, after);
        return {[this, edge = m_edges[before], sweep](double t) { return moved(edge, 1.0, t * sweep); }};
    }

    [[nodiscard]] bool inside(const Vector2 &uv) const
    {
        const ParameterBox &box = m_input.box;
        return uv.x() >= box.umin && uv.x() <= box.umax && uv.y() >= box.vmin && uv.y() <= box.vmax;
    }

    //! Both ends of an open curve are led to the border of the face's parameter box: back to it, or on to it.
    void reach_borders()
    {
        for (const bool at_end : {true, false})
        {
            PathPart &part = at_end ? m_parts.back() : m_parts.front();
            const auto place = [part, at_end](double back) { return part.at(at_end ? 1.0 - back : back); };
            if (!inside(place(0.0)))
            {
                double out = 0.0, in = 1.0;
                for (int i = 1; i <= polygon_points && in == 1.0; ++i)
                    if (inside(place(static_cast<double>(i) / polygon_points)))
                        in = static_cast<double>(i) / polygon_points;
                    else
                        out = static_cast<double>(i) / polygon_points;
                for (int i = 0; i < 60; ++i)
                    (inside(place(0.5 * (in + out))) ? in : out) = 0.5 * (in + out);
                const double t = part.first + (at_end ? 1.0 - in : in) * (part.last - part.first);
                (at_end ? part.last : part.first) = t;
                continue;
            }
            go_on(part, at_end);
        }
    }

    //! A straight line in the parameters from the part's end to the border, where that is near.
    void go_on(const PathPart &part, bool at_end)
    {
        constexpr double step = 1e-4;
        const Vector2 end = part.at(at_end ? 1.0 : 0.0);
        const Vector2 heading = (end - part.at(at_end ? 1.0 - step : step)) / step;
        const ParameterBox &box = m_input.box;
        double reach = std::numeric_limits<double>::infinity();
        const auto limit = [&](double x, double slope, double low, double high) {
            if (slope != 0.0)
                reach = std::min(reach, ((slope > 0.0 ? high : low) - x) / slope);
        };
        limit(end.x(), heading.x(), box.umin, box.umax);
        limit(end.y(), heading.y(), box.vmin, box.vmax);
        const Vector2 border = end + reach * heading;
        const double length = (m_walker.point(border) - m_walker.point(end)).norm();
        if (!(length > m_tolerance && length <= 2.0 * m_distance))
            return;
        const Vector2 from = at_end ? end : border, to = at_end ? border : end;
        const PathPart line{[from, to](double t) -> Vector2 { return from + t * (to - from); }};
        m_parts.insert(at_end ? m_parts.end() : m_parts.begin(), line);
    }

    //! Does the whole wire cross itself?
    [[nodiscard]] std::optional<Failure> crossing() const
    {
        const std::optional<Vector2> where = own_crossing(m_parts, m_closed);
        if (!where)
            return std::nullopt;
        return refusal(
            m_input, Status::NotSupported, *where,
            fmt::format("Moved inwards by {:.4g} mm it crosses itself; take a smaller distance.", m_distance));
    }

    const InputFace &m_input;
    const GeodesicWalker &m_walker;
    double m_sign;
    double m_distance;
    double m_tolerance;
    bool m_closed = false;
    std::vector<EdgePath> m_edges;
    std::vector<bool> m_left_out; //!< of each edge: nothing of it is left when it is moved
    std::vector<PathPart> m_parts;
    std::vector<std::size_t> m_sources; //!< the edge of each part, before they are joined
};

} // namespace

Result<BoundaryInset> inset_boundary(const InputFace &input, const BoundaryImage &image, double distance,
                                     double tolerance)
{
    std::vector<TopoDS_Shape> wires;
    if (image.wires.ShapeType() == TopAbs_WIRE)
        wires.push_back(image.wires);
    else
        for (TopoDS_Iterator it(image.wires); it.More(); it.Next())
            wires.push_back(it.Value());
    const GeodesicWalker walker(input);
    std::vector<ImagePart> parts;
    BoundaryInset result;
    for (const TopoDS_Shape &wire : wires)
    {
        WireInset moved(input, walker, wire, image.keeps_left, distance, tolerance);
        Result<std::vector<ImagePart>> made = moved.parts(result.error);
        if (!made)
            return made.failure();
        parts.insert(parts.end(), made.value().begin(), made.value().end());
    }
    result.image = {image_wires(input, parts, tolerance).Located(TopLoc_Location()), image.keeps_left};
    return result;
}

} // namespace laminate_offset
