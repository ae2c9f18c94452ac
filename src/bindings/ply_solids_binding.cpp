// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ply_solids_binding.h"

#include "offset_error.h"
#include "shape_exchange.h"
#include "without_gil.h"

#include <laminate_offset/ply_solids.h>

#include <pybind11/stl.h>
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

py::list ply_solids_for_python(const std::vector<py::object> &faces,
                               const std::vector<std::pair<std::size_t, std::size_t>> &spans)
{
    std::vector<TopoDS_Shape> shapes;
    for (const py::object &face : faces)
        shapes.push_back(from_part(face, selected_exchange()));
    std::vector<SolidSpan> between;
    for (const auto &[low, high] : spans)
        between.push_back({low, high});
    const Result<std::vector<TopoDS_Solid>> made = run_without_gil(shapes, between);
    if (!made)
        raise(made.failure(), OffsetOptions{});
    py::list solids;
    for (const TopoDS_Solid &solid : made.value())
        solids.append(to_part(solid, selected_exchange()));
    return solids;
}

} // namespace

void bind_ply_solids(py::module_ &module)
{
    module.def(
        "ply_solids", &ply_solids_for_python, py::arg("faces"), py::arg("spans"),
        "Valid, closed Part.Solids between offsets of one face. A span holds the indices of two of the faces, that "
        "at the lower distance along the outward normal first; solids that meet share the face. Raises "
        "OffsetError or ValueError.");
}

} // namespace laminate_offset::python
