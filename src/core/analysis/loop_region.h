// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The inside of the trimming loops as a set of parameters.
#pragma once

#include "../input/input_face.h"

#include <vector>

namespace laminate_offset
{

//! Answers where parameters lie with respect to the trimming loops. The loops are cut into short pieces,
//! each inside a box; away from the boxes the answer is that of the chords and exact. Safe to share
//! between threads.
class LoopRegion
{
public:
    explicit LoopRegion(const InputFace &input);

    //! Inside the loops; next to them (inside a piece's box) the chord of the piece decides.
    [[nodiscard]] bool contains(const gp_Pnt2d &uv) const;

    //! False only if no point inside the rectangle is inside the loops. A rectangle that the loops merely
    //! touch from outside does not count.
    [[nodiscard]] bool may_touch(const ParameterBox &box) const;

    //! A box around the loops.
    [[nodiscard]] ParameterBox bounds() const;

    //! Where the line u = value (v = value unless constant_u) enters and leaves the loops: the running parameters in
    //! increasing order, an even number of them. Where a loop runs along the line, either side may count.
    [[nodiscard]] std::vector<double> crossings(bool constant_u, double value) const;

    //! Points on the loops, the ends of the pieces.
    [[nodiscard]] std::vector<gp_Pnt2d> boundary_points() const;

private:
    [[nodiscard]] std::size_t band(double v) const;

    std::vector<PcurvePiece> m_pieces;
    // Pieces by the bands of v that their chords reach into: m_chords from m_bands[i] to m_bands[i + 1] for band i.
    std::vector<std::size_t> m_bands;
    std::vector<std::size_t> m_chords;
    ParameterBox m_bounds;
};

} // namespace laminate_offset
