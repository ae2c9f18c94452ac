// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Shapes cross as OpenCASCADE's BREP text: the slowest way, and the one that always works.
#pragma once

#include <TopoDS_Shape.hxx>
#include <pybind11/pybind11.h>

namespace laminate_offset::python
{

TopoDS_Shape brep_text_from_part(const pybind11::object &part_shape);
pybind11::object brep_text_to_part(const TopoDS_Shape &shape);

} // namespace laminate_offset::python
