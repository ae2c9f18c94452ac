// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_report_binding.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <string>

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

py::object to_python(const nlohmann::ordered_json &json);

py::object dict_of(const nlohmann::ordered_json &json)
{
    py::dict dict;
    for (const auto &[key, value] : json.items())
        dict[py::str(key)] = to_python(value);
    return dict;
}

py::object list_of(const nlohmann::ordered_json &json)
{
    py::list list;
    for (const auto &value : json)
        list.append(to_python(value));
    return list;
}

//! JSON has no word for infinity and NaN; as in its text they become null.
py::object number_of(double value)
{
    return std::isfinite(value) ? py::object(py::float_(value)) : py::object(py::none());
}

py::object to_python(const nlohmann::ordered_json &json)
{
    if (json.is_object())
        return dict_of(json);
    if (json.is_array())
        return list_of(json);
    if (json.is_string())
        return py::str(json.get<std::string>());
    if (json.is_boolean())
        return py::bool_(json.get<bool>());
    if (json.is_number_integer())
        return py::int_(json.get<std::int64_t>());
    if (json.is_number_float())
        return number_of(json.get<double>());
    return py::none();
}

} // namespace

py::object to_python(const OffsetReport &report) { return to_python(to_json(report)); }

} // namespace laminate_offset::python
