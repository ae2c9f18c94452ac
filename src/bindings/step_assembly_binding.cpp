// SPDX-License-Identifier: LGPL-2.1-or-later
#include "step_assembly_binding.h"

#include "shape_exchange.h"

#include <exchange/step_assembly.h>

#include <pybind11/stl.h>

#include <array>
#include <string>
#include <tuple>
#include <vector>

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

using Part = std::tuple<py::object, std::string, std::array<double, 3>>;

StepSchema schema_named(const std::string &text)
{
    if (text == "AP214")
        return StepSchema::Ap214;
    if (text == "AP242")
        return StepSchema::Ap242;
    throw py::value_error("schema must be AP214 or AP242; it is '" + text + "'.");
}

//! The GIL is kept: it is what lets only one thread into OpenCASCADE's STEP settings.
void write_step_assembly_for_python(const std::string &path, const std::string &name, const std::vector<Part> &parts,
                                    const std::string &schema)
{
    std::vector<NamedPart> named;
    for (const auto &[shape, label, colour] : parts)
        named.push_back({from_part(shape, selected_exchange()), label, colour});
    write_step_assembly(path, name, named, schema_named(schema));
}

} // namespace

void bind_step_assembly(py::module_ &module)
{
    module.def("write_step_assembly", &write_step_assembly_for_python, py::arg("path"), py::arg("name"),
               py::arg("parts"), py::arg("schema"),
               "Writes an assembly of named, coloured parts, (shape, name, (red, green, blue)) each, as STEP AP214 or "
               "AP242 in mm. Raises RuntimeError, ValueError or TypeError.");
}

} // namespace laminate_offset::python
