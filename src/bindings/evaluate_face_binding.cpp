// SPDX-License-Identifier: LGPL-2.1-or-later
#include "evaluate_face_binding.h"

#include "detached_shape.h"
#include "offset_error.h"
#include "shape_exchange.h"
#include "without_gil.h"

#include <laminate_offset/evaluate_face.h>

#include <pybind11/numpy.h>
#include <vector>

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

using Parameters = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::vector<gp_Pnt2d> read_parameters(const Parameters &uv)
{
    if (uv.ndim() != 2 || uv.shape(1) != 2)
        throw py::value_error("uv must be an array of shape (n, 2): parameters u, v of the face in each row.");
    const auto rows = uv.unchecked<2>();
    std::vector<gp_Pnt2d> result;
    for (py::ssize_t i = 0; i < rows.shape(0); ++i)
        result.emplace_back(rows(i, 0), rows(i, 1));
    return result;
}

//! Thousands of places take a while: other threads of Python go on, and have no hold on the copy of the face.
template <typename Evaluation>
auto evaluate_without_gil(const Evaluation &evaluation, const TopoDS_Shape &face, const std::vector<gp_Pnt2d> &uv)
{
    return without_gil([&] { return evaluation(face, uv); });
}

py::array_t<double> face_curvatures_for_python(const py::object &shape, const Parameters &uv)
{
    const Result<std::vector<FaceCurvatures>> found =
        evaluate_without_gil(face_curvatures, detached(from_part(shape, selected_exchange())), read_parameters(uv));
    if (!found)
        raise(found.failure(), OffsetOptions{});
    const auto count = static_cast<py::ssize_t>(found.value().size());
    py::array_t<double> curvatures({count, py::ssize_t{2}});
    auto to_curvatures = curvatures.mutable_unchecked<2>();
    for (py::ssize_t i = 0; i < count; ++i)
    {
        to_curvatures(i, 0) = found.value()[static_cast<std::size_t>(i)].lowest;
        to_curvatures(i, 1) = found.value()[static_cast<std::size_t>(i)].highest;
    }
    return curvatures;
}

py::tuple evaluate_face_for_python(const py::object &shape, const Parameters &uv)
{
    const Result<std::vector<FacePoint>> found =
        evaluate_without_gil(evaluate_face, detached(from_part(shape, selected_exchange())), read_parameters(uv));
    if (!found)
        raise(found.failure(), OffsetOptions{});
    const auto count = static_cast<py::ssize_t>(found.value().size());
    py::array_t<double> points({count, py::ssize_t{3}});
    py::array_t<double> normals({count, py::ssize_t{3}});
    py::array_t<bool> inside(count);
    auto to_points = points.mutable_unchecked<2>();
    auto to_normals = normals.mutable_unchecked<2>();
    auto to_inside = inside.mutable_unchecked<1>();
    for (py::ssize_t i = 0; i < count; ++i)
    {
        const FacePoint &place = found.value()[static_cast<std::size_t>(i)];
        for (int e = 0; e < 3; ++e)
        {
            to_points(i, e) = place.point.Coord(e + 1);
            to_normals(i, e) = place.normal.Coord(e + 1);
        }
        to_inside(i) = place.inside;
    }
    return py::make_tuple(points, normals, inside);
}

} // namespace

void bind_evaluate_face(py::module_ &module)
{
    module.def(
        "evaluate_face", &evaluate_face_for_python, py::arg("shape"), py::arg("uv"),
        "Points (n, 3) in mm and outward unit normals (n, 3) of one Part.Face at the rows of an (n, 2) array of "
        "parameters, and whether they lie inside its loops (n,); or raises OffsetError, ValueError or TypeError.");
    module.def(
        "face_curvatures", &face_curvatures_for_python, py::arg("shape"), py::arg("uv"),
        "The lowest and the highest principal curvature (n, 2) in 1/mm of one Part.Face at the rows of an (n, 2) array "
        "of "
        "parameters, positive where the face bends towards its outward normal; NaN where there are none; or raises "
        "OffsetError, ValueError or TypeError.");
}

} // namespace laminate_offset::python
