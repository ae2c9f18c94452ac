// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Extreme principal curvatures of the base inside its trimming loops, proven from both sides.
//!
//! For kappa > 0, kappa bounds the larger principal curvature if kappa I - II is positive semidefinite,
//! with the fundamental forms I and II. |M| II = (S_uu.M, S_uv.M, S_vv.M) for M = S_u x S_v is polynomial,
//! and |M| >= M.n0 for any unit n0; so the Bernstein coefficients of the matrix polynomials
//! J = I (M.n0) and |M| II decide: the largest generalised eigenvalue of any pair of matrix
//! coefficients is an upper bound, which closes in quadratically as pieces are halved. A cheap bound from
//! the spread of the derivatives sorts out most pieces before. Rational pieces are multiplied through by
//! their weight function.
#pragma once

#include "base_surface.h"
#include "loop_region.h"

#include <optional>
#include <utility>

namespace laminate_offset
{

//! A bound of one principal curvature [1/mm]. Positive where the surface bends towards S_u x S_v, so that
//! S + d N folds at d = 1 / curvature.
struct CurvatureBound
{
    double attained = 0.0; //!< the most extreme curvature found, at uv
    double proven = 0.0;   //!< no curvature inside the loops is more extreme than this
    gp_Pnt2d uv;
    bool sampled = false; //!< somewhere (at a pole, or everywhere on a base without spline or model) only samples count
};

struct CurvatureExtremes
{
    CurvatureBound lowest;
    CurvatureBound highest;
};

//! Both principal curvatures at a jet of order 2, lower one first. Nothing at singular places, which show
//! if the parameters are scaled so that each runs over a range of about 1.
std::optional<std::pair<double, double>> principal_curvatures(const SurfaceJet &jet);

//! The same for parameters that run over ranges of about wu and wv.
std::optional<std::pair<double, double>> principal_curvatures(const SurfaceJet &jet, double wu, double wv);

//! What to search for.
struct CurvatureSearch
{
    //! [mm] along S_u x S_v. The search for that side's extreme goes on until it is decided whether
    //! 1 / distance lies beyond it, and the limits are left wide (but proven) soon after; the other side
    //! is looked at until it is known to about one half. 0: the limits themselves are wanted.
    double distance = 0.0;
    double gap = 1e-3;   //!< relative width between proven and attained at which a search ends
    double extent = 1.0; //!< [mm] size of the face; radii above a hundred extents are not pinned down
};

//! Branch and bound over the pieces that the loops touch.
CurvatureExtremes curvature_extremes(const BaseSurface &base, const LoopRegion &region, const CurvatureSearch &search);

} // namespace laminate_offset
