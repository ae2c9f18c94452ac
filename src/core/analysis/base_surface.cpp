// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base_surface.h"

#include "swept_model.h"

#include "../spline/geom_values.h"
#include "../spline/undo_rounding.h"

#include <GeomAbs_Shape.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <gp_Lin.hxx>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <tuple>

namespace laminate_offset
{
namespace
{

// Sine of the angle between S_u and S_v (and relative length of either) below which a place counts as
// singular: far above the rounding of a cross product, far below the shear of any real surface.
constexpr double singular_sine = 1e-9;

// The limit of the normal at a singular place is accepted when two nested probes agree to this angle [rad].
constexpr double limit_agreement = 1e-4;

Handle(Geom_BSplineSurface) restricted(const Handle(Geom_BSplineSurface) & surface, ParameterBox box)
{
    Handle(Geom_BSplineSurface) copy = Handle(Geom_BSplineSurface)::DownCast(surface->Copy());
    double u0, u1, v0, v1;
    copy->Bounds(u0, u1, v0, v1);
    if (copy->IsUPeriodic())
        std::tie(box.umin, box.umax) = period_cut(box.umin, box.umax, u0, u1);
    if (copy->IsVPeriodic())
        std::tie(box.vmin, box.vmax) = period_cut(box.vmin, box.vmax, v0, v1);
    const bool whole = box.umin <= u0 && box.umax >= u1 && box.vmin <= v0 && box.vmax >= v1;
    const bool outside = box.umin < u0 || box.umax > u1 || box.vmin < v0 || box.vmax > v1;
    const bool wraps = outside && (copy->IsUPeriodic() || copy->IsVPeriodic());
    if (!whole || wraps)
        copy->Segment(box.umin, box.umax, box.vmin, box.vmax);
    return copy;
}

bool keeps_parameters(const Handle(Geom_Curve) & profile)
{
    Handle(Geom_Curve) curve = profile;
    while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve))
        curve = trimmed->BasisCurve();
    return curve->IsKind(STANDARD_TYPE(Geom_BSplineCurve)) || curve->IsKind(STANDARD_TYPE(Geom_BezierCurve)) ||
           curve->IsKind(STANDARD_TYPE(Geom_Line));
}

//! The surface as a B-spline in its own parameters, or null where the conversion would change them.
Handle(Geom_BSplineSurface) same_parameter_spline(const Handle(Geom_Surface) & surface, const ParameterBox &box)
{
    if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface))
        return restricted(spline, box);
    if (const auto bezier = Handle(Geom_BezierSurface)::DownCast(surface))
        return restricted(GeomConvert::SurfaceToBSplineSurface(bezier), box);
    const auto extrusion = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface);
    if (extrusion.IsNull() || !keeps_parameters(extrusion->BasisCurve()))
        return {};
    return GeomConvert::SurfaceToBSplineSurface(
        new Geom_RectangularTrimmedSurface(extrusion, box.umin, box.umax, box.vmin, box.vmax));
}

//! Interval ends by class of continuity, as OpenCASCADE reports them: C0 first, so that the lowest
//! class that a parameter breaks is the one that is kept.
template <typename Count, typename Fill>
std::vector<SmoothnessBreak> geom_breaks(double low, double high, const Count &count, const Fill &fill)
{
    std::vector<SmoothnessBreak> breaks;
    const std::pair<GeomAbs_Shape, int> classes[] = {{GeomAbs_C1, 0}, {GeomAbs_C2, 1}, {GeomAbs_C3, 2}};
    for (const auto &[shape, continuity] : classes)
    {
        TColStd_Array1OfReal ends(1, count(shape) + 1);
        fill(ends, shape);
        for (int i = ends.Lower(); i <= ends.Upper(); ++i)
        {
            const double t = ends(i);
            const bool known = std::any_of(breaks.begin(), breaks.end(), [&](const SmoothnessBreak &b) {
                return std::abs(b.parameter - t) <= Precision::PConfusion();
            });
            if (t > low && t < high && !known)
                breaks.push_back({t, continuity});
        }
    }
    std::sort(breaks.begin(), breaks.end(), [](const auto &a, const auto &b) { return a.parameter < b.parameter; });
    return breaks;
}

std::vector<double> with_ends(double low, const std::vector<SmoothnessBreak> &breaks, double high)
{
    std::vector<double> ends{low};
    for (const SmoothnessBreak &b : breaks)
        ends.push_back(b.parameter);
    ends.push_back(high);
    return ends;
}

//! Is v a pole of a circle turned about an axis? Past it the surface runs back on the other side, with its normal turned
//! round.
bool is_pole(const Handle(Geom_Surface) & surface, double v)
{
    const auto revolution = Handle(Geom_SurfaceOfRevolution)::DownCast(surface);
    if (revolution.IsNull() || revolution->BasisCurve()->DynamicType() != STANDARD_TYPE(Geom_Circle))
        return false;
    return gp_Lin(revolution->Axis()).Distance(revolution->BasisCurve()->Value(v)) <= meant_on_axis;
}

//! One side of the box with its margin, inside [first, last] unless the surface goes round.
void widen(double &low, double &high, double first, double last, bool periodic)
{
    constexpr double margin = 0.01;
    const double extra = margin * (high - low);
    if (periodic)
    {
        // loops all the way round may overlap by a little (read_face): beyond a period there is nothing to add
        const double room = std::min(extra, 0.5 * (last - first - (high - low)));
        low -= room;
        high += room;
        return;
    }
    low = std::max(low - extra, first);
    high = std::min(high + extra, last);
    // nearly the whole domain: take all of it, which spares inserting a knot beside the end
    if (low - first < 2.0 * extra)
        low = first;
    if (last - high < 2.0 * extra)
        high = last;
}

} // namespace

std::vector<SmoothnessBreak> spline_breaks(const KnotVector &kv)
{
    std::vector<SmoothnessBreak> breaks;
    for (const Knot &knot : kv.distinct())
        if (knot.parameter > kv.front() && knot.parameter < kv.back())
            breaks.push_back({knot.parameter, std::max(0, kv.degree - knot.multiplicity)});
    return breaks;
}

double ModelError::of_offset(double distance) const { return point + std::abs(distance) * normal; }

BaseSurface::BaseSurface(const Handle(Geom_Surface) & surface, const ParameterBox &box,
                         const std::optional<ModelDemand> &demand)
    : m_surface(surface), m_box(box)
{
    if (const Handle(Geom_BSplineSurface) spline = same_parameter_spline(surface, box); !spline.IsNull())
    {
        m_spline = from_geom(spline);
        if (surface->IsUPeriodic())
            realign(m_spline->u, box.umin, box.umax);
        if (surface->IsVPeriodic())
            realign(m_spline->v, box.vmin, box.vmax);
        if (demand)
        {
            const UndoneRounding undone = undo_rounding(*m_spline, demand->distance, demand->tolerance);
            m_model_error.point = undone.moved;
            m_rounding = undone.operations;
        }
        m_box = {m_spline->u.front(), m_spline->u.back(), m_spline->v.front(), m_spline->v.back()};
        m_breaks_u = spline_breaks(m_spline->u);
        m_breaks_v = spline_breaks(m_spline->v);
        return;
    }
    if (std::optional<SweptModel> model = demand ? swept_model(surface, box, *demand) : std::nullopt)
    {
        m_spline = std::move(model->spline);
        m_model_error = model->error;
        m_strip = std::move(model->strip);
        m_box = {m_spline->u.front(), m_spline->u.back(), m_spline->v.front(), m_spline->v.back()};
        m_breaks_u = std::move(model->breaks_u);
        m_breaks_v = std::move(model->breaks_v);
        return;
    }
    const GeomAdaptor_Surface adaptor(surface, box.umin, box.umax, box.vmin, box.vmax);
    m_breaks_u = geom_breaks(
        box.umin, box.umax, [&](GeomAbs_Shape s) { return adaptor.NbUIntervals(s); },
        [&](TColStd_Array1OfReal &ends, GeomAbs_Shape s) { adaptor.UIntervals(ends, s); });
    m_breaks_v = geom_breaks(
        box.vmin, box.vmax, [&](GeomAbs_Shape s) { return adaptor.NbVIntervals(s); },
        [&](TColStd_Array1OfReal &ends, GeomAbs_Shape s) { adaptor.VIntervals(ends, s); });
}

void BaseSurface::adopt_model(TensorSpline model, const ModelError &error)
{
    m_model_error.point += error.point;
    m_model_error.normal += error.normal;
    m_model_error.curvature += error.curvature;
    m_rounding = 0.0;
    m_breaks_u = spline_breaks(model.u);
    m_breaks_v = spline_breaks(model.v);
    m_spline = std::move(model);
}

std::vector<double> BaseSurface::interval_ends_u() const { return with_ends(m_box.umin, m_breaks_u, m_box.umax); }

std::vector<double> BaseSurface::interval_ends_v() const { return with_ends(m_box.vmin, m_breaks_v, m_box.vmax); }

std::vector<SurfaceJet> BaseSurface::jets(const std::vector<double> &us, const std::vector<double> &vs, int order) const
{
    if (m_spline)
        return m_spline->jets(us, vs, order);
    std::vector<SurfaceJet> result(us.size() * vs.size());
    std::size_t index = 0;
    for (const double u : us)
        for (const double v : vs)
        {
            SurfaceJet &jet = result[index++];
            gp_Pnt s;
            gp_Vec du, dv, duu, dvv, duv;
            if (order < 2)
                m_surface->D1(u, v, s, du, dv);
            else
                m_surface->D2(u, v, s, du, dv, duu, dvv, duv);
            jet = {vector(s.XYZ()),   vector(du.XYZ()),  vector(dv.XYZ()),
                   vector(duu.XYZ()), vector(duv.XYZ()), vector(dvv.XYZ())};
        }
    return result;
}

std::optional<Eigen::Vector3d> BaseSurface::unit_normal(const SurfaceJet &jet, double u, double v) const
{
    const Eigen::Vector3d normal = jet.u.cross(jet.v);
    const double length = normal.norm();
    const double lu = jet.u.norm() * (m_box.umax - m_box.umin);
    const double lv = jet.v.norm() * (m_box.vmax - m_box.vmin);
    const double longest = std::max(lu, lv);
    const double product = jet.u.norm() * jet.v.norm();
    if (length > singular_sine * product && std::min(lu, lv) > singular_sine * longest)
        return normal / length;
    return limit_normal(u, v);
}

std::optional<Eigen::Vector3d> BaseSurface::limit_normal(double u, double v) const
{
    const double wu = m_box.umax - m_box.umin;
    const double wv = m_box.vmax - m_box.vmin;
    const double tu = u - m_box.umin < m_box.umax - u ? 1.0 : -1.0;
    const double tv = v - m_box.vmin < m_box.vmax - v ? 1.0 : -1.0;
    const auto probe = [&](double step) -> std::optional<Eigen::Vector3d> {
        const std::vector<double> pu{u + tu * step * wu};
        const std::vector<double> pv{v + tv * step * wv};
        const SurfaceJet jet = jets(pu, pv, 1).front();
        const Eigen::Vector3d normal = jet.u.cross(jet.v);
        if (!(normal.norm() > 0.0))
            return std::nullopt;
        return normal.normalized();
    };
    for (const double step : {1e-6, 1e-5, 1e-4}) // nearer to a cusp there is but rounding
    {
        const std::optional<Eigen::Vector3d> near = probe(step);
        const std::optional<Eigen::Vector3d> far = probe(2.0 * step);
        if (near && far && near->cross(*far).norm() <= limit_agreement && near->dot(*far) > 0.0)
            return (2.0 * *near - *far).normalized(); // extrapolated linearly to the place itself
    }
    return std::nullopt;
}

std::vector<Eigen::Vector3d> BaseSurface::offset_grid(const std::vector<double> &us, const std::vector<double> &vs,
                                                      double distance, std::optional<gp_Pnt2d> &singular) const
{
    const std::vector<SurfaceJet> all = jets(us, vs, 1);
    std::vector<Eigen::Vector3d> points(all.size());
    std::atomic<std::ptrdiff_t> bad{-1};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, all.size(), 4096), [&](const auto &range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
        {
            const auto normal = unit_normal(all[i], us[i / vs.size()], vs[i % vs.size()]);
            if (normal)
                points[i] = all[i].s + distance * *normal;
            else
                bad = static_cast<std::ptrdiff_t>(i);
        }
    });
    if (bad < 0)
        return points;
    const std::size_t i = static_cast<std::size_t>(bad);
    singular = gp_Pnt2d(us[i / vs.size()], vs[i % vs.size()]);
    return {};
}

ParameterBox fit_box(const InputFace &input)
{
    ParameterBox box = input.box;
    double u0, u1, v0, v1;
    input.surface->Bounds(u0, u1, v0, v1);
    widen(box.umin, box.umax, u0, u1, input.surface->IsUPeriodic());
    widen(box.vmin, box.vmax, v0, v1, input.surface->IsVPeriodic());
    if (is_pole(input.surface, input.box.vmin))
        box.vmin = input.box.vmin;
    if (is_pole(input.surface, input.box.vmax))
        box.vmax = input.box.vmax;
    return box;
}

} // namespace laminate_offset
