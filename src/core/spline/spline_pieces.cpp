// SPDX-License-Identifier: LGPL-2.1-or-later
#include "spline_pieces.h"

#include <algorithm>
#include <cmath>

namespace laminate_offset
{

namespace
{

//! The largest sum of the changes of all weights from one row of an extraction to the next.
double largest_change(const double *matrix, int degree)
{
    double largest = 0.0;
    for (int r = 1; r <= degree; ++r)
    {
        double sum = 0.0;
        for (int k = 0; k <= degree; ++k)
            sum += std::abs(matrix[r * (degree + 1) + k] - matrix[(r - 1) * (degree + 1) + k]);
        largest = std::max(largest, sum);
    }
    return largest;
}

} // namespace

Eigen::Vector3d RationalPiece::centre() const
{
    return Eigen::Vector3d(numerator[0].centre(), numerator[1].centre(), numerator[2].centre()) / omega.centre();
}

void RationalPiece::halve(bool along_u, RationalPiece &upper)
{
    for (std::size_t e = 0; e < 3; ++e)
        numerator[e].halve(along_u, upper.numerator[e]);
    omega.halve(along_u, upper.omega);
}

SplinePieces::SplinePieces(const TensorSpline &spline, const std::vector<double> &us, const std::vector<double> &vs)
    : m_spline(&spline), m_u(std::make_shared<const std::vector<SpanExtraction>>(extractions(spline.u, us))),
      m_v(std::make_shared<const std::vector<SpanExtraction>>(extractions(spline.v, vs)))
{
}

Eigen::Vector3d SplinePieces::near_point(std::size_t i, std::size_t j) const
{
    const Eigen::Vector4d &pole = m_spline->pole((*m_u)[i].first, (*m_v)[j].first);
    return pole.head<3>() / pole.w();
}

void SplinePieces::append_controls(std::size_t i, std::size_t j, const Eigen::Vector3d &origin,
                                   std::vector<Eigen::Vector4d> &controls)
{
    const int p = m_spline->u.degree;
    const int q = m_spline->v.degree;
    const SpanExtraction &along_u = (*m_u)[i];
    const SpanExtraction &along_v = (*m_v)[j];
    const double *matrix_u = along_u.matrix.data();
    const double *matrix_v = along_v.matrix.data();
    const auto shifted = [&](Eigen::Vector4d homogeneous) {
        homogeneous.head<3>() -= homogeneous.w() * origin;
        return homogeneous;
    };
    m_rows.assign(static_cast<std::size_t>((p + 1) * (q + 1)), Eigen::Vector4d::Zero());
    m_first.resize(static_cast<std::size_t>(q + 1));
    m_reach = {0.0, 0.0, largest_change(matrix_u, p), largest_change(matrix_v, q)};
    for (int l = 0; l <= q; ++l)
    {
        const Eigen::Vector4d &first = m_spline->pole(along_u.first, along_v.first + l);
        m_first[static_cast<std::size_t>(l)] = shifted(first);
        m_reach.along_v = std::max(m_reach.along_v, m_first[static_cast<std::size_t>(l)].norm());
        for (int k = 1; k <= p; ++k)
        {
            const Eigen::Vector4d step = shifted(m_spline->pole(along_u.first + k, along_v.first + l) - first);
            m_reach.across_u = std::max(m_reach.across_u, step.norm());
            for (int r = 0; r <= p; ++r)
                m_rows[static_cast<std::size_t>(r * (q + 1) + l)] += matrix_u[r * (p + 1) + k] * step;
        }
    }
    const auto combined = [&](int s, const Eigen::Vector4d *row) {
        Eigen::Vector4d sum = Eigen::Vector4d::Zero();
        for (int l = 0; l <= q; ++l)
            sum += matrix_v[s * (q + 1) + l] * row[l];
        return sum;
    };
    m_common.clear();
    for (int s = 0; s <= q; ++s)
        m_common.push_back(combined(s, m_first.data()));
    for (int r = 0; r <= p; ++r)
        for (int s = 0; s <= q; ++s)
            controls.push_back(m_common[static_cast<std::size_t>(s)] +
                               combined(s, &m_rows[static_cast<std::size_t>(r * (q + 1))]));
}

void SplinePieces::cut(std::size_t i, std::size_t j, const Eigen::Vector3d &origin, RationalPiece &piece)
{
    const int p = m_spline->u.degree;
    const int q = m_spline->v.degree;
    m_controls.clear();
    append_controls(i, j, origin, m_controls);
    for (Bernstein &component : piece.numerator)
        component.reset(p, q);
    piece.omega.reset(m_spline->rational ? p : 0, m_spline->rational ? q : 0);
    piece.omega.set_coefficient(0, 0, 1.0);
    const Eigen::Vector4d *control = m_controls.data();
    for (int r = 0; r <= p; ++r)
        for (int s = 0; s <= q; ++s, ++control)
        {
            for (int e = 0; e < 3; ++e)
                piece.numerator[static_cast<std::size_t>(e)].set_coefficient(r, s, (*control)[e]);
            if (m_spline->rational)
                piece.omega.set_coefficient(r, s, control->w());
        }
}

} // namespace laminate_offset
