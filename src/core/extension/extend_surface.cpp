// SPDX-License-Identifier: LGPL-2.1-or-later
#include "extend_surface.h"

#include "../spline/geom_values.h"
#include "extend_curve.h"
#include "extension_check.h"
#include "length_search.h"
#include "pole_lines.h"

#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_SweptSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace laminate_offset
{
namespace
{

// The paper retrieves eight iso-curves.
constexpr int iso_curves = 8;
// Places along a side at which the join and the side itself are looked at.
constexpr int side_samples = 33;
// Poles may move by so much of the surface's extent when a knot at the join is taken out: rounding only.
constexpr double removal_share = 1e-13;
// A side, or a tangent across it, shorter than this part of the face's size has no direction.
constexpr double point_share = 1e-9;

bool along_u(Side side) { return side == Side::UMin || side == Side::UMax; }
bool at_end(Side side) { return side == Side::UMax || side == Side::VMax; }

double &end_of(ParameterBox &box, Side side)
{
    switch (side)
    {
    case Side::UMin: return box.umin;
    case Side::UMax: return box.umax;
    case Side::VMin: return box.vmin;
    default: return box.vmax;
    }
}

double end_of(const ParameterBox &box, Side side)
{
    ParameterBox copy = box;
    return end_of(copy, side);
}

Side opposite(Side side)
{
    switch (side)
    {
    case Side::UMin: return Side::UMax;
    case Side::UMax: return Side::UMin;
    case Side::VMin: return Side::VMax;
    default: return Side::VMin;
    }
}

//! The derivative across a side.
gp_Vec across(const Geom_Surface &surface, Side side, double t, double other)
{
    gp_Pnt point;
    gp_Vec du, dv;
    along_u(side) ? surface.D1(t, other, point, du, dv) : surface.D1(other, t, point, du, dv);
    return along_u(side) ? du : dv;
}

//! `count` parameters with equal spacing along a side of the rectangle, its ends included.
std::vector<double> along_side(const ParameterBox &box, Side side, int count)
{
    const double low = along_u(side) ? box.vmin : box.umin;
    const double high = along_u(side) ? box.vmax : box.umax;
    std::vector<double> result;
    for (int k = 0; k < count; ++k)
        result.push_back(low + (high - low) * k / (count - 1));
    return result;
}

gp_Pnt2d place_at(Side side, double t, double other) { return along_u(side) ? gp_Pnt2d(t, other) : gp_Pnt2d(other, t); }

gp_Pnt point_at(const Geom_Surface &surface, const gp_Pnt2d &uv) { return surface.Value(uv.X(), uv.Y()); }

// Loops may hang over the ends of the surface's domain by what their pcurves miss them, as part of the domain.
constexpr double most_overhang = 1e-3;

//! A place of the loops that leaves the domain by more than that. The loops' box would not do: it holds control points.
std::optional<gp_Pnt2d> place_outside(const InputFace &input, const Geom_Surface &surface)
{
    double u0, u1, v0, v1;
    surface.Bounds(u0, u1, v0, v1);
    const auto outside = [](double x, double first, double last, bool periodic) {
        return !periodic && std::max(first - x, x - last) > most_overhang * (last - first);
    };
    for (const TrimmingLoop &loop : input.loops)
        for (const TrimmingCurve &curve : loop.curves)
            for (const PcurvePiece &piece : curve.pieces)
                if (outside(piece.start.X(), u0, u1, surface.IsUPeriodic()) ||
                    outside(piece.start.Y(), v0, v1, surface.IsVPeriodic()))
                    return piece.start;
    return std::nullopt;
}

//! The rectangle inside of the surface's own domain.
ParameterBox inside(const Geom_Surface &surface, ParameterBox box)
{
    double u0, u1, v0, v1;
    surface.Bounds(u0, u1, v0, v1);
    if (!surface.IsUPeriodic())
    {
        box.umin = std::max(box.umin, u0);
        box.umax = std::min(box.umax, u1);
    }
    if (!surface.IsVPeriodic())
    {
        box.vmin = std::max(box.vmin, v0);
        box.vmax = std::min(box.vmax, v1);
    }
    return box;
}

//! The spline in the parameters of the rectangle: a periodic one is cut to it.
TensorSpline spline_over(const Handle(Geom_BSplineSurface) & surface, const ParameterBox &box)
{
    const Handle(Geom_BSplineSurface) copy = Handle(Geom_BSplineSurface)::DownCast(surface->Copy());
    if (!copy->IsUPeriodic() && !copy->IsVPeriodic())
        return from_geom(copy);
    double u0, u1, v0, v1;
    copy->Bounds(u0, u1, v0, v1);
    if (copy->IsUPeriodic())
        std::tie(u0, u1) = period_cut(box.umin, box.umax, u0, u1);
    if (copy->IsVPeriodic())
        std::tie(v0, v1) = period_cut(box.vmin, box.vmax, v0, v1);
    copy->Segment(u0, u1, v0, v1);
    TensorSpline spline = from_geom(copy);
    realign(spline.u, u0, u1);
    realign(spline.v, v0, v1);
    return spline;
}

double extent_of(const TensorSpline &spline)
{
    double extent = 0.0;
    for (const Eigen::Vector4d &pole : spline.poles)
        extent = std::max(extent, (pole.head<3>() / pole.w()).norm());
    return extent;
}

//! Takes the knot at the join out as often as the surface does not need it. For polynomial lines that is at least
//! once, since mirrored ones meet C1.
void take_out_join(const Handle(Geom_BSplineSurface) & surface, bool in_u, double join, double tolerance)
{
    const int count = in_u ? surface->NbUKnots() : surface->NbVKnots();
    for (int i = 2; i < count; ++i)
    {
        if ((in_u ? surface->UKnot(i) : surface->VKnot(i)) != join)
            continue;
        const int most = in_u ? surface->UMultiplicity(i) : surface->VMultiplicity(i);
        for (int left = most - 1; left >= 0; --left)
            if (!(in_u ? surface->RemoveUKnot(i, left, tolerance) : surface->RemoveVKnot(i, left, tolerance)))
                return;
        return;
    }
}

Handle(Geom_Curve) without_trims(Handle(Geom_Curve) curve)
{
    while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve))
        curve = trimmed->BasisCurve();
    return curve;
}

//! The sweep of another profile.
Handle(Geom_Surface) with_profile(const Handle(Geom_SweptSurface) & swept, const Handle(Geom_Curve) & profile)
{
    if (const auto revolved = Handle(Geom_SurfaceOfRevolution)::DownCast(swept))
        revolved->SetBasisCurve(profile);
    else
        Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(swept)->SetBasisCurve(profile);
    return Handle(Geom_Surface)(swept);
}

class SurfaceExtender
{
public:
    SurfaceExtender(const SurfaceToExtend &base, const ExtensionOptions &options)
        : m_input(base.input), m_options(options), m_surface(plain(base.surface)),
          m_base(inside(*m_surface, base.input.box)), m_box(m_base)
    {
    }

    Result<ExtendedSurface> run()
    {
        if (const auto outside = place_outside(m_input, *m_surface))
            return refusal(Status::InvalidFace,
                           "The trimming loops leave the surface's own domain, past which there is nothing to extend; "
                           "repair the face.",
                           *outside);
        for (const Side side : all_sides)
        {
            if (std::find(m_options.sides.begin(), m_options.sides.end(), side) == m_options.sides.end())
                continue;
            if (const Result<bool> done = extend(side); !done)
                return done.failure();
        }
        return ExtendedSurface{m_surface, m_box, m_sides};
    }

private:
    static Handle(Geom_Surface) plain(const Handle(Geom_Surface) & surface)
    {
        if (!Handle(Geom_BezierSurface)::DownCast(surface).IsNull())
            return GeomConvert::SurfaceToBSplineSurface(surface);
        const Handle(Geom_SweptSurface) swept = Handle(Geom_SweptSurface)::DownCast(surface->Copy());
        if (!swept.IsNull())
            return with_profile(swept, without_trims(swept->BasisCurve()));
        return surface;
    }

    [[nodiscard]] Failure refusal(Status status, std::string message, const gp_Pnt2d &uv) const
    {
        const ParameterBox &box = m_input.box;
        const gp_Pnt2d on_face(std::clamp(uv.X(), box.umin, box.umax), std::clamp(uv.Y(), box.vmin, box.vmax));
        return {status, Stage::Extension, std::move(message), m_input.place(on_face), std::nullopt};
    }

    [[nodiscard]] gp_Pnt2d middle_of(Side side) const
    {
        return place_at(side, end_of(m_box, side), along_side(m_base, side, 3)[1]);
    }

    Result<bool> extend(Side side)
    {
        if (const Result<bool> open = check_side(side); !open)
            return open;
        const ParameterBox before = m_box;
        if (const Result<bool> made = go_on(side); !made)
            return made;
        return check_extension(side, before);
    }

    Result<bool> go_on(Side side)
    {
        if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(m_surface))
            return extend_spline(side, spline);
        const auto swept = Handle(Geom_SweptSurface)::DownCast(m_surface);
        const bool revolved = !Handle(Geom_SurfaceOfRevolution)::DownCast(m_surface).IsNull();
        if (!swept.IsNull() && along_u(side) != revolved)
        {
            const Handle(Geom_Curve) profile = swept->BasisCurve();
            if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(profile))
                return extend_profile(side, spline);
            if (const auto bezier = Handle(Geom_BezierCurve)::DownCast(profile))
                return extend_profile(side, GeomConvert::CurveToBSplineCurve(bezier));
        }
        return extend_own(side);
    }

    //! The side must be a curve, and not that of the opposite side.
    Result<bool> check_side(Side side) const
    {
        const double here = end_of(m_box, side);
        const double there = end_of(m_box, opposite(side));
        const gp_Pnt start = point_at(*m_surface, place_at(side, here, along_side(m_box, side, 2)[0]));
        double width = 0.0;
        double gap = 0.0;
        for (const double other : along_side(m_box, side, side_samples))
        {
            const gp_Pnt point = point_at(*m_surface, place_at(side, here, other));
            width = std::max(width, start.Distance(point));
            gap = std::max(gap, point.Distance(point_at(*m_surface, place_at(side, there, other))));
        }
        if (width <= std::max(point_share * m_input.diagonal, Precision::Confusion()))
            return refusal(Status::SingularNormal,
                           fmt::format("The side {} is a point, past which there is no direction to extend; leave this "
                                       "side out, or trim the face clear of the point.",
                                       name(side)),
                           middle_of(side));
        if (gap <= std::max(2.0 * m_input.tolerance, Precision::Confusion()))
            return refusal(Status::SelfIntersection,
                           fmt::format("The sides {} and {} meet: the face is closed in this direction, so that an "
                                       "extension would run over the face itself; extend the other sides only.",
                                       name(side), name(opposite(side))),
                           middle_of(side));
        return true;
    }

    //! Arc lengths of the eight iso-curves from the join on.
    [[nodiscard]] std::array<double, iso_curves> lengths(const Geom_Surface &surface, Side side, double end) const
    {
        const double join = end_of(m_base, side);
        std::vector<double> breaks{std::min(join, end), std::max(join, end)};
        if (const auto *spline = dynamic_cast<const Geom_BSplineSurface *>(&surface))
        {
            const int count = along_u(side) ? spline->NbUKnots() : spline->NbVKnots();
            for (int i = 1; i <= count; ++i)
                if (const double t = along_u(side) ? spline->UKnot(i) : spline->VKnot(i);
                    t > breaks.front() && t < breaks.back())
                    breaks.insert(breaks.end() - 1, t);
        }
        const std::vector<double> others = along_side(m_base, side, iso_curves);
        std::array<double, iso_curves> result{};
        for (std::size_t k = 0; k < result.size(); ++k)
            result[k] = arc_length([&](double t) { return across(surface, side, t, others[k]).Magnitude(); }, breaks);
        return result;
    }

    [[nodiscard]] double by_rule(const std::array<double, iso_curves> &lengths) const
    {
        if (m_options.rule == LengthRule::AtLeast)
            return *std::min_element(lengths.begin(), lengths.end());
        return std::accumulate(lengths.begin(), lengths.end(), 0.0) / iso_curves;
    }

    //! The paper's parameter: the mean of the straight extensions of the eight iso-curves, eq. 3.9. Iso-curves that
    //! stand still at the side do not count.
    [[nodiscard]] std::optional<double> straight_start(Side side) const
    {
        double sum = 0.0;
        int count = 0;
        for (const double other : along_side(m_base, side, iso_curves))
        {
            const double speed = across(*m_surface, side, end_of(m_box, side), other).Magnitude();
            const double range = std::abs(end_of(m_box, side) - end_of(m_box, opposite(side)));
            if (speed * range <= point_share * m_input.diagonal)
                continue;
            sum += m_options.length / speed;
            ++count;
        }
        return count > 0 ? std::optional(sum / count) : std::nullopt;
    }

    [[nodiscard]] Failure standing_still(Side side) const
    {
        return refusal(Status::SingularNormal,
                       fmt::format("The surface has no direction across its side {}, because its derivative vanishes "
                                   "there; trim the face a little before that side.",
                                   name(side)),
                       middle_of(side));
    }

    [[nodiscard]] Failure out_of_reach(Side side) const
    {
        return refusal(Status::NotSupported,
                       fmt::format("Past the side {} the surface cannot be continued by {:.6g} mm; ask for less, or "
                                   "for the other continuity.",
                                   name(side), m_options.length),
                       middle_of(side));
    }

    void record(Side side, double end, double join_angle)
    {
        const auto own = lengths(*m_surface, side, end);
        ExtendedSide done;
        done.side = side;
        done.parameter = end;
        done.mean_length = std::accumulate(own.begin(), own.end(), 0.0) / iso_curves;
        done.shortest = *std::min_element(own.begin(), own.end());
        done.longest = *std::max_element(own.begin(), own.end());
        done.join_angle = join_angle;
        m_sides.push_back(done);
        end_of(m_box, side) = end;
    }

    Result<bool> extend_spline(Side side, const Handle(Geom_BSplineSurface) & surface)
    {
        const bool in_u = along_u(side);
        const double sign = at_end(side) ? 1.0 : -1.0;
        const TensorSpline spline = spline_over(surface, m_box);
        const KnotVector &other = in_u ? spline.v : spline.u;
        const PoleLines whole = lines_of(spline, in_u);
        const PoleLines lines = cut_at_end(at_end(side) ? whole : turned(whole), sign * end_of(m_box, side));
        // The cut is at a knot where one is near, and loops may stray past the surface's end by their tolerance.
        const double join = sign * lines.knots.back();
        end_of(m_base, side) = end_of(m_box, side) = join;
        const std::vector<FixedLine> fixed = fixed_lines(lines, other);
        const auto longer = [&](double more) -> Handle(Geom_BSplineSurface) {
            const double end = sign * join + more;
            const auto made =
                m_options.continuity == Continuity::G1 ? mirrored_to(lines, end, fixed) : continued_to(lines, end);
            return made ? to_geom(surface_of(at_end(side) ? *made : turned(*made), other, in_u)) : nullptr;
        };
        const std::optional<double> start = straight_start(side);
        if (!start)
            return standing_still(side);
        const auto length_of = [&](double more) -> std::optional<double> {
            const Handle(Geom_BSplineSurface) made = longer(more);
            return made.IsNull() ? std::nullopt : std::optional(by_rule(lengths(*made, side, join + sign * more)));
        };
        const double most = longest_extension * (lines.knots.back() - lines.knots.front());
        const std::optional<double> more = increment_for(length_of, m_options.length, *start, most);
        const Handle(Geom_BSplineSurface) made = more ? longer(*more) : nullptr;
        if (made.IsNull())
            return out_of_reach(side);
        take_out_join(made, in_u, join, removal_share * extent_of(spline));
        const Handle(Geom_Surface) before = m_surface;
        m_surface = made;
        record(side, join + sign * *more, join_angle(*before, side));
        return true;
    }

    //! The largest angle between the iso-curves' tangents before and past the join.
    [[nodiscard]] double join_angle(const Geom_Surface &before, Side side) const
    {
        double largest = 0.0;
        const double join = end_of(m_box, side);
        const auto after = from_geom(Handle(Geom_BSplineSurface)::DownCast(m_surface));
        // towards the outside: at a start the derivatives of the turned surface
        const PoleLines lines = lines_of(after, along_u(side));
        const PoleLines outer = at_end(side) ? cut_at_start(lines, join) : cut_at_end(lines, join);
        const Handle(Geom_BSplineSurface) past =
            to_geom(surface_of(outer, along_u(side) ? after.v : after.u, along_u(side)));
        for (const double other : along_side(m_base, side, side_samples))
        {
            const gp_Vec a = inner_tangent(before, side, join, other);
            const gp_Vec b = across(*past, side, join, other);
            if (a.Magnitude() > 0.0 && b.Magnitude() > 0.0)
                largest = std::max(largest, a.Angle(b));
        }
        return largest;
    }

    //! The derivative on the face's side of the join, where a spline may have a knot.
    static gp_Vec inner_tangent(const Geom_Surface &surface, Side side, double join, double other)
    {
        const auto *spline = dynamic_cast<const Geom_BSplineSurface *>(&surface);
        if (spline == nullptr)
            return across(surface, side, join, other);
        const bool in_u = along_u(side);
        int low = 0;
        int high = 0;
        in_u ? spline->LocateU(join, Precision::PConfusion(), low, high)
             : spline->LocateV(join, Precision::PConfusion(), low, high);
        if (low != high)
            return across(surface, side, join, other);
        const int count = in_u ? spline->NbUKnots() : spline->NbVKnots();
        int from = at_end(side) ? low - 1 : low;
        if (from < 1 || from >= count) // a whole turn away, on a periodic surface
        {
            from = from < 1 ? count - 1 : 1;
            const int knot = at_end(side) ? from + 1 : from;
            join = in_u ? spline->UKnot(knot) : spline->VKnot(knot);
        }
        int other_low = 0;
        int other_high = 0;
        in_u ? spline->LocateV(other, Precision::PConfusion(), other_low, other_high)
             : spline->LocateU(other, Precision::PConfusion(), other_low, other_high);
        const int last = in_u ? spline->NbVKnots() : spline->NbUKnots();
        const int other_from = std::clamp(other_low, 1, last - 1);
        return in_u ? spline->LocalDN(join, other, from, from + 1, other_from, other_from + 1, 1, 0)
                    : spline->LocalDN(other, join, other_from, other_from + 1, from, from + 1, 0, 1);
    }

    //! All iso-curves across the sweep are copies of the profile.
    Result<bool> extend_profile(Side side, const Handle(Geom_BSplineCurve) & profile)
    {
        const double join = end_of(m_box, side);
        const Handle(Geom_BSplineCurve) cut = Handle(Geom_BSplineCurve)::DownCast(profile->Copy());
        const bool whole = cut->IsPeriodic();
        const double first =
            whole || !at_end(side) ? end_of(m_box, at_end(side) ? opposite(side) : side) : cut->FirstParameter();
        const double last =
            whole || at_end(side) ? end_of(m_box, at_end(side) ? side : opposite(side)) : cut->LastParameter();
        cut->Segment(first, last);
        if (std::abs((at_end(side) ? cut->LastParameter() : cut->FirstParameter()) - join) > Precision::PConfusion())
            return out_of_reach(side);
        const CurveExtension kind =
            m_options.continuity == Continuity::G1 ? CurveExtension::Mirrored : CurveExtension::Natural;
        const Result<Handle(Geom_BSplineCurve)> made = extend_curve(cut, m_options.length, at_end(side), kind);
        if (!made)
            return refusal(made.failure().status, made.failure().message, middle_of(side));
        m_surface = with_profile(Handle(Geom_SweptSurface)::DownCast(m_surface->Copy()), made.value());
        const double end = at_end(side) ? made.value()->LastParameter() : made.value()->FirstParameter();
        const Handle(Geom_BSplineCurve) past = Handle(Geom_BSplineCurve)::DownCast(made.value()->Copy());
        past->Segment(std::min(join, end), std::max(join, end));
        record(side, end, cut->DN(join, 1).Angle(past->DN(join, 1)));
        return true;
    }

    //! The surface's own parameters go on.
    Result<bool> extend_own(Side side)
    {
        const double sign = at_end(side) ? 1.0 : -1.0;
        const double join = end_of(m_box, side);
        const std::optional<double> start = straight_start(side);
        if (!start)
            return standing_still(side);
        const auto length_of = [&](double more) {
            return std::optional(by_rule(lengths(*m_surface, side, join + sign * more)));
        };
        const std::optional<double> more = increment_for(length_of, m_options.length, *start, room(side, *start));
        if (!more)
            return no_room(side);
        record(side, join + sign * *more, 0.0);
        return true;
    }

    [[nodiscard]] bool periodic(Side side) const
    {
        return along_u(side) ? m_surface->IsUPeriodic() : m_surface->IsVPeriodic();
    }

    //! How far the surface's own parameters go past the side.
    [[nodiscard]] double room(Side side, double start) const
    {
        const double join = end_of(m_box, side);
        constexpr double no_end = 1e3; // times the straight extension
        // A surface that came all the way round would have to be closed there.
        constexpr double nearly_round = 1.0 - 1e-6;
        if (periodic(side))
            return nearly_round * (along_u(side) ? m_surface->UPeriod() : m_surface->VPeriod()) -
                   std::abs(join - end_of(m_box, opposite(side)));
        ParameterBox bounds;
        m_surface->Bounds(bounds.umin, bounds.umax, bounds.vmin, bounds.vmax);
        const double bound = end_of(bounds, side);
        return Precision::IsInfinite(bound) ? no_end * start : std::max(std::abs(bound - join), 0.0);
    }

    [[nodiscard]] Failure no_room(Side side) const
    {
        const double end = end_of(m_box, side) + (at_end(side) ? 1.0 : -1.0) * room(side, 1.0);
        const double most = by_rule(lengths(*m_surface, side, end));
        const bool round = periodic(side);
        return refusal(
            round ? Status::SelfIntersection : Status::NotSupported,
            fmt::format("Past the side {} the surface {} after {:.6g} mm, and {:.6g} mm were asked for; use a shorter "
                        "extension there.",
                        name(side), round ? "comes round to itself" : "ends", std::max(most, 0.0), m_options.length),
            middle_of(side));
    }

    Result<bool> check_extension(Side side, const ParameterBox &before) const
    {
        if (const auto fold = find_fold(*m_surface, before, m_box, side))
            return refusal(Status::SelfIntersection,
                           fmt::format("Past the side {} the extension turns over or comes to a point some {:.4g} mm "
                                       "from the reported place; use a shorter extension there.",
                                       name(side), fold->length),
                           fold->uv);
        Handle(Geom_BSplineSurface) spline = Handle(Geom_BSplineSurface)::DownCast(m_surface);
        if (spline.IsNull() && !Handle(Geom_SweptSurface)::DownCast(m_surface).IsNull())
            spline = GeomConvert::SurfaceToBSplineSurface(
                new Geom_RectangularTrimmedSurface(m_surface, m_box.umin, m_box.umax, m_box.vmin, m_box.vmax));
        if (spline.IsNull())
            return true;
        if (const auto meeting = find_meeting(from_geom(spline), own_part(*spline)))
        {
            const gp_Pnt there = point_at(*m_surface, meeting->second).Transformed(m_input.location);
            return refusal(Status::SelfIntersection,
                           fmt::format("Past the side {} the extension meets the surface itself near ({:.6g}, {:.6g}, "
                                       "{:.6g}); use a shorter extension there, or leave this side out.",
                                       name(side), there.X(), there.Y(), there.Z()),
                           meeting->first);
        }
        return true;
    }

    //! What of the surface is no extension: past the sides that stay, all of it.
    [[nodiscard]] ParameterBox own_part(const Geom_Surface &surface) const
    {
        ParameterBox part;
        surface.Bounds(part.umin, part.umax, part.vmin, part.vmax);
        for (const ExtendedSide &done : m_sides)
            end_of(part, done.side) = end_of(m_base, done.side);
        return part;
    }

    const InputFace &m_input;
    const ExtensionOptions &m_options;
    Handle(Geom_Surface) m_surface;
    ParameterBox m_base; //!< the rectangle before any extension
    ParameterBox m_box;
    std::vector<ExtendedSide> m_sides;
};

} // namespace

Result<ExtendedSurface> extend_surface(const SurfaceToExtend &base, const ExtensionOptions &options)
{
    return SurfaceExtender(base, options).run();
}

} // namespace laminate_offset
