// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curvature.h"

#include "../spline/knot_choice.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace laminate_offset
{
namespace
{

constexpr int samples_per_interval = 4;
constexpr int least_samples = 48;
constexpr int samples_per_curve = 64;
constexpr int refined_places = 6;
constexpr int refinement_rounds = 24;

//! The search keeps the best few places of one sign.
class Search
{
public:
    Search(const BaseSurface &base, const LoopRegion &region, double sign) : m_base(base), m_region(region), m_sign(sign)
    {
    }

    void offer(double value, const gp_Pnt2d &uv)
    {
        if (m_places.size() == refined_places && m_sign * value <= m_sign * m_places.back().curvature)
            return;
        m_places.push_back({value, uv});
        std::sort(m_places.begin(), m_places.end(),
                  [this](const auto &a, const auto &b) { return m_sign * a.curvature > m_sign * b.curvature; });
        if (m_places.size() > refined_places)
            m_places.pop_back();
    }

    //! Compass search from every place, inside the loops, with steps that start at (du, dv).
    void refine(double du, double dv)
    {
        for (PlacedCurvature &place : m_places)
            climb(place, du, dv);
    }

    [[nodiscard]] std::optional<PlacedCurvature> best() const
    {
        const auto it = std::max_element(m_places.begin(), m_places.end(), [this](const auto &a, const auto &b) {
            return m_sign * a.curvature < m_sign * b.curvature;
        });
        return it == m_places.end() ? std::nullopt : std::optional(*it);
    }

private:
    void climb(PlacedCurvature &place, double du, double dv) const
    {
        const ParameterBox &box = m_base.box();
        for (int round = 0; round < refinement_rounds; ++round)
        {
            bool moved = false;
            for (const auto &[x, y] : {std::array{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
            {
                const gp_Pnt2d uv(std::clamp(place.uv.X() + x * du, box.umin, box.umax),
                                  std::clamp(place.uv.Y() + y * dv, box.vmin, box.vmax));
                const auto k = principal_curvatures(m_base.jets({uv.X()}, {uv.Y()}, 2).front());
                if (!k || m_sign * pick(*k) <= m_sign * place.curvature || !m_region.contains(uv))
                    continue;
                place = {pick(*k), uv};
                moved = true;
            }
            if (moved)
                continue;
            du *= 0.5;
            dv *= 0.5;
        }
    }

    [[nodiscard]] double pick(const std::pair<double, double> &k) const { return m_sign > 0 ? k.second : k.first; }

    const BaseSurface &m_base;
    const LoopRegion &m_region;
    double m_sign;
    std::vector<PlacedCurvature> m_places;
};

std::vector<double> grid_parameters(double low, double high, const std::vector<SmoothnessBreak> &breaks)
{
    std::vector<double> ends{low};
    for (const SmoothnessBreak &b : breaks)
        ends.push_back(b.parameter);
    ends.push_back(high);
    const int intervals = static_cast<int>(ends.size()) - 1;
    return chebyshev_parameters(ends, std::max(samples_per_interval, least_samples / intervals));
}

} // namespace

std::optional<std::pair<double, double>> principal_curvatures(const SurfaceJet &jet)
{
    const Eigen::Vector3d normal = jet.u.cross(jet.v);
    const double area = normal.norm();
    if (!(area > 1e-9 * jet.u.norm() * jet.v.norm()))
        return std::nullopt;
    const Eigen::Vector3d n = normal / area;
    // second fundamental form in the orthonormal frame (S_u, its normal in the tangent plane)
    const double lu = jet.u.norm();
    const double shear = jet.u.dot(jet.v) / (lu * lu);
    const double lv = area / lu;
    const double l = jet.uu.dot(n) / (lu * lu);
    const double m = (jet.uv - shear * jet.uu).dot(n) / (lu * lv);
    const double k = (jet.vv - 2.0 * shear * jet.uv + shear * shear * jet.uu).dot(n) / (lv * lv);
    const double mean = 0.5 * (l + k);
    const double spread = std::hypot(0.5 * (l - k), m);
    return std::pair{mean - spread, mean + spread};
}

CurvatureExtremes curvature_extremes(const BaseSurface &base, const InputFace &input, const LoopRegion &region)
{
    const ParameterBox &box = base.box();
    const std::vector<double> us = grid_parameters(box.umin, box.umax, base.breaks_u());
    const std::vector<double> vs = grid_parameters(box.vmin, box.vmax, base.breaks_v());
    Search lowest(base, region, -1.0);
    Search highest(base, region, 1.0);
    const auto offer = [&](const SurfaceJet &jet, const gp_Pnt2d &uv) {
        const auto k = principal_curvatures(jet);
        if (!k)
            return;
        lowest.offer(k->first, uv);
        highest.offer(k->second, uv);
    };
    const std::vector<SurfaceJet> jets = base.jets(us, vs, 2);
    for (std::size_t i = 0; i < jets.size(); ++i)
        if (const gp_Pnt2d uv(us[i / vs.size()], vs[i % vs.size()]); region.contains(uv))
            offer(jets[i], uv);
    for (const TrimmingLoop &loop : input.loops)
        for (const TrimmingCurve &curve : loop.curves)
            for (int i = 0; i <= samples_per_curve; ++i)
            {
                const double t = curve.first + (curve.last - curve.first) * i / samples_per_curve;
                const gp_Pnt2d uv = curve.pcurve->Value(t);
                offer(base.jets({uv.X()}, {uv.Y()}, 2).front(), uv);
            }
    const double du = (box.umax - box.umin) / static_cast<double>(us.size());
    const double dv = (box.vmax - box.vmin) / static_cast<double>(vs.size());
    lowest.refine(du, dv);
    highest.refine(du, dv);
    return {lowest.best(), highest.best()};
}

} // namespace laminate_offset
