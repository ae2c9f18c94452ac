// SPDX-License-Identifier: LGPL-2.1-or-later
#include "watched_progress.h"

#include <algorithm>
#include <stdexcept>

namespace py = pybind11;

namespace laminate_offset::python
{

bool WatchedProgress::report(double fraction) const
{
    m_state->fraction = m_start + m_width * std::clamp(fraction, 0.0, 1.0);
    return !m_state->cancelled;
}

WatchedProgress WatchedProgress::part(int index, int count) const
{
    if (index < 0 || index >= count)
        throw std::invalid_argument("index must be from 0 to count - 1.");
    WatchedProgress result(*this);
    result.m_width = m_width / count;
    result.m_start = m_start + index * result.m_width;
    return result;
}

void bind_watched_progress(py::module_ &module)
{
    py::class_<WatchedProgress>(module, "Progress",
                                "To be given as progress: the engine tells it how far it is without taking Python's "
                                "lock. Ctrl-C does not end the work.")
        .def(py::init<>())
        .def("__call__", &WatchedProgress::report, py::arg("fraction"),
             "Tells a fraction; False when it was cancelled.")
        .def("cancel", &WatchedProgress::cancel, "Asks the work to end.")
        .def("part", &WatchedProgress::part, py::arg("index"), py::arg("count"),
             "The progress of the index-th of count equal steps. Raises ValueError.")
        .def_property_readonly("fraction", &WatchedProgress::fraction, "How far the whole work is, from 0 to 1.")
        .def_property_readonly("cancelled", &WatchedProgress::cancelled, "Whether it was asked to end.");
}

} // namespace laminate_offset::python
