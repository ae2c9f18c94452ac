// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pcurve_pieces.h"

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

int piece_count(const Geom2dAdaptor_Curve &curve)
{
    if (curve.GetType() == GeomAbs_Line || (curve.GetType() == GeomAbs_BSplineCurve && curve.NbPoles() == 2))
        return 1;
    return std::max(least_pieces, pieces_per_interval * curve.NbIntervals(GeomAbs_C2));
}

} // namespace

std::vector<PcurvePiece> cut_up(const Handle(Geom2d_Curve) & pcurve, double first, double last)
{
    const Geom2dAdaptor_Curve adaptor(pcurve, first, last);
    const int count = piece_count(adaptor);
    std::vector<PcurvePiece> pieces;
    gp_Pnt2d start = adaptor.Value(first);
    for (int i = 0; i < count; ++i)
    {
        const double a = first + (last - first) * i / count;
        const double b = first + (last - first) * (i + 1) / count;
        const gp_Pnt2d end = adaptor.Value(b);
        Bnd_Box2d bounds;
        if (count > 1)
            BndLib_Add2dCurve::Add(adaptor, a, b, 0.0, bounds);
        bounds.Add(start);
        bounds.Add(end);
        PcurvePiece piece{start, end, {}};
        bounds.Get(piece.box.umin, piece.box.vmin, piece.box.umax, piece.box.vmax);
        pieces.push_back(piece);
        start = end;
    }
    return pieces;
}

} // namespace laminate_offset
