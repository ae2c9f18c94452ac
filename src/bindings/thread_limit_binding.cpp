// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thread_limit_binding.h"

#include <oneapi/tbb/global_control.h>

#include <memory>

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

//! The limit holds as long as TBB's object lives; it is left to the end of the process, when TBB may be gone already.
std::unique_ptr<oneapi::tbb::global_control> &current_limit()
{
    static auto *limit = new std::unique_ptr<oneapi::tbb::global_control>();
    return *limit;
}

void limit_threads(int count)
{
    if (count < 0)
        throw py::value_error("count must be 0, for all processor cores, or more.");
    current_limit().reset();
    if (count > 0)
        current_limit() = std::make_unique<oneapi::tbb::global_control>(
            oneapi::tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
}

} // namespace

void bind_thread_limit(py::module_ &module)
{
    module.def("limit_threads", &limit_threads, py::arg("count"),
               "Lets later computations use at most count processor cores; 0 lifts the limit. Raises ValueError.");
}

} // namespace laminate_offset::python
