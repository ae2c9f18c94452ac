// SPDX-License-Identifier: LGPL-2.1-or-later
#include "face_nearest.h"

#include "../analysis/analytic_form.h"
#include "../analysis/base_surface.h"

#include <BRepTools.hxx>
#include <Geom_OffsetSurface.hxx>

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

Failure procedural()
{
    return {
        Status::NotSupported, Stage::Trimming,
        "Nearest points of a procedural surface (an offset of a free-form surface, a swept offset curve or hyperbola) "
        "are not available; turn the face into a spline first, for instance by its offset at the distance 0.",
        std::nullopt, std::nullopt};
}

//! Does the equivalent of an offset surface keep its parameters?
bool same_points(const InputFace &input, const Handle(Geom_Surface) & surface)
{
    constexpr int grid = 4;
    for (int i = 0; i <= grid; ++i)
        for (int j = 0; j <= grid; ++j)
        {
            const ParameterBox &box = input.box;
            const gp_Pnt2d uv(box.umin + (box.umax - box.umin) * i / grid, box.vmin + (box.vmax - box.vmin) * j / grid);
            if (surface->Value(uv.X(), uv.Y()).Distance(input.point(uv)) > 1e-12 * input.diagonal)
                return false;
        }
    return true;
}

//! Of the five kinds, also where an extrusion or a revolution is one of them.
std::optional<AnalyticNearest> closed_form(const InputFace &input, const Handle(Geom_Surface) & surface,
                                           const ParameterBox &box)
{
    if (std::optional<AnalyticNearest> result = AnalyticNearest::make(surface, box))
        return result;
    const std::optional<AnalyticForm> form = input.base_distance == 0.0 ? analytic_form(input) : std::nullopt;
    return form && form->error.point == 0.0 ? AnalyticNearest::make(form->surface, box, form->shift) : std::nullopt;
}

} // namespace

Result<Handle(Geom_Surface)> true_surface(const InputFace &input)
{
    if (input.base_distance == 0.0)
        return input.surface;
    const Handle(Geom_OffsetSurface) offset = new Geom_OffsetSurface(input.surface, input.base_distance, true);
    const Handle(Geom_Surface) equivalent = offset->Surface();
    if (equivalent.IsNull() || equivalent->IsKind(STANDARD_TYPE(Geom_OffsetSurface)) || !same_points(input, equivalent))
        return procedural();
    return equivalent;
}

ParameterBox domain_box(const InputFace &input, const Handle(Geom_Surface) & surface)
{
    ParameterBox box;
    BRepTools::UVBounds(input.face, box.umin, box.umax, box.vmin, box.vmax);
    box = {std::min(box.umin, input.box.umin), std::max(box.umax, input.box.umax), std::min(box.vmin, input.box.vmin),
           std::max(box.vmax, input.box.vmax)};
    double u0, u1, v0, v1;
    surface->Bounds(u0, u1, v0, v1);
    constexpr double near = 1e-9; // an end that all but reaches the surface's own is meant to reach it
    const auto fit = [](double &low, double &high, double first, double last) {
        const double reach = near * (high - low);
        if (low < first + reach)
            low = first;
        if (high > last - reach)
            high = last;
    };
    if (!surface->IsUPeriodic())
        fit(box.umin, box.umax, u0, u1);
    if (!surface->IsVPeriodic())
        fit(box.vmin, box.vmax, v0, v1);
    return box;
}

Result<FaceNearest> FaceNearest::make(const InputFace &input, bool trimmed)
{
    const Result<Handle(Geom_Surface)> surface = true_surface(input);
    if (!surface)
        return surface.failure();
    const ParameterBox box = domain_box(input, surface.value());
    std::optional<ExactSpline> spline = exact_spline(surface.value(), box);
    if (!spline)
        return procedural();
    FaceNearest result{NearestSearch(std::move(*spline))};
    result.m_form = closed_form(input, surface.value(), box);
    if (trimmed)
    {
        result.m_trim.emplace(Trim{LoopRegion(input), BorderSearch(input, surface.value()), {}});
        result.m_trim->touched = result.m_search.touched(result.m_trim->rule());
    }
    return result;
}

NearestSearch::Region FaceNearest::Trim::rule() const
{
    return {[this](const ParameterBox &box) { return region.may_touch(box); },
            [this](const ParameterBox &box) { return region.touches(box); },
            [this](const Eigen::Vector2d &uv) { return region.contains(gp_Pnt2d(uv.x(), uv.y())); }};
}

SurfaceFoot FaceNearest::nearest(const Eigen::Vector3d &point) const
{
    const Eigen::Vector3d centre = m_hull.center();
    const Eigen::Vector3d away = point - centre;
    const double reach = most_sizes * m_hull.diagonal().norm();
    const double largest = away.cwiseAbs().maxCoeff(); // squares may be too large for a number
    if (!(largest > reach))
        return nearest_of_near(point);
    SurfaceFoot foot = nearest_of_near(centre + reach * (away / largest).normalized());
    foot.distance = (point - foot.point).stableNorm();
    return foot;
}

SurfaceFoot FaceNearest::nearest_of_near(const Eigen::Vector3d &point) const
{
    const SurfaceFoot anywhere = m_form ? m_form->nearest(point) : m_search.nearest(point);
    if (!m_trim || m_trim->region.contains(gp_Pnt2d(anywhere.uv.x(), anywhere.uv.y())))
        return anywhere;
    return m_search.nearest(point, m_trim->border.nearest(point), m_trim->rule(), m_trim->touched);
}

} // namespace laminate_offset
