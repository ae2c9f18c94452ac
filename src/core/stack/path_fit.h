// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Curves on a surface that are fitted to paths in its parameters.
#pragma once

#include "geodesic_walker.h"
#include "path_part.h"

#include "../projection/curve_image.h"

#include <optional>

namespace laminate_offset
{

//! Pcurve and curve of a part, with as many spans as it needs; its distance is the largest error seen at places between
//! those it was fitted at [mm].
//! \param tolerance of the curve together with its pcurve [mm].
//! \return nothing where that is not reached.
std::optional<ImagePiece> fitted_piece(const GeodesicWalker &walker, const PathPart &part, double tolerance);

} // namespace laminate_offset
