// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! project_curve for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace laminate_offset::python
{

void bind_project_curve(pybind11::module_ &module);

} // namespace laminate_offset::python
