// SPDX-License-Identifier: LGPL-2.1-or-later
#include "without_gil.h"

#ifdef __linux__
    #include <sys/resource.h>
    #include <unistd.h>
#endif

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

thread_local int niceness_of_thread = 0;

void set_engine_niceness(int niceness)
{
    if (niceness < 0 || niceness > 19)
        throw py::value_error("niceness must be from 0 to 19.");
    niceness_of_thread = niceness;
}

} // namespace

int engine_niceness() { return niceness_of_thread; }

void step_back([[maybe_unused]] int niceness)
{
#ifdef __linux__
    // Linux gives every thread a priority of its own; threads that the engine starts from this one inherit it.
    const auto own = static_cast<id_t>(gettid());
    setpriority(PRIO_PROCESS, own, getpriority(PRIO_PROCESS, own) + niceness); // a wish, no need
#endif
}

void bind_engine_niceness(py::module_ &module)
{
    module.def(
        "set_engine_niceness", &set_engine_niceness, py::arg("niceness"),
        "By how much the engine's work that this thread starts later steps back behind other threads, 0 to 19; on "
        "Linux. Raises ValueError.");
}

} // namespace laminate_offset::python
