// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! First derivatives and normal of a rational piece S = P / omega, as polynomials.
#pragma once

#include "spline_pieces.h"

namespace laminate_offset
{

//! Derivatives of numerator and weight function along one direction.
void assign_derivative_u(const RationalPiece &piece, RationalPiece &out);
void assign_derivative_v(const RationalPiece &piece, RationalPiece &out);

//! Keeps its workspace; one object serves one thread.
class PieceTangents
{
public:
    //! Takes P_u, P_v, omega_u, omega_v and the normal of a piece.
    void assign(const RationalPiece &piece);

    //! Takes omega^2 S_u and omega^2 S_v of the same piece too.
    void find_tangents(const RationalPiece &piece);

    [[nodiscard]] const RationalPiece &derivative_u() const { return m_u; }
    [[nodiscard]] const RationalPiece &derivative_v() const { return m_v; }
    //! omega^3 S_u x S_v = omega P_u x P_v + omega_v P x P_u + omega_u P_v x P; P_u x P_v where omega is 1.
    [[nodiscard]] const Bernstein3 &normal() const { return m_normal; }
    //! omega^2 S_u = omega P_u - omega_u P, after find_tangents; P_u where omega is 1.
    [[nodiscard]] const Bernstein3 &tangent_u() const { return m_rational ? m_qu : m_u.numerator; }
    [[nodiscard]] const Bernstein3 &tangent_v() const { return m_rational ? m_qv : m_v.numerator; }

    //! M . n0 with M the normal and n0 its direction at the centre: at most |M|.
    void assign_height(Bernstein &out) const;

private:
    void add_weight_term(const Bernstein3 &a, const Bernstein3 &b, const Bernstein &weight);
    void assign_tangent(const RationalPiece &piece, const RationalPiece &derivative, Bernstein3 &out);

    bool m_rational = false;
    RationalPiece m_u;
    RationalPiece m_v;
    Bernstein3 m_normal, m_qu, m_qv, m_cross;
    Bernstein m_product;
};

} // namespace laminate_offset
