// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Stage Input: a TopoDS_Face read into checked, plain parts. Nothing is healed or changed.
#pragma once

#include "../base/result.h"

#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_XYZ.hxx>

#include <vector>

namespace laminate_offset
{

//! A rectangle in the parameters of the base surface.
struct ParameterBox
{
    double umin = 0.0;
    double umax = 0.0;
    double vmin = 0.0;
    double vmax = 0.0;
};

//! A short part of a trimming curve.
struct PcurvePiece
{
    gp_Pnt2d start;
    gp_Pnt2d end;
    ParameterBox box; //!< holds the whole piece
    //! The exact Bezier arcs of the piece in order, which meet bit for bit with each other, with the neighbouring pieces
    //! and with `start` and `end`. Empty where the chord is the piece, and for curves that have none (offset curves).
    std::vector<std::vector<gp_XYZ>> arcs; //!< control points (u, v, 1) times their weight
};

//! One use of an edge in a trimming loop.
struct TrimmingCurve
{
    TopoDS_Edge edge;            //!< with the orientation it has in its loop
    Handle(Geom2d_Curve) pcurve; //!< in the base surface's parameters
    double first = 0.0;          //!< parameter range of the pcurve and the edge
    double last = 0.0;
    bool degenerated = false;        //!< the whole curve maps to one point of space
    bool seam = false;               //!< the edge stands twice in the loop, on both sides of a closed surface
    std::vector<PcurvePiece> pieces; //!< the pcurve cut up in order; a straight one is a single piece

    //! False for an edge that only lies in the face (orientation INTERNAL or EXTERNAL).
    [[nodiscard]] bool bounds_face() const;
};

//! One wire of the face, in the face's own order.
struct TrimmingLoop
{
    TopoDS_Wire wire;
    std::vector<TrimmingCurve> curves;
};

//! The face without its location: surface and loops are in local coordinates, so that the result
//! only has to be given the same location again.
struct InputFace
{
    TopoDS_Face face;             //!< location removed, orientation FORWARD
    TopLoc_Location location;     //!< of the original
    bool reversed = false;        //!< orientation of the original
    double normal_sign = 1.0;     //!< +1 where the outward normal is S_u x S_v, -1 where it is opposite
    Handle(Geom_Surface) surface; //!< unwrapped from rectangular trims and from Geom_OffsetSurface, however nested
    //! Where the face stands: at this distance from `surface` along S_u x S_v [mm]; not 0 for a Geom_OffsetSurface.
    double base_distance = 0.0;
    std::vector<TrimmingLoop> loops;
    ParameterBox box;       //!< of all trimming curves
    double diagonal = 0.0;  //!< size of the face: of the box of points on it [mm]
    double tolerance = 0.0; //!< largest tolerance of the face's edges and vertices [mm]

    [[nodiscard]] int edge_count() const; //!< distinct edges, a seam counted once

    //! A distance from the face along its outward normal as one from `surface` along S_u x S_v.
    [[nodiscard]] double from_surface(double distance) const { return base_distance + normal_sign * distance; }
    //! The other way round.
    [[nodiscard]] double from_face(double distance) const { return normal_sign * (distance - base_distance) + 0.0; }

    //! The point of the face, in local coordinates.
    [[nodiscard]] gp_Pnt point(const gp_Pnt2d &uv) const;

    //! The place of base parameters, its point where the original face stands.
    [[nodiscard]] Where place(const gp_Pnt2d &uv) const;
};

//! Reads and checks a face. Refusals: NullShape, NotAFace, InvalidFace, OpenLoop, ZeroArea, NotFinite,
//! UnboundedFace.
Result<InputFace> read_face(const TopoDS_Shape &shape);

} // namespace laminate_offset
