// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python_progress.h"

#include <algorithm>
#include <utility>

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

//! Short enough for a smooth bar and a prompt Esc; long enough that taking the GIL costs nothing.
constexpr std::chrono::milliseconds least_pause{10};

} // namespace

PythonProgress::PythonProgress(py::object callback) : m_callback(std::move(callback))
{
    if (!m_callback.is_none() && !PyCallable_Check(m_callback.ptr()))
        throw py::type_error("progress must be None or a callable that takes a fraction from 0 to 1.");
    if (py::isinstance<WatchedProgress>(m_callback))
        m_watched = m_callback.cast<WatchedProgress>();
}

bool PythonProgress::due(double fraction)
{
    const Clock::time_point now = Clock::now();
    if (m_last_asked != Clock::time_point{} && fraction < 1.0 && now - m_last_asked < least_pause)
        return false;
    m_last_asked = now;
    return true;
}

bool PythonProgress::ask(double fraction)
{
    if (PyErr_CheckSignals() != 0)
        throw py::error_already_set();
    if (m_callback.is_none())
        return true;
    const py::object answer = m_callback(std::clamp(fraction, 0.0, 1.0));
    return answer.is_none() || PyObject_IsTrue(answer.ptr()) == 1;
}

bool PythonProgress::report(double fraction)
{
    if (m_cancelled)
        return false;
    if (m_watched)
    {
        if (!m_watched->report(fraction))
            m_cancelled = true;
        return !m_cancelled;
    }
    if (m_busy.test_and_set())
        return true; // another thread is asking
    if (due(fraction))
    {
        const py::gil_scoped_acquire gil;
        try
        {
            m_cancelled = !ask(fraction);
        }
        catch (...)
        {
            // The core is not built to carry Python's exceptions: it is cancelled, and they go on after it.
            m_raised = std::current_exception();
            m_cancelled = true;
        }
    }
    m_busy.clear();
    return !m_cancelled;
}

void PythonProgress::rethrow() const
{
    if (m_raised)
        std::rethrow_exception(m_raised);
}

} // namespace laminate_offset::python
