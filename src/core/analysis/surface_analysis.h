// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Stage Analysis: creases and curvature of the base inside its trimming loops.
#pragma once

#include "base_surface.h"
#include "loop_region.h"

#include "../base/result.h"
#include "../input/input_face.h"

#include <optional>

namespace laminate_offset
{

//! A signed distance up to which the offset is proven not to fold, and the place of the base where it
//! will fold soon after.
struct CurvatureLimit
{
    double distance = 0.0; //!< [mm] along S_u x S_v; feasible up to here
    double folds = 0.0;    //!< [mm] the offset certainly folds from here on; infinite when no place was found
    gp_Pnt2d uv;
};

//! What the base surface permits inside the loops. Distances here are from InputFace::surface along
//! S_u x S_v, the face's orientation and its own distance not yet included.
struct SurfaceAnalysis
{
    BaseSurface base;
    LoopRegion region;
    std::optional<CurvatureLimit> negative; //!< empty: no limit on that side
    std::optional<CurvatureLimit> positive;
    bool sampled =
        false; //!< curvature could only be sampled somewhere: at a pole, or on a base without spline or model
};

//! The base and its loops without the limits.
//! \param distance signed along S_u x S_v [mm]; decides whether a crease matters.
//! \param tolerance a crease that tears the offset by less than half of it is no crease [mm].
//! Refusals: KinkedSurface; CurvatureLimit for a face on an offset surface that is folded itself.
Result<SurfaceAnalysis> read_base(const InputFace &input, double distance, double tolerance);

//! The same whatever creases there are. Curvature is searched between the knots, so both sides of a crease count for what they
//! are by themselves, and the limits are the tightest of the parts that the face would be split into.
//! Refusal: CurvatureLimit as above.
Result<SurfaceAnalysis> read_creased_base(const InputFace &input, double distance, double tolerance);

//! The gap (see find_limits) of the limits that come with a refusal.
inline constexpr double refusal_gap = 5e-3;

//! Searches both limits; planes, cylinders, cones, spheres and tori have them in closed form.
//! \param distance the one that has to be decided [mm]; the search ends soon after it is found to be feasible, and
//! leaves limits that are proven but may fall short of the true ones, by a tenth or where these are costly by more.
//! 0: the limits themselves are wanted.
//! \param gap relative width between what is proven and what is attained at which a search ends.
void find_limits(SurfaceAnalysis &analysis, const InputFace &input, double distance, double gap);

//! Both in one, for one distance.
//! Refusals: those of read_base.
Result<SurfaceAnalysis> analyse(const InputFace &input, double distance, double tolerance);

//! Refuses a distance past the curvature limits, with the place and the feasible range.
Result<bool> check_distance(const SurfaceAnalysis &analysis, const InputFace &input, double distance);

//! The limits as signed distances from the face along its outward normal.
FeasibleRange feasible_range(const SurfaceAnalysis &analysis, const InputFace &input);

} // namespace laminate_offset
