// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The default method beside the paper's.
#pragma once

#include <filesystem>
#include <iosfwd>

namespace benchmark
{

//! Offsets generated faces, the shipped examples and one free-form face of some real models by 1 percent of their
//! diagonal, to the outside where that is feasible, else inwards, with both methods at 1e-1 and 1e-3 mm. Prints a table
//! in Markdown with poles, time, proven and sampled error, and the medians of the ratios; the same as CSV. The error is
//! sampled at equal parameters for the default method, by projection for the other.
void run_methods(const std::filesystem::path &csv, std::ostream &out);

} // namespace benchmark
