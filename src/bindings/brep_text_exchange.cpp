// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep_text_exchange.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>

#include <sstream>
#include <stdexcept>
#include <string>

namespace py = pybind11;

namespace laminate_offset::python
{

TopoDS_Shape brep_text_from_part(const py::object &part_shape)
{
    std::istringstream stream(part_shape.attr("exportBrepToString")().cast<std::string>());
    TopoDS_Shape shape;
    BRepTools::Read(shape, stream, BRep_Builder());
    if (shape.IsNull())
        throw std::runtime_error("FreeCAD's BREP text of the shape could not be read.");
    return shape;
}

py::object brep_text_to_part(const TopoDS_Shape &shape)
{
    std::ostringstream stream;
    BRepTools::Write(shape, stream);
    py::object part_shape = py::module_::import("Part").attr("Shape")();
    part_shape.attr("importBrepFromString")(stream.str());
    return part_shape;
}

} // namespace laminate_offset::python
