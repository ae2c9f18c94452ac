// SPDX-License-Identifier: LGPL-2.1-or-later
#include "profile_spline.h"

#include "../spline/geom_values.h"

#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfReal.hxx>

#include <cmath>
#include <tuple>

namespace laminate_offset
{
namespace
{

Eigen::Vector4d homogeneous(const Eigen::Vector3d &p) { return {p.x(), p.y(), p.z(), 1.0}; }

Handle(Geom_BSplineCurve) as_spline(const Handle(Geom_Curve) & curve)
{
    if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve))
        return Handle(Geom_BSplineCurve)::DownCast(spline->Copy());
    if (const auto bezier = Handle(Geom_BezierCurve)::DownCast(curve))
        return GeomConvert::CurveToBSplineCurve(bezier);
    return {};
}

ProfileSpline from_spline(Geom_BSplineCurve &curve, double low, double high)
{
    if (curve.IsPeriodic())
        std::tie(low, high) = period_cut(low, high, curve.FirstParameter(), curve.LastParameter());
    if (low > curve.FirstParameter() || high < curve.LastParameter() || curve.IsPeriodic())
        curve.Segment(low, high);
    if (curve.IsPeriodic())
        curve.SetNotPeriodic();
    if (curve.Multiplicity(1) <= curve.Degree() || curve.Multiplicity(curve.NbKnots()) <= curve.Degree())
        curve.Segment(curve.FirstParameter(), curve.LastParameter());
    ProfileSpline profile;
    profile.knots.degree = curve.Degree();
    const TColStd_Array1OfReal &sequence = curve.KnotSequence();
    for (int i = sequence.Lower(); i <= sequence.Upper(); ++i)
        profile.knots.knots.push_back(sequence(i));
    realign(profile.knots, low, high);
    profile.rational = curve.IsRational();
    for (int i = 1; i <= curve.NbPoles(); ++i)
    {
        const double w = profile.rational ? curve.Weight(i) : 1.0;
        profile.poles.push_back(w * homogeneous(vector(curve.Pole(i).XYZ())));
    }
    return profile;
}

//! A curve of degree 1 or 2 in its own parameter.
ProfileSpline from_polynomial(const Geom_Curve &curve, int degree, double low, double high)
{
    ProfileSpline profile;
    profile.knots = clamped_knots(degree, low, high, {});
    const Eigen::Vector3d first = vector(curve.Value(low).XYZ());
    profile.poles.push_back(homogeneous(first));
    if (degree == 2)
        profile.poles.push_back(homogeneous(first + 0.5 * (high - low) * vector(curve.DN(low, 1).XYZ())));
    profile.poles.push_back(homogeneous(vector(curve.Value(high).XYZ())));
    return profile;
}

ConicFrame frame(ConicKind kind, const Geom_Conic &conic, double major, double minor)
{
    const gp_Ax2 &position = conic.Position();
    return {kind, vector(position.Location().XYZ()), major * vector(position.XDirection().XYZ()),
            minor * vector(position.YDirection().XYZ())};
}

std::optional<ConicFrame> conic_frame(const Handle(Geom_Curve) & curve)
{
    if (const auto circle = Handle(Geom_Circle)::DownCast(curve))
        return frame(ConicKind::Circle, *circle, circle->Radius(), circle->Radius());
    if (const auto ellipse = Handle(Geom_Ellipse)::DownCast(curve))
        return frame(ConicKind::Circle, *ellipse, ellipse->MajorRadius(), ellipse->MinorRadius());
    if (const auto hyperbola = Handle(Geom_Hyperbola)::DownCast(curve))
        return frame(ConicKind::Hyperbola, *hyperbola, hyperbola->MajorRadius(), hyperbola->MinorRadius());
    return std::nullopt;
}

} // namespace

std::optional<ProfileSpline> profile_spline(const Handle(Geom_Curve) & profile, double low, double high,
                                            const std::function<ConicErrors(const ConicFrame &)> &wanted)
{
    Handle(Geom_Curve) curve = profile;
    while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve))
        curve = trimmed->BasisCurve();
    if (const Handle(Geom_BSplineCurve) spline = as_spline(curve); !spline.IsNull())
        return from_spline(*spline, low, high);
    if (curve->IsKind(STANDARD_TYPE(Geom_Line)))
        return from_polynomial(*curve, 1, low, high);
    if (curve->IsKind(STANDARD_TYPE(Geom_Parabola)))
        return from_polynomial(*curve, 2, low, high);
    const std::optional<ConicFrame> conic = conic_frame(curve);
    if (!conic)
        return std::nullopt;
    const std::optional<ConicSpline> functions = conic_spline(conic->kind, low, high, wanted(*conic));
    if (!functions)
        return std::nullopt;
    ProfileSpline result;
    result.knots = functions->knots;
    result.conic = conic;
    result.errors = functions->errors;
    for (const Eigen::Vector2d &e : functions->poles)
        result.poles.push_back(homogeneous(conic->centre + e.x() * conic->x + e.y() * conic->y));
    return result;
}

} // namespace laminate_offset
