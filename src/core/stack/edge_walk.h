// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Places along the cut edges of a ply, and where a ramp goes from there.
#pragma once

#include "ply_region.h"

#include "../analysis/base_surface.h"

#include <optional>
#include <utility>
#include <vector>

namespace laminate_offset
{

//! A place on a ply's edge, and where the ramp goes from there.
struct EdgeSample
{
    Eigen::Vector2d uv;
    Eigen::Vector3d point;
    Eigen::Vector2d reach;   //!< the ramp's end less uv
    Eigen::Vector2d density; //!< knots per unit of u and of v that the ramp needs here
};

//! Walks along a ply's cut edges.
class EdgeWalk
{
public:
    //! \param length of the ramp beside the edges [mm], above zero.
    EdgeWalk(const BaseSurface &base, const PlyRegion &region, double length);

    //! Samples that follow each other; corners are runs of their own.
    [[nodiscard]] const std::vector<std::vector<EdgeSample>> &runs() const { return m_runs; }

private:
    struct End
    {
        Eigen::Vector2d uv;
        SurfaceJet jet;
        Eigen::Vector3d outward;
    };

    [[nodiscard]] std::optional<End> at(const TrimmingCurve &curve, double t) const;
    void walk(const TrimmingCurve &curve);
    [[nodiscard]] int sample_count(const TrimmingCurve &curve) const;
    void stretch(EdgeSample &sample) const;
    void turn(const End &from, const End &to);

    const BaseSurface &m_base;
    double m_length;
    std::vector<std::vector<EdgeSample>> m_runs;
    std::vector<std::pair<End, End>> m_ends; //!< of each edge, in the loop's direction
};

//! A curve's length on the surface, roughly [mm].
double length_on(const BaseSurface &base, const TrimmingCurve &curve);

} // namespace laminate_offset
