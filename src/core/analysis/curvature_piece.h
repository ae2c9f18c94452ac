// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Bounds of the principal curvatures of one Bernstein piece (the mathematics is in curvature.h).
#pragma once

#include "../spline/piece_tangents.h"

#include <optional>
#include <utility>

namespace laminate_offset
{

//! Looks at one piece at a time and keeps the workspace of the bounds; one bounder serves one thread. Curvatures are pairs (lower bound of
//! the smaller one, upper bound of the larger one); infinite where a piece cannot be bounded.
class CurvaturePieceBounder
{
public:
    //! \param resolution length [mm] below which the differences of poles are rounding.
    explicit CurvaturePieceBounder(double resolution) : m_resolution(resolution) {}

    //! The piece that all questions are about from here on.
    void assign(const RationalPiece &piece);

    //! From the spread of the derivatives over the piece: cheap, closes in linearly.
    [[nodiscard]] std::pair<double, double> rough() const;

    //! From the fundamental forms in Bernstein form: closes in quadratically.
    std::pair<double, double> fine();

    //! The curvatures at the piece's centre. Nothing for a piece below the resolution, where rounding
    //! of the poles shows in second derivatives.
    [[nodiscard]] std::optional<std::pair<double, double>> at_centre() const;

    //! Is the piece too small, in either direction, to tell its curvature from rounding?
    [[nodiscard]] bool below_resolution() const;

    //! Does a side of the piece come down to a point?
    static bool has_collapsed_side(const RationalPiece &piece);

    //! Do the tangents vary more along u than along v? Then bounds gain more from halves in u.
    [[nodiscard]] bool varies_more_along_u() const;

private:
    void move_to_centre(const RationalPiece &piece);
    void weighted_first(const Bernstein3 &a, const Bernstein3 &b, Bernstein &out);
    void weighted_second(const RationalPiece &d, Bernstein &out);
    std::pair<double, double> widest_pencil();

    double m_resolution;
    RationalPiece m_piece; //!< relative to the point at its centre
    RationalPiece m_u, m_v, m_uu, m_uv, m_vv;
    PieceTangents m_tangents;
    Bernstein m_height, m_square, m_scalar, m_product, m_sum;
    std::array<Bernstein, 3> m_first, m_second; //!< uu, uv, vv
};

} // namespace laminate_offset
