// SPDX-License-Identifier: LGPL-2.1-or-later
#include "crease_sides.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

constexpr int points_per_degree = 4;
constexpr int deepest = 24;
constexpr int most_intervals = 4000; // and so many more for every knot:
constexpr int intervals_per_knot = 8;
constexpr int places_without_spline = 512;
// Of a product of three tangents: what rounding may make of a determinant that vanishes.
constexpr double rounding = 1e-12;
// Normals as near to opposite ones as this sine make a cusp: which side lies above the other one, the determinant tells
// less well than the sides themselves do, on steps into them of 2^-20 to 1/2 of their width.
constexpr double cusp_sine = 1e-6;
constexpr int shortest_step = 20;
constexpr int foot_steps = 6;
// Sides that differ by less than this part of their size lie on each other.
constexpr double same_height = 1e-10;

//! The range of a polynomial.
struct Range
{
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }

    //! From its values at the Chebyshev points to all of it.
    void widen(double factor)
    {
        const double more = 0.5 * (factor - 1.0) * (high - low);
        low -= more;
        high += more;
    }
};

//! The two sides of an edge at a place: tangents of the base along it and across it, times powers of the weights that
//! make them polynomials along the edge.
struct Sides
{
    Eigen::Vector3d along;
    Eigen::Vector3d before; //!< across, in the part with the lower parameters
    Eigen::Vector3d after;

    [[nodiscard]] double determinant() const { return along.dot(before.cross(after)); }
    [[nodiscard]] Eigen::Vector3d normal_before() const { return before.cross(along); }
    [[nodiscard]] Eigen::Vector3d normal_after() const { return after.cross(along); }

    [[nodiscard]] bool is_cusp() const
    {
        const Eigen::Vector3d one = normal_before(), other = normal_after();
        return one.dot(other) < 0.0 && std::abs(determinant()) * along.norm() <= cusp_sine * one.norm() * other.norm();
    }
};

//! One edge of two parts. Creases and seams run along parameter lines.
class SharedLine
{
public:
    SharedLine(const CreasedPart &one, const TrimmingCurve &a, const CreasedPart &other, const TrimmingCurve &b)
    {
        const gp_Pnt2d start = a.pcurve->Value(a.first), end = a.pcurve->Value(a.last),
                       there = b.pcurve->Value(b.first);
        const ParameterBox &box = one.input.box;
        m_constant_u = std::abs(end.X() - start.X()) * (box.vmax - box.vmin) <
                       std::abs(end.Y() - start.Y()) * (box.umax - box.umin);
        const double here_at = m_constant_u ? start.X() : start.Y();
        m_low = m_constant_u ? std::min(start.Y(), end.Y()) : std::min(start.X(), end.X());
        m_high = m_constant_u ? std::max(start.Y(), end.Y()) : std::max(start.X(), end.X());
        m_parameter = here_at;
        const double middle = m_constant_u ? 0.5 * (box.umin + box.umax) : 0.5 * (box.vmin + box.vmax);
        const bool ends_here = here_at > middle; // the edge is the one part's upper end
        m_before = {ends_here ? &one.base : &other.base, ends_here ? here_at : m_constant_u ? there.X() : there.Y()};
        m_after = {ends_here ? &other.base : &one.base, ends_here ? m_constant_u ? there.X() : there.Y() : here_at};
        m_same_height = same_height * std::max(one.input.diagonal, other.input.diagonal) +
                        one.base.model_error().point + other.base.model_error().point;
    }

    [[nodiscard]] double low() const { return m_low; }
    [[nodiscard]] double high() const { return m_high; }
    [[nodiscard]] bool constant_u() const { return m_constant_u; }
    [[nodiscard]] bool has_splines() const { return m_before.base->spline() && m_after.base->spline(); }

    [[nodiscard]] gp_Pnt2d place(double t) const
    {
        return m_constant_u ? gp_Pnt2d(m_parameter, t) : gp_Pnt2d(t, m_parameter);
    }

    [[nodiscard]] std::vector<Sides> sides(const std::vector<double> &ts) const
    {
        const std::vector<SurfaceJet> before = jets(m_before, ts), after = jets(m_after, ts);
        std::vector<Sides> result;
        for (std::size_t i = 0; i < ts.size(); ++i)
            result.push_back({m_constant_u ? before[i].v : before[i].u, m_constant_u ? before[i].u : before[i].v,
                              m_constant_u ? after[i].u : after[i].v});
        return result;
    }

    //! At a cusp, which has the sign of the determinant for what opens like it: that of the nearest place beside the edge
    //! where one side lies clearly above the other. 0: they lie on each other.
    [[nodiscard]] double cusp_sign(double t) const
    {
        const Sides at = sides({t}).front();
        const Eigen::Vector3d up = at.normal_before().normalized();
        const ParameterBox &box = m_after.base->box();
        const double width = m_constant_u ? box.umax - box.umin : box.vmax - box.vmin;
        for (int k = shortest_step; k > 0; --k)
        {
            const double step = std::ldexp(width, -k);
            const Eigen::Vector3d target = point_at(m_after, m_after.parameter + step, t).s;
            const std::optional<Eigen::Vector3d> rise =
                from_before(target, m_before.parameter - step * at.after.norm() / at.before.norm(), t);
            if (rise && std::abs(rise->dot(up)) > m_same_height)
                return rise->dot(up) > 0.0 ? -1.0 : 1.0;
        }
        return 0.0;
    }

    //! Largest degree along the edge of one of the tangents, and the breaks between which they are polynomials.
    [[nodiscard]] int degree() const
    {
        int degree = 1;
        for (const End &end : {m_before, m_after})
        {
            const TensorSpline &spline = *end.base->spline();
            const int own = m_constant_u ? spline.v.degree : spline.u.degree;
            degree = std::max(degree, spline.rational ? 2 * own : own);
        }
        return degree;
    }

    [[nodiscard]] std::vector<double> breaks() const
    {
        std::vector<double> ends{m_low};
        const auto knots = [&](const End &end) {
            return m_constant_u ? end.base->spline()->v.breaks() : end.base->spline()->u.breaks();
        };
        for (const double knot : merged_breaks(knots(m_before), knots(m_after)))
            if (knot > m_low && knot < m_high)
                ends.push_back(knot);
        ends.push_back(m_high);
        return ends;
    }

private:
    struct End
    {
        const BaseSurface *base = nullptr;
        double parameter = 0.0;
    };

    [[nodiscard]] SurfaceJet point_at(const End &end, double across, double along) const
    {
        return m_constant_u ? end.base->jets({across}, {along}, 1).front()
                            : end.base->jets({along}, {across}, 1).front();
    }

    //! The way to a point from its foot on the side before the edge, found from a place near it; nothing where that has none.
    [[nodiscard]] std::optional<Eigen::Vector3d> from_before(const Eigen::Vector3d &target, double across,
                                                             double along) const
    {
        const ParameterBox &box = m_before.base->box();
        const auto inside = [&](double u, double v) {
            return u >= box.umin && u <= box.umax && v >= box.vmin && v <= box.vmax;
        };
        for (int step = 0; step <= foot_steps; ++step)
        {
            if (!(m_constant_u ? inside(across, along) : inside(along, across)))
                return std::nullopt;
            const SurfaceJet jet = point_at(m_before, across, along);
            const Eigen::Vector3d way = target - jet.s;
            Eigen::Matrix<double, 3, 2> tangents;
            tangents << (m_constant_u ? jet.u : jet.v), (m_constant_u ? jet.v : jet.u);
            const Eigen::Vector2d move = tangents.colPivHouseholderQr().solve(way);
            if ((tangents * move).norm() <= 0.5 * m_same_height)
                return way;
            across += move.x();
            along += move.y();
        }
        return std::nullopt;
    }

    [[nodiscard]] std::vector<SurfaceJet> jets(const End &end, const std::vector<double> &ts) const
    {
        const ParameterBox &box = end.base->box();
        const double across = m_constant_u ? std::clamp(end.parameter, box.umin, box.umax)
                                           : std::clamp(end.parameter, box.vmin, box.vmax);
        std::vector<double> along = ts;
        for (double &t : along)
            t = m_constant_u ? std::clamp(t, box.vmin, box.vmax) : std::clamp(t, box.umin, box.umax);
        const std::vector<double> line{across};
        std::vector<SurfaceJet> jets = m_constant_u ? end.base->jets(line, along, 1) : end.base->jets(along, line, 1);
        const std::optional<TensorSpline> &spline = end.base->spline();
        if (!spline || !spline->rational)
            return jets;
        const std::vector<double> weights = m_constant_u ? spline->weights(line, along) : spline->weights(along, line);
        for (std::size_t i = 0; i < jets.size(); ++i)
        {
            jets[i].u *= weights[i] * weights[i];
            jets[i].v *= weights[i] * weights[i];
        }
        return jets;
    }

    bool m_constant_u = false;
    double m_low = 0.0;
    double m_high = 0.0;
    double m_parameter = 0.0;
    double m_same_height = 0.0; //!< [mm]
    End m_before, m_after;
};

//! Looks for a place where the parts are on one chosen side of each other.
class WindowSearch
{
public:
    //! \param sign of the determinant there.
    //! \param opens is it where they move apart? At a cusp whose sides lie on each other they do.
    WindowSearch(const SharedLine &line, double sign, bool opens, double distance, double tolerance)
        : m_line(line), m_sign(sign), m_opens(opens), m_distance(std::abs(distance)), m_tear(0.5 * tolerance)
    {
    }

    std::optional<double> run()
    {
        if (!m_line.has_splines())
            return seen_between(m_line.low(), m_line.high(), places_without_spline);
        const std::vector<double> ends = m_line.breaks();
        m_budget = most_intervals + intervals_per_knot * static_cast<int>(ends.size());
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
            if (const std::optional<double> found = within(ends[i], ends[i + 1], 0))
                return found;
        return std::nullopt;
    }

    //! A part of the line that is not known to hold none, if there is one.
    [[nodiscard]] const std::optional<double> &open() const { return m_open; }

private:
    [[nodiscard]] bool is_window(const Sides &sides, double t) const
    {
        const Eigen::Vector3d one = sides.normal_before(), other = sides.normal_after();
        if (!(one.norm() > 0.0) || !(other.norm() > 0.0) ||
            m_distance * (other.normalized() - one.normalized()).norm() <= m_tear)
            return false;
        if (!sides.is_cusp())
            return m_sign * sides.determinant() > 0.0;
        const double sign = m_line.cusp_sign(t);
        return sign == 0.0 ? m_opens : m_sign * sign > 0.0;
    }

    [[nodiscard]] std::optional<double> seen_between(double low, double high, int count) const
    {
        std::vector<double> ts;
        for (int k = 0; k < count; ++k)
            ts.push_back(low + (high - low) * (k + 0.5) / count);
        const std::vector<Sides> sides = m_line.sides(ts);
        for (std::size_t k = 0; k < ts.size(); ++k)
            if (is_window(sides[k], ts[k]))
                return ts[k];
        return std::nullopt;
    }

    //! On one interval between knots, or a part of it.
    std::optional<double> within(double low, double high, int halvings)
    {
        if (halvings > deepest) // a place where a side's derivatives vanish; nothing as short can be told from it
            return std::nullopt;
        if (++m_intervals > m_budget)
        {
            m_open = 0.5 * (low + high);
            return std::nullopt;
        }
        const int points = points_per_degree * 4 * m_line.degree() + 1;
        std::vector<double> ts;
        for (int k = 0; k < points; ++k)
            ts.push_back(0.5 * (low + high) - 0.5 * (high - low) * std::cos(M_PI * (k + 0.5) / points));
        const std::vector<Sides> sides = m_line.sides(ts);
        for (std::size_t k = 0; k < ts.size(); ++k)
            if (is_window(sides[k], ts[k]))
                return ts[k];
        const double middle = 0.5 * (low + high);
        if (holds_none(sides, middle))
            return std::nullopt;
        const std::optional<double> found = within(low, middle, halvings + 1);
        return found ? found : within(middle, high, halvings + 1);
    }

    //! Do the values at the Chebyshev points prove that there is no window between them?
    [[nodiscard]] bool holds_none(const std::vector<Sides> &sides, double middle)
    {
        Range determinant, along, one, other, together;
        for (const Sides &s : sides)
        {
            determinant.add(m_sign * s.determinant());
            along.add(s.along.squaredNorm());
            one.add(s.normal_before().squaredNorm());
            other.add(s.normal_after().squaredNorm());
            together.add(s.normal_before().dot(s.normal_after()));
        }
        // of degree four times that of a tangent at most
        const double factor = 1.0 / std::cos(0.5 * M_PI / points_per_degree);
        for (Range *range : {&determinant, &along, &one, &other, &together})
            range->widen(factor);
        const double turn = std::max(std::abs(determinant.low), std::abs(determinant.high));
        if (together.high < 0.0 && one.low > 0.0 && other.low > 0.0 &&
            turn * std::sqrt(along.high) <= cusp_sine * std::sqrt(one.low * other.low))
        {
            m_open = middle; // a cusp all along: it has been looked at in places only
            return true;
        }
        const double noise = along.low > 0.0 ? rounding * std::sqrt(one.high * other.high / along.low) : 0.0;
        if (determinant.high <= noise && (determinant.low < -noise || together.low > 0.0))
            return true;
        if (!(one.low > 0.0) || !(other.low > 0.0) || !(together.low > 0.0))
            return false;
        const double sine = determinant.high * std::sqrt(along.high / (one.low * other.low));
        return sine < 1.0 && 2.0 * m_distance * std::sin(0.5 * std::asin(sine)) <= m_tear;
    }

    const SharedLine &m_line;
    double m_sign;
    bool m_opens;
    double m_distance;
    double m_tear;
    int m_intervals = 0;
    int m_budget = most_intervals;
    std::optional<double> m_open;
};

std::vector<const TrimmingCurve *> curves_of(const InputFace &input)
{
    std::vector<const TrimmingCurve *> curves;
    for (const TrimmingLoop &loop : input.loops)
        for (const TrimmingCurve &curve : loop.curves)
            if (!curve.degenerated && curve.bounds_face())
                curves.push_back(&curve);
    return curves;
}

//! Across a line of constant u the normal is A x T, across one of constant v it is T x A: from that the sign.
CreaseEdge judged(const SharedLine &line, double distance, double tolerance)
{
    CreaseEdge edge;
    const double opening = (line.constant_u() ? 1.0 : -1.0) * (distance < 0.0 ? -1.0 : 1.0);
    WindowSearch gap(line, opening, true, distance, tolerance), overlap(line, -opening, false, distance, tolerance);
    edge.opens = gap.run().has_value();
    if (const std::optional<double> t = overlap.run())
        edge.crosses = line.place(*t);
    if (!edge.opens && gap.open())
        edge.open = line.place(*gap.open());
    if (!edge.crosses && overlap.open())
        edge.open = line.place(*overlap.open());
    return edge;
}

} // namespace

std::vector<CreaseEdge> crease_edges(const std::vector<CreasedPart> &parts, double distance, double tolerance)
{
    std::vector<CreaseEdge> edges;
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = i + 1; j < parts.size(); ++j)
            for (const TrimmingCurve *a : curves_of(parts[i].input))
                for (const TrimmingCurve *b : curves_of(parts[j].input))
                    if (a->edge.IsSame(b->edge))
                    {
                        const SharedLine line(parts[i], *a, parts[j], *b);
                        CreaseEdge &edge = edges.emplace_back(judged(line, distance, tolerance));
                        edge.first = i;
                        edge.second = j;
                        edge.edge = a->edge;
                        const double middle = 0.5 * (a->first + a->last);
                        edge.shift = gp_Vec2d(b->pcurve->Value(middle), a->pcurve->Value(middle));
                    }
    return edges;
}

std::optional<CreaseKind> kind_of(const std::vector<CreaseEdge> &edges)
{
    const bool gap = std::any_of(edges.begin(), edges.end(), [](const CreaseEdge &e) { return e.opens; });
    const bool overlap =
        std::any_of(edges.begin(), edges.end(), [](const CreaseEdge &e) { return e.crosses.has_value(); });
    if (!gap && !overlap)
        return std::nullopt;
    return !overlap ? CreaseKind::Gap : !gap ? CreaseKind::Overlap : CreaseKind::Both;
}

} // namespace laminate_offset
