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
// Where a pcurve has many intervals, each is short: this many pieces in all, or two an interval, serve as well.
constexpr int enough_pieces = 64;
// An edge may begin before its pcurve, or end behind it, by this part of the pcurve's range: its ends are meant.
constexpr double end_rounding = 1e-12;

int piece_count(const Geom2dAdaptor_Curve &curve)
{
    if (curve.GetType() == GeomAbs_Line || (curve.GetType() == GeomAbs_BSplineCurve && curve.NbPoles() == 2))
        return 1;
    const int intervals = curve.NbIntervals(GeomAbs_C2);
    return std::clamp(pieces_per_interval * intervals, least_pieces, std::max(enough_pieces, 2 * intervals));
}

//! Piece ends between two parameters.
std::vector<double> piece_ends(double first, double last, int count)
{
    std::vector<double> ends;
    for (int i = 0; i < count; ++i)
        ends.push_back(first + (last - first) * i / count);
    ends.push_back(last); // rounding must not put it behind the curve's own end
    return ends;
}

using Arcs = std::vector<ControlPoints>;

//! Can a spline be cut there? Not if it goes round or ends early.
bool can_be_cut(const Geom2d_BSplineCurve &curve, const std::vector<double> &ends)
{
    const double slack = end_rounding * (curve.LastParameter() - curve.FirstParameter());
    return !curve.IsPeriodic() && ends.front() >= curve.FirstParameter() - slack &&
           ends.back() <= curve.LastParameter() + slack;
}

//! Lets every arc start from the last bit of the one before it; what is cut separately may differ by a factor too.
void join(std::vector<Arcs> &pieces)
{
    const Eigen::Vector3d *before = nullptr;
    for (Arcs &arcs : pieces)
        for (ControlPoints &arc : arcs)
        {
            if (before)
            {
                const double factor = before->z() / arc.front().z();
                for (Eigen::Vector3d &point : arc)
                    point *= factor;
                arc.front() = *before;
            }
            before = &arc.back();
        }
}

//! The arcs of each piece; none at all for a straight line and for a curve without exact ones.
std::vector<Arcs> arcs_of(const Handle(Geom2d_Curve) & pcurve, const Geom2dAdaptor_Curve &curve,
                          const std::vector<double> &ends)
{
    const std::size_t count = ends.size() - 1;
    std::vector<Arcs> pieces(count);
    if (count == 1)
        return pieces;
    if (curve.GetType() == GeomAbs_BSplineCurve && can_be_cut(*curve.BSpline(), ends))
        pieces = pieces_between(*curve.BSpline(), ends);
    else
        for (std::size_t i = 0; i < count; ++i)
            pieces[i] = bezier_pieces(pcurve, ends[i], ends[i + 1]);
    for (const Arcs &arcs : pieces)
        if (arcs.empty() || !positive_weights(arcs))
            return std::vector<Arcs>(count);
    join(pieces);
    return pieces;
}

std::vector<gp_XYZ> plain(const ControlPoints &arc)
{
    std::vector<gp_XYZ> result;
    result.reserve(arc.size());
    for (const Eigen::Vector3d &point : arc)
        result.emplace_back(point.x(), point.y(), point.z());
    return result;
}

gp_Pnt2d plane_point(const Eigen::Vector3d &weighted)
{
    return {weighted.x() / weighted.z(), weighted.y() / weighted.z()};
}

PcurvePiece piece_of(const Arcs &arcs, const Geom2dAdaptor_Curve &curve, double first, double last, bool straight)
{
    PcurvePiece piece;
    piece.start = arcs.empty() ? curve.Value(first) : plane_point(arcs.front().front());
    piece.end = arcs.empty() ? curve.Value(last) : plane_point(arcs.back().back());
    Bnd_Box2d box;
    box.Add(piece.start);
    box.Add(piece.end);
    if (arcs.empty() && !straight)
        BndLib_Add2dCurve::Add(curve, first, last, 0.0, box);
    for (const ControlPoints &arc : arcs)
    {
        for (const Eigen::Vector3d &point : arc)
            box.Add(plane_point(point));
        piece.arcs.push_back(plain(arc));
    }
    box.Get(piece.box.umin, piece.box.vmin, piece.box.umax, piece.box.vmax);
    return piece;
}

} // namespace

std::vector<PcurvePiece> cut_up(const Handle(Geom2d_Curve) & pcurve, double first, double last)
{
    const Geom2dAdaptor_Curve adaptor(pcurve, first, last);
    const std::vector<double> ends = piece_ends(first, last, piece_count(adaptor));
    const std::vector<Arcs> arcs = arcs_of(pcurve, adaptor, ends);
    std::vector<PcurvePiece> pieces;
    for (std::size_t i = 0; i < arcs.size(); ++i)
        pieces.push_back(piece_of(arcs[i], adaptor, ends[i], ends[i + 1], arcs.size() == 1));
    return pieces;
}

} // namespace laminate_offset
