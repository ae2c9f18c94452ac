// SPDX-License-Identifier: LGPL-2.1-or-later
#include "piece_tangents.h"

#include <algorithm>

namespace laminate_offset
{

void assign_derivative_u(const RationalPiece &piece, RationalPiece &out)
{
    for (std::size_t e = 0; e < 3; ++e)
        out.numerator[e].assign_derivative_u(piece.numerator[e]);
    out.omega.assign_derivative_u(piece.omega);
}

void assign_derivative_v(const RationalPiece &piece, RationalPiece &out)
{
    for (std::size_t e = 0; e < 3; ++e)
        out.numerator[e].assign_derivative_v(piece.numerator[e]);
    out.omega.assign_derivative_v(piece.omega);
}

void PieceTangents::assign(const RationalPiece &piece)
{
    m_rational = piece.rational();
    assign_derivative_u(piece, m_u);
    assign_derivative_v(piece, m_v);
    if (!m_rational)
        return assign_cross(m_u.numerator, m_v.numerator, m_normal);
    assign_cross(m_u.numerator, m_v.numerator, m_cross);
    for (std::size_t e = 0; e < 3; ++e)
        assign_product(m_cross[e], piece.omega, m_normal[e]);
    add_weight_term(piece.numerator, m_u.numerator, m_v.omega);
    add_weight_term(m_v.numerator, piece.numerator, m_u.omega);
}

void PieceTangents::add_weight_term(const Bernstein3 &a, const Bernstein3 &b, const Bernstein &weight)
{
    assign_cross(a, b, m_cross);
    for (std::size_t e = 0; e < 3; ++e)
    {
        assign_product(m_cross[e], weight, m_product);
        m_normal[e].add_raised(1.0, m_product);
    }
}

void PieceTangents::find_tangents(const RationalPiece &piece)
{
    if (!m_rational)
        return;
    assign_tangent(piece, m_u, m_qu);
    assign_tangent(piece, m_v, m_qv);
}

void PieceTangents::assign_tangent(const RationalPiece &piece, const RationalPiece &derivative, Bernstein3 &out)
{
    const Bernstein &w = piece.omega;
    const Bernstein &dw = derivative.omega;
    for (std::size_t e = 0; e < 3; ++e)
    {
        const Bernstein &p = piece.numerator[e];
        const Bernstein &dp = derivative.numerator[e];
        out[e].reset(std::max(dp.degree_u() + w.degree_u(), p.degree_u() + dw.degree_u()),
                     std::max(dp.degree_v() + w.degree_v(), p.degree_v() + dw.degree_v()));
        assign_product(dp, w, m_product);
        out[e].add_raised(1.0, m_product);
        assign_product(p, dw, m_product);
        out[e].add_raised(-1.0, m_product);
    }
}

void PieceTangents::assign_height(Bernstein &out) const
{
    const Eigen::Vector3d n0 = centre(m_normal).normalized();
    out.reset(m_normal[0].degree_u(), m_normal[0].degree_v());
    for (int e = 0; e < 3; ++e)
        out.add_raised(n0[e], m_normal[static_cast<std::size_t>(e)]);
}

} // namespace laminate_offset
