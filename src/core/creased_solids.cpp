// SPDX-License-Identifier: LGPL-2.1-or-later
#include "creased_solids.h"

#include "offset_stack.h"

#include "analysis/creases.h"
#include "input/input_face.h"

#include <Eigen/Geometry>
#include <TopoDS.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace laminate_offset
{
namespace
{

constexpr int crease_samples = 16;

//! A part of the face and its surface, which ends at the creases.
struct Part
{
    const InputFace &input;
    BaseSurface base;
};

//! An edge of a part at a place: the normal S_u x S_v, and the direction that leads out of the part, both of length 1.
struct Border
{
    Eigen::Vector3d normal;
    Eigen::Vector3d outwards;
};

std::optional<Border> border_at(const Part &part, const TrimmingCurve &curve, double t)
{
    gp_Pnt2d uv;
    gp_Vec2d along;
    curve.pcurve->D1(t, uv, along);
    const SurfaceJet jet = part.base.jets({uv.X()}, {uv.Y()}, 1).front();
    const std::optional<Eigen::Vector3d> normal = part.base.unit_normal(jet, uv.X(), uv.Y());
    if (!normal)
        return std::nullopt;
    const double sense = curve.edge.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
    const Eigen::Vector3d out = sense * (along.X() * jet.u + along.Y() * jet.v).cross(*normal);
    return out.norm() > 0.0 ? std::optional<Border>({*normal, out.normalized()}) : std::nullopt;
}

//! A place of an edge between two parts where their offsets at a distance along S_u x S_v cross each other.
std::optional<gp_Pnt2d> crossing_on(const Part &one, const TrimmingCurve &a, const Part &other, const TrimmingCurve &b,
                                    double distance, double tolerance)
{
    for (int i = 0; i <= crease_samples; ++i)
    {
        const double t = a.first + (a.last - a.first) * i / crease_samples;
        const std::optional<Border> here = border_at(one, a, t), there = border_at(other, b, t);
        if (!here || !there)
            continue;
        const Eigen::Vector3d across = distance * (there->normal - here->normal);
        if (across.norm() > 0.5 * tolerance && across.dot(here->outwards - there->outwards) < 0.0)
            return a.pcurve->Value(t);
    }
    return std::nullopt;
}

std::vector<const TrimmingCurve *> curves_of(const InputFace &input)
{
    std::vector<const TrimmingCurve *> curves;
    for (const TrimmingLoop &loop : input.loops)
        for (const TrimmingCurve &curve : loop.curves)
            if (!curve.degenerated)
                curves.push_back(&curve);
    return curves;
}

//! Nothing where all parts keep out of each other's way at a distance.
std::optional<Failure> crossing(const std::vector<Part> &parts, double distance, double tolerance)
{
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = i + 1; j < parts.size(); ++j)
            for (const TrimmingCurve *a : curves_of(parts[i].input))
                for (const TrimmingCurve *b : curves_of(parts[j].input))
                    if (const auto place = a->edge.IsSame(b->edge)
                                               ? crossing_on(parts[i], *a, parts[j], *b, distance, tolerance)
                                               : std::nullopt)
                        return Failure{
                            Status::KinkedSurface, Stage::Topology,
                            fmt::format("At {:.4g} mm the plies on both sides of a crease cross each other, so they "
                                        "have no solids; stack on the face's other side, or round the crease by a "
                                        "radius of more than that.",
                                        std::abs(parts[i].input.from_face(distance))),
                            parts[i].input.place(*place), std::nullopt};
    return std::nullopt;
}

TopoDS_Face located(const InputFace &part)
{
    constexpr bool refuse_mirrors = false;
    TopoDS_Shape face = part.face.Oriented(part.reversed ? TopAbs_REVERSED : TopAbs_FORWARD);
    face.Location(part.location, refuse_mirrors);
    return TopoDS::Face(face);
}

Result<std::vector<TopoDS_Solid>> solids_of(const InputFace &part, const std::vector<double> &distances,
                                            const std::vector<SolidSpan> &spans, const OffsetOptions &options)
{
    const Result<StackResult> stack = offset_stack(located(part), distances, options);
    if (!stack)
        return stack.failure();
    std::vector<TopoDS_Face> faces;
    for (const OffsetResult &surface : stack.value().surfaces)
    {
        if (surface.shape.ShapeType() != TopAbs_FACE)
            return Failure{Status::KinkedSurface, Stage::Topology,
                           "A part of the creased face is torn once more; split the face at its creases first.",
                           part.place(part.loops.front().curves.front().pieces.front().start), std::nullopt};
        faces.push_back(surface.face());
    }
    return make_solids(faces, spans);
}

Result<std::vector<std::vector<TopoDS_Solid>>> all_solids(const TopoDS_Shape &face,
                                                          const std::vector<double> &distances,
                                                          const std::vector<SolidSpan> &spans,
                                                          const OffsetOptions &options)
{
    const Result<InputFace> input = read_face(face);
    if (!input)
        return input.failure();
    std::vector<double> ends{0.0, 0.0};
    for (const double distance : distances)
    {
        ends[0] = std::min(ends[0], input.value().from_surface(distance));
        ends[1] = std::max(ends[1], input.value().from_surface(distance));
    }
    const double farthest = std::abs(ends[0]) > std::abs(ends[1]) ? ends[0] : ends[1];
    const Result<std::vector<InputFace>> split = split_at_creases(input.value(), farthest, options.tolerance);
    if (!split)
        return split.failure();
    std::vector<Part> parts;
    for (const InputFace &part : split.value())
        parts.push_back({part, base_beside_creases(part, {farthest, options.tolerance})});
    for (const double end : ends)
        if (std::optional<Failure> crossed = crossing(parts, end, options.tolerance))
            return *std::move(crossed);
    std::vector<std::vector<TopoDS_Solid>> result(spans.size());
    for (const InputFace &part : split.value())
    {
        const Result<std::vector<TopoDS_Solid>> solids = solids_of(part, distances, spans, options);
        if (!solids)
            return solids.failure();
        for (std::size_t i = 0; i < spans.size(); ++i)
            result[i].push_back(solids.value()[i]);
    }
    return result;
}

} // namespace

Result<std::vector<std::vector<TopoDS_Solid>>> creased_ply_solids(const TopoDS_Shape &face,
                                                                  const std::vector<double> &distances,
                                                                  const std::vector<SolidSpan> &spans,
                                                                  const OffsetOptions &options)
{
    try
    {
        return all_solids(face, distances, spans, options);
    }
    catch (const Standard_Failure &error)
    {
        return kernel_failure(error, Stage::Topology);
    }
}

} // namespace laminate_offset
