// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shape_exchange.h"

#include "binary_exchange.h"
#include "brep_text_exchange.h"
#include "zero_copy_exchange.h"

#include <Standard_Version.hxx>
#include <fmt/format.h>

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

ShapeExchange &selection()
{
    static ShapeExchange way = ShapeExchange::BrepText;
    return way;
}

TopoDS_Shape read_part(const py::object &part_shape, ShapeExchange way)
{
    switch (way)
    {
    case ShapeExchange::ZeroCopy: return zero_copy_from_part(part_shape);
    case ShapeExchange::Binary: return binary_from_part(part_shape);
    case ShapeExchange::BrepText: break;
    }
    return brep_text_from_part(part_shape);
}

py::object write_part(const TopoDS_Shape &shape, ShapeExchange way)
{
    switch (way)
    {
    case ShapeExchange::ZeroCopy: return zero_copy_to_part(shape);
    case ShapeExchange::Binary: return binary_to_part(shape);
    case ShapeExchange::BrepText: break;
    }
    return brep_text_to_part(shape);
}

} // namespace

std::string_view name(ShapeExchange way)
{
    switch (way)
    {
    case ShapeExchange::ZeroCopy: return "zero-copy";
    case ShapeExchange::Binary: return "binary";
    case ShapeExchange::BrepText: break;
    }
    return "brep-text";
}

ShapeExchange shape_exchange_by_name(const std::string &text)
{
    for (const ShapeExchange way : {ShapeExchange::ZeroCopy, ShapeExchange::Binary, ShapeExchange::BrepText})
        if (text == name(way))
            return way;
    throw py::value_error(
        fmt::format("There is no shape exchange '{}'; use 'zero-copy', 'binary' or 'brep-text'.", text));
}

ShapeExchange selected_exchange() { return selection(); }

TopoDS_Shape from_part(const py::object &part_shape, ShapeExchange way)
{
    const py::object shape_type = py::module_::import("Part").attr("Shape");
    if (!py::isinstance(part_shape, shape_type))
        throw py::type_error(fmt::format("A Part.Face is needed, not {}; of a document object take a face of its "
                                         "shape, as in obj.Shape.Faces[0].",
                                         py::str(py::type::of(part_shape).attr("__name__")).cast<std::string>()));
    if (part_shape.attr("isNull")().cast<bool>())
        return {};
    return read_part(part_shape, way);
}

py::object to_part(const TopoDS_Shape &shape, ShapeExchange way)
{
    // FreeCAD's readers give a plain Part.Shape; the cast makes it the Part.Face it is.
    return py::module_::import("Part").attr("cast_to_shape")(write_part(shape, way));
}

void bind_shape_exchange(py::module_ &module)
{
    module.attr("occt_version") = OCC_VERSION_COMPLETE;
    module.def(
        "shape_exchange", [] { return std::string(name(selected_exchange())); },
        "The way in which shapes cross between FreeCAD and the engine.");
    module.def(
        "select_shape_exchange", [](const std::string &way) { selection() = shape_exchange_by_name(way); },
        py::arg("way"), "Makes 'zero-copy', 'binary' or 'brep-text' the way of every later call.");
    module.def(
        "round_trip",
        [](const py::object &shape, const std::string &way) {
            const ShapeExchange by = shape_exchange_by_name(way);
            const TopoDS_Shape taken = from_part(shape, by);
            if (taken.IsNull())
                throw py::value_error("The shape is null: there is nothing to exchange.");
            return to_part(taken, by);
        },
        py::arg("shape"), py::arg("way"), "The shape after a way to the engine and back; a check of that way.");
}

} // namespace laminate_offset::python
