// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_face_binding.h"

#include "detached_shape.h"
#include "offset_error.h"
#include "offset_options_binding.h"
#include "offset_report_binding.h"
#include "python_progress.h"
#include "shape_exchange.h"
#include "without_gil.h"

#include <laminate_offset/offset_face.h>

#include <optional>
#include <pybind11/stl.h>
#include <string>

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

//! The core reports from inside its long stages only; the begin and the end are told here, so that every
//! computation can be watched and cancelled.
Result<OffsetResult> run_without_gil(const TopoDS_Shape &base, OffsetOptions options, PythonProgress &progress)
{
    const Failure cancelled{Status::Cancelled, Stage::Options, std::string(sentence(Status::Cancelled)), {}, {}};
    options.progress = [&progress](double fraction) { return progress.report(fraction); };
    return without_gil([&]() -> Result<OffsetResult> {
        if (!progress.report(0.0))
            return cancelled;
        Result<OffsetResult> result = offset_face(base, options);
        if (result && !progress.report(1.0))
            return cancelled;
        return result;
    });
}

py::tuple offset_face_for_python(const py::object &shape, double distance, double tolerance, const std::string &method,
                                 double extension, std::optional<int> max_degree, py::object callback)
{
    const OffsetOptions options = make_options(distance, tolerance, method, extension, max_degree);
    const TopoDS_Shape base = from_part(shape, selected_exchange());
    if (const Result<bool> checked = check(options); !checked)
        raise(checked.failure(), options);
    PythonProgress progress(std::move(callback));
    const Result<OffsetResult> result = run_without_gil(detached(base), options, progress);
    progress.rethrow();
    if (!result)
        raise(result.failure(), options);
    return py::make_tuple(to_part(result.value().shape, selected_exchange()), to_python(result.value().report));
}

} // namespace

void bind_offset_face(py::module_ &module)
{
    const OffsetOptions defaults;
    module.def("offset_face", &offset_face_for_python, py::arg("shape"), py::arg("distance"),
               py::arg("tolerance") = defaults.tolerance, py::arg("method") = std::string(name(defaults.method)),
               py::arg("extension") = defaults.extension, py::arg("max_degree") = py::none(),
               py::arg("progress") = py::none(),
               "Offsets one Part.Face; lengths in mm, the distance signed along the face's outward normal. Returns "
               "the new face, or the shell of a creased face's parts, and the report as a dict, or raises OffsetError, "
               "ValueError or TypeError.");
}

} // namespace laminate_offset::python
