// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! OffsetOptions from Python's arguments.
#pragma once

#include <laminate_offset/base/options.h>

#include <pybind11/pybind11.h>

#include <optional>
#include <string>

namespace laminate_offset::python
{

//! \throw pybind11::value_error for an unknown name.
Method method_by_name(const std::string &text);

//! Options without progress, unchecked; an empty max_degree means the default.
OffsetOptions make_options(double distance, double tolerance, const std::string &method, double extension,
                           std::optional<int> max_degree);

void bind_offset_options(pybind11::module_ &module);

} // namespace laminate_offset::python
