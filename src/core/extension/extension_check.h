// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Does an extension fold, or meet another part of the surface?
#pragma once

#include "../base/extension_options.h"
#include "../input/input_face.h"
#include "../spline/tensor_spline.h"

#include <Geom_Surface.hxx>

#include <optional>

namespace laminate_offset
{

//! A place past a side where the extension turns over or comes to a point, seen along 33 iso-curves.
struct ExtensionFold
{
    gp_Pnt2d uv;
    double length = 0.0; //!< arc length from the join [mm]
};

//! \param before the rectangle without, `after` with the extension at one side.
std::optional<ExtensionFold> find_fold(const Geom_Surface &surface, const ParameterBox &before,
                                       const ParameterBox &after, Side side);

//! Two places of the surface at one point of space; the first lies in an extension.
struct ExtensionMeeting
{
    gp_Pnt2d first;
    gp_Pnt2d second;
};

//! Searches pairs of patches, one of them past the rectangle `base`, as analysis/self_intersection does: pairs are
//! settled when their boxes lie apart or when the surface is one-to-one over both, and a meeting is reported only
//! when it has been computed, to rounding. Where the rectangle's own sides meet (a closed direction) or lie in one
//! point, places that continue them are no meeting. Pairs still open at the budget count as apart.
std::optional<ExtensionMeeting> find_meeting(const TensorSpline &surface, const ParameterBox &base);

} // namespace laminate_offset
