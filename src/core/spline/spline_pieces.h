// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A tensor-product spline cut into Bernstein pieces on a grid of rectangles.
#pragma once

#include "bernstein.h"

#include <memory>
#include <vector>

namespace laminate_offset
{

//! numerator / omega over the unit square; omega has degree (0, 0) and is 1 for a polynomial.
struct RationalPiece
{
    Bernstein3 numerator;
    Bernstein omega;

    [[nodiscard]] bool rational() const { return omega.degree_u() + omega.degree_v() > 0; }
    //! The point at the centre of the square.
    [[nodiscard]] Eigen::Vector3d centre() const;
    //! Halves like Bernstein::halve.
    void halve(bool along_u, RationalPiece &upper);
};

//! What the rounding of a piece's control points goes with.
struct PieceReach
{
    double across_u = 0.0; //!< how far the poles reach from those of their first row, in homogeneous coordinates
    double along_v = 0.0;  //!< how far that row reaches from the origin
    double change_u = 2.0; //!< how far two control points that are neighbours in u may part for poles that are off by 1
    double change_v = 2.0; //!< in v
};

//! Cuts a spline along breaks that hold at least its own knots. Copies share the tables and have a workspace of their
//! own: one copy serves one thread.
class SplinePieces
{
public:
    SplinePieces(const TensorSpline &spline, const std::vector<double> &us, const std::vector<double> &vs);

    //! A pole of the piece, to shift coordinates by.
    [[nodiscard]] Eigen::Vector3d near_point(std::size_t i, std::size_t j) const;

    //! The piece on [us[i], us[i+1]] x [vs[j], vs[j+1]] relative to `origin`.
    void cut(std::size_t i, std::size_t j, const Eigen::Vector3d &origin, RationalPiece &piece);

    //! That of the piece cut last.
    [[nodiscard]] const PieceReach &reach() const { return m_reach; }

    //! The homogeneous control points of the same piece, appended to others, all v to one u together. What they have in common
    //! along u is added last, so that their differences lose nothing to it on pieces that are narrow in u.
    void append_controls(std::size_t i, std::size_t j, const Eigen::Vector3d &origin,
                         std::vector<Eigen::Vector4d> &controls);

private:
    const TensorSpline *m_spline;
    std::shared_ptr<const std::vector<SpanExtraction>> m_u;
    std::shared_ptr<const std::vector<SpanExtraction>> m_v;
    std::vector<Eigen::Vector4d> m_rows;
    std::vector<Eigen::Vector4d> m_first; //!< row of poles
    std::vector<Eigen::Vector4d> m_common;
    PieceReach m_reach;
    std::vector<Eigen::Vector4d> m_controls;
};

} // namespace laminate_offset
