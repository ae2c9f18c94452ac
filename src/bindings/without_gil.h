// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Engine work without the GIL, behind other threads where these asked for it.
#pragma once

#include <pybind11/pybind11.h>

#include <exception>
#include <optional>
#include <thread>
#include <utility>

namespace laminate_offset::python
{

//! By how much engine work that the calling thread starts steps back (niceness); 0: not at all.
int engine_niceness();

//! Lets the calling thread step back where the system has priorities of threads.
void step_back(int niceness);

void bind_engine_niceness(pybind11::module_ &module);

//! Does the work without the GIL; other threads of Python go on meanwhile. Where the calling thread asked for it, a thread
//! of lower priority does the work: the calling thread keeps its own, since one that steps back while it holds the GIL
//! would hold up all others.
template <typename Work> auto without_gil(const Work &work) -> decltype(work())
{
    const pybind11::gil_scoped_release release;
    const int niceness = engine_niceness();
    if (niceness == 0)
        return work();
    std::optional<decltype(work())> result;
    std::exception_ptr raised;
    std::thread([&] {
        step_back(niceness);
        try
        {
            result.emplace(work());
        }
        catch (...)
        {
            raised = std::current_exception();
        }
    }).join();
    if (raised)
        std::rethrow_exception(raised);
    return *std::move(result);
}

} // namespace laminate_offset::python
