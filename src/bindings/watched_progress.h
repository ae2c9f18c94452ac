// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Progress that is told and looked at without the GIL.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <memory>

namespace laminate_offset::python
{

//! How far work is, and whether it shall end. The core writes it from its own threads, Python looks at it from any other:
//! neither waits for the other, so that a thread of the core that has to wait for a processor holds nothing up.
//! Copies, and the parts made of it, share what they tell.
class WatchedProgress
{
public:
    WatchedProgress() : m_state(std::make_shared<State>()) {}

    //! \return false when the work shall end.
    [[nodiscard]] bool report(double fraction) const;

    [[nodiscard]] double fraction() const { return m_state->fraction; }
    [[nodiscard]] bool cancelled() const { return m_state->cancelled; }
    void cancel() const { m_state->cancelled = true; }

    //! What tells of the index-th of count equal steps. \throw std::invalid_argument unless 0 <= index < count.
    [[nodiscard]] WatchedProgress part(int index, int count) const;

private:
    struct State
    {
        std::atomic<double> fraction = 0.0;
        std::atomic<bool> cancelled = false;
    };

    std::shared_ptr<State> m_state;
    double m_start = 0.0; //!< the share of the whole work that is done before, and that of this part
    double m_width = 1.0;
};

void bind_watched_progress(pybind11::module_ &module);

} // namespace laminate_offset::python
