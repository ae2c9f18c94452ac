// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! OffsetReport as Python's own types, in the documented JSON form.
#pragma once

#include <laminate_offset/report/offset_report.h>

#include <pybind11/pybind11.h>

namespace laminate_offset::python
{

//! The report as a dict with the keys of the JSON format, in its order.
pybind11::object to_python(const OffsetReport &report);

} // namespace laminate_offset::python
