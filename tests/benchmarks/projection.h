// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Every edge of the real models put back onto its own face.
#pragma once

#include "cases.h"

#include <iosfwd>

namespace benchmark
{

//! Writes a line for every edge whose image is refused, not proven, or farther than the tolerance at dense samples, and a
//! summary; `all` writes a line for every edge.
void run_projection(const std::vector<BaseFace> &faces, bool all, std::ostream &out);

} // namespace benchmark
