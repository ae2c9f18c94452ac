// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! stack_plies of the engine for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace laminate_offset::python
{

void bind_ply_stack(pybind11::module_ &module);

} // namespace laminate_offset::python
