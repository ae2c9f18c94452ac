// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The integrals of a face to Python.
#pragma once

#include <pybind11/pybind11.h>

namespace laminate_offset::python
{

void bind_face_integrals(pybind11::module_ &module);

} // namespace laminate_offset::python
