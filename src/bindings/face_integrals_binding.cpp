// SPDX-License-Identifier: LGPL-2.1-or-later
#include "face_integrals_binding.h"

#include "laid_layer.h"
#include "offset_error.h"
#include "shape_exchange.h"

#include <laminate_offset/face_integrals.h>

#include <array>
#include <pybind11/stl.h>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

using Triple = std::array<double, 3>;

py::dict face_integrals_for_python(const py::object &shape, const std::vector<double> &distances,
                                   const std::vector<std::pair<double, double>> &intervals)
{
    const Result<FaceIntegrals> found = face_integrals(from_part(shape, selected_exchange()));
    if (!found)
        raise(found.failure(), OffsetOptions{});
    const FaceIntegrals &face = found.value();
    std::vector<double> areas;
    for (const double distance : distances)
        areas.push_back(face.area_at(distance));
    std::vector<double> volumes;
    std::vector<Triple> moments;
    for (const auto &[low, high] : intervals)
    {
        volumes.push_back(face.volume(low, high));
        const gp_XYZ moment = face.first_moment(low, high);
        moments.push_back({moment.X(), moment.Y(), moment.Z()});
    }
    py::dict result;
    result["area"] = face.area;
    result["mean_curvature"] = face.mean_curvature;
    result["gaussian_curvature"] = face.gaussian_curvature;
    result["relative_error"] = face.relative_error;
    result["areas"] = areas;
    result["volumes"] = volumes;
    result["moments"] = moments;
    return result;
}

py::list ply_integrals_for_python(const py::object &region, const std::vector<LaidLayer> &layers)
{
    std::vector<PlyLayer> between;
    for (const LaidLayer &layer : layers)
        between.push_back({*layer.distance, layer.thickness});
    const Result<std::vector<PlyIntegrals>> found = ply_integrals(from_part(region, selected_exchange()), between);
    if (!found)
        raise(found.failure(), OffsetOptions{});
    py::list result;
    for (const PlyIntegrals &ply : found.value())
    {
        py::dict figures;
        figures["area"] = ply.area;
        figures["volume"] = ply.volume;
        figures["moment"] = Triple{ply.first_moment.X(), ply.first_moment.Y(), ply.first_moment.Z()};
        figures["relative_error"] = ply.relative_error;
        result.append(figures);
    }
    return result;
}

} // namespace

void bind_face_integrals(py::module_ &module)
{
    module.def("face_integrals", &face_integrals_for_python, py::arg("shape"), py::arg("distances"),
               py::arg("intervals"),
               "Integrals over one Part.Face without a mesh: its area, integral mean and Gaussian curvature, their "
               "estimated relative error; the areas in mm2 of its offsets at the distances in mm along the outward "
               "normal; volumes in mm3 and first moments (x, y, z) in mm4 between the two distances of every interval. "
               "Raises OffsetError.");
    py::class_<LaidLayer>(module, "LaidLayer", "Where a ply of stack_plies lies over its region.");
    module.def(
        "ply_integrals", &ply_integrals_for_python, py::arg("region"), py::arg("layers"),
        "For each LaidLayer over the Part.Face of its region: the area in mm2 of its middle surface, its volume in "
        "mm3, first moment in mm4 and their estimated relative error. Raises OffsetError.");
}

} // namespace laminate_offset::python
