// SPDX-License-Identifier: LGPL-2.1-or-later
#include "straight_pcurve.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

// A pcurve counts as straight up to this part of its size.
constexpr double straightness = 1e-9;
// The line's own rounding and that of the distances that are measured.
constexpr double operations = 32.0;

//! The parameter at which a linear function takes the value of its pole i (Greville).
double pole_parameter(const TColStd_Array1OfReal &knots, int degree, int i)
{
    double sum = 0.0;
    for (int k = 1; k <= degree; ++k)
        sum += knots(i + k);
    return sum / degree;
}

//! Largest distance of the poles from those that p + (t - first) d has over the same knots; nothing less bounds the
//! curves' distance.
double pole_deviation(const Geom2d_BSplineCurve &spline, const gp_XY &p, const gp_XY &d, double first)
{
    const TColStd_Array1OfReal &knots = spline.KnotSequence();
    double worst = 0.0;
    for (int i = 1; i <= spline.NbPoles(); ++i)
    {
        const double t = pole_parameter(knots, spline.Degree(), i);
        worst = std::max(worst, (spline.Pole(i).XY() - p - (t - first) * d).Modulus());
    }
    return worst;
}

Handle(Geom2d_Curve) segment(const gp_XY &a, const gp_XY &b, double first, double last)
{
    TColgp_Array1OfPnt2d poles(1, 2);
    poles(1) = gp_Pnt2d(a);
    poles(2) = gp_Pnt2d(b);
    TColStd_Array1OfReal knots(1, 2);
    knots(1) = first;
    knots(2) = last;
    TColStd_Array1OfInteger multiplicities(1, 2);
    multiplicities.Init(2);
    return new Geom2d_BSplineCurve(poles, knots, multiplicities, 1);
}

} // namespace

std::optional<StraightPcurve> straight_pcurve(const Handle(Geom2d_Curve) & pcurve, double first, double last)
{
    Handle(Geom2d_Curve) basis = pcurve;
    while (const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(basis))
        basis = trimmed->BasisCurve();
    const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(basis);
    if (spline.IsNull() || spline->IsRational() || spline->IsPeriodic() || !(last > first))
        return std::nullopt;
    const gp_XY a = spline->Value(first).XY();
    const gp_XY b = spline->Value(last).XY();
    const gp_XY speed = (b - a) / (last - first);
    const double size = a.Modulus() + b.Modulus();
    const double admissible = straightness * size;
    const double reach = std::max(
        {std::abs(first), std::abs(last), std::abs(spline->FirstParameter()), std::abs(spline->LastParameter())});
    const double rounding =
        operations * std::numeric_limits<double>::epsilon() * (size + 2.0 * reach * std::max(1.0, speed.Modulus()));
    if (!(speed.Modulus() > 0.0))
        return std::nullopt;
    const gp_Dir2d direction(speed);
    const gp_Pnt2d start(a - first * direction.XY());
    const double as_line = pole_deviation(*spline, start.XY() + first * direction.XY(), direction.XY(), first);
    if (as_line <= admissible)
        return StraightPcurve{new Geom2d_Line(start, direction), as_line + rounding};
    const double as_segment = pole_deviation(*spline, a, speed, first);
    if (spline->NbPoles() == 2 || !(as_segment <= admissible))
        return std::nullopt;
    return StraightPcurve{segment(a, b, first, last), as_segment + rounding};
}

} // namespace laminate_offset
