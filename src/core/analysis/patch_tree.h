// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A tree of boxes over the Bernstein pieces of a spline surface: where each part lies and how its
//! derivatives vary.
#pragma once

#include "../input/input_face.h"
#include "../spline/spline_pieces.h"
#include "../spline/tensor_spline.h"

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
    std::size_t first = 0; //!< of the piece's control points in the tree's store

    [[nodiscard]] bool is_piece() const { return halvings >= 0; }
};

//! The tree. All pieces share one origin near the surface; children of pieces are made when asked for.
class PatchTree
{
public:
    explicit PatchTree(const TensorSpline &spline);
    //! \param origin of its points and boxes, so that several trees can have the same.
    PatchTree(const TensorSpline &spline, const Eigen::Vector3d &origin);

    [[nodiscard]] static constexpr int root() { return 0; }
    [[nodiscard]] const PatchNode &node(int index) const { return m_nodes[static_cast<std::size_t>(index)]; }

    [[nodiscard]] int degree_u() const { return m_degree_u; }
    [[nodiscard]] int degree_v() const { return m_degree_v; }
    //! Control point (i, j) of a piece as a point relative to the tree's origin.
    [[nodiscard]] Eigen::Vector3d point(const PatchNode &piece, int i, int j) const
    {
        const Eigen::Vector4d &control = homogeneous(piece, i, j);
        return control.head<3>() / control.w();
    }

    //! Makes sure that a node has children: halves of its longer side.
    void split(int index);

    //! The same, but halves a piece along the parameter in which its derivatives vary more.
    void split_where_it_bends(int index);

    //! Enclosure over all nodes that share inner points with the rectangle; leaves that are longer than it in one
    //! parameter are halved along that before.
    [[nodiscard]] PatchBounds bounds_over(const ParameterBox &box);

private:
    [[nodiscard]] const Eigen::Vector4d &homogeneous(const PatchNode &piece, int i, int j) const
    {
        return m_controls[piece.first + static_cast<std::size_t>(i * (m_degree_v + 1) + j)];
    }
    int build(SplinePieces &pieces, const Eigen::Vector3d &origin, const std::array<std::size_t, 4> &range);
    void halve(int index, bool along_u);
    [[nodiscard]] bool bends_along_u(const PatchNode &piece) const;
    int add_piece(const ParameterBox &box, int halvings, std::size_t first);
    void gather(int index, const ParameterBox &box, PatchBounds &bounds);

    std::vector<double> m_us;
    std::vector<double> m_vs;
    int m_degree_u;
    int m_degree_v;
    bool m_rational;
    std::deque<PatchNode> m_nodes;
    std::vector<Eigen::Vector4d> m_controls; //!< homogeneous
};

//! Is the whole surface one-to-one, as its poles alone show? False: that is not known.
bool one_to_one_whole(const TensorSpline &spline);

//! Enclosure over a whole spline.
//! \param parts a rational one is cut into at least so many pieces in each direction.
//! \param axes orthonormal rows, along which the boxes lie.
PatchBounds whole_bounds(const TensorSpline &spline, std::size_t parts = 8,
                         const Eigen::Matrix3d &axes = Eigen::Matrix3d::Identity());

} // namespace laminate_offset
