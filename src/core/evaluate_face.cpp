// SPDX-License-Identifier: LGPL-2.1-or-later
#include "evaluate_face.h"

#include "analysis/base_surface.h"
#include "analysis/curvature.h"
#include "analysis/loop_region.h"
#include "input/input_face.h"
#include "spline/geom_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace laminate_offset
{
namespace
{

//! How far beside a pole its curvatures are taken, in parts of the parameter box.
constexpr double beside_pole = 1e-3;

Failure not_finite()
{
    return {Status::InvalidOption, Stage::Options, "A parameter is no finite number; leave such places out.",
            std::nullopt, std::nullopt};
}

bool is_finite(const gp_Pnt2d &p) { return std::isfinite(p.X()) && std::isfinite(p.Y()); }

Result<std::vector<FacePoint>> evaluate(const InputFace &input, const std::vector<gp_Pnt2d> &uv)
{
    const LoopRegion region(input);
    const BaseSurface base(input.surface, fit_box(input));
    const gp_Trsf &to_place = input.location.Transformation();
    std::vector<FacePoint> result;
    result.reserve(uv.size());
    for (const gp_Pnt2d &p : uv)
    {
        if (!is_finite(p))
            return not_finite();
        gp_Pnt s;
        gp_Vec du, dv;
        input.surface->D1(p.X(), p.Y(), s, du, dv);
        SurfaceJet jet;
        jet.u = vector(du.XYZ());
        jet.v = vector(dv.XYZ());
        const std::optional<Eigen::Vector3d> normal = base.unit_normal(jet, p.X(), p.Y());
        if (!normal)
            return Failure{Status::SingularNormal, Stage::Analysis,
                           "The surface has no normal at this place; choose another one beside it.", input.place(p),
                           std::nullopt};
        const gp_Vec along(normal->x(), normal->y(), normal->z());
        result.push_back({s.Translated(input.base_distance * along).Transformed(to_place),
                          (input.normal_sign * along).Transformed(to_place), region.contains(p)});
    }
    return result;
}

//! Of InputFace::surface along S_u x S_v, lower one first.
std::optional<std::pair<double, double>> surface_curvatures(const InputFace &input, const gp_Pnt2d &p)
{
    gp_Pnt s;
    gp_Vec du, dv, duu, dvv, duv;
    input.surface->D2(p.X(), p.Y(), s, du, dv, duu, dvv, duv);
    SurfaceJet jet;
    jet.u = vector(du.XYZ());
    jet.v = vector(dv.XYZ());
    jet.uu = vector(duu.XYZ());
    jet.uv = vector(duv.XYZ());
    jet.vv = vector(dvv.XYZ());
    return principal_curvatures(jet, input.box.umax - input.box.umin, input.box.vmax - input.box.vmin);
}

FaceCurvatures curvatures_at(const InputFace &input, const gp_Pnt2d &p)
{
    const gp_Pnt2d middle(0.5 * (input.box.umin + input.box.umax), 0.5 * (input.box.vmin + input.box.vmax));
    auto found = surface_curvatures(input, p);
    if (!found)
        found = surface_curvatures(input, p.XY() + beside_pole * (middle.XY() - p.XY()));
    if (!found)
        return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
    // A face that stands at a distance from the surface has its centres of curvature in the same places.
    const auto of_face = [&](double k) { return input.normal_sign * k / (1.0 - input.base_distance * k); };
    const double a = of_face(found->first);
    const double b = of_face(found->second);
    return {std::min(a, b), std::max(a, b)};
}

Result<std::vector<FaceCurvatures>> curvatures(const InputFace &input, const std::vector<gp_Pnt2d> &uv)
{
    std::vector<FaceCurvatures> result;
    result.reserve(uv.size());
    for (const gp_Pnt2d &p : uv)
    {
        if (!is_finite(p))
            return not_finite();
        result.push_back(curvatures_at(input, p));
    }
    return result;
}

} // namespace

Result<std::vector<FacePoint>> evaluate_face(const TopoDS_Shape &face, const std::vector<gp_Pnt2d> &uv)
{
    try
    {
        const Result<InputFace> input = read_face(face);
        return input ? evaluate(input.value(), uv) : input.failure();
    }
    catch (const Standard_Failure &error)
    {
        return kernel_failure(error, Stage::Input);
    }
}

Result<std::vector<FaceCurvatures>> face_curvatures(const TopoDS_Shape &face, const std::vector<gp_Pnt2d> &uv)
{
    try
    {
        const Result<InputFace> input = read_face(face);
        return input ? curvatures(input.value(), uv) : input.failure();
    }
    catch (const Standard_Failure &error)
    {
        return kernel_failure(error, Stage::Input);
    }
}

} // namespace laminate_offset
