// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The default method beside the paper's.
#pragma once

#include <filesystem>
#include <iosfwd>

namespace benchmark
{

//! Offsets generated faces, the shipped examples and one curved free-form face of some real models with both methods at
//! 1e-1 and 1e-3 mm, by 1 percent of their diagonal, or inwards, or by less, whatever is feasible first. Prints a table
//! in Markdown with poles, time, proven and sampled error, and the medians of the ratios; the same as CSV. The error is
//! sampled at equal parameters for the default method, by projection for the other.
void run_methods(const std::filesystem::path &csv, std::ostream &out);

} // namespace benchmark
