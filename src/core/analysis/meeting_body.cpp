// SPDX-License-Identifier: LGPL-2.1-or-later
#include "meeting_body.h"

#include "meeting_search.h"

namespace laminate_offset
{

std::vector<double> period_shifts(double period)
{
    return period > 0.0 ? std::vector<double>{0.0, -period, period} : std::vector<double>{0.0};
}

Reach SheetBounds::along(const Eigen::Vector3d &axis, const ParameterBox &box) const
{
    const double half = 0.5 * (box.umax - box.umin) * Reach::of(axis, bounds.du).largest() +
                        0.5 * (box.vmax - box.vmin) * Reach::of(axis, bounds.dv).largest();
    const double at = axis.dot(middle);
    const Reach by_box = Reach::of(axis, bounds.point);
    return {std::max(at - half, by_box.low), std::min(at + half, by_box.high)};
}

MeetingBody::MeetingBody(const MeetingPart &part, double tolerance, const Eigen::Vector3d &origin)
    : m_part(part), m_periods(periods_of(part.input, tolerance)), m_base(*part.analysis.base.spline(), origin),
      m_tree(part.far, origin)
{
    m_sheets.push_back(std::make_unique<Sheet>(part.far, origin));
    if (part.near)
        m_sheets.push_back(std::make_unique<Sheet>(*part.near, origin));
}

const std::vector<SheetBounds> &MeetingBody::patch(int index)
{
    if (m_patches.size() <= static_cast<std::size_t>(index))
        m_patches.resize(static_cast<std::size_t>(2 * index + 16));
    std::vector<SheetBounds> &known = m_patches[static_cast<std::size_t>(index)];
    if (known.empty())
    {
        const ParameterBox box = tree().node(index).box;
        const double u = 0.5 * (box.umin + box.umax), v = 0.5 * (box.vmin + box.vmax);
        for (const auto &sheet : m_sheets)
            known.push_back({sheet->at(u, v), sheet->tree.bounds_over(box)});
    }
    return known;
}

bool MeetingBody::touches(int index)
{
    if (m_touches.size() <= static_cast<std::size_t>(index))
        m_touches.resize(static_cast<std::size_t>(2 * index + 16), -1);
    signed char &known = m_touches[static_cast<std::size_t>(index)];
    if (known < 0)
        known = m_part.analysis.region.may_touch(tree().node(index).box) ? 1 : 0;
    return known == 1;
}

std::vector<PatchBounds> MeetingBody::over(const ParameterBox &box)
{
    std::vector<PatchBounds> bounds;
    for (const auto &sheet : m_sheets)
        bounds.push_back(wrapped(sheet->tree, box));
    return bounds;
}

std::vector<Eigen::Vector3d> MeetingBody::points(double u, double v) const
{
    const ParameterBox &box = m_part.analysis.base.box();
    const auto inside = [](double x, double low, double high, double period) {
        while (period > 0.0 && x < low - 1e-9 * period)
            x += period;
        while (period > 0.0 && x > high + 1e-9 * period)
            x -= period;
        return std::clamp(x, low, high);
    };
    std::vector<Eigen::Vector3d> result;
    for (const auto &sheet : m_sheets)
        result.push_back(
            sheet->at(inside(u, box.umin, box.umax, m_periods.u), inside(v, box.vmin, box.vmax, m_periods.v)));
    return result;
}

std::array<Eigen::Vector3d, 4> MeetingBody::jet(double u, double v, double height) const
{
    const SurfaceJet far = m_part.far.jets({u}, {v}, 1).front();
    if (!is_slab())
        return {far.s, far.u, far.v, Eigen::Vector3d::Zero()};
    const SurfaceJet near = m_part.near->jets({u}, {v}, 1).front();
    return {near.s + height * (far.s - near.s), near.u + height * (far.u - near.u), near.v + height * (far.v - near.v),
            far.s - near.s};
}

std::array<Eigen::Vector3d, 4> MeetingBody::jet_at(double u, double v, double part) const
{
    const SurfaceJet far = m_part.far.jets({u}, {v}, 1).front(), own = base(u, v);
    return {own.s + part * (far.s - own.s), own.u + part * (far.u - own.u), own.v + part * (far.v - own.v),
            far.s - own.s};
}

std::array<Eigen::Vector3d, 4> MeetingBody::still_at(double u, double v, double part) const
{
    auto jet = jet_at(u, v, part);
    jet[3].setZero();
    return jet;
}

PatchBounds MeetingBody::wrapped(PatchTree &tree, const ParameterBox &box) const
{
    PatchBounds bounds;
    for (const double u : period_shifts(m_periods.u))
        for (const double v : period_shifts(m_periods.v))
            bounds.extend(tree.bounds_over(shifted(box, u, v)));
    return bounds;
}

} // namespace laminate_offset
