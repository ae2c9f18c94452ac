// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Plies that cover parts of a lay-up face, with ramps where plies below them end.
//!
//! Between two plies there is one surface, S + d N with d the sum of what lies below: thickness times share
//! (stack/ply_ramp.h) of every ply. A ply's bottom and top are parts of two such surfaces. On the ply its own share is 1,
//! so that it is exactly as thick as it should be; beside its edge the plies above come down over a ramp, and what
//! is left open there is a pocket of resin.
#pragma once

#include "offset_face.h"

#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace laminate_offset
{

struct ScalarSpline;

//! Which part of the face a boundary leaves to its ply. Left and right are those of the boundary's direction for someone
//! who stands on the face with the outward normal upwards.
enum class PlySide
{
    Inside,  //!< of closed curves; a closed curve inside another one is a hole
    Outside, //!< the rest
    Left,
    Right,
    Nearest //!< the part next to a point
};

//! What a ramp's ratio of length to thickness stands for.
enum class RampSlope
{
    Mean,    //!< the whole ramp; in its middle it is some 1.4 to 1.8 times as steep
    Steepest //!< the steepest place; the ramp is made as much longer
};

//! What bounds plies.
struct PlyBoundary
{
    std::string name;   //!< for messages
    TopoDS_Shape shape; //!< an edge, a wire, a face (its wires) or a compound of these, on or near the face
    PlySide side = PlySide::Inside;
    gp_Pnt point; //!< of PlySide::Nearest
};

//! One ply, from the lay-up surface outwards.
struct PlySpec
{
    double thickness = 0.0;              //!< [mm], above zero
    std::optional<std::size_t> boundary; //!< which of the boundaries; empty: the whole face
    //! How far the ply's edge keeps inside of the boundary, along the face [mm]. Range: >= 0. Default 0.
    double inset = 0.0;
};

struct PlyStackOptions
{
    //! Largest deviation [mm] of every surface from S + d N. Range: > 0. Default 1e-3.
    double tolerance = 1e-3;
    //! Highest degree of fitted surfaces. Range: 3 to 7. Default 7.
    int max_degree = 7;
    //! +1: plies are laid along the face's outward normal, -1: against it. Default +1.
    double direction = 1.0;
    //! Where the first ply's bottom would be if every ply covered the whole face, along the outward normal [mm]. Default 0.
    double start = 0.0;
    //! Length of a ramp in thicknesses of the ply that ends there. Range: 1 to 1000. Default 20. A short ramp costs poles.
    double ratio = 20.0;
    //! Length of every ramp instead [mm]. Range: > 0. Default none.
    std::optional<double> ramp_length;
    //! Whether ratio or length stand for the mean or for the steepest slope. Default Mean.
    RampSlope ramp_slope = RampSlope::Mean;
    //! Largest distance of a boundary from the face [mm]; one that stands farther off is refused. Range: >= 0. Default none: a
    //! quarter of the boundary's own size or of the face's, whichever is less, 1 mm at least.
    std::optional<double> boundary_gap;
    //! Surfaces half way through the plies are made as well. Default no.
    bool middle = false;
    //! Progress and cancellation. Default none. It may be called from any thread.
    Progress progress;
};

//! One surface of a ply.
struct PlySurface
{
    OffsetResult result;    //!< its report's distance is that where every ply is present
    bool over_ramp = false; //!< its distance from the lay-up face varies
};

//! How the plies above come down beside a ply. Slopes are heights over lengths along the lay-up face; both ends are level.
struct RampFigures
{
    double length = 0.0;   //!< [mm]
    double mean = 0.0;     //!< slope: the ply's thickness over the length
    double steepest = 0.0; //!< largest slope seen
};

//! Ramps that lie over each other, since plies end along one line or nearly so: their slopes add up. Slopes are heights
//! over lengths along the lay-up face.
struct SteepRamps
{
    double slope = 0.0;             //!< of a ply's surface over all of them, the largest one seen
    double alone = 0.0;             //!< the largest one that a single one of them has, or was asked for
    Where where;                    //!< the place of `slope`, on the lay-up face
    double longest = 0.0;           //!< length of the longest one [mm]; edges so far apart have ramps apart
    std::vector<std::size_t> plies; //!< that end there, counted from 0
};

struct StackedPly
{
    TopoDS_Face region; //!< what it covers, on the lay-up face itself
    //! Distance of its bottom from the lay-up surface over the region's parameters, along S_u x S_v [mm], for ply_integrals.
    std::shared_ptr<const ScalarSpline> distance;
    double thickness = 0.0;          //!< along S_u x S_v [mm], signed
    std::optional<RampFigures> ramp; //!< empty where no ply above comes down beside it
    PlySurface bottom;
    std::optional<PlySurface> middle; //!< where asked for
    PlySurface top;
};

struct PlyStackResult
{
    //! The lay-up face again with its seam at another place, where boundaries would have crossed it; the plies and their
    //! regions have its parameters. Empty where the face was taken as it is.
    std::optional<TopoDS_Face> moved_seam;
    std::vector<StackedPly> plies;
    //! Largest distance seen of each boundary from the face [mm], inside the face's loops; empty where no ply has it.
    std::vector<std::optional<double>> boundary_gaps;
    double inset_error = 0.0; //!< largest error seen of a boundary moved inwards [mm]; 0 where none was
    //! Where ramps together are steeper than each of them alone by more than 5 percent: for every set of boundaries whose
    //! ramps lie over each other the worst place, the worst set first.
    std::vector<SteepRamps> steep_ramps;
    double elapsed = 0.0; //!< [ms]
};

//! Lays plies on a trimmed face.
//! \return the stack, or the first refusal; nothing is made in part.
//! Refusals: those of offset_stack and project_curve; InvalidOption for an option out of its range; NotSupported for a
//! boundary that stands too far from the face, does not cut it or leaves several parts of it, an open boundary without a side, a ramp that would
//! take too many poles, and for a creased face, which is told before any boundary is looked at. Messages name the boundary.
Result<PlyStackResult> stack_plies(const TopoDS_Shape &face, const std::vector<PlySpec> &plies,
                                   const std::vector<PlyBoundary> &boundaries, const PlyStackOptions &options);

} // namespace laminate_offset
