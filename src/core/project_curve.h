// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Space curves put onto a face: parametric images of edges and wires (Ravi Kumar, Shastry & Prakash 2003, 3.4).
#pragma once

#include "base/result.h"
#include "projection/outside.h"

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Shape.hxx>

#include <optional>
#include <vector>

namespace laminate_offset
{

struct ProjectionOptions
{
    //! Largest deviation [mm]. Range: > 0. Default 1e-3. A decade costs about twice the poles.
    double tolerance = 1e-3;

    //! What becomes of parts whose nearest points lie on the end of the surface. Default Clip.
    Outside outside = Outside::Clip;
};

//! One edge of the image. An edge that crosses a seam, or leaves the surface and comes back, has several.
struct ProjectedEdge
{
    Handle(Geom2d_Curve) pcurve; //!< in the parameters of the face's surface, by the given edge's own parameter
    Handle(Geom_Curve) given;    //!< the given edge's curve, where the face stands without its location
    double first = 0.0;
    double last = 0.0;
    //! Proven bound of |E(t) - S(c(t))| [mm] for the edge's curve E, the surface S and the pcurve c; empty where one of
    //! them has no closed form (an offset curve).
    std::optional<double> certified_error;
    double sampled_error = 0.0; //!< that bound, or the largest such distance seen [mm]
    //! E is the given edge's own curve: certified_error is then the distance of the given curve from its image. Else the
    //! given curve keeps away from the surface and E is made along the image.
    bool on_surface = true;
    double distance = 0.0; //!< largest distance seen between the given curve and its image [mm]
    //! Proven bound of |C(t) - S(c(t))| [mm] for the given curve C: it keeps no farther from its image. Some 15 percent above the
    //! true distance at worst; empty where one of the three has no closed form.
    std::optional<double> certified_distance;
    //! The image crosses a hollow crease, over which the nearest point jumps: there it is farther from the given curve than
    //! the nearest point by up to the tolerance, or up to a tenth, as samples show.
    bool bridged = false;
};

struct CurveProjection
{
    TopoDS_Shape wire;                //!< a TopoDS_Wire, or a compound of wires where the image is in several parts
    std::vector<ProjectedEdge> edges; //!< in the order of the wire's edges
    std::optional<double> certified_error;    //!< largest one of the edges
    double distance = 0.0;                    //!< largest one of the edges [mm]
    std::optional<double> certified_distance; //!< largest one of the edges [mm]
};

//! Drops an edge or a wire onto the surface of a face, along the surface's normal. The wire stands on the face: its edges
//! have pcurves on the face's surface. The loops of the face do not cut it. Degenerated edges are left out; a seam
//! splits the curve. Of a clipped curve no piece shorter than the tolerance is kept, unless it links others. The given shapes are only read.
//! Refusals: those of the stage Input; InvalidTolerance; at the stage Trimming NotSupported (not an edge or wire, an edge
//! without a curve in space, an offset surface, all of the curve outside) and EdgeToleranceNotReached.
Result<CurveProjection> project_curve(const TopoDS_Shape &face, const TopoDS_Shape &edge_or_wire,
                                      const ProjectionOptions &options = {});

} // namespace laminate_offset
