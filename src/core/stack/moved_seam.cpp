// SPDX-License-Identifier: LGPL-2.1-or-later
#include "moved_seam.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace laminate_offset
{
namespace
{

constexpr int samples = 32;
// Parameters that differ by less, as a part of the box, count as equal.
constexpr double same_parameter = 1e-9;
// Poles and weights that differ by less, as a part of the face or of the weight, are one: rounding, not shape.
constexpr double same_pole = 1e-14;
// The least free part of the turn in which a seam finds a place.
constexpr double least_gap = 1e-3;

//! One direction of the parameters, u or v, in which a face may go all round.
class RoundDirection
{
public:
    RoundDirection(const InputFace &input, bool along_u)
        : m_input(input), m_along_u(along_u), m_low(along_u ? input.box.umin : input.box.vmin),
          m_high(along_u ? input.box.umax : input.box.vmax)
    {
    }

    //! Is the face bounded by its seam in this direction and by whole parameter lines in the other one?
    [[nodiscard]] bool whole_band() const
    {
        bool seam = false;
        for (const TrimmingLoop &loop : m_input.loops)
            for (const TrimmingCurve &curve : loop.curves)
            {
                if (!curve.bounds_face())
                    continue;
                const bool across = curve.seam && constant(curve, m_along_u);
                if (!across && !constant(curve, !m_along_u))
                    return false;
                seam = seam || across;
            }
        return seam;
    }

    //! The parts of the turn, from 0 to 1, that curves with ramps beside them take; they may reach past both ends.
    [[nodiscard]] std::vector<std::pair<double, double>> taken(const std::vector<TopoDS_Shape> &images,
                                                               double clearance) const
    {
        std::vector<std::pair<double, double>> parts;
        for (const TopoDS_Shape &image : images)
            for (TopExp_Explorer it(image, TopAbs_EDGE); it.More(); it.Next())
                parts.push_back(taken_by(TopoDS::Edge(it.Current()), clearance));
        return parts;
    }

    //! The face that begins at a part of the turn.
    [[nodiscard]] std::optional<TopoDS_Face> beginning_at(double part) const
    {
        const double place = m_low + part * (m_high - m_low);
        if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(m_input.surface); !spline.IsNull())
        {
            const Handle(Geom_Surface) moved = begun_at(*spline, place);
            return moved.IsNull() ? std::nullopt : face_on(moved);
        }
        const auto round = Handle(Geom_ElementarySurface)::DownCast(m_input.surface);
        if (round.IsNull() || !m_along_u || !round->IsUPeriodic())
            return std::nullopt;
        const auto turned = Handle(Geom_ElementarySurface)::DownCast(round->Copy());
        turned->Rotate(round->Axis(), round->Position().Direct() ? place : -place);
        return face_on(turned);
    }

private:
    [[nodiscard]] static double coordinate(const gp_Pnt2d &uv, bool u) { return u ? uv.X() : uv.Y(); }

    [[nodiscard]] bool constant(const TrimmingCurve &curve, bool u) const
    {
        const ParameterBox &box = m_input.box;
        const double same = same_parameter * (u ? box.umax - box.umin : box.vmax - box.vmin);
        const double first = coordinate(curve.pcurve->Value(curve.first), u);
        for (int i = 1; i <= samples; ++i)
        {
            const double t = curve.first + (curve.last - curve.first) * i / samples;
            if (std::abs(coordinate(curve.pcurve->Value(t), u) - first) > same)
                return false;
        }
        return true;
    }

    [[nodiscard]] std::pair<double, double> taken_by(const TopoDS_Edge &edge, double clearance) const
    {
        double first = 0.0;
        double last = 0.0;
        const Handle(Geom2d_Curve) pcurve = BRep_Tool::CurveOnSurface(edge, m_input.face, first, last);
        std::pair<double, double> part{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
        for (int i = 0; i <= samples; ++i)
        {
            const gp_Pnt2d uv = pcurve->Value(first + (last - first) * i / samples);
            gp_Pnt point;
            gp_Vec du, dv;
            m_input.surface->D1(uv.X(), uv.Y(), point, du, dv);
            const double speed = (m_along_u ? du : dv).Magnitude();
            const double margin = speed > Precision::Confusion() ? clearance / speed : m_high - m_low;
            const double here = coordinate(uv, m_along_u);
            part.first = std::min(part.first, (here - margin - m_low) / (m_high - m_low));
            part.second = std::max(part.second, (here + margin - m_low) / (m_high - m_low));
        }
        return part;
    }

    //! Do poles and weights go on over the seam? A rational surface may close in points alone, with other weights behind.
    [[nodiscard]] bool closes(const Geom_BSplineSurface &surface) const
    {
        const int across = m_along_u ? surface.NbVPoles() : surface.NbUPoles();
        const int last = m_along_u ? surface.NbUPoles() : surface.NbVPoles();
        for (int k = 1; k <= across; ++k)
        {
            const gp_Pnt a = m_along_u ? surface.Pole(1, k) : surface.Pole(k, 1);
            const gp_Pnt b = m_along_u ? surface.Pole(last, k) : surface.Pole(k, last);
            const double weight_a = m_along_u ? surface.Weight(1, k) : surface.Weight(k, 1);
            const double weight_b = m_along_u ? surface.Weight(last, k) : surface.Weight(k, last);
            if (a.Distance(b) > same_pole * m_input.diagonal || std::abs(weight_a - weight_b) > same_pole * weight_a)
                return false;
        }
        return true;
    }

    //! \return null where the surface would become another one.
    [[nodiscard]] Handle(Geom_Surface) begun_at(const Geom_BSplineSurface &surface, double place) const
    {
        if (!(m_along_u ? surface.IsUPeriodic() : surface.IsVPeriodic()) && !closes(surface))
            return {};
        constexpr int once = 1;
        constexpr bool add = false;
        const Handle(Geom_BSplineSurface) moved = Handle(Geom_BSplineSurface)::DownCast(surface.Copy());
        const double near = same_parameter * (m_high - m_low);
        int i = 1;
        if (m_along_u)
        {
            moved->SetUPeriodic();
            moved->InsertUKnot(place, once, near, add);
            while (i < moved->NbUKnots() && std::abs(moved->UKnot(i) - place) > near)
                ++i;
            moved->SetUOrigin(i);
            moved->SetUNotPeriodic();
        }
        else
        {
            moved->SetVPeriodic();
            moved->InsertVKnot(place, once, near, add);
            while (i < moved->NbVKnots() && std::abs(moved->VKnot(i) - place) > near)
                ++i;
            moved->SetVOrigin(i);
            moved->SetVNotPeriodic();
        }
        return Handle(Geom_Surface)(moved);
    }

    //! The face over the same box of the other direction and the whole turn.
    [[nodiscard]] std::optional<TopoDS_Face> face_on(const Handle(Geom_Surface) & surface) const
    {
        ParameterBox box = m_input.box;
        double u0, u1, v0, v1;
        surface->Bounds(u0, u1, v0, v1);
        (m_along_u ? box.umin : box.vmin) = m_along_u ? u0 : v0;
        (m_along_u ? box.umax : box.vmax) = m_along_u ? u1 : v1;
        BRepBuilderAPI_MakeFace made(surface, box.umin, box.umax, box.vmin, box.vmax, Precision::Confusion());
        if (!made.IsDone())
            return std::nullopt;
        constexpr bool refuse_mirrors = false;
        TopoDS_Shape face = made.Face().Oriented(m_input.reversed ? TopAbs_REVERSED : TopAbs_FORWARD);
        face.Location(m_input.location, refuse_mirrors);
        return TopoDS::Face(face);
    }

    const InputFace &m_input;
    bool m_along_u;
    double m_low;
    double m_high;
};

//! The middle of the widest part of the turn that nothing takes; empty where the seam, at 0, is in nothing's way, or where all
//! is taken.
std::optional<double> better_place(const std::vector<std::pair<double, double>> &taken)
{
    std::vector<std::pair<double, double>> parts;
    bool in_the_way = false;
    for (const auto &[low, high] : taken)
    {
        in_the_way = in_the_way || low <= 0.0 || high >= 1.0;
        for (const double turn : {-1.0, 0.0, 1.0})
            parts.emplace_back(low + turn, high + turn);
    }
    if (!in_the_way)
        return std::nullopt;
    std::sort(parts.begin(), parts.end());
    double reached = parts.front().second;
    double widest = least_gap;
    std::optional<double> place;
    for (const auto &[low, high] : parts)
    {
        if (low - reached > widest && reached > -1.0 && low < 2.0)
        {
            widest = low - reached;
            place = 0.5 * (low + reached);
        }
        reached = std::max(reached, high);
    }
    if (place)
        *place -= std::floor(*place);
    return place;
}

} // namespace

bool has_seam(const InputFace &input)
{
    for (const TrimmingLoop &loop : input.loops)
        for (const TrimmingCurve &curve : loop.curves)
            if (curve.seam)
                return true;
    return false;
}

std::optional<TopoDS_Face> with_moved_seam(const InputFace &input, const std::vector<TopoDS_Shape> &images,
                                           double clearance)
{
    if (input.base_distance != 0.0)
        return std::nullopt;
    for (const bool along_u : {true, false})
    {
        const RoundDirection direction(input, along_u);
        if (!direction.whole_band())
            continue;
        if (const std::optional<double> place = better_place(direction.taken(images, clearance)))
            return direction.beginning_at(*place);
    }
    return std::nullopt;
}

} // namespace laminate_offset
