// SPDX-License-Identifier: LGPL-2.1-or-later
#include "loop_region.h"

#include "../input/loop_gaps.h"
#include "../spline/arc_crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

// A loop that runs along a rectangle's border does not touch it; pcurves miss their line by rounding.
constexpr double grazing = 1e-10;
constexpr std::size_t pieces_per_band = 4;
constexpr double border_share = 1e-10;
constexpr double widest_border = 1.1; // times the border's width, what may still count as inside
constexpr double rounding = 1e-13;

ParameterBox bounds_of(const std::vector<PcurvePiece> &pieces)
{
    ParameterBox box = pieces.empty() ? ParameterBox{} : pieces.front().box;
    for (const PcurvePiece &piece : pieces)
    {
        box.umin = std::min(box.umin, piece.box.umin);
        box.umax = std::max(box.umax, piece.box.umax);
        box.vmin = std::min(box.vmin, piece.box.vmin);
        box.vmax = std::max(box.vmax, piece.box.vmax);
    }
    return box;
}

ControlPoints control_points(const std::vector<gp_XYZ> &arc)
{
    ControlPoints points;
    for (const gp_XYZ &point : arc)
        points.emplace_back(point.X(), point.Y(), point.Z());
    return points;
}

bool same(const gp_Pnt2d &a, const gp_Pnt2d &b) { return a.X() == b.X() && a.Y() == b.Y(); }

PcurvePiece straight_piece(const gp_Pnt2d &a, const gp_Pnt2d &b)
{
    return {a,
            b,
            {std::min(a.X(), b.X()), std::max(a.X(), b.X()), std::min(a.Y(), b.Y()), std::max(a.Y(), b.Y())},
            {{{a.X(), a.Y(), 1.0}, {b.X(), b.Y(), 1.0}}}};
}

//! The pieces that join the curves of a loop where these differ by rounding or by the vertex's tolerance, or at a pole: a
//! ray through such a gap would count one crossing too few.
std::vector<PcurvePiece> closing_pieces(const InputFace &input, const TrimmingLoop &loop)
{
    std::vector<PcurvePiece> closing;
    for (const LoopGap &gap : loop_gaps(input, loop, curve_ends(loop)))
        if (!same(gap.from, gap.to))
            closing.push_back(straight_piece(gap.from, gap.to));
    return closing;
}

bool overlap(const ParameterBox &a, const ParameterBox &b)
{
    return a.umin <= b.umax && a.umax >= b.umin && a.vmin <= b.vmax && a.vmax >= b.vmin;
}

//! False only if an arc passes a rectangle by: it is halved until the boxes of its control points tell.
bool arc_reaches(ControlPoints arc, const ParameterBox &box, int depth)
{
    constexpr int deepest = 50;
    const auto at = [](const Eigen::Vector3d &p) { return gp_Pnt2d(p.x() / p.z(), p.y() / p.z()); };
    const gp_Pnt2d start = at(arc.front());
    ParameterBox around{start.X(), start.X(), start.Y(), start.Y()};
    for (const Eigen::Vector3d &point : arc)
    {
        const gp_Pnt2d p = at(point);
        around = {std::min(around.umin, p.X()), std::max(around.umax, p.X()), std::min(around.vmin, p.Y()),
                  std::max(around.vmax, p.Y())};
    }
    if (!overlap(around, box))
        return false;
    const bool starts_inside =
        start.X() >= box.umin && start.X() <= box.umax && start.Y() >= box.vmin && start.Y() <= box.vmax;
    if (starts_inside || depth >= deepest)
        return true;
    const ControlPoints first = cut_off(arc, 0.5);
    return arc_reaches(first, box, depth + 1) || arc_reaches(std::move(arc), box, depth + 1);
}

} // namespace

LoopRegion::LoopRegion(const InputFace &input)
{
    for (const TrimmingLoop &loop : input.loops)
        for (const TrimmingCurve &curve : loop.curves)
            if (curve.bounds_face())
                add(curve.pieces);
    m_bounds = bounds_of(m_pieces);
    for (const TrimmingLoop &loop : input.loops)
    {
        const std::vector<PcurvePiece> closing = closing_pieces(input, loop);
        m_pieces.insert(m_pieces.end(), closing.begin(), closing.end());
    }
    for (PcurvePiece &piece : m_pieces)
        if (piece.arcs.empty())
            piece.arcs = straight_piece(piece.start, piece.end).arcs;
    const auto width = [](double low, double high) {
        return std::max({border_share * (high - low), rounding * std::max(std::abs(low), std::abs(high)),
                         std::numeric_limits<double>::min()});
    };
    m_border = {width(m_bounds.umin, m_bounds.umax), width(m_bounds.vmin, m_bounds.vmax)};
    sort_into_bands();
}

void LoopRegion::add(const std::vector<PcurvePiece> &pieces)
{
    for (std::size_t k = 0; k < pieces.size(); ++k)
    {
        if (k > 0 && !same(pieces[k - 1].end, pieces[k].start)) // cut up in several goes
            m_pieces.push_back(straight_piece(pieces[k - 1].end, pieces[k].start));
        m_pieces.push_back(pieces[k]);
    }
}

void LoopRegion::sort_into_bands()
{
    const std::size_t bands = m_pieces.size() / pieces_per_band + 1;
    m_bands.assign(bands + 1, 0);
    std::vector<std::vector<std::size_t>> pieces(bands);
    for (std::size_t k = 0; k < m_pieces.size(); ++k)
    {
        const ParameterBox &box = m_pieces[k].box;
        for (std::size_t i = band(box.vmin - 2.0 * m_border.Y()); i <= band(box.vmax + 2.0 * m_border.Y()); ++i)
            pieces[i].push_back(k);
    }
    for (std::size_t i = 0; i < bands; ++i)
    {
        m_in_bands.insert(m_in_bands.end(), pieces[i].begin(), pieces[i].end());
        m_bands[i + 1] = m_in_bands.size();
    }
}

std::size_t LoopRegion::band(double v) const
{
    // grows with v, rounding included; no piece that crosses a line v = const is missed in the line's band
    const double height = m_bounds.vmax - m_bounds.vmin;
    const auto bands = static_cast<double>(m_bands.size() - 1);
    const double place = height > 0.0 ? bands * ((v - m_bounds.vmin) / height) : 0.0;
    return static_cast<std::size_t>(std::clamp(place, 0.0, bands - 1.0));
}

bool LoopRegion::contains(const gp_Pnt2d &uv) const
{
    // parity of the crossings of the ray towards larger u
    const Eigen::Vector2d point(uv.X(), uv.Y());
    const Eigen::Vector2d width(m_border.X(), m_border.Y());
    bool inside = false;
    const std::size_t own = band(uv.Y());
    for (std::size_t k = m_bands[own]; k < m_bands[own + 1]; ++k)
    {
        const PcurvePiece &piece = m_pieces[m_in_bands[k]];
        if (uv.Y() < piece.box.vmin - width.y() || uv.Y() > piece.box.vmax + width.y() ||
            uv.X() > piece.box.umax + width.x())
            continue;
        if (uv.X() < piece.box.umin - width.x())
        {
            inside ^= (piece.start.Y() > uv.Y()) != (piece.end.Y() > uv.Y());
            continue;
        }
        for (const std::vector<gp_XYZ> &arc : piece.arcs)
        {
            const RayMeeting meeting = meet_ray(control_points(arc), point, width);
            if (meeting == RayMeeting::OnArc)
                return true;
            inside ^= meeting == RayMeeting::Odd;
        }
    }
    return inside;
}

ParameterBox LoopRegion::core_of(const ParameterBox &box) const
{
    const double du = box.umax > box.umin ? grazing * (box.umax - box.umin) : -widest_border * m_border.X();
    const double dv = box.vmax > box.vmin ? grazing * (box.vmax - box.vmin) : -widest_border * m_border.Y();
    return {box.umin + du, box.umax - du, box.vmin + dv, box.vmax - dv};
}

bool LoopRegion::may_touch(const ParameterBox &box) const
{
    const ParameterBox inner = core_of(box);
    for (const PcurvePiece &piece : m_pieces)
        if (overlap(piece.box, inner))
            return true;
    return contains(gp_Pnt2d(0.5 * (box.umin + box.umax), 0.5 * (box.vmin + box.vmax)));
}

bool LoopRegion::touches(const ParameterBox &box) const
{
    const ParameterBox inner = core_of(box);
    for (const PcurvePiece &piece : m_pieces)
        if (overlap(piece.box, inner))
            for (const std::vector<gp_XYZ> &arc : piece.arcs)
                if (arc_reaches(control_points(arc), inner, 0))
                    return true;
    return contains(gp_Pnt2d(0.5 * (box.umin + box.umax), 0.5 * (box.vmin + box.vmax)));
}

ParameterBox LoopRegion::bounds() const { return m_bounds; }

std::vector<double> LoopRegion::crossings(bool constant_u, double value) const
{
    std::vector<double> places;
    for (const PcurvePiece &piece : m_pieces)
        for (const std::vector<gp_XYZ> &arc : piece.arcs)
            add_crossings(control_points(arc), constant_u ? 0 : 1, value, {m_border.X(), m_border.Y()}, places);
    std::sort(places.begin(), places.end());
    return places;
}

std::vector<gp_Pnt2d> LoopRegion::boundary_points() const
{
    std::vector<gp_Pnt2d> points;
    for (const PcurvePiece &piece : m_pieces)
        points.push_back(piece.start);
    return points;
}

} // namespace laminate_offset
