// SPDX-License-Identifier: LGPL-2.1-or-later
#include "loop_region.h"

#include <algorithm>

namespace laminate_offset
{
namespace
{

// A loop that runs along a rectangle's border does not touch it; pcurves miss their line by rounding.
constexpr double grazing = 1e-10;
constexpr std::size_t pieces_per_band = 4;
// Gaps between curves that belong together are narrower, in parts of the loops' box.
constexpr double widest_gap = 1e-3;

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

//! The ends of a loop's curves, two a curve.
std::vector<gp_Pnt2d> curve_ends(const TrimmingLoop &loop)
{
    std::vector<gp_Pnt2d> ends;
    for (const TrimmingCurve &curve : loop.curves)
        if (curve.bounds_face() && !curve.pieces.empty())
        {
            ends.push_back(curve.pieces.front().start);
            ends.push_back(curve.pieces.back().end);
        }
    return ends;
}

PcurvePiece straight_piece(const gp_Pnt2d &a, const gp_Pnt2d &b)
{
    return {a, b, {std::min(a.X(), b.X()), std::max(a.X(), b.X()), std::min(a.Y(), b.Y()), std::max(a.Y(), b.Y())}};
}

//! The pieces that join each end of a loop's curves to the nearest other one: ends that belong together differ by
//! rounding or by the vertex's tolerance, and a ray through such a gap would count one crossing too few. Every end is
//! joined to one other, so that every line crosses the loop an even number of times, however they are paired.
std::vector<PcurvePiece> closing_pieces(const TrimmingLoop &loop, double widest)
{
    std::vector<gp_Pnt2d> ends = curve_ends(loop);
    std::vector<PcurvePiece> closing;
    while (!ends.empty())
    {
        const gp_Pnt2d end = ends.back();
        ends.pop_back();
        const auto other = std::min_element(ends.begin(), ends.end(), [&](const gp_Pnt2d &a, const gp_Pnt2d &b) {
            return end.SquareDistance(a) < end.SquareDistance(b);
        });
        const double gap = end.Distance(*other);
        if (gap > 0.0 && gap <= widest)
            closing.push_back(straight_piece(end, *other));
        *other = ends.back();
        ends.pop_back();
    }
    return closing;
}

} // namespace

LoopRegion::LoopRegion(const InputFace &input)
{
    for (const TrimmingLoop &loop : input.loops)
        for (const TrimmingCurve &curve : loop.curves)
            if (curve.bounds_face())
                m_pieces.insert(m_pieces.end(), curve.pieces.begin(), curve.pieces.end());
    m_bounds = bounds_of(m_pieces);
    const double size = std::max(m_bounds.umax - m_bounds.umin, m_bounds.vmax - m_bounds.vmin);
    for (const TrimmingLoop &loop : input.loops)
    {
        const std::vector<PcurvePiece> closing = closing_pieces(loop, widest_gap * size);
        m_pieces.insert(m_pieces.end(), closing.begin(), closing.end());
    }
    const std::size_t bands = m_pieces.size() / pieces_per_band + 1;
    m_bands.assign(bands + 1, 0);
    std::vector<std::vector<std::size_t>> chords(bands);
    for (std::size_t k = 0; k < m_pieces.size(); ++k)
    {
        const double from = m_pieces[k].start.Y();
        const double to = m_pieces[k].end.Y();
        for (std::size_t i = band(std::min(from, to)); i <= band(std::max(from, to)); ++i)
            chords[i].push_back(k);
    }
    for (std::size_t i = 0; i < bands; ++i)
    {
        m_chords.insert(m_chords.end(), chords[i].begin(), chords[i].end());
        m_bands[i + 1] = m_chords.size();
    }
}

std::size_t LoopRegion::band(double v) const
{
    // grows with v, rounding included; no chord that crosses a line v = const is missed in the line's band
    const double height = m_bounds.vmax - m_bounds.vmin;
    const auto bands = static_cast<double>(m_bands.size() - 1);
    const double place = height > 0.0 ? bands * ((v - m_bounds.vmin) / height) : 0.0;
    return static_cast<std::size_t>(std::clamp(place, 0.0, bands - 1.0));
}

bool LoopRegion::contains(const gp_Pnt2d &uv) const
{
    // parity of the crossings of the ray towards larger u
    bool inside = false;
    const std::size_t own = band(uv.Y());
    for (std::size_t k = m_bands[own]; k < m_bands[own + 1]; ++k)
    {
        const PcurvePiece &piece = m_pieces[m_chords[k]];
        const double from = piece.start.Y() - uv.Y();
        const double to = piece.end.Y() - uv.Y();
        if ((from > 0.0) == (to > 0.0))
            continue;
        const double s = from / (from - to);
        if (piece.start.X() + s * (piece.end.X() - piece.start.X()) > uv.X())
            inside = !inside;
    }
    return inside;
}

bool LoopRegion::may_touch(const ParameterBox &box) const
{
    const double du = grazing * (box.umax - box.umin);
    const double dv = grazing * (box.vmax - box.vmin);
    for (const PcurvePiece &piece : m_pieces)
        if (piece.box.umin < box.umax - du && piece.box.umax > box.umin + du && piece.box.vmin < box.vmax - dv &&
            piece.box.vmax > box.vmin + dv)
            return true;
    return contains(gp_Pnt2d(0.5 * (box.umin + box.umax), 0.5 * (box.vmin + box.vmax)));
}

ParameterBox LoopRegion::bounds() const { return m_bounds; }

std::vector<double> LoopRegion::crossings(bool constant_u, double value) const
{
    std::vector<double> places;
    for (const PcurvePiece &piece : m_pieces)
    {
        const double from = (constant_u ? piece.start.X() : piece.start.Y()) - value;
        const double to = (constant_u ? piece.end.X() : piece.end.Y()) - value;
        if ((from > 0.0) == (to > 0.0))
            continue;
        const gp_XY place = piece.start.XY() + from / (from - to) * (piece.end.XY() - piece.start.XY());
        places.push_back(constant_u ? place.Y() : place.X());
    }
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
