// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The inside of the trimming loops as a set of parameters.
#pragma once

#include "../input/input_face.h"

#include <gp_Vec2d.hxx>

#include <vector>

namespace laminate_offset
{

//! Answers where parameters lie with respect to the trimming loops. The loops are cut into short pieces, each inside a box;
//! away from the boxes the ends of the pieces decide, inside of them their exact Bezier arcs. Where the pcurves of
//! neighbouring edges only meet within tolerance, a straight piece closes the loop. Parameters are not moved by whole
//! periods. Safe to share between threads.
class LoopRegion
{
public:
    explicit LoopRegion(const InputFace &input);

    //! Inside the loops, or on them within the border's width. The answer is that of the exact pcurves; only where a pcurve
    //! has no exact Bezier arcs (an offset curve, a weight that is not positive) the chords of its pieces decide.
    [[nodiscard]] bool contains(const gp_Pnt2d &uv) const;

    //! How far from the loops a point still counts as inside, in u and in v: 1e-10 of the loops' box, but no less than
    //! rounding needs (1e-13 of the largest parameter). Between 0.9 and 1.1 times as far either answer may come.
    [[nodiscard]] gp_Vec2d border_width() const { return {m_border.X(), m_border.Y()}; }

    //! False only if no point inside the rectangle is inside the loops. A rectangle that the loops merely
    //! touch from outside does not count. One without a width, or without a height, is a segment or a point: there the loops
    //! themselves count, as they do for contains(), only not at a segment's very ends.
    [[nodiscard]] bool may_touch(const ParameterBox &box) const;

    //! The same for small rectangles, which a piece's box may hold although the piece passes them by.
    [[nodiscard]] bool touches(const ParameterBox &box) const;

    //! A box around the loops.
    [[nodiscard]] ParameterBox bounds() const;

    //! Where the line u = value (v = value unless constant_u) enters and leaves the loops: the running parameters in
    //! increasing order, an even number of them, each within the border's width of a loop. Where a loop runs along the
    //! line, either side may count.
    [[nodiscard]] std::vector<double> crossings(bool constant_u, double value) const;

    //! Points on the loops, the ends of the pieces.
    [[nodiscard]] std::vector<gp_Pnt2d> boundary_points() const;

private:
    void add(const std::vector<PcurvePiece> &pieces);
    void sort_into_bands();
    [[nodiscard]] std::size_t band(double v) const;
    //! Without the border that a loop may run along; a direction without an extent gets the loops' border instead.
    [[nodiscard]] ParameterBox core_of(const ParameterBox &box) const;

    std::vector<PcurvePiece> m_pieces; //!< each with one arc at least
    // Pieces by the bands of v that they reach into: m_in_bands from m_bands[i] to m_bands[i + 1] for band i.
    std::vector<std::size_t> m_bands;
    std::vector<std::size_t> m_in_bands;
    ParameterBox m_bounds;
    gp_XY m_border{0.0, 0.0};
};

} // namespace laminate_offset
