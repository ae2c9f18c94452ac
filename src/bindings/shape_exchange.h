// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The one place where FreeCAD's Part.Shape becomes a TopoDS_Shape and back.
#pragma once

#include <TopoDS_Shape.hxx>
#include <pybind11/pybind11.h>

#include <string>
#include <string_view>

namespace laminate_offset::python
{

//! Ways to move a shape across, best first. All keep poles and orientation exactly; the placement too,
//! but for BREP text, which writes it with 15 digits.
enum class ShapeExchange
{
    ZeroCopy, //!< the same TShape on both sides, through SWIG's runtime; microseconds
    Binary,   //!< FreeCAD's own binary format through a temporary file; milliseconds
    BrepText  //!< OpenCASCADE's BREP text; ten times slower than Binary, understood everywhere
};

//! Stable identifier: "zero-copy", "binary" or "brep-text".
std::string_view name(ShapeExchange way);

//! \throw pybind11::value_error for an unknown name.
ShapeExchange shape_exchange_by_name(const std::string &text);

//! The way in use. It is process-wide and guarded by the GIL.
ShapeExchange selected_exchange();

//! The C++ shape of a Part.Shape; null for a null Part.Shape.
//! \throw pybind11::type_error when the object is no Part.Shape.
TopoDS_Shape from_part(const pybind11::object &part_shape, ShapeExchange way);

//! The Part.Face, Part.Wire ... of a shape that is not null.
pybind11::object to_part(const TopoDS_Shape &shape, ShapeExchange way);

void bind_shape_exchange(pybind11::module_ &module);

} // namespace laminate_offset::python
