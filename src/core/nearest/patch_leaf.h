// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Bezier patches small enough for a plane to stand for them, with the bounds that a search of nearest points needs.
#pragma once

#include "../input/input_face.h"
#include "../spline/spline_pieces.h"

#include <Eigen/Geometry>

#include <utility>
#include <vector>

namespace laminate_offset
{

//! A patch over the unit square with its derivatives there.
struct LeafJet
{
    Eigen::Vector3d s, u, v, uu, uv, vv;
};

//! A rectangle inside the unit square.
struct UnitBox
{
    double x0 = 0.0;
    double x1 = 1.0;
    double y0 = 0.0;
    double y1 = 1.0;
};

//! One patch; lengths in mm, derivatives with respect to the unit square, points relative to the tree's origin.
struct PatchLeaf
{
    ParameterBox box; //!< in the spline's parameters
    int degree_u = 0;
    int degree_v = 0;
    bool rational = false;
    RationalPiece piece;
    std::vector<double> poles; //!< Bezier poles (x, y, z, w), homogeneous, row by row
    Eigen::AlignedBox3d hull;
    // S = centre + (x - 1/2) du + (y - 1/2) dv + R, |R| <= bulge
    Eigen::Vector3d centre;
    Eigen::Vector3d du;
    Eigen::Vector3d dv;
    double bulge = 0.0;
    double radius = 0.0; //!< of a ball about the centre that holds the patch
    // enclosures in a frame whose first axis runs along du and whose last one is normal to du and dv: a long patch
    // then bends across its length only
    Eigen::Matrix3d frame;
    Eigen::AlignedBox3d around; //!< S - centre
    Eigen::AlignedBox3d u;      //!< S_u
    Eigen::AlignedBox3d v;
    Eigen::AlignedBox3d uu;
    Eigen::AlignedBox3d uv;
    Eigen::AlignedBox3d vv;
    double size_uu = 0.0; //!< longest S_uu, S_uv, S_vv
    double size_uv = 0.0;
    double size_vv = 0.0;

    [[nodiscard]] LeafJet jet(double x, double y) const;
    [[nodiscard]] double u_at(double x) const { return x >= 1.0 ? box.umax : box.umin + x * (box.umax - box.umin); }
    [[nodiscard]] double v_at(double y) const { return y >= 1.0 ? box.vmax : box.vmin + y * (box.vmax - box.vmin); }

    //! A part of the patch that holds its nearest point to p: a side on which the distance falls all the way.
    struct Focus
    {
        UnitBox box;
        bool convex = false; //!< certainly: the squared distance over that part
    };
    [[nodiscard]] Focus focus(const Eigen::Vector3d &p) const;

    struct Plane
    {
        double distance = 0.0; //!< of p from the parallelogram; infinite where the patch has none
        double least = 0.0;    //!< no point of the patch is nearer to p
        double most = 0.0;     //!< some point of the patch is as near as that
        double x = 0.5;        //!< nearest place on the parallelogram that stands for the patch
        double y = 0.5;
    };
    [[nodiscard]] Plane nearest_on_plane(const Eigen::Vector3d &p) const;
};

//! A patch from a piece.
PatchLeaf make_leaf(const ParameterBox &box, RationalPiece piece);

//! The direction in which a patch bends too much for a plane to stand for it; nothing where one does.
enum class Bend
{
    None,
    AlongU,
    AlongV
};
Bend bend_of(const PatchLeaf &leaf);

//! The halves of a patch, the one with the lower parameters first.
std::pair<PatchLeaf, PatchLeaf> halves(const PatchLeaf &leaf, bool along_u);

} // namespace laminate_offset
