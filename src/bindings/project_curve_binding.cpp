// SPDX-License-Identifier: LGPL-2.1-or-later
#include "project_curve_binding.h"

#include "offset_error.h"
#include "shape_exchange.h"

#include <laminate_offset/project_curve.h>

#include <pybind11/stl.h>
#include <string>

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

Outside outside_by_name(const std::string &text)
{
    if (text == "clip")
        return Outside::Clip;
    if (text == "extend")
        return Outside::Extend;
    throw py::value_error("outside must be \"clip\" or \"extend\", not \"" + text + "\".");
}

//! The wire, a dict for each of its edges, and the largest figures. The GIL is kept: no other thread of Python can
//! change the shapes meanwhile.
py::tuple project_curve_for_python(const py::object &shape, const py::object &edge_or_wire, double tolerance,
                                   const std::string &outside)
{
    using namespace py::literals;
    const ShapeExchange way = selected_exchange();
    const Result<CurveProjection> result =
        project_curve(from_part(shape, way), from_part(edge_or_wire, way), {tolerance, outside_by_name(outside)});
    if (!result)
        raise(result.failure(), OffsetOptions{});
    py::list edges;
    for (const ProjectedEdge &edge : result.value().edges)
        edges.append(py::dict("first"_a = edge.first, "last"_a = edge.last, "certified_error"_a = edge.certified_error,
                              "sampled_error"_a = edge.sampled_error, "on_surface"_a = edge.on_surface,
                              "distance"_a = edge.distance, "certified_distance"_a = edge.certified_distance,
                              "bridged"_a = edge.bridged));
    return py::make_tuple(to_part(result.value().wire, way), edges, result.value().certified_error,
                          result.value().distance, result.value().certified_distance);
}

} // namespace

void bind_project_curve(py::module_ &module)
{
    const ProjectionOptions defaults;
    module.def("project_curve", &project_curve_for_python, py::arg("shape"), py::arg("edge_or_wire"),
               py::arg("tolerance") = defaults.tolerance, py::arg("outside") = "clip",
               "Drops a Part.Edge or Part.Wire onto one Part.Face; lengths in mm. Returns the wire, a list with a dict "
               "for each of its edges, the proven error or None, the largest distance seen, and the proven one or "
               "None; or raises OffsetError, ValueError or TypeError.");
}

} // namespace laminate_offset::python
