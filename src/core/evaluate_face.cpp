// SPDX-License-Identifier: LGPL-2.1-or-later
#include "evaluate_face.h"

#include "analysis/base_surface.h"
#include "analysis/loop_region.h"
#include "input/input_face.h"
#include "spline/geom_values.h"

#include <cmath>

namespace laminate_offset
{
namespace
{

Result<std::vector<FacePoint>> evaluate(const InputFace &input, const std::vector<gp_Pnt2d> &uv)
{
    const LoopRegion region(input);
    const BaseSurface base(input.surface, fit_box(input));
    const gp_Trsf &to_place = input.location.Transformation();
    std::vector<FacePoint> result;
    result.reserve(uv.size());
    for (const gp_Pnt2d &p : uv)
    {
        if (!std::isfinite(p.X()) || !std::isfinite(p.Y()))
            return Failure{Status::InvalidOption, Stage::Options,
                           "A parameter is no finite number; leave such places out.", std::nullopt, std::nullopt};
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

} // namespace laminate_offset
