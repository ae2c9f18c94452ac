// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Nearest points against OpenCASCADE's extrema.
#pragma once

#include "cases.h"

#include <filesystem>
#include <iosfwd>
#include <optional>

namespace benchmark
{

//! On every face, `count` random points on the surface and off it: how much farther than OpenCASCADE's nearest point
//! (of Extrema_ExtPS's minima, and of the border curves), and how many points a second each way. Faces with few poles come
//! first, since those with many take OpenCASCADE hours.
//! \param table a CSV file with a line for every finished face, written at once: a run that was ended goes on behind the
//! faces it holds for the same count. Without it nothing is kept.
void run_nearest(std::vector<BaseFace> faces, int count, const std::optional<std::filesystem::path> &table,
                 std::ostream &out);

} // namespace benchmark
