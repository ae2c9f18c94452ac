// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! extend_face for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace laminate_offset::python
{

void bind_extend_face(pybind11::module_ &module);

} // namespace laminate_offset::python
