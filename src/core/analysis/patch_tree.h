// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A tree of boxes over the Bernstein pieces of a spline surface: where each part lies and how its
//! derivatives vary.
#pragma once

#include "../input/input_face.h"
#include "../spline/spline_pieces.h"

#include <Eigen/Geometry>

#include <array>
#include <deque>
#include <vector>

namespace laminate_offset
{

//! Enclosures of a surface's points and first derivatives over a rectangle of parameters.
struct PatchBounds
{
    Eigen::AlignedBox3d point;
    Eigen::AlignedBox3d du;
    Eigen::AlignedBox3d dv;

    void extend(const PatchBounds &other);

    //! True only if the surface is one-to-one over every rectangle whose derivatives stay in these boxes: O(p) - O(q)
    //! is M (p - q) with a mean M of the derivatives on the way from q to p, and no matrix in the boxes,
    //! projected to the plane of their centres, is singular.
    [[nodiscard]] bool one_to_one() const;
};

//! A rectangle of parameters: several pieces, one, or a part of one.
struct PatchNode
{
    ParameterBox box;
    PatchBounds bounds;
    int halvings = -1; //!< of the piece; -1 for several pieces
    int lower = -1;    //!< children, -1 where there are none yet
    int upper = -1;
    RationalPiece piece;                 //!< empty for several pieces
    std::vector<Eigen::Vector3d> points; //!< control points of the piece

    [[nodiscard]] bool is_piece() const { return halvings >= 0; }
};

//! The tree. All pieces share one origin near the surface; children of pieces are made when asked for.
class PatchTree
{
public:
    explicit PatchTree(const TensorSpline &spline);

    [[nodiscard]] static constexpr int root() { return 0; }
    [[nodiscard]] const PatchNode &node(int index) const { return m_nodes[static_cast<std::size_t>(index)]; }

    //! Makes sure that a node has children.
    void split(int index);

    //! Enclosure over all nodes that share inner points with the rectangle; larger leaves are halved before.
    [[nodiscard]] PatchBounds bounds_over(const ParameterBox &box);

private:
    int build(SplinePieces &pieces, const Eigen::Vector3d &origin, const std::array<std::size_t, 4> &range);
    int add_piece(const ParameterBox &box, int halvings, RationalPiece piece);
    void gather(int index, const ParameterBox &box, PatchBounds &bounds);

    std::vector<double> m_us;
    std::vector<double> m_vs;
    std::deque<PatchNode> m_nodes;
};

//! Enclosure over a whole spline from its poles alone: nothing has to be cut.
PatchBounds whole_bounds(const TensorSpline &spline);

} // namespace laminate_offset
