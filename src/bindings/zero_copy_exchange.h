// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Shapes cross as SWIG pointers, the door FreeCAD opened for pythonOCC: both sides share the TShape.
#pragma once

#include <TopoDS_Shape.hxx>
#include <pybind11/pybind11.h>

namespace laminate_offset::python
{

//! The shape inside a Part.Shape; location and orientation included.
//! \throw std::runtime_error or a Python exception when FreeCAD's SWIG runtime is another than ours.
TopoDS_Shape zero_copy_from_part(const pybind11::object &part_shape);

//! A Part.Shape of the same TShape.
pybind11::object zero_copy_to_part(const TopoDS_Shape &shape);

} // namespace laminate_offset::python
