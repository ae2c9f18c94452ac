// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Every face of the real models: each must end in a valid certified offset or in a refusal with a reason and a place.
#pragma once

#include "cases.h"

#include <filesystem>
#include <iosfwd>

namespace benchmark
{

//! Offsets by +-0.1 and +-1 percent of the diagonal at 1e-3 mm; prints what failed and what was slow, and writes a
//! line for every offset into the CSV file. Whether a distance is feasible is judged by a dense grid inside the loops
//! and, for a refusal, by the curvatures at the place that it names.
void run_corpus(const std::vector<BaseFace> &faces, const std::filesystem::path &csv, std::ostream &out);

} // namespace benchmark
