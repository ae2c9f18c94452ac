// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ply_solids_binding.h"

#include "detached_shape.h"
#include "offset_error.h"
#include "offset_options_binding.h"
#include "shape_exchange.h"
#include "without_gil.h"

#include <laminate_offset/creased_solids.h>
#include <laminate_offset/ply_solids.h>

#include <optional>
#include <pybind11/stl.h>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

Result<std::vector<TopoDS_Solid>> run_without_gil(const std::vector<TopoDS_Shape> &faces,
                                                  const std::vector<SolidSpan> &spans)
{
    return without_gil([&] { return ply_solids(faces, spans); });
}

std::vector<SolidSpan> spans_of(const std::vector<std::pair<std::size_t, std::size_t>> &pairs)
{
    std::vector<SolidSpan> spans;
    for (const auto &[low, high] : pairs)
        spans.push_back({low, high});
    return spans;
}

py::list for_python(const std::vector<TopoDS_Solid> &solids)
{
    py::list list;
    for (const TopoDS_Solid &solid : solids)
        list.append(to_part(solid, selected_exchange()));
    return list;
}

py::list ply_solids_for_python(const std::vector<py::object> &faces,
                               const std::vector<std::pair<std::size_t, std::size_t>> &spans)
{
    std::vector<TopoDS_Shape> shapes;
    for (const py::object &face : faces)
        shapes.push_back(from_part(face, selected_exchange()));
    const Result<std::vector<TopoDS_Solid>> made = run_without_gil(shapes, spans_of(spans));
    if (!made)
        raise(made.failure(), OffsetOptions{});
    return for_python(made.value());
}

py::list creased_ply_solids_for_python(const py::object &shape, const std::vector<double> &distances,
                                       const std::vector<std::pair<std::size_t, std::size_t>> &spans, double tolerance,
                                       std::optional<int> max_degree)
{
    const OffsetOptions options =
        make_options(0.0, tolerance, std::string(name(Method::SameParameter)), 0.0, max_degree);
    const TopoDS_Shape face = detached(from_part(shape, selected_exchange()));
    const auto made = without_gil([&] { return creased_ply_solids(face, distances, spans_of(spans), options); });
    if (!made)
        raise(made.failure(), options);
    py::list list;
    for (const std::vector<TopoDS_Solid> &solids : made.value())
        list.append(for_python(solids));
    return list;
}

} // namespace

void bind_ply_solids(py::module_ &module)
{
    module.def(
        "ply_solids", &ply_solids_for_python, py::arg("faces"), py::arg("spans"),
        "Valid, closed Part.Solids between offsets of one face. A span holds the indices of two of the faces, that "
        "at the lower distance along the outward normal first; solids that meet share the face. Raises "
        "OffsetError or ValueError.");
    module.def(
        "creased_ply_solids", &creased_ply_solids_for_python, py::arg("shape"), py::arg("distances"), py::arg("spans"),
        py::arg("tolerance"), py::arg("max_degree") = py::none(),
        "For each span between two of the distances, which it counts from 0, the Part.Solids of the parts between "
        "the face's creases; lengths in mm. Raises OffsetError, ValueError or TypeError.");
}

} // namespace laminate_offset::python
