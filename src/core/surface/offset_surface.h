// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Stage Surface: the offset of the base surface, before it is trimmed.
#pragma once

#include "../analysis/surface_analysis.h"
#include "../base/options.h"
#include "../base/result.h"
#include "../input/input_face.h"

#include <Geom_Surface.hxx>

#include <optional>

namespace laminate_offset
{

//! The offset surface. A base parameter (u, v) belongs to (u, v) + parameter_shift of the result.
struct OffsetSurface
{
    Handle(Geom_Surface) geometry;
    gp_Vec2d parameter_shift{0.0, 0.0};
    std::optional<double> certified_error; //!< proven bound of |O - (S + d N)| [mm]
    std::optional<double> sampled_error;   //!< largest deviation seen [mm]; empty for exact surfaces
};

//! Parts of the user's tolerance. The surface takes nearly all of it, because its poles are many; the
//! edge curves, cheap to refine, take the rest, so that an edge stays within the tolerance of the
//! exact offset of its base edge: surface_share + edge_share = 1.
inline constexpr double surface_share = 0.9;
inline constexpr double edge_share = 0.1;

//! The offset of a plane, cylinder, cone, sphere or torus as the same kind of surface in the same
//! parameters (a cone may shift them), or nothing for any other base.
//! \param distance along S_u x S_v [mm].
//! Refusal: CurvatureLimit, where the radius inside the loops would not stay positive.
std::optional<Result<OffsetSurface>> exact_offset(const InputFace &input, double distance);

//! A polynomial B-spline in the base's parameters within `tolerance` [mm] of the exact offset, with
//! degree and knots chosen for few poles. The bound is proven over the trimmed region (certificate.h)
//! where the base is a spline in its own parameters; else it is checked at a dense set of samples.
//! \param distance along S_u x S_v [mm].
//! Refusals: SingularNormal, ToleranceNotReached, Cancelled.
Result<OffsetSurface> fit_offset(const SurfaceAnalysis &analysis, const InputFace &input, double distance,
                                 double tolerance, const OffsetOptions &options);

} // namespace laminate_offset
