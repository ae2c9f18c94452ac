// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! write_step_assembly for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace laminate_offset::python
{

void bind_step_assembly(pybind11::module_ &module);

} // namespace laminate_offset::python
