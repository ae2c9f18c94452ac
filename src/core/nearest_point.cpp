// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nearest_point.h"

#include "input/input_face.h"
#include "nearest/face_nearest.h"
#include "spline/geom_values.h"

#include <fmt/format.h>

#include <cmath>

namespace laminate_offset
{
namespace
{

Result<std::vector<Eigen::Vector3d>> local_points(const InputFace &input, const std::vector<gp_Pnt> &points)
{
    const gp_Trsf to_face = input.location.Transformation().Inverted();
    std::vector<Eigen::Vector3d> local;
    local.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        local.push_back(vector(points[i].Transformed(to_face).XYZ()));
        if (!local.back().allFinite())
            return Failure{Status::InvalidOption, Stage::Options,
                           fmt::format("Point {} has a coordinate that is no finite number; leave such points out.", i),
                           std::nullopt, std::nullopt};
    }
    return local;
}

Result<std::vector<NearestPoint>> nearest_on(const InputFace &input, const std::vector<gp_Pnt> &points, bool trimmed)
{
    const Result<std::vector<Eigen::Vector3d>> local = local_points(input, points);
    if (!local)
        return local.failure();
    const Result<FaceNearest> face = FaceNearest::make(input, trimmed);
    if (!face)
        return face.failure();
    const gp_Trsf &from_face = input.location.Transformation();
    std::vector<NearestPoint> result;
    result.reserve(points.size());
    for (const SurfaceFoot &foot : face.value().nearest(local.value()))
    {
        const gp_Pnt point(foot.point.x(), foot.point.y(), foot.point.z());
        result.push_back({gp_Pnt2d(foot.uv.x(), foot.uv.y()), point.Transformed(from_face), foot.distance});
    }
    return result;
}

} // namespace

Result<std::vector<NearestPoint>> nearest_points(const TopoDS_Shape &face, const std::vector<gp_Pnt> &points,
                                                 bool trimmed)
{
    Stage stage = Stage::Input;
    try
    {
        const Result<InputFace> input = read_face(face);
        if (!input)
            return input.failure();
        stage = Stage::Trimming;
        return nearest_on(input.value(), points, trimmed);
    }
    catch (const Standard_Failure &error)
    {
        return kernel_failure(error, stage);
    }
}

} // namespace laminate_offset
