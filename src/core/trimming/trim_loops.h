// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Stage Trimming: the base's trimming curves carried over to the offset surface.
//!
//! The offset keeps the base's parameters, so a pcurve is taken over (shifted where the surface says so, a straight
//! one in its simplest form) and only the curve in space is new.
#pragma once

#include "../analysis/base_surface.h"
#include "../base/result.h"
#include "../input/input_face.h"
#include "../spline/scalar_spline.h"
#include "../surface/offset_surface.h"
#include "edge_curve.h"

#include <Geom_Curve.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include <functional>
#include <vector>

namespace laminate_offset
{

//! One edge of the offset face.
struct OffsetEdge
{
    Handle(Geom_Curve) curve; //!< null for an edge that stays a point
    Handle(Geom2d_Curve) pcurve;
    Handle(Geom2d_Curve) second_pcurve; //!< of a seam, else null
    double first = 0.0;
    double last = 0.0;
    Deviation deviation;        //!< of the curve, or the point, from the offset surface at its pcurves and the base's
    double sampled_error = 0.0; //!< largest distance seen from the exact offset of the base edge [mm]
    double moved = 0.0;         //!< part of the bound: how far the pcurve leads away from the base's [mm]
    //! The surface has parameters of its own. Then the distance from the exact offset of the base edge is proven by
    //! itself, without the surface, or not at all.
    bool own_parameters = false;
    std::optional<double> offset_error; //!< that proven bound [mm]
};

//! The offset edges; edge k belongs to the base edge bases(k + 1).
struct TrimLoops
{
    TopTools_IndexedMapOfShape bases;
    std::vector<OffsetEdge> edges;

    //! Proven bound of the distance [mm] of every edge from the exact offset of its base edge at equal
    //! parameters: through the offset surface, which keeps within `certified_error` there. Nothing where a
    //! part of it is not proven.
    [[nodiscard]] std::optional<double> edge_error(const std::optional<double> &certified_error) const;
    //! Largest such distance seen [mm].
    [[nodiscard]] double sampled_error() const;
};

//! The image of a curve in space on the offset surface, with the curve's parameter, within an accuracy [mm]; null where
//! that is not reached.
using CurveImage =
    std::function<Handle(Geom2d_Curve)(const Handle(Geom_Curve) & curve, double first, double last, double accuracy)>;

//! Everything an edge is fitted against.
struct EdgeContext
{
    const InputFace &input;
    const BaseSurface &base;
    const OffsetSurface &surface;
    double distance = 0.0;  //!< along S_u x S_v [mm]
    double tolerance = 0.0; //!< largest deviation of an edge curve from the offset surface [mm]
    //! The distance itself where it varies over the parameters; null: it is `distance` everywhere.
    const ScalarSpline *varying = nullptr;
    //! For a surface with a parameter map: how edges get their pcurves. Empty: as the base's pcurves through the map.
    CurveImage image = {};
    //! Edges of another offset of the same face, whose knots are tried before any are chosen; may be null.
    const TrimLoops *like = nullptr;
};

//! Largest distance seen of a curve from S + d N over the base's pcurve, at equal parameters [mm].
double sampled_edge_error(const EdgeContext &context, const TrimmingCurve &base, const Handle(Geom_Curve) & curve);

//! Makes the curves of all edges. An edge that is a point on the base gets one where the offset opens up there.
//! Refusal: EdgeToleranceNotReached.
Result<TrimLoops> offset_loops(const EdgeContext &context);

} // namespace laminate_offset
