// SPDX-License-Identifier: LGPL-2.1-or-later
#include "face_strips.h"

#include "../input/loop_gaps.h"
#include "../trimming/curve_breaks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace laminate_offset
{
namespace
{

// Parameters that differ by less, as a part of the box, count as equal: what a crossing is computed to.
constexpr double same_parameter = 1e-13;

//! The knot vector of degree 1 with these breaks.
KnotVector knots_at(const std::vector<double> &breaks)
{
    return clamped_knots(1, breaks.front(), breaks.back(), {breaks.begin() + 1, breaks.end() - 1});
}

class StripMaker
{
public:
    StripMaker(const InputFace &input, const std::vector<double> &us, const std::vector<double> &vs)
        : m_input(input), m_us(us), m_vs(vs), m_u_knots(knots_at(m_us)), m_v_knots(knots_at(m_vs)),
          m_jumps(m_vs.size() - 1)
    {
    }

    std::vector<FaceStrip> make()
    {
        for (const TrimmingLoop &loop : m_input.loops)
        {
            for (const TrimmingCurve &curve : loop.curves)
                if (curve.bounds_face())
                    add_curve(curve);
            close_gaps(loop);
        }
        add_rectangles();
        return std::move(m_strips);
    }

private:
    static double interval(const std::vector<double> &ends, double value)
    {
        return static_cast<double>(std::upper_bound(ends.begin() + 1, ends.end() - 1, value) - ends.begin() - 1);
    }
    [[nodiscard]] std::size_t column(double u) const { return static_cast<std::size_t>(interval(m_us, u)); }
    [[nodiscard]] std::size_t row(double v) const { return static_cast<std::size_t>(interval(m_vs, v)); }

    static double sign_of(const TrimmingCurve &curve)
    {
        return curve.edge.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
    }

    void add_curve(const TrimmingCurve &curve)
    {
        const CurveOnSurface on_surface{m_input.surface, curve.pcurve, curve.first, curve.last};
        const auto uv = [&](double t) -> Eigen::Vector2d {
            const gp_Pnt2d p = curve.pcurve->Value(t);
            return {p.X(), p.Y()};
        };
        double from = curve.first;
        for (const DataBreak &b : curve_breaks(on_surface, uv, &m_u_knots, &m_v_knots))
            add_piece(curve.pcurve, std::exchange(from, b.parameter), b.parameter, sign_of(curve));
        add_piece(curve.pcurve, from, curve.last, sign_of(curve));
    }

    //! A piece between two breaks lies in one row and one column.
    void add_piece(const Handle(Geom2d_Curve) & pcurve, double from, double to, double sign)
    {
        const gp_Pnt2d middle = pcurve->Value(0.5 * (from + to));
        add_strip({pcurve, from, to, pcurve->Value(from), pcurve->Value(to), 0.0, sign}, middle);
    }

    void add_strip(FaceStrip strip, const gp_Pnt2d &middle)
    {
        const std::size_t i = column(middle.X());
        const std::size_t j = row(middle.Y());
        strip.left = m_us[i];
        // left of the strip, whole intervals follow, up to the strip's end and less what ends at its start
        m_jumps[j][i][snapped(strip.end.Y(), j)] += strip.sign;
        m_jumps[j][i][snapped(strip.start.Y(), j)] -= strip.sign;
        m_strips.push_back(std::move(strip));
    }

    [[nodiscard]] double snapped(double v, std::size_t j) const
    {
        const double same = same_parameter * (m_vs.back() - m_vs.front());
        if (std::abs(v - m_vs[j]) <= same)
            return m_vs[j];
        return std::abs(v - m_vs[j + 1]) <= same ? m_vs[j + 1] : v;
    }

    //! The rectangles left of the strips, row by row from the right to the left.
    void add_rectangles()
    {
        for (std::size_t j = 0; j + 1 < m_vs.size(); ++j)
        {
            std::map<double, double> counts;
            for (auto at_column = m_jumps[j].rbegin(); at_column != m_jumps[j].rend(); ++at_column)
            {
                for (const auto &[v, count] : at_column->second)
                    counts[v] += count;
                const auto next = std::next(at_column);
                const std::size_t stop = next == m_jumps[j].rend() ? 0 : next->first;
                for (std::size_t i = at_column->first; i > stop; --i)
                    add_rectangles_of(i - 1, j, counts);
            }
        }
    }

    void add_rectangles_of(std::size_t i, std::size_t j, const std::map<double, double> &counts)
    {
        for (const auto &[v, count] : counts)
            if (count != 0.0 && v != m_vs[j])
                m_strips.push_back({{}, 0.0, 1.0, {m_us[i + 1], m_vs[j]}, {m_us[i + 1], v}, m_us[i], count});
    }

    //! Pcurves meet to their tolerance only; straight pieces join them.
    void close_gaps(const TrimmingLoop &loop)
    {
        std::vector<CurveEnds> ends;
        for (const TrimmingCurve &curve : loop.curves)
            if (curve.bounds_face())
            {
                const bool forward = sign_of(curve) > 0.0;
                ends.push_back({curve.pcurve->Value(forward ? curve.first : curve.last),
                                curve.pcurve->Value(forward ? curve.last : curve.first)});
            }
        for (const LoopGap &gap : loop_gaps(m_input, loop, ends))
            if (gap.from.Y() != gap.to.Y())
                add_strip({{}, 0.0, 1.0, gap.from, gap.to, 0.0, 1.0}, gp_Pnt2d(0.5 * (gap.from.XY() + gap.to.XY())));
    }

    const InputFace &m_input;
    std::vector<double> m_us;
    std::vector<double> m_vs;
    KnotVector m_u_knots;
    KnotVector m_v_knots;
    std::vector<FaceStrip> m_strips;
    //! For each row of intervals: by column, how often the intervals left of it count, up to each value of v.
    std::vector<std::map<std::size_t, std::map<double, double>>> m_jumps;
};

} // namespace

StripRow FaceStrip::row(double y) const
{
    if (pcurve.IsNull())
        return {start.Y() + y * (end.Y() - start.Y()), left, start.X() + y * (end.X() - start.X()),
                end.Y() - start.Y()};
    gp_Pnt2d p;
    gp_Vec2d slope;
    pcurve->D1(first + y * (last - first), p, slope);
    return {p.Y(), left, p.X(), (last - first) * slope.Y()};
}

std::vector<FaceStrip> face_strips(const InputFace &input, const std::vector<double> &us, const std::vector<double> &vs)
{
    return StripMaker(input, us, vs).make();
}

} // namespace laminate_offset
