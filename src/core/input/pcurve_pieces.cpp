// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pcurve_pieces.h"

#include "../spline/control_points.h"
#include "../spline/geom_values.h"

#include <BndLib_Add2dCurve.hxx>
#include <Bnd_Box2d.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_BSplineCurve.hxx>

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

//! Piece ends between two parameters.
std::vector<double> piece_ends(double first, double last, int count)
{
    std::vector<double> ends;
    for (int i = 0; i <= count; ++i)
        ends.push_back(first + (last - first) * i / count);
    return ends;
}

//! False where a weight is not positive.
bool add_points(const ControlPoints &points, Bnd_Box2d &box)
{
    for (const Eigen::Vector3d &point : points)
    {
        if (!(point.z() > 0.0))
            return false;
        box.Add(gp_Pnt2d(point.x() / point.z(), point.y() / point.z()));
    }
    return true;
}

//! Adds a spline's control points, cut at knots and ends, to the boxes of its pieces. False where the spline goes
//! round, ends early or has a weight that is not positive.
bool add_control_points(const Geom2d_BSplineCurve &curve, const std::vector<double> &ends,
                        std::vector<Bnd_Box2d> &boxes)
{
    if (curve.IsPeriodic() || ends.front() < curve.FirstParameter() || ends.back() > curve.LastParameter())
        return false;
    const KnotVector kv = knots_of(curve);
    const ControlPoints poles = weighted_poles(curve);
    std::size_t piece = 0;
    for (int span = kv.span(ends.front()); span <= kv.span(ends.back()); ++span)
    {
        double low = kv.knots[static_cast<std::size_t>(span)];
        const double high = kv.knots[static_cast<std::size_t>(span) + 1];
        if (!(low < high))
            continue;
        ControlPoints rest = span_points(kv, poles, span);
        if (low < ends.front())
        {
            cut_off(rest, (ends.front() - low) / (high - low));
            low = ends.front();
        }
        for (; piece + 1 < boxes.size() && ends[piece + 1] < high; ++piece)
        {
            if (!add_points(cut_off(rest, (ends[piece + 1] - low) / (high - low)), boxes[piece]))
                return false;
            low = ends[piece + 1];
        }
        if (ends.back() < high)
            rest = cut_off(rest, (ends.back() - low) / (high - low));
        if (!add_points(rest, boxes[piece]))
            return false;
        if (piece + 1 < boxes.size() && ends[piece + 1] == high)
            ++piece;
    }
    return true;
}

//! A box for each piece between two ends; void for a straight line.
std::vector<Bnd_Box2d> piece_boxes(const Geom2dAdaptor_Curve &curve, const std::vector<double> &ends)
{
    std::vector<Bnd_Box2d> boxes(ends.size() - 1);
    if (boxes.size() == 1)
        return boxes;
    if (curve.GetType() == GeomAbs_BSplineCurve && add_control_points(*curve.BSpline(), ends, boxes))
        return boxes;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        BndLib_Add2dCurve::Add(curve, ends[i], ends[i + 1], 0.0, boxes[i]);
    return boxes;
}

} // namespace

std::vector<PcurvePiece> cut_up(const Handle(Geom2d_Curve) & pcurve, double first, double last)
{
    const Geom2dAdaptor_Curve adaptor(pcurve, first, last);
    const std::vector<double> ends = piece_ends(first, last, piece_count(adaptor));
    std::vector<Bnd_Box2d> boxes = piece_boxes(adaptor, ends);
    std::vector<PcurvePiece> pieces;
    gp_Pnt2d start = adaptor.Value(first);
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
        const gp_Pnt2d end = adaptor.Value(ends[i + 1]);
        boxes[i].Add(start);
        boxes[i].Add(end);
        PcurvePiece piece{start, end, {}};
        boxes[i].Get(piece.box.umin, piece.box.vmin, piece.box.umax, piece.box.vmax);
        pieces.push_back(piece);
        start = end;
    }
    return pieces;
}

} // namespace laminate_offset
