// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Points, normals and curvatures of a face to Python.
#pragma once

#include <pybind11/pybind11.h>

namespace laminate_offset::python
{

void bind_evaluate_face(pybind11::module_ &module);

} // namespace laminate_offset::python
