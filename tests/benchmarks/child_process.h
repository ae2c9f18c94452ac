// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Runs one measurement in a process of its own: a crash or an endless run costs one line of the table, and the
//! peak memory belongs to that measurement alone.
#pragma once

#include "routes.h"

#include <functional>

namespace benchmark
{

struct ChildResult
{
    Outcome outcome;
    double peak_mib = 0.0; //!< largest resident memory of the process
    double wall_ms = 0.0;
};

//! \param limit_s after which the process is ended; status is then "timeout", after a crash "crash".
ChildResult run_in_child(const std::function<Outcome()> &work, double limit_s);

} // namespace benchmark
