// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nearest_point_binding.h"

#include "detached_shape.h"
#include "offset_error.h"
#include "shape_exchange.h"
#include "without_gil.h"

#include <laminate_offset/nearest_point.h>

#include <pybind11/numpy.h>
#include <vector>

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

using Points = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::vector<gp_Pnt> read_points(const Points &points)
{
    if (points.ndim() != 2 || points.shape(1) != 3)
        throw py::value_error("points must be an array of shape (n, 3): x, y, z in mm in each row.");
    const auto rows = points.unchecked<2>();
    std::vector<gp_Pnt> result;
    result.reserve(static_cast<std::size_t>(rows.shape(0)));
    for (py::ssize_t i = 0; i < rows.shape(0); ++i)
        result.emplace_back(rows(i, 0), rows(i, 1), rows(i, 2));
    return result;
}

//! A search for many points takes seconds: other threads of Python go on, and have no hold on the copy of the face.
Result<std::vector<NearestPoint>> search_without_gil(const TopoDS_Shape &face, const std::vector<gp_Pnt> &points,
                                                     bool trimmed)
{
    return without_gil([&] { return nearest_points(face, points, trimmed); });
}

//! The arrays (n, 2) of parameters, (n, 3) of points, (n,) of distances.
py::tuple nearest_point_for_python(const py::object &shape, const Points &points, bool trimmed)
{
    const Result<std::vector<NearestPoint>> found =
        search_without_gil(detached(from_part(shape, selected_exchange())), read_points(points), trimmed);
    if (!found)
        raise(found.failure(), OffsetOptions{});
    const auto count = static_cast<py::ssize_t>(found.value().size());
    py::array_t<double> uv({count, py::ssize_t{2}});
    py::array_t<double> xyz({count, py::ssize_t{3}});
    py::array_t<double> distance(count);
    auto to_uv = uv.mutable_unchecked<2>();
    auto to_xyz = xyz.mutable_unchecked<2>();
    auto to_distance = distance.mutable_unchecked<1>();
    for (py::ssize_t i = 0; i < count; ++i)
    {
        const NearestPoint &foot = found.value()[static_cast<std::size_t>(i)];
        to_uv(i, 0) = foot.uv.X();
        to_uv(i, 1) = foot.uv.Y();
        for (int e = 0; e < 3; ++e)
            to_xyz(i, e) = foot.point.Coord(e + 1);
        to_distance(i) = foot.distance;
    }
    return py::make_tuple(uv, xyz, distance);
}

} // namespace

void bind_nearest_point(py::module_ &module)
{
    module.def("nearest_point", &nearest_point_for_python, py::arg("shape"), py::arg("points"),
               py::arg("trimmed") = false,
               "The points of one Part.Face nearest to the rows of an (n, 3) array in mm: parameters (n, 2), points "
               "(n, 3) and distances (n,); or raises OffsetError, ValueError or TypeError.");
}

} // namespace laminate_offset::python
