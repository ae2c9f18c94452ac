// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! How many processor cores the engine uses.
#pragma once

#include <pybind11/pybind11.h>

namespace laminate_offset::python
{

//! Adds limit_threads.
void bind_thread_limit(pybind11::module_ &module);

} // namespace laminate_offset::python
