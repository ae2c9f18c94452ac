// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Extreme principal curvatures of the base inside its trimming loops.
#pragma once

#include "base_surface.h"
#include "loop_region.h"

#include <optional>

namespace laminate_offset
{

//! A principal curvature [1/mm] and its place. Positive where the surface bends towards S_u x S_v, so
//! that S + d N folds at d = 1 / curvature.
struct PlacedCurvature
{
    double curvature = 0.0;
    gp_Pnt2d uv;
};

struct CurvatureExtremes
{
    std::optional<PlacedCurvature> lowest;
    std::optional<PlacedCurvature> highest;
};

//! Both principal curvatures at a jet of order 2 with its unit normal, lower one first. Nothing at
//! singular places.
std::optional<std::pair<double, double>> principal_curvatures(const SurfaceJet &jet);

//! Searches a grid, the loops themselves, and then around the best places found. The extremes found are
//! attained, so the true ones are at least as extreme.
CurvatureExtremes curvature_extremes(const BaseSurface &base, const InputFace &input, const LoopRegion &region);

} // namespace laminate_offset
