// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A Failure of the core as the Python exception laminate_offset.OffsetError or ValueError.
#pragma once

#include <laminate_offset/base/options.h>
#include <laminate_offset/base/result.h>

#include <pybind11/pybind11.h>
#include <string>

namespace laminate_offset::python
{

//! A place on a face as {"u", "v", "x", "y", "z"}, x, y and z in mm.
pybind11::dict place_for_python(const Where &where);

//! Raises ValueError for an argument out of its range and OffsetError for every other refusal.
//! Needs the GIL.
[[noreturn]] void raise(const Failure &failure, const OffsetOptions &options);

//! The same with a report of the caller's own, as JSON text.
[[noreturn]] void raise(const Failure &failure, const std::string &report);

} // namespace laminate_offset::python
