// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ply_ramp.h"

#include "edge_distance.h"
#include "ramp_knots.h"

#include "../analysis/parameter_periods.h"
#include "../input/pcurve_pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace laminate_offset
{
namespace
{

constexpr int degree = 3;
constexpr double pieces_per_ramp = 24.0;
constexpr double most_pieces = 2e4;

//! Poles from distances at the knots.
class ShareMaker
{
public:
    ShareMaker(const BaseSurface &base, const PlyRegion &region, const EdgeWalk &walk, double length,
               ScalarSpline &share)
        : m_length(length), m_share(share), m_us(share.u.breaks()), m_vs(share.v.breaks())
    {
        const LoopRegion fine = fine_region(base, region, length);
        const EdgeDistance distance(walk, length);
        const std::vector<SurfaceJet> jets = base.jets(m_us, m_vs, 0);
        for (std::size_t i = 0; i < jets.size(); ++i)
        {
            const bool inside = fine.contains(gp_Pnt2d(m_us[i / m_vs.size()], m_vs[i % m_vs.size()]));
            m_distances.push_back(inside ? 0.0 : std::min(distance(jets[i].s), 2.0 * length));
        }
        fill();
        settle(fine);
    }

private:
    [[nodiscard]] double at(std::size_t k, std::size_t l) const { return m_distances[k * m_vs.size() + l]; }

    //! Between which of the distinct knots the middle part of a pole's support lies.
    static std::pair<std::size_t, std::size_t> core(const KnotVector &kv, const std::vector<double> &breaks, int pole)
    {
        const auto place = [&](int knot) {
            return static_cast<std::size_t>(
                std::lower_bound(breaks.begin(), breaks.end(), kv.knots[static_cast<std::size_t>(knot)]) -
                breaks.begin());
        };
        return {place(pole + 1), place(pole + kv.degree)};
    }

    //! From the least and the largest distance in the middle of each pole's support: 1 where the ply reaches into it, 0
    //! where the ramp ends in it, linear between across a straight edge. The basis functions make it an S.
    void fill()
    {
        for (int i = 0; i < m_share.u.pole_count(); ++i)
            for (int j = 0; j < m_share.v.pole_count(); ++j)
            {
                const auto [k0, k1] = core(m_share.u, m_us, i);
                const auto [l0, l1] = core(m_share.v, m_vs, j);
                double least = std::numeric_limits<double>::max();
                double largest = 0.0;
                for (std::size_t k = k0; k <= k1; ++k)
                    for (std::size_t l = l0; l <= l1; ++l)
                    {
                        least = std::min(least, at(k, l));
                        largest = std::max(largest, at(k, l));
                    }
                const double above = std::max(0.0, m_length - largest);
                const bool nothing = above + least <= 0.0; // the ply reaches in, and so does the ramp's end
                m_share.poles.push_back(nothing ? 0.5 : above / (above + least));
            }
    }

    //! Exactly 0 past the ramp, and, which counts more, exactly 1 on the ply.
    void settle(const LoopRegion &fine)
    {
        std::vector<std::pair<std::size_t, std::size_t>> ply;
        for (std::size_t k = 0; k + 1 < m_us.size(); ++k)
            for (std::size_t l = 0; l + 1 < m_vs.size(); ++l)
                if (fine.may_touch({m_us[k], m_us[k + 1], m_vs[l], m_vs[l + 1]}))
                    ply.emplace_back(k, l);
                else if (std::min({at(k, l), at(k + 1, l), at(k, l + 1), at(k + 1, l + 1)}) >= m_length)
                    set(k, l, 0.0);
        for (const auto &[k, l] : ply)
            set(k, l, 1.0);
    }

    //! All poles that act on one span.
    void set(std::size_t k, std::size_t l, double value)
    {
        const int first_u = m_share.u.span(m_us[k]) - degree;
        const int first_v = m_share.v.span(m_vs[l]) - degree;
        for (int i = first_u; i <= first_u + degree; ++i)
            for (int j = first_v; j <= first_v + degree; ++j)
                m_share.poles[static_cast<std::size_t>(i * m_share.v.pole_count() + j)] = value;
    }

    double m_length;
    ScalarSpline &m_share;
    std::vector<double> m_us;
    std::vector<double> m_vs;
    std::vector<double> m_distances;
};

// Shares of a ply's thickness that differ by less are equal.
constexpr double same_share = 1e-9;
// Ends that are nearer to each other than this part of the face's size are a seam.
constexpr double same_seam = 1e-6;

bool differ(double a, double b) { return std::abs(a - b) > same_share; }

//! Does the share run on smoothly across a seam? Its knots know nothing of what lies on the other side.
bool torn_at_seam(const ScalarSpline &share, const InputFace &input, const ParameterBox &box)
{
    const int rows = share.u.pole_count();
    const int columns = share.v.pole_count();
    const double same = same_seam * input.diagonal;
    bool torn = false;
    if (ends_meet(*input.surface, box, true, same))
        for (int j = 0; j < columns; ++j)
            for (int i = 0; i < degree; ++i)
                torn = torn || differ(share.pole(i, j), share.pole(rows - 1, j)) ||
                       differ(share.pole(rows - 1 - i, j), share.pole(0, j));
    if (ends_meet(*input.surface, box, false, same))
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < degree; ++j)
                torn = torn || differ(share.pole(i, j), share.pole(i, columns - 1)) ||
                       differ(share.pole(i, columns - 1 - j), share.pole(i, 0));
    return torn;
}

//! Is a side of the box one point of the surface?
bool collapsed(const Geom_Surface &surface, const ParameterBox &box, bool along_u, bool at_end, double size)
{
    constexpr int probes = 4;
    constexpr double same = 1e-9;
    const auto at = [&](int i) {
        const double part = static_cast<double>(i) / probes;
        return along_u ? surface.Value(box.umin + part * (box.umax - box.umin), at_end ? box.vmax : box.vmin)
                       : surface.Value(at_end ? box.umax : box.umin, box.vmin + part * (box.vmax - box.vmin));
    };
    for (int i = 1; i <= probes; ++i)
        if (at(i).Distance(at(0)) > same * size)
            return false;
    return true;
}

//! Does the share vary along a side that is one point, such as a pole of a sphere?
bool torn_at_tip(const ScalarSpline &share, const InputFace &input, const ParameterBox &box)
{
    const int rows = share.u.pole_count();
    const int columns = share.v.pole_count();
    for (const bool along_u : {true, false})
        for (const bool at_end : {true, false})
        {
            if (!collapsed(*input.surface, box, along_u, at_end, input.diagonal))
                continue;
            const int across = along_u ? (at_end ? columns - 1 : 0) : (at_end ? rows - 1 : 0);
            const auto pole = [&](int k) { return along_u ? share.pole(k, across) : share.pole(across, k); };
            for (int k = 1; k < (along_u ? rows : columns); ++k)
                if (differ(pole(k), pole(0)))
                    return true;
        }
    return false;
}

} // namespace

LoopRegion fine_region(const BaseSurface &base, const PlyRegion &region, double length)
{
    InputFace fine = region.input;
    for (const auto &[loop, place] : region.cuts)
    {
        TrimmingCurve &curve = fine.loops[loop].curves[place];
        const double wanted = pieces_per_ramp * length_on(base, curve) / length;
        const double parts = std::clamp(std::ceil(wanted / static_cast<double>(curve.pieces.size())), 1.0, most_pieces);
        const double width = (curve.last - curve.first) / parts;
        curve.pieces.clear();
        for (int i = 0; i < static_cast<int>(parts); ++i)
        {
            const double to = i + 1 == static_cast<int>(parts) ? curve.last : curve.first + width * (i + 1);
            const std::vector<PcurvePiece> cut = cut_up(curve.pcurve, curve.first + width * i, to);
            curve.pieces.insert(curve.pieces.end(), cut.begin(), cut.end());
        }
    }
    return LoopRegion(fine);
}

Result<ScalarSpline> ply_share(const BaseSurface &base, const PlyRegion &region, double length, int most_poles)
{
    const EdgeWalk walk(base, region, length);
    const ParameterBox &box = base.box();
    ScalarSpline share{clamped_knots(degree, box.umin, box.umax, ramp_knots(walk, 0, box.umin, box.umax)),
                       clamped_knots(degree, box.vmin, box.vmax, ramp_knots(walk, 1, box.vmin, box.vmax)),
                       {}};
    const double poles = static_cast<double>(share.u.pole_count()) * static_cast<double>(share.v.pole_count());
    if (poles > most_poles)
        return Failure{
            Status::NotSupported, Stage::Surface,
            fmt::format(
                "A ramp of {:.3g} mm beside the boundary '{}' would take some {:.0f} poles, more than {}; make it "
                "{:.2g} mm or longer, or lead the boundary along parameter lines.",
                length, region.name, poles, most_poles, 1.05 * length * std::sqrt(poles / most_poles)),
            std::nullopt, std::nullopt};
    share.poles.reserve(static_cast<std::size_t>(poles));
    ShareMaker(base, region, walk, length, share);
    if (torn_at_seam(share, region.input, box) || torn_at_tip(share, region.input, box))
        return Failure{
            Status::NotSupported, Stage::Surface,
            fmt::format("The ramp of {:.3g} mm beside the boundary '{}' reaches the seam of the closed face, or a "
                        "point in which the face ends; move the boundary away from it, turn the face so that seam "
                        "and poles lie elsewhere, or make the ramp shorter.",
                        length, region.name),
            std::nullopt, std::nullopt};
    return share;
}

} // namespace laminate_offset
