// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Stage Surface: the offset of the base surface, before it is trimmed.
#pragma once

#include "../analysis/surface_analysis.h"
#include "../base/options.h"
#include "../base/result.h"
#include "../input/input_face.h"
#include "../spline/monotone_map.h"

#include <Geom_Surface.hxx>

#include <memory>
#include <optional>

namespace laminate_offset
{

//! The offset surface. A base parameter (u, v) belongs to (u, v) + parameter_shift of the result, or to the place that
//! the parameter map takes to (u, v).
struct OffsetSurface
{
    Handle(Geom_Surface) geometry;
    gp_Vec2d parameter_shift{0.0, 0.0};
    std::optional<double> certified_error; //!< proven bound of |O - (S + d N)| at places that belong together [mm]
    std::optional<double> sampled_error;   //!< largest deviation seen [mm]; empty for exact surfaces
    //! From the result's own parameters to the base's, where they are more than shifted.
    std::shared_ptr<const ParameterMap> parameter_map = nullptr;
    bool apart = true; //!< false: whether distant parts of it meet could not be settled (check_meetings.h)
};

//! Parts of the user's tolerance. The surface takes nearly all of it, because its poles are many; the
//! edge curves, cheap to refine, take the rest, so that an edge stays within the tolerance of the
//! exact offset of its base edge: surface_share + edge_share = 1.
inline constexpr double surface_share = 0.9;
inline constexpr double edge_share = 0.1;

//! Bound of the rounding [mm] of a few dozen operations on coordinates of the face's size.
double rounding_of(const InputFace &input, double distance);

//! The offset surface with the fewest poles of those that the base permits: analytic where the base is
//! (exact_offset), the base itself at distance 0, else the fewest of hidden_offset, fit_offset and, for a distance
//! below the tolerance, the base itself.
//! \param distance from InputFace::surface along S_u x S_v [mm], inside the limits of the analysis.
//! Refusals: those of fit_offset.
Result<OffsetSurface> offset_surface(const SurfaceAnalysis &analysis, const InputFace &input, double distance,
                                     const OffsetOptions &options);

//! The offset of a plane, cylinder, cone, sphere or torus, also where a surface of extrusion or revolution is one,
//! as the same kind of surface in the same parameters up to a shift. Nothing for any other base, and where the base is
//! off its form (AnalyticForm::error) by a part of the tolerance that counts.
//! \param distance as above.
//! \param tolerance of the face [mm].
std::optional<OffsetSurface> exact_offset(const InputFace &input, double distance, double tolerance);

//! The offset of a spline base that is a plane, cylinder, cone, sphere or torus to within a small part of the
//! tolerance, on the base's own knots and weights, less those that are redundant. How the shape was recognised
//! does not matter: the certificate proves the result. A cone or torus has one only where the parameters run along
//! its circles.
//! \param tolerance the bound to prove [mm].
//! \return nothing where the base is no such shape.
std::optional<OffsetSurface> hidden_offset(const SurfaceAnalysis &analysis, double distance, double tolerance);

//! A B-spline in the base's parameters, polynomial or over a rational base's own weights, within `tolerance` [mm] of
//! the exact offset, with degree and knots chosen for few poles. The bound is proven over the trimmed region (certificate.h)
//! where the base is a spline in its own parameters or has a model; else it is checked at a dense set of samples.
//! \param distance along S_u x S_v [mm].
//! Refusals: SingularNormal, ToleranceNotReached, Cancelled.
Result<OffsetSurface> fit_offset(const SurfaceAnalysis &analysis, const InputFace &input, double distance,
                                 double tolerance, const OffsetOptions &options);

} // namespace laminate_offset
