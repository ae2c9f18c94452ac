// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_error.h"

#include "offset_report_binding.h"

#include <laminate_offset/report/offset_report.h>

#include <pybind11/pybind11.h>

#include <optional>
#include <string>

namespace py = pybind11;

namespace laminate_offset::python
{

py::dict place_for_python(const Where &where)
{
    using namespace py::literals;
    return py::dict("u"_a = where.uv.X(), "v"_a = where.uv.Y(), "x"_a = where.point.X(), "y"_a = where.point.Y(),
                    "z"_a = where.point.Z());
}

namespace
{

bool is_bad_argument(Status status)
{
    return status == Status::InvalidDistance || status == Status::InvalidTolerance || status == Status::InvalidOption;
}

py::object to_python(const std::optional<double> &value)
{
    return value ? py::object(py::float_(*value)) : py::object(py::none());
}

py::object to_python(const std::optional<Where> &where)
{
    return where ? py::object(place_for_python(*where)) : py::object(py::none());
}

py::object to_python(const std::optional<FeasibleRange> &range)
{
    if (!range)
        return py::none();
    return py::make_tuple(to_python(range->negative), to_python(range->positive));
}

[[noreturn]] void raise_with(const Failure &failure, const py::object &report)
{
    if (is_bad_argument(failure.status))
        throw py::value_error(failure.message);
    const py::object error_type = py::module_::import("laminate_offset.errors").attr("OffsetError");
    const py::object error =
        error_type(std::string(name(failure.status)), std::string(name(failure.stage)), failure.message,
                   to_python(failure.where), to_python(failure.feasible_range), report);
    PyErr_SetObject(error_type.ptr(), error.ptr());
    throw py::error_already_set();
}

} // namespace

void raise(const Failure &failure, const OffsetOptions &options)
{
    raise_with(failure, python::to_python(refusal_report(failure, options)));
}

void raise(const Failure &failure, const std::string &report)
{
    raise_with(failure, py::module_::import("json").attr("loads")(report));
}

} // namespace laminate_offset::python
