// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The surfaces between plies that cover parts of a face: S + d N with d the thickness that lies below.
#pragma once

#include "ply_region.h"

#include "../analysis/surface_analysis.h"
#include "../spline/scalar_spline.h"
#include "../surface/offset_surface.h"

#include <gp_Pnt2d.hxx>

#include <cstddef>
#include <optional>
#include <vector>

namespace laminate_offset
{

struct LaidPly
{
    double thickness = 0.0; //!< along S_u x S_v [mm], signed
    std::size_t region = 0; //!< which of the regions it covers
    double ramp = 0.0;      //!< length of the ramp beside its edge [mm], or the least where its steepest slope is given
};

struct Stacking
{
    double start = 0.0; //!< the first bottom's distance along S_u x S_v [mm]
    bool middle = false;
    bool steepest = false;      //!< a ramp is so long that nowhere it is steeper than thickness / LaidPly::ramp
    std::vector<LaidPly> plies; //!< from the lay-up surface outwards
};

//! One surface.
struct PlyLevel
{
    OffsetSurface surface;
    double nominal = 0.0;                 //!< distance where all plies below are present, along S_u x S_v [mm]
    double constant = 0.0;                //!< the distance where it does not vary [mm]
    std::optional<ScalarSpline> distance; //!< where it varies
};

//! How a ply's share goes from 1 to 0, level at both ends.
struct PlyRamp
{
    double length = 0.0;   //!< [mm]
    double steepest = 0.0; //!< largest slope seen of the share, along the lay-up surface [1/mm]
};

//! Ramps that lie over each other and are steeper together than each of them alone.
struct AddedRamps
{
    double slope = 0.0;             //!< of a surface over all of them, along the lay-up surface
    double alone = 0.0;             //!< the largest one that a single one of them has, or was asked for
    gp_Pnt2d uv;                    //!< where
    double longest = 0.0;           //!< length of the longest one [mm]
    std::vector<std::size_t> plies; //!< that have these ramps beside them, in their order
};

struct PlyLevels
{
    SurfaceAnalysis analysis;                  //!< of the whole face
    std::vector<PlyLevel> between;             //!< below the first ply, between each two, above the last
    std::vector<PlyLevel> middle;              //!< one for each ply, where asked for
    std::vector<LoopRegion> inside;            //!< of each region, its edges in short pieces
    std::vector<std::optional<PlyRamp>> ramps; //!< of each ply; empty where no ply above needs one
    //! The worst place for every set of boundaries whose ramps lie over each other, the worst one first.
    std::vector<AddedRamps> added;

    //! The bottom (0) and the top (1) of a ply, or bottom (0), middle (1) and top (2).
    [[nodiscard]] const PlyLevel &of(std::size_t ply, std::size_t which, bool with_middle) const;
};

//! Refuses a face that the surfaces up to a distance would be torn on at creases: boundaries are not carried across them.
//! \param farthest along S_u x S_v [mm].
//! Refusal: NotSupported at stage Analysis, at the worst crease; those of read_base but for creases.
Result<bool> check_uncreased(const InputFace &input, double farthest, double tolerance);

//! All surfaces of a stack, each certified over the regions of the plies that it bounds. A distance that is constant
//! there gives the offset at that distance, exact where the base permits; any other is a variable offset of one family.
//! \param regions all that plies cover; those without cuts are the whole face.
//! Refusals: those of check_uncreased, analyse, check_distance, fit_offset_family and fit_variable_offset; those of ply_share.
Result<PlyLevels> ply_levels(const InputFace &input, const Stacking &stacking, const std::vector<PlyRegion> &regions,
                             const OffsetOptions &options);

} // namespace laminate_offset
