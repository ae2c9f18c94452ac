// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Progress and cancellation between the core, which runs without the GIL, and Python.
#pragma once

#include "watched_progress.h"

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <optional>

namespace laminate_offset::python
{

//! Passes the core's progress to a Python callable and watches for Ctrl-C.
//!
//! The core may call it often and from any thread: Python is asked at most every few milliseconds, by
//! one thread at a time, so a callable needs no lock and does not slow the computation down.
class PythonProgress
{
public:
    //! \param callback a callable taking a fraction in [0, 1] and returning a false value other than
    //! None to cancel; or None. A WatchedProgress is told at once and without the GIL.
    explicit PythonProgress(pybind11::object callback);

    //! Called without the GIL. \return false to cancel.
    bool report(double fraction);

    //! Throws what the callable raised, or KeyboardInterrupt. Needs the GIL.
    void rethrow() const;

    //! The callable asked to stop, or raised.
    [[nodiscard]] bool cancelled() const { return m_cancelled; }

private:
    using Clock = std::chrono::steady_clock;

    //! True for the first call, for the end, and when Python has not been asked for a while.
    bool due(double fraction);

    //! Asks Python. \return false to cancel.
    bool ask(double fraction);

    pybind11::object m_callback;
    std::optional<WatchedProgress> m_watched;
    std::exception_ptr m_raised;
    std::atomic<bool> m_cancelled = false;
    std::atomic_flag m_busy = ATOMIC_FLAG_INIT;
    Clock::time_point m_last_asked{}; //!< guarded by m_busy
};

} // namespace laminate_offset::python
