// SPDX-License-Identifier: LGPL-2.1-or-later
#include "extend_face_binding.h"

#include "offset_error.h"
#include "shape_exchange.h"

#include <laminate_offset/extend_face.h>

#include <nlohmann/json.hpp>
#include <pybind11/stl.h>

#include <string>
#include <vector>

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

template <typename Value> Value known(std::optional<Value> value, const std::string &text, const char *what)
{
    if (!value)
        throw py::value_error("'" + text + "' is no " + what + ".");
    return *value;
}

ExtensionOptions make_options(double length, const std::vector<std::string> &sides, const std::string &continuity,
                              const std::string &rule)
{
    ExtensionOptions options;
    options.length = length;
    options.sides.clear();
    for (const std::string &side : sides)
        options.sides.push_back(known(side_named(side), side, "side; use u-min, u-max, v-min, v-max or all"));
    options.continuity = known(continuity_named(continuity), continuity, "continuity; use G1 or natural");
    options.rule = known(length_rule_named(rule), rule, "rule for the length; use mean or at-least");
    return options;
}

//! The new face and its report as JSON text. The GIL is kept: the work takes milliseconds.
py::tuple extend_face_for_python(const py::object &shape, double length, const std::vector<std::string> &sides,
                                 const std::string &continuity, const std::string &rule)
{
    const ExtensionOptions options = make_options(length, sides, continuity, rule);
    const Result<ExtensionResult> result = extend_face(from_part(shape, selected_exchange()), options);
    if (!result)
        raise(result.failure(), to_json(refusal_report(result.failure(), options)).dump());
    return py::make_tuple(to_part(result.value().face, selected_exchange()), to_json(result.value().report).dump());
}

} // namespace

void bind_extend_face(py::module_ &module)
{
    module.def("extend_face", &extend_face_for_python, py::arg("shape"), py::arg("length"), py::arg("sides"),
               py::arg("continuity"), py::arg("rule"),
               "Extends one Part.Face past the named sides by a length in mm. Returns the new face and the report as "
               "JSON text, or raises OffsetError, ValueError or TypeError.");
}

} // namespace laminate_offset::python
