// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_limits_binding.h"

#include "detached_shape.h"
#include "offset_error.h"
#include "shape_exchange.h"
#include "without_gil.h"

#include <laminate_offset/offset_limits.h>

#include <nlohmann/json.hpp>

#include <string>

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

//! Large faces take a second: other threads of Python go on, and have no hold on the copy of the face.
Result<OffsetLimits> search_without_gil(const TopoDS_Shape &face)
{
    return without_gil([&] { return offset_limits(face); });
}

//! The limits as JSON text.
std::string offset_limits_for_python(const py::object &shape)
{
    const Result<OffsetLimits> limits = search_without_gil(detached(from_part(shape, selected_exchange())));
    if (!limits)
        raise(limits.failure(), OffsetOptions{});
    return to_json(limits).dump();
}

} // namespace

void bind_offset_limits(py::module_ &module)
{
    module.def(
        "offset_limits", &offset_limits_for_python, py::arg("shape"),
        "The feasible distances of one Part.Face in mm, signed along its outward normal, as JSON text; or raises "
        "OffsetError or TypeError.");
}

} // namespace laminate_offset::python
