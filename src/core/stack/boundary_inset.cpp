// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boundary_inset.h"

#include "../projection/image_wire.h"
#include "../spline/geom_values.h"
#include "../spline/knot_choice.h"
#include "../spline/least_squares.h"

#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Geom2d_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace laminate_offset
{
namespace
{

constexpr int geodesic_steps = 12;
constexpr int degree = 3;
constexpr int samples_per_span = 5;
constexpr int checks_per_span = 3;
constexpr int most_spans = 256;
constexpr int polygon_points = 96; // of a curve, where crossings are looked for
// No place of a moved curve may be nearer to the boundary than that, as a part of the shortest move of one of its own
// places: distances are measured in space, to chords.
constexpr double nearest_share = 0.97;

using Vector2 = Eigen::Vector2d;

Failure refusal(const InputFace &input, Status status, const Vector2 &uv, std::string message)
{
    return {status, Stage::Trimming, std::move(message), input.place({uv.x(), uv.y()}), std::nullopt};
}

//! Moves about on the face's surface.
class Walker
{
public:
    explicit Walker(const InputFace &input) : m_surface(BRep_Tool::Surface(input.face)) {}

    [[nodiscard]] const Handle(Geom_Surface) & surface() const { return m_surface; }

    [[nodiscard]] Eigen::Vector3d point(const Vector2 &uv) const
    {
        return vector(m_surface->Value(uv.x(), uv.y()).XYZ());
    }

    //! The direction in space as a speed in the parameters.
    [[nodiscard]] Vector2 in_parameters(const Vector2 &uv, const Eigen::Vector3d &direction) const
    {
        const Jet jet = at(uv);
        return jet.solve({jet.u.dot(direction), jet.v.dot(direction)});
    }

    //! A speed in the parameters in space, and the unit normal.
    [[nodiscard]] Eigen::Vector3d in_space(const Vector2 &uv, const Vector2 &speed, Eigen::Vector3d &normal) const
    {
        const Jet jet = at(uv);
        normal = jet.u.cross(jet.v).normalized();
        return speed.x() * jet.u + speed.y() * jet.v;
    }

    //! The end of the geodesic that starts in a direction of length 1 (classical Runge-Kutta steps).
    [[nodiscard]] Vector2 geodesic(const Vector2 &from, const Eigen::Vector3d &direction, double length) const
    {
        Vector2 x = from;
        Vector2 v = in_parameters(from, direction);
        const double h = length / geodesic_steps;
        for (int i = 0; i < geodesic_steps; ++i)
        {
            const Vector2 a1 = bend(x, v);
            const Vector2 v2 = v + 0.5 * h * a1, a2 = bend(x + 0.5 * h * v, v2);
            const Vector2 v3 = v + 0.5 * h * a2, a3 = bend(x + 0.5 * h * v2, v3);
            const Vector2 v4 = v + h * a3, a4 = bend(x + h * v3, v4);
            x += h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
            v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
        }
        return x;
    }

private:
    struct Jet
    {
        Eigen::Vector3d u, v, uu, uv, vv;

        //! The parameters' rates for given products with S_u and S_v.
        [[nodiscard]] Vector2 solve(const Vector2 &products) const
        {
            const double e = u.squaredNorm(), f = u.dot(v), g = v.squaredNorm();
            return Vector2(g * products.x() - f * products.y(), e * products.y() - f * products.x()) / (e * g - f * f);
        }
    };

    [[nodiscard]] Jet at(const Vector2 &uv) const
    {
        gp_Pnt p;
        gp_Vec u, v, uu, vv, mixed;
        m_surface->D2(uv.x(), uv.y(), p, u, v, uu, vv, mixed);
        return {vector(u.XYZ()), vector(v.XYZ()), vector(uu.XYZ()), vector(mixed.XYZ()), vector(vv.XYZ())};
    }

    //! Second derivative of a geodesic in the parameters: no acceleration is left in the tangent plane.
    [[nodiscard]] Vector2 bend(const Vector2 &x, const Vector2 &v) const
    {
        const Jet jet = at(x);
        const Eigen::Vector3d turn = v.x() * v.x() * jet.uu + 2.0 * v.x() * v.y() * jet.uv + v.y() * v.y() * jet.vv;
        return -jet.solve({jet.u.dot(turn), jet.v.dot(turn)});
    }

    Handle(Geom_Surface) m_surface;
};

//! A curve in the parameters over [0, 1].
using Path = std::function<Vector2(double)>;

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

//! A moved curve, or the arc at a corner, over a part of [0, 1].
struct Part
{
    Path path;
    double first = 0.0;
    double last = 1.0;

    [[nodiscard]] Vector2 at(double part) const { return path(first + part * (last - first)); }
};

//! One wire of the boundary.
class WireInset
{
public:
    WireInset(const InputFace &input, const Walker &walker, const TopoDS_Shape &wire, bool to_left, double distance,
              double tolerance)
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
        for (const Part &part : m_parts)
        {
            const Result<ImagePiece> piece = fitted(part, error);
            if (!piece)
                return piece.failure();
            result.push_back({piece.value(), false, {}, false});
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
            std::vector<Part> joined;
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
        const std::vector<Vector2> own = traced(m_edges, [](const EdgePath &edge, double t) { return edge(t); });
        const std::vector<Vector2> moved = traced(m_parts, [](const Part &part, double t) { return part.at(t); });
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

    //! Points along curves that go on from each other, both ends included.
    template <class Curve, class At> static std::vector<Vector2> traced(const std::vector<Curve> &curves, const At &at)
    {
        std::vector<Vector2> points;
        for (const Curve &curve : curves)
            for (int i = 0; i < polygon_points; ++i)
                points.push_back(at(curve, static_cast<double>(i) / polygon_points));
        points.push_back(at(curves.back(), 1.0));
        return points;
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
    [[nodiscard]] std::optional<Failure> join(std::vector<Part> &joined)
    {
        const std::size_t count = m_parts.size();
        std::vector<std::optional<Part>> bridges(count);
        for (std::size_t k = 0; k < count; ++k)
        {
            const std::size_t next = (k + 1) % count;
            if (next == 0 && !m_closed)
                continue;
            const Eigen::Vector3d gap = m_walker.point(m_parts[k].path(1.0)) - m_walker.point(m_parts[next].path(0.0));
            if (gap.norm() <= m_tolerance || cut(m_parts[k], m_parts[next]))
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

    //! Lets two parts end and begin where their whole curves cross, which may leave nothing of a short one. False where
    //! they do not cross.
    [[nodiscard]] bool cut(Part &before, Part &after) const
    {
        const auto places = [](const Part &part) {
            std::vector<Vector2> points;
            for (int i = 0; i <= polygon_points; ++i)
                points.push_back(part.path(static_cast<double>(i) / polygon_points));
            return points;
        };
        const std::vector<Vector2> a = places(before), b = places(after);
        for (int i = polygon_points - 1; i >= 0; --i)
            for (int j = 0; j < polygon_points; ++j)
            {
                double s = 0.0, t = 0.0;
                if (&before == &after && i <= j + 1)
                    continue;
                if (!meet(a[static_cast<std::size_t>(i)], a[static_cast<std::size_t>(i) + 1],
                          b[static_cast<std::size_t>(j)], b[static_cast<std::size_t>(j) + 1], s, t))
                    continue;
                s = (i + s) / polygon_points;
                t = (j + t) / polygon_points;
                refine(before, after, s, t);
                before.last = s;
                after.first = t;
                return true;
            }
        return false;
    }

    //! Where two segments cross.
    static bool meet(const Vector2 &a, const Vector2 &b, const Vector2 &c, const Vector2 &d, double &s, double &t)
    {
        const Vector2 x = b - a, y = d - c, z = c - a;
        const double turn = x.x() * y.y() - x.y() * y.x();
        if (turn == 0.0)
            return false;
        s = (z.x() * y.y() - z.y() * y.x()) / turn;
        t = (z.x() * x.y() - z.y() * x.x()) / turn;
        return s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0;
    }

    //! Newton's steps towards the place where both parts are one, by differences.
    static void refine(const Part &before, const Part &after, double &s, double &t)
    {
        constexpr double step = 1e-5;
        for (int i = 0; i < 8; ++i)
        {
            const Vector2 gap = after.path(t) - before.path(s);
            const Vector2 x = (before.path(s + step) - before.path(s - step)) / (2.0 * step);
            const Vector2 y = (after.path(t + step) - after.path(t - step)) / (2.0 * step);
            const double turn = x.x() * y.y() - x.y() * y.x();
            if (turn == 0.0)
                return;
            s = std::clamp(s + (gap.x() * y.y() - gap.y() * y.x()) / turn, 0.0, 1.0);
            t = std::clamp(t + (gap.x() * x.y() - gap.y() * x.x()) / turn, 0.0, 1.0);
        }
    }

    //! The ends of the geodesics from a corner, from one curve's direction to the other's.
    [[nodiscard]] Part bridge(std::size_t before, std::size_t after) const
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
            Part &part = at_end ? m_parts.back() : m_parts.front();
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
    void go_on(const Part &part, bool at_end)
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
        const Part line{[from, to](double t) -> Vector2 { return from + t * (to - from); }};
        m_parts.insert(at_end ? m_parts.end() : m_parts.begin(), line);
    }

    //! Does the whole wire cross itself?
    [[nodiscard]] std::optional<Failure> crossing() const
    {
        const std::vector<Vector2> points = traced(m_parts, [](const Part &part, double t) { return part.at(t); });
        const std::size_t count = points.size() - 1;
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = i + 2; j < count; ++j)
            {
                double s = 0.0, t = 0.0;
                if (m_closed && i == 0 && j + 1 == count)
                    continue;
                if (meet(points[i], points[i + 1], points[j], points[j + 1], s, t))
                    return refusal(m_input, Status::NotSupported, points[i],
                                   fmt::format("Moved inwards by {:.4g} mm it crosses itself; take a smaller distance.",
                                               m_distance));
            }
        return std::nullopt;
    }

    //! Pcurve and curve of a part, with as many spans as it needs.
    [[nodiscard]] Result<ImagePiece> fitted(const Part &part, double &error) const
    {
        for (int spans = 1; spans <= most_spans; spans *= 2)
        {
            std::vector<double> interior;
            for (int i = 1; i < spans; ++i)
                interior.push_back(static_cast<double>(i) / spans);
            const KnotVector kv = clamped_knots(degree, 0.0, 1.0, interior);
            const Handle(Geom2d_BSplineCurve) pcurve = pcurve_on(kv, part);
            const double seen = pcurve.IsNull() ? 2.0 * m_tolerance : deviation(*pcurve, kv, part);
            if (!(seen <= 0.5 * m_tolerance))
                continue;
            const auto form = AnalyticSurface::make(m_walker.surface());
            const EdgeTarget target({m_walker.surface(), Handle(Geom2d_Curve)(pcurve), 0.0, 1.0},
                                    form ? &*form : nullptr);
            const std::optional<EdgeCurve> curve = edge_curve(target, 0.5 * m_tolerance);
            if (!curve)
                break;
            error = std::max(error, seen);
            return ImagePiece{Handle(Geom2d_Curve)(pcurve), curve->curve, 0.0, 1.0, curve->deviation, false, seen};
        }
        return refusal(m_input, Status::EdgeToleranceNotReached, part.at(0.5),
                       "The curve moved inwards could not be fitted; loosen the tolerance or smooth the boundary.");
    }

    [[nodiscard]] static Handle(Geom2d_BSplineCurve) pcurve_on(const KnotVector &kv, const Part &part)
    {
        const std::vector<double> parameters = chebyshev_parameters(kv.breaks(), samples_per_span);
        const auto solver = LeastSquaresFit::make(kv, parameters);
        if (!solver)
            return {};
        RowMatrix rows = RowMatrix::Zero(static_cast<Eigen::Index>(parameters.size()), 3);
        for (std::size_t i = 0; i < parameters.size(); ++i)
            rows.row(static_cast<Eigen::Index>(i)).head<2>() = part.at(parameters[i]).transpose();
        const RowMatrix net = solver->solve(rows);
        TColgp_Array1OfPnt2d poles(1, kv.pole_count());
        for (int i = 0; i < kv.pole_count(); ++i)
            poles(i + 1) = gp_Pnt2d(net(i, 0), net(i, 1));
        const std::vector<Knot> distinct = kv.distinct();
        TColStd_Array1OfReal knots(1, static_cast<int>(distinct.size()));
        TColStd_Array1OfInteger multiplicities(1, static_cast<int>(distinct.size()));
        for (std::size_t i = 0; i < distinct.size(); ++i)
        {
            knots(static_cast<int>(i) + 1) = distinct[i].parameter;
            multiplicities(static_cast<int>(i) + 1) = distinct[i].multiplicity;
        }
        return new Geom2d_BSplineCurve(poles, knots, multiplicities, kv.degree);
    }

    [[nodiscard]] double deviation(const Geom2d_BSplineCurve &pcurve, const KnotVector &kv, const Part &part) const
    {
        double worst = 0.0;
        for (const double t : span_parameters(kv, kv.breaks(), checks_per_span * samples_per_span + 1, 1))
        {
            const gp_Pnt2d p = pcurve.Value(t);
            worst = std::max(worst, (m_walker.point({p.X(), p.Y()}) - m_walker.point(part.at(t))).norm());
        }
        return worst;
    }

    const InputFace &m_input;
    const Walker &m_walker;
    double m_sign;
    double m_distance;
    double m_tolerance;
    bool m_closed = false;
    std::vector<EdgePath> m_edges;
    std::vector<bool> m_left_out; //!< of each edge: nothing of it is left when it is moved
    std::vector<Part> m_parts;
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
    const Walker walker(input);
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
