// SPDX-License-Identifier: LGPL-2.1-or-later
#include "loop_region.h"

#include <BndLib_Add2dCurve.hxx>
#include <Bnd_Box2d.hxx>
#include <Geom2dAdaptor_Curve.hxx>

#include <algorithm>

namespace laminate_offset
{
namespace
{

constexpr int pieces_per_interval = 8;
constexpr int least_pieces = 16;
// A loop that runs along a rectangle's border does not touch it; pcurves miss their line by rounding.
constexpr double grazing = 1e-10;

int piece_count(const Geom2dAdaptor_Curve &curve)
{
    if (curve.GetType() == GeomAbs_Line)
        return 1;
    return std::max(least_pieces, pieces_per_interval * curve.NbIntervals(GeomAbs_C2));
}

} // namespace

LoopRegion::LoopRegion(const InputFace &input)
{
    for (const TrimmingLoop &loop : input.loops)
        for (const TrimmingCurve &curve : loop.curves)
        {
            if (!curve.bounds_face())
                continue;
            const Geom2dAdaptor_Curve adaptor(curve.pcurve, curve.first, curve.last);
            const int count = piece_count(adaptor);
            for (int i = 0; i < count; ++i)
            {
                const double a = curve.first + (curve.last - curve.first) * i / count;
                const double b = curve.first + (curve.last - curve.first) * (i + 1) / count;
                Bnd_Box2d bounds;
                BndLib_Add2dCurve::Add(adaptor, a, b, 0.0, bounds);
                Piece piece{adaptor.Value(a), adaptor.Value(b), {}};
                bounds.Add(piece.start);
                bounds.Add(piece.end);
                bounds.Get(piece.box.umin, piece.box.vmin, piece.box.umax, piece.box.vmax);
                m_pieces.push_back(piece);
            }
        }
}

bool LoopRegion::contains(const gp_Pnt2d &uv) const
{
    // parity of the crossings of the ray towards larger u
    bool inside = false;
    for (const Piece &piece : m_pieces)
    {
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
    for (const Piece &piece : m_pieces)
        if (piece.box.umin < box.umax - du && piece.box.umax > box.umin + du && piece.box.vmin < box.vmax - dv &&
            piece.box.vmax > box.vmin + dv)
            return true;
    return contains(gp_Pnt2d(0.5 * (box.umin + box.umax), 0.5 * (box.vmin + box.vmax)));
}

std::vector<gp_Pnt2d> LoopRegion::boundary_points() const
{
    std::vector<gp_Pnt2d> points;
    for (const Piece &piece : m_pieces)
        points.push_back(piece.start);
    return points;
}

} // namespace laminate_offset
