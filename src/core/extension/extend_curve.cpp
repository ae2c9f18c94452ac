// SPDX-License-Identifier: LGPL-2.1-or-later
#include "extend_curve.h"

#include "length_search.h"
#include "pole_lines.h"

#include <Precision.hxx>
#include <fmt/format.h>
#include <gp_Vec.hxx>

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

// Poles may move by so much of the curve's extent when a knot at the join is taken out: rounding only.
constexpr double removal_share = 1e-13;

Failure refusal(Status status, std::string message)
{
    return {status, Stage::Extension, std::move(message), std::nullopt, std::nullopt};
}

PoleLines lines_of_curve(const Handle(Geom_BSplineCurve) & curve)
{
    PoleLines lines;
    lines.rational = curve->IsRational();
    lines.knots.degree = curve->Degree();
    lines.lines.resize(1);
    for (int i = 1; i <= curve->NbKnots(); ++i)
    {
        const bool end = i == 1 || i == curve->NbKnots();
        const int count = end ? curve->Degree() + 1 : curve->Multiplicity(i);
        lines.knots.knots.insert(lines.knots.knots.end(), static_cast<std::size_t>(count), curve->Knot(i));
    }
    for (int i = 1; i <= curve->NbPoles(); ++i)
    {
        const gp_Pnt p = curve->Pole(i);
        const double w = curve->Weight(i);
        lines.lines[0].emplace_back(w * p.X(), w * p.Y(), w * p.Z(), w);
    }
    return lines;
}

Handle(Geom_BSplineCurve) curve_of(const PoleLines &lines)
{
    const PoleLine &line = lines.lines.front();
    const std::vector<Knot> distinct = lines.knots.distinct();
    TColgp_Array1OfPnt poles(1, static_cast<int>(line.size()));
    TColStd_Array1OfReal weights(1, static_cast<int>(line.size()));
    TColStd_Array1OfReal knots(1, static_cast<int>(distinct.size()));
    TColStd_Array1OfInteger multiplicities(1, static_cast<int>(distinct.size()));
    for (int i = 1; i <= poles.Length(); ++i)
    {
        const Eigen::Vector4d &p = line[static_cast<std::size_t>(i) - 1];
        poles(i).SetCoord(p.x() / p.w(), p.y() / p.w(), p.z() / p.w());
        weights(i) = p.w();
    }
    for (int i = 1; i <= knots.Length(); ++i)
    {
        knots(i) = distinct[static_cast<std::size_t>(i) - 1].parameter;
        multiplicities(i) = distinct[static_cast<std::size_t>(i) - 1].multiplicity;
    }
    if (!lines.rational)
        return new Geom_BSplineCurve(poles, knots, multiplicities, lines.knots.degree);
    return new Geom_BSplineCurve(poles, weights, knots, multiplicities, lines.knots.degree);
}

//! Eq. 3.5 to 3.8: a straight piece with the last pole's weight, of the curve's own degree.
PoleLines straight_to(const PoleLines &lines, double increment, double length)
{
    PoleLines result = lines; // eq. 3.5
    PoleLine &line = result.lines.front();
    const int p = lines.knots.degree;
    const Eigen::Vector4d last = line.back();
    const Eigen::Vector3d end = last.head<3>() / last.w();
    const Eigen::Vector3d leg = end - line[line.size() - 2].head<3>() / line[line.size() - 2].w();
    Eigen::Vector4d far;
    far << last.w() * (end + length * leg.normalized()), last.w(); // eq. 3.6
    for (int i = 1; i <= p; ++i)                                   // eq. 3.7
        line.emplace_back((1.0 - static_cast<double>(i) / p) * last + (static_cast<double>(i) / p) * far);
    auto &knots = result.knots.knots; // eq. 3.8
    const double b = knots.back();
    knots.pop_back();
    knots.insert(knots.end(), static_cast<std::size_t>(p) + 1, b + increment);
    return result;
}

double length_past(const Handle(Geom_BSplineCurve) & curve, double join)
{
    std::vector<double> breaks{join};
    for (int i = 1; i <= curve->NbKnots(); ++i)
        if (curve->Knot(i) > join)
            breaks.push_back(curve->Knot(i));
    return arc_length([&](double t) { return curve->DN(t, 1).Magnitude(); }, breaks);
}

double extent_of(const PoleLines &lines)
{
    double extent = 0.0;
    for (const Eigen::Vector4d &pole : lines.lines.front())
        extent = std::max(extent, (pole.head<3>() / pole.w()).norm());
    return extent;
}

void take_out_join(const Handle(Geom_BSplineCurve) & curve, double join, double extent)
{
    for (int i = 2; i < curve->NbKnots(); ++i)
        if (curve->Knot(i) == join)
        {
            for (int left = curve->Multiplicity(i) - 1; left >= 0; --left)
                if (!curve->RemoveKnot(i, left, removal_share * extent))
                    return;
            return;
        }
}

Result<Handle(Geom_BSplineCurve)> extended_end(const Handle(Geom_BSplineCurve) & curve, const PoleLines &lines,
                                               double length, CurveExtension kind)
{
    const double b = lines.knots.back();
    const double increment = straight_increment(*curve, b, length);
    if (!std::isfinite(increment))
        return refusal(Status::SingularNormal, "The curve stands still at its end and has no tangent there; trim it a "
                                               "little before that end first.");
    std::optional<PoleLines> result;
    if (kind == CurveExtension::Straight)
        result = straight_to(lines, increment, length);
    else
    {
        const auto longer = [&](double more) {
            return kind == CurveExtension::Mirrored ? mirrored_to(lines, b + more) : continued_to(lines, b + more);
        };
        const auto length_of = [&](double more) -> std::optional<double> {
            const std::optional<PoleLines> made = longer(more);
            return made ? std::optional(length_past(curve_of(*made), b)) : std::nullopt;
        };
        const double most = longest_extension * (b - lines.knots.front());
        const std::optional<double> found = increment_for(length_of, length, increment, most);
        if (found)
            result = longer(*found);
    }
    if (!result)
        return refusal(Status::NotSupported,
                       fmt::format("The curve cannot be continued by {:.6g} mm in this way; ask for less, or for a "
                                   "straight extension.",
                                   length));
    const Handle(Geom_BSplineCurve) made = curve_of(*result);
    take_out_join(made, b, extent_of(*result));
    return made;
}

} // namespace

double straight_increment(const Geom_Curve &curve, double end_parameter, double length)
{
    const double speed = curve.DN(end_parameter, 1).Magnitude();
    return speed > 0.0 ? length / speed : std::numeric_limits<double>::infinity();
}

Result<Handle(Geom_BSplineCurve)> extend_curve(const Handle(Geom_BSplineCurve) & curve, double length, bool at_end,
                                               CurveExtension kind)
{
    if (!std::isfinite(length) || length <= 0.0)
        return refusal(Status::InvalidOption, "The length of the extension must be finite and above zero.");
    if (curve->IsClosed() || curve->IsPeriodic())
        return refusal(Status::SelfIntersection,
                       "The curve is closed, so that its extension would run over its own start; cut it open first.");
    Handle(Geom_BSplineCurve) clamped = Handle(Geom_BSplineCurve)::DownCast(curve->Copy());
    clamped->Segment(curve->FirstParameter(), curve->LastParameter());
    const PoleLines lines = lines_of_curve(clamped);
    if (at_end)
        return extended_end(clamped, lines, length, kind);
    const PoleLines back = turned(lines);
    const Result<Handle(Geom_BSplineCurve)> made = extended_end(curve_of(back), back, length, kind);
    if (!made)
        return made;
    return curve_of(turned(lines_of_curve(made.value())));
}

} // namespace laminate_offset
