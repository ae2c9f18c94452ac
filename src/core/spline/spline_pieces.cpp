// SPDX-License-Identifier: LGPL-2.1-or-later
#include "spline_pieces.h"

namespace laminate_offset
{

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
    m_rows.assign(static_cast<std::size_t>((p + 1) * (q + 1)), Eigen::Vector4d::Zero());
    for (int l = 0; l <= q; ++l)
        for (int k = 0; k <= p; ++k)
        {
            Eigen::Vector4d pole = m_spline->pole(along_u.first + k, along_v.first + l);
            pole.head<3>() -= pole.w() * origin;
            for (int r = 0; r <= p; ++r)
                m_rows[static_cast<std::size_t>(r * (q + 1) + l)] += matrix_u[r * (p + 1) + k] * pole;
        }
    for (int r = 0; r <= p; ++r)
        for (int s = 0; s <= q; ++s)
        {
            Eigen::Vector4d sum = Eigen::Vector4d::Zero();
            for (int l = 0; l <= q; ++l)
                sum += matrix_v[s * (q + 1) + l] * m_rows[static_cast<std::size_t>(r * (q + 1) + l)];
            controls.push_back(sum);
        }
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
