// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Ply stacks on two real fuselage panels beside a single ply and beside OpenCASCADE's route ply by ply.
#pragma once

#include <iosfwd>

namespace benchmark
{

//! Prints times, ratios, peak memory and what an independent sample sees. Each measurement runs in a process of its own.
void run_stacks(std::ostream &out);

} // namespace benchmark
