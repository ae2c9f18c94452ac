// SPDX-License-Identifier: LGPL-2.1-or-later
#include "border_search.h"

#include "../spline/geom_values.h"

#include <Geom2dAdaptor_Curve.hxx>
#include <TColStd_Array1OfReal.hxx>

#include <algorithm>
#include <array>
#include <cmath>

namespace laminate_offset
{
namespace
{

// Largest sag of a part against the face's size.
constexpr double admissible_sag = 1e-4;
constexpr int first_parts = 4;
constexpr int deepest = 14;
constexpr int most_steps = 60;
constexpr double infinity = std::numeric_limits<double>::infinity();

double distance_to_chord(const Eigen::Vector3d &start, const Eigen::Vector3d &end, const Eigen::Vector3d &point)
{
    const Eigen::Vector3d along = end - start;
    const double square = along.squaredNorm();
    const double s = square > 0.0 ? std::clamp(along.dot(point - start) / square, 0.0, 1.0) : 0.0;
    return (start + s * along - point).norm();
}

} // namespace

BorderSearch::BorderSearch(const InputFace &input, const Handle(Geom_Surface) & surface) : m_surface(surface)
{
    for (const TrimmingLoop &loop : input.loops)
        for (const TrimmingCurve &curve : loop.curves)
        {
            if (!curve.bounds_face())
                continue;
            m_curves.push_back({curve.pcurve, curve.first, curve.last});
            const Geom2dAdaptor_Curve adaptor(curve.pcurve, curve.first, curve.last);
            TColStd_Array1OfReal ends(1, adaptor.NbIntervals(GeomAbs_C1) + 1);
            adaptor.Intervals(ends, GeomAbs_C1);
            for (int i = 1; i < ends.Upper(); ++i)
                for (int k = 0; k < first_parts; ++k)
                {
                    const double step = (ends(i + 1) - ends(i)) / first_parts;
                    cut(m_curves.size() - 1, ends(i) + k * step,
                        k + 1 == first_parts ? ends(i + 1) : ends(i) + (k + 1) * step, admissible_sag * input.diagonal,
                        0);
                }
        }
    if (!m_chords.empty())
        build(0, m_chords.size());
}

Eigen::Vector3d BorderSearch::value(std::size_t curve, double t) const
{
    const gp_Pnt2d uv = m_curves[curve].pcurve->Value(t);
    return vector(m_surface->Value(uv.X(), uv.Y()).XYZ());
}

void BorderSearch::cut(std::size_t curve, double low, double high, double admissible, int depth)
{
    Chord chord{curve, low, high, value(curve, low), value(curve, high), 0.0};
    for (const double s : {0.2, 0.4, 0.5, 0.6, 0.8})
        chord.sag =
            std::max(chord.sag, 2.0 * distance_to_chord(chord.start, chord.end, value(curve, low + s * (high - low))));
    if (chord.sag <= admissible || depth >= deepest)
    {
        m_chords.push_back(chord);
        return;
    }
    const double middle = 0.5 * (low + high);
    cut(curve, low, middle, admissible, depth + 1);
    cut(curve, middle, high, admissible, depth + 1);
}

int BorderSearch::build(std::size_t first, std::size_t last)
{
    const int index = static_cast<int>(m_nodes.size());
    m_nodes.push_back({{}, first, last, -1, -1});
    if (last - first == 1)
    {
        const Chord &chord = m_chords[first];
        Eigen::AlignedBox3d hull(chord.start);
        hull.extend(chord.end);
        hull.min().array() -= chord.sag;
        hull.max().array() += chord.sag;
        m_nodes.back().hull = hull;
        return index;
    }
    const std::size_t middle = (first + last) / 2;
    const int lower = build(first, middle);
    const int upper = build(middle, last);
    Node &node = m_nodes[static_cast<std::size_t>(index)];
    node.lower = lower;
    node.upper = upper;
    node.hull = m_nodes[static_cast<std::size_t>(lower)].hull.merged(m_nodes[static_cast<std::size_t>(upper)].hull);
    return index;
}

//! The zero of the distance's slope between the ends, by secants with every third step a halving.
void BorderSearch::try_chord(const Chord &chord, const Eigen::Vector3d &point, SurfaceFoot &best) const
{
    if (distance_to_chord(chord.start, chord.end, point) - chord.sag >= best.distance)
        return;
    const auto offer = [&](double t) {
        const gp_Pnt2d uv = m_curves[chord.curve].pcurve->Value(t);
        const Eigen::Vector3d at = vector(m_surface->Value(uv.X(), uv.Y()).XYZ());
        if (const double distance = (at - point).norm(); distance < best.distance)
            best = {{uv.X(), uv.Y()}, at, distance};
    };
    const auto slope = [&](double t) {
        gp_Pnt2d uv;
        gp_Vec2d along;
        m_curves[chord.curve].pcurve->D1(t, uv, along);
        gp_Pnt s;
        gp_Vec su, sv;
        m_surface->D1(uv.X(), uv.Y(), s, su, sv);
        return vector(s.XYZ() - gp_XYZ(point.x(), point.y(), point.z()))
            .dot(vector((along.X() * su + along.Y() * sv).XYZ()));
    };
    offer(chord.low);
    offer(chord.high);
    double a = chord.low;
    double b = chord.high;
    double at_a = slope(a);
    double at_b = slope(b);
    if (!(at_a < 0.0 && at_b > 0.0))
        return;
    for (int step = 0; step < most_steps && b - a > 1e-14 * (chord.high - chord.low); ++step)
    {
        const double t = step % 3 == 2 ? 0.5 * (a + b) : a + (b - a) * at_a / (at_a - at_b);
        const double at_t = slope(t);
        (at_t < 0.0 ? a : b) = t;
        (at_t < 0.0 ? at_a : at_b) = at_t;
        if (at_t == 0.0)
            break;
    }
    offer(a);
    offer(b);
}

SurfaceFoot BorderSearch::nearest(const Eigen::Vector3d &point) const
{
    SurfaceFoot best;
    best.distance = infinity;
    std::vector<std::pair<double, int>> stack;
    if (!m_nodes.empty())
        stack.emplace_back(0.0, 0);
    while (!stack.empty())
    {
        const auto [away, index] = stack.back();
        stack.pop_back();
        if (away >= best.distance)
            continue;
        const Node &node = m_nodes[static_cast<std::size_t>(index)];
        if (node.lower < 0)
        {
            try_chord(m_chords[node.first], point, best);
            continue;
        }
        std::pair<double, int> near{m_nodes[static_cast<std::size_t>(node.lower)].hull.exteriorDistance(point),
                                    node.lower};
        std::pair<double, int> far{m_nodes[static_cast<std::size_t>(node.upper)].hull.exteriorDistance(point),
                                   node.upper};
        if (near.first > far.first)
            std::swap(near, far);
        stack.push_back(far);
        stack.push_back(near);
    }
    return best;
}

} // namespace laminate_offset
