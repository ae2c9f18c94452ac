// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Extensions of every free-form face of the real models.
#pragma once

#include "cases.h"

#include <filesystem>
#include <iosfwd>

namespace benchmark
{

//! Extends every face past all four sides by 5 percent of its diagonal, G1 and natural, by the mean and by the
//! at-least rule. Prints for every face the mean length ratio, the spread and the largest join angle, or the refusal,
//! and a summary; the same as CSV.
void run_extension(const std::vector<BaseFace> &faces, const std::filesystem::path &csv, std::ostream &out);

} // namespace benchmark
