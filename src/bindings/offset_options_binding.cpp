// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_options_binding.h"

#include <fmt/format.h>

namespace py = pybind11;

namespace laminate_offset::python
{

Method method_by_name(const std::string &text)
{
    for (const Method method : {Method::SameParameter, Method::RaviKumar})
        if (text == name(method))
            return method;
    throw py::value_error(fmt::format("There is no method '{}'; use '{}' or '{}'.", text, name(Method::SameParameter),
                                      name(Method::RaviKumar)));
}

OffsetOptions make_options(double distance, double tolerance, const std::string &method, double extension,
                           std::optional<int> max_degree)
{
    OffsetOptions options;
    options.distance = distance;
    options.tolerance = tolerance;
    options.method = method_by_name(method);
    options.extension = extension;
    options.max_degree = max_degree.value_or(options.max_degree);
    return options;
}

void bind_offset_options(py::module_ &module)
{
    module.def(
        "default_options",
        [] {
            using namespace py::literals;
            const OffsetOptions options;
            return py::dict("distance"_a = options.distance, "tolerance"_a = options.tolerance,
                            "method"_a = std::string(name(options.method)), "extension"_a = options.extension,
                            "max_degree"_a = options.max_degree);
        },
        "The engine's defaults: lengths in mm, the method by its name.");
}

} // namespace laminate_offset::python
