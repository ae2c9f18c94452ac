// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_stack_binding.h"

#include "detached_shape.h"
#include "offset_error.h"
#include "offset_options_binding.h"
#include "offset_report_binding.h"
#include "python_progress.h"
#include "shape_exchange.h"
#include "without_gil.h"

#include <laminate_offset/offset_stack.h>

#include <optional>
#include <pybind11/stl.h>
#include <string>
#include <vector>

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

Result<StackResult> run_without_gil(const TopoDS_Shape &base, const std::vector<double> &distances,
                                    OffsetOptions options, StackFit fit, PythonProgress &progress)
{
    options.progress = [&progress](double fraction) { return progress.report(fraction); };
    return without_gil([&] { return offset_stack(base, distances, options, fit); });
}

py::tuple offset_stack_for_python(const py::object &shape, const std::vector<double> &distances, double tolerance,
                                  std::optional<int> max_degree, bool each, py::object callback)
{
    const OffsetOptions options =
        make_options(0.0, tolerance, std::string(name(Method::SameParameter)), 0.0, max_degree);
    const TopoDS_Shape base = from_part(shape, selected_exchange());
    PythonProgress progress(std::move(callback));
    const Result<StackResult> result =
        run_without_gil(detached(base), distances, options, each ? StackFit::Each : StackFit::Shared, progress);
    progress.rethrow();
    if (!result)
        raise(result.failure(), options);
    py::list surfaces;
    for (const OffsetResult &surface : result.value().surfaces)
        surfaces.append(py::make_tuple(to_part(surface.shape, selected_exchange()), to_python(surface.report)));
    return py::make_tuple(surfaces, result.value().one_fit, result.value().elapsed.total);
}

} // namespace

void bind_offset_stack(py::module_ &module)
{
    const OffsetOptions defaults;
    module.def("offset_stack", &offset_stack_for_python, py::arg("shape"), py::arg("distances"),
               py::arg("tolerance") = defaults.tolerance, py::arg("max_degree") = py::none(), py::arg("each") = false,
               py::arg("progress") = py::none(),
               "Offsets one Part.Face by many distances in mm along its outward normal, from one fit, or each from a "
               "fit of its own. "
               "Returns a list of "
               "(shape, report) in the order of the distances, whether they are one family, and the time in ms; or "
               "raises OffsetError, ValueError or TypeError.");
}

} // namespace laminate_offset::python
