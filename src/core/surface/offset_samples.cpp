// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_samples.h"

#include <utility>

namespace laminate_offset
{

OffsetSampler::OffsetSampler(const BaseSurface &base, std::vector<double> distances, Denominator denominator)
    : m_base(base), m_distances(std::move(distances)), m_denominator(denominator)
{
    const ParameterBox &box = base.box();
    m_origin = base.jets({0.5 * (box.umin + box.umax)}, {0.5 * (box.vmin + box.vmax)}, 0).front().s;
}

RowMatrix OffsetSampler::rows(double distance, const std::vector<double> &us, const std::vector<double> &vs,
                              bool transposed)
{
    std::optional<gp_Pnt2d> singular;
    const std::vector<Eigen::Vector3d> points = m_base.offset_grid(us, vs, distance, singular);
    if (singular)
        keep(*singular);
    const std::vector<double> factors = weights(us, vs);
    const auto nu = static_cast<Eigen::Index>(us.size());
    const auto nv = static_cast<Eigen::Index>(vs.size());
    RowMatrix result = transposed ? RowMatrix::Zero(nv, 3 * nu) : RowMatrix::Zero(nu, 3 * nv);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const Eigen::Index k = static_cast<Eigen::Index>(i) / nv;
        const Eigen::Index l = static_cast<Eigen::Index>(i) % nv;
        result.row(transposed ? l : k).segment<3>(3 * (transposed ? k : l)) =
            factors[i] * (points[i] - m_origin).transpose();
    }
    return result;
}

RowMatrix OffsetSampler::joined_rows(const std::vector<double> &us, const std::vector<double> &vs, bool transposed)
{
    const auto count = static_cast<Eigen::Index>(transposed ? vs.size() : us.size());
    const auto columns = static_cast<Eigen::Index>(3 * (transposed ? us.size() : vs.size()));
    RowMatrix joined(count, columns * static_cast<Eigen::Index>(m_distances.size()));
    for (std::size_t k = 0; k < m_distances.size(); ++k)
        joined.middleCols(static_cast<Eigen::Index>(k) * columns, columns) = rows(m_distances[k], us, vs, transposed);
    return joined;
}

RowMatrix OffsetSampler::weight_rows(const std::vector<double> &us, const std::vector<double> &vs) const
{
    const std::vector<double> factors = weights(us, vs);
    RowMatrix result = RowMatrix::Zero(static_cast<Eigen::Index>(us.size()), 3 * static_cast<Eigen::Index>(vs.size()));
    for (std::size_t i = 0; i < factors.size(); ++i)
        result(static_cast<Eigen::Index>(i / vs.size()), 3 * static_cast<Eigen::Index>(i % vs.size())) = factors[i];
    return result;
}

std::vector<double> OffsetSampler::weights(const std::vector<double> &us, const std::vector<double> &vs) const
{
    if (m_denominator == Denominator::BaseWeight)
        return m_base.spline()->weights(us, vs);
    return std::vector<double>(us.size() * vs.size(), 1.0);
}

void OffsetSampler::keep(const gp_Pnt2d &singular)
{
    const std::lock_guard lock(m_guard);
    m_singular = singular;
}

} // namespace laminate_offset
