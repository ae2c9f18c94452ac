// SPDX-License-Identifier: LGPL-2.1-or-later
#include "edge_images.h"

#include <utility>

namespace laminate_offset
{

EdgeImages::EdgeImages(NearestSearch search, const Handle(Geom_Surface) & surface, const ParameterBox &box, double size)
    : m_search(std::move(search)), m_surface(surface), m_box(box), m_size(size)
{
}

std::optional<EdgeImages> EdgeImages::make(const Handle(Geom_Surface) & surface, const ParameterBox &box, double size)
{
    std::optional<ExactSpline> spline = exact_spline(surface, box);
    if (!spline)
        return std::nullopt;
    return EdgeImages(NearestSearch(std::move(*spline)), surface, box, size);
}

Handle(Geom2d_Curve) EdgeImages::image(const SpaceCurve &curve, double accuracy) const
{
    return dropped_pcurve({m_search, m_surface, m_box, m_surface, nullptr, 0.0, m_size}, curve, accuracy);
}

} // namespace laminate_offset
