// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! What the offsets of a creased base's parts do along the edges that the parts share: move apart or cross.
//!
//! With T along the crease and A, B across it on its two sides, the determinant det(T, A, B) tells by its sign on which
//! side the crease opens, and by its size against |T x A| and |T x B| the angle between the normals. Between the knots
//! all of these are polynomials along the crease (over a weight, which drops out), and a polynomial of degree n is nowhere
//! farther from a middle value than 1 / cos(pi n / (2 N)) times the farthest of its values at N Chebyshev points. An
//! interval is halved until the sides are proven to keep within half of the tolerance or on the right side of each other, or
//! until a place is computed where they do not: however narrow a window is, it is seen if it is deeper than that. An edge is
//! not settled where the search runs out of intervals, and at a cusp, where the determinant vanishes between opposite
//! normals. There the sides themselves tell: where the one lies above the other along its own normal, the offsets of both cross
//! on that side and move apart on the other; where they lie on each other, as a sheet folded flat, they move apart on both. That is
//! seen at places, not proven; what is shorter than 2^-24 of a knot interval is not looked at.
#pragma once

#include "base_surface.h"

#include "../base/crease_kind.h"

#include <gp_Vec2d.hxx>

#include <optional>
#include <vector>

namespace laminate_offset
{

//! A part of a creased base (split_at_creases) with its surface, which ends at the creases.
struct CreasedPart
{
    const InputFace &input;
    const BaseSurface &base;
};

//! An edge that two parts share, and what their offsets do there by more than half of the tolerance.
struct CreaseEdge
{
    std::size_t first = 0; //!< index of the one part
    std::size_t second = 0;
    TopoDS_Edge edge;                //!< as it stands in the first part
    gp_Vec2d shift;                  //!< takes the second part's parameters of the edge to those of the first
    bool opens = false;              //!< somewhere the parts move apart
    std::optional<gp_Pnt2d> crosses; //!< a place in the first part's parameters where they cross each other
    std::optional<gp_Pnt2d> open;    //!< such a place where neither could be found nor ruled out
};

//! All edges that two of the parts share. On a base without spline or model the edges are looked at in 512 places.
//! \param distance along S_u x S_v [mm]; at the opposite one what opens crosses, and the other way round.
//! \param tolerance of the offset [mm].
std::vector<CreaseEdge> crease_edges(const std::vector<CreasedPart> &parts, double distance, double tolerance);

//! What all of them are together; nothing where the parts keep within half of the tolerance of each other.
std::optional<CreaseKind> kind_of(const std::vector<CreaseEdge> &edges);

} // namespace laminate_offset
