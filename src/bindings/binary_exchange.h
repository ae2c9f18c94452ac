// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Shapes cross in FreeCAD's binary format: a BinTools_ShapeSet of version 3, then three integers that
//! give the root's number, location and orientation. FreeCAD reads and writes it by file name only.
#pragma once

#include <TopoDS_Shape.hxx>
#include <pybind11/pybind11.h>

namespace laminate_offset::python
{

TopoDS_Shape binary_from_part(const pybind11::object &part_shape);
pybind11::object binary_to_part(const TopoDS_Shape &shape);

} // namespace laminate_offset::python
