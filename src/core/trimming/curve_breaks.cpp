// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve_breaks.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>

#include <algorithm>

namespace laminate_offset
{
namespace
{

constexpr int crossing_probes = 32;

using UvCurve = std::function<Eigen::Vector2d(double)>;

//! Knots of the pcurve with their continuity.
void add_pcurve_breaks(const CurveOnSurface &c, std::vector<DataBreak> &breaks)
{
    Handle(Geom2d_Curve) curve = c.pcurve;
    while (const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(curve))
        curve = trimmed->BasisCurve();
    const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(curve);
    if (spline.IsNull())
        return;
    for (int i = 1; i <= spline->NbKnots(); ++i)
        breaks.push_back({spline->Knot(i), std::max(0, spline->Degree() - spline->Multiplicity(i))});
}

//! Where the pcurve's coordinate takes the value `knot` between a and b, which lie on either side of it.
double crossing(const UvCurve &uv, int direction, double knot, double a, double b)
{
    const bool rising = uv(a)[direction] < knot;
    for (int k = 0; k < 60; ++k)
    {
        const double middle = 0.5 * (a + b);
        ((uv(middle)[direction] < knot) == rising ? a : b) = middle;
    }
    return 0.5 * (a + b);
}

//! Parameters at which the pcurve crosses a knot line of the surface.
void add_crossings(const UvCurve &uv, int direction, const KnotVector &kv, const std::vector<double> &probes,
                   std::vector<DataBreak> &breaks)
{
    const std::vector<Knot> knots = kv.distinct();
    double at_low = uv(probes.front())[direction];
    for (std::size_t i = 1; i < probes.size(); ++i)
    {
        const double at_high = uv(probes[i])[direction];
        const auto [low, high] = std::minmax(at_low, at_high);
        const auto first = std::upper_bound(knots.begin(), knots.end(), low,
                                            [](double value, const Knot &knot) { return value < knot.parameter; });
        for (auto knot = first; knot != knots.end() && knot->parameter < high; ++knot)
            if (knot != knots.begin() && knot + 1 != knots.end())
                breaks.push_back({crossing(uv, direction, knot->parameter, probes[i - 1], probes[i]),
                                  kv.degree - knot->multiplicity});
        at_low = at_high;
    }
}

} // namespace

std::vector<DataBreak> curve_breaks(const CurveOnSurface &c, const UvCurve &uv, const KnotVector *u,
                                    const KnotVector *v)
{
    std::vector<DataBreak> breaks;
    add_pcurve_breaks(c, breaks);
    std::vector<double> probes;
    for (int i = 0; i <= crossing_probes; ++i)
        probes.push_back(c.first + (c.last - c.first) * i / crossing_probes);
    for (const DataBreak &b : breaks)
        if (b.parameter > c.first && b.parameter < c.last)
            probes.push_back(b.parameter);
    std::sort(probes.begin(), probes.end());
    if (u)
        add_crossings(uv, 0, *u, probes, breaks);
    if (v)
        add_crossings(uv, 1, *v, probes, breaks);
    std::sort(breaks.begin(), breaks.end(), [](const auto &a, const auto &b) { return a.parameter < b.parameter; });
    std::vector<DataBreak> merged;
    const double same = 1e-7 * (c.last - c.first);
    for (const DataBreak &b : breaks)
    {
        if (b.parameter <= c.first + same || b.parameter >= c.last - same)
            continue;
        if (!merged.empty() && b.parameter - merged.back().parameter <= same)
            merged.back().continuity = std::min(merged.back().continuity, b.continuity);
        else
            merged.push_back(b);
    }
    return merged;
}

Handle(Geom_BSplineCurve) spline_curve(const KnotVector &kv, const RowMatrix &poles, const Eigen::Vector3d &origin)
{
    TColgp_Array1OfPnt points(1, static_cast<int>(poles.rows()));
    for (int i = 0; i < poles.rows(); ++i)
        points(i + 1) = gp_Pnt(origin.x() + poles(i, 0), origin.y() + poles(i, 1), origin.z() + poles(i, 2));
    const std::vector<Knot> distinct = kv.distinct();
    TColStd_Array1OfReal knots(1, static_cast<int>(distinct.size()));
    TColStd_Array1OfInteger multiplicities(1, static_cast<int>(distinct.size()));
    for (int i = 1; i <= knots.Length(); ++i)
    {
        knots(i) = distinct[static_cast<std::size_t>(i) - 1].parameter;
        multiplicities(i) = distinct[static_cast<std::size_t>(i) - 1].multiplicity;
    }
    return new Geom_BSplineCurve(points, knots, multiplicities, kv.degree);
}

} // namespace laminate_offset
