// SPDX-License-Identifier: LGPL-2.1-or-later
#include "loop_gaps.h"

#include <TopExp.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

// A gap wider than this part of the box is a jump, which only a point of the surface excuses.
constexpr double widest_gap = 1e-3;
// Points of space that are nearer to each other than this part of the face's size are one.
constexpr double same_point = 1e-7;

class GapFinder
{
public:
    GapFinder(const InputFace &input, const TrimmingLoop &loop, const std::vector<CurveEnds> &ends)
        : m_input(input), m_ends(ends), m_next(ends.size(), ends.size()), m_taken(ends.size(), 0)
    {
        for (const TrimmingCurve &curve : loop.curves)
            if (curve.bounds_face())
            {
                m_first.push_back(TopExp::FirstVertex(curve.edge, true));
                m_last.push_back(TopExp::LastVertex(curve.edge, true));
            }
    }

    const std::vector<std::size_t> &following()
    {
        for (const bool by_vertex : {true, false})
            for (std::size_t i = 0; i < m_ends.size(); ++i)
                if (m_next[i] == m_ends.size())
                    pair(i, by_vertex);
        return m_next;
    }

    std::vector<LoopGap> find()
    {
        following();
        std::vector<LoopGap> gaps;
        for (std::size_t i = 0; i < m_ends.size(); ++i)
        {
            const gp_Pnt2d &from = m_ends[i].end;
            const gp_Pnt2d &to = m_ends[m_next[i]].start;
            gaps.push_back({from, to, !(gap(from, to) <= widest_gap) && !one_point(from, to)});
        }
        return gaps;
    }

private:
    //! The nearest start that is free, from the vertex where curve i ends or from any.
    void pair(std::size_t i, bool by_vertex)
    {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < m_ends.size(); ++k)
        {
            if (m_taken[k] != 0 || (by_vertex && (m_last[i].IsNull() || !m_last[i].IsSame(m_first[k]))))
                continue;
            const double width = gap(m_ends[i].end, m_ends[k].start);
            if (m_next[i] == m_ends.size() || width < least) // some start at any rate, though a width be no number
            {
                least = width;
                m_next[i] = k;
            }
        }
        if (m_next[i] < m_ends.size())
            m_taken[m_next[i]] = 1;
    }

    //! The distance of two places as a part of the box.
    [[nodiscard]] double gap(const gp_Pnt2d &a, const gp_Pnt2d &b) const
    {
        const ParameterBox &box = m_input.box;
        return std::max(std::abs(a.X() - b.X()) / (box.umax - box.umin),
                        std::abs(a.Y() - b.Y()) / (box.vmax - box.vmin));
    }

    //! Are the places between two ones the same point of space, within the tolerance of the face?
    [[nodiscard]] bool one_point(const gp_Pnt2d &a, const gp_Pnt2d &b) const
    {
        const double near = std::max(m_input.tolerance, same_point * m_input.diagonal);
        const gp_Pnt middle = m_input.point(gp_Pnt2d(0.5 * (a.XY() + b.XY())));
        return middle.Distance(m_input.point(a)) <= near && middle.Distance(m_input.point(b)) <= near;
    }

    const InputFace &m_input;
    const std::vector<CurveEnds> &m_ends;
    std::vector<TopoDS_Vertex> m_first;
    std::vector<TopoDS_Vertex> m_last;
    std::vector<std::size_t> m_next; //!< the curve that follows each one; their number: none yet
    std::vector<char> m_taken;       //!< is the curve's start taken?
};

} // namespace

std::vector<CurveEnds> curve_ends(const TrimmingLoop &loop)
{
    std::vector<CurveEnds> ends;
    for (const TrimmingCurve &curve : loop.curves)
        if (curve.bounds_face())
        {
            const CurveEnds along{curve.pieces.front().start, curve.pieces.back().end};
            const bool reversed = curve.edge.Orientation() == TopAbs_REVERSED;
            ends.push_back(reversed ? CurveEnds{along.end, along.start} : along);
        }
    return ends;
}

std::vector<std::size_t> following_curves(const InputFace &input, const TrimmingLoop &loop,
                                          const std::vector<CurveEnds> &ends)
{
    return GapFinder(input, loop, ends).following();
}

std::vector<LoopGap> loop_gaps(const InputFace &input, const TrimmingLoop &loop, const std::vector<CurveEnds> &ends)
{
    return GapFinder(input, loop, ends).find();
}

} // namespace laminate_offset
