// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The solids of a stack to Python.
#pragma once

#include <pybind11/pybind11.h>

namespace laminate_offset::python
{

void bind_ply_solids(pybind11::module_ &module);

} // namespace laminate_offset::python
