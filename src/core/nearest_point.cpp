// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nearest_point.h"

#include "input/input_face.h"
#include "nearest/face_nearest.h"
#include "spline/geom_values.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>

namespace laminate_offset
{
namespace
{

constexpr std::size_t grain = 256;

Failure not_finite(std::size_t index)
{
    return {
        Status::InvalidOption, Stage::Options,
        fmt::format("Point {} has a coordinate that is no finite number, or is so far away that its distance is none; "
                    "leave such points out.",
                    index),
        std::nullopt, std::nullopt};
}

Result<std::vector<NearestPoint>> nearest_on(const InputFace &input, const std::vector<gp_Pnt> &points, bool trimmed)
{
    const Result<FaceNearest> face = FaceNearest::make(input, trimmed);
    if (!face)
        return face.failure();
    const gp_Trsf &from_face = input.location.Transformation();
    const gp_Trsf to_face = from_face.Inverted();
    std::vector<NearestPoint> result(points.size());
    std::atomic<std::size_t> bad{points.size()};
    const auto nearest = [&](std::size_t i) {
        const Eigen::Vector3d local = vector(points[i].Transformed(to_face).XYZ());
        if (!local.allFinite())
            return false;
        const SurfaceFoot foot = face.value().nearest(local);
        if (!std::isfinite(foot.distance))
            return false;
        const gp_Pnt point(foot.point.x(), foot.point.y(), foot.point.z());
        result[i] = {gp_Pnt2d(foot.uv.x(), foot.uv.y()), point.Transformed(from_face), foot.distance};
        return true;
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), grain), [&](const auto &range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            if (!nearest(i))
            {
                std::size_t first = bad;
                while (i < first && !bad.compare_exchange_weak(first, i))
                    continue;
            }
    });
    if (bad < points.size())
        return not_finite(bad);
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
