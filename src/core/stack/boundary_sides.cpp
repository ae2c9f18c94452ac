// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boundary_sides.h"

#include "../spline/geom_values.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Precision.hxx>
#include <ShapeAnalysis_FreeBounds.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_HSequenceOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

constexpr int samples_per_edge = 24;
constexpr double same_point = 1e-6; // of the polygon's size

using Polygon = std::vector<Eigen::Vector3d>;

//! Points along a wire in its direction.
Polygon polygon_of(const TopoDS_Wire &wire)
{
    Polygon points;
    for (BRepTools_WireExplorer it(wire); it.More(); it.Next())
    {
        if (BRep_Tool::Degenerated(it.Current()))
            continue;
        const BRepAdaptor_Curve curve(it.Current());
        const bool reversed = it.Current().Orientation() == TopAbs_REVERSED;
        for (int i = 0; i <= samples_per_edge; ++i)
        {
            const double part = static_cast<double>(reversed ? samples_per_edge - i : i) / samples_per_edge;
            points.push_back(vector(
                curve.Value(curve.FirstParameter() + part * (curve.LastParameter() - curve.FirstParameter())).XYZ()));
        }
    }
    return points;
}

double size_of(const Polygon &polygon)
{
    double size = 0.0;
    for (const Eigen::Vector3d &point : polygon)
        size = std::max(size, (point - polygon.front()).norm());
    return size;
}

//! Twice the enclosed area as a vector along the axis about which the polygon goes round to the left.
Eigen::Vector3d area_of(const Polygon &polygon)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i + 1 < polygon.size(); ++i)
        sum += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
    return sum;
}

//! Parity of the crossings of a ray in the plane across `axis`.
bool encloses(const Polygon &polygon, const Eigen::Vector3d &point, const Eigen::Vector3d &axis)
{
    const Eigen::Vector3d x = axis.unitOrthogonal();
    const Eigen::Vector3d y = axis.normalized().cross(x);
    bool inside = false;
    for (std::size_t i = 0; i + 1 < polygon.size(); ++i)
    {
        const Eigen::Vector2d a(x.dot(polygon[i] - point), y.dot(polygon[i] - point));
        const Eigen::Vector2d b(x.dot(polygon[i + 1] - point), y.dot(polygon[i + 1] - point));
        if ((a.y() > 0.0) != (b.y() > 0.0) && a.x() + a.y() / (a.y() - b.y()) * (b.x() - a.x()) > 0.0)
            inside = !inside;
    }
    return inside;
}

//! Mean of the face's normal S_u x S_v over a grid, where the face stands.
Eigen::Vector3d mean_normal(const InputFace &input)
{
    constexpr int grid = 8;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = 0; i <= grid; ++i)
        for (int j = 0; j <= grid; ++j)
        {
            gp_Pnt point;
            gp_Vec du, dv;
            input.surface->D1(input.box.umin + (input.box.umax - input.box.umin) * i / grid,
                              input.box.vmin + (input.box.vmax - input.box.vmin) * j / grid, point, du, dv);
            const gp_Vec normal = du.Crossed(dv);
            if (normal.Magnitude() > 0.0)
                sum += vector((normal / normal.Magnitude()).XYZ());
        }
    return vector(gp_Vec(sum.x(), sum.y(), sum.z()).Transformed(input.location.Transformation()).XYZ()) *
           (input.location.Transformation().IsNegative() ? -1.0 : 1.0);
}

} // namespace

std::vector<TopoDS_Wire> boundary_wires(const TopoDS_Shape &shape)
{
    std::vector<TopoDS_Wire> wires;
    if (shape.IsNull())
        return wires;
    for (TopExp_Explorer it(shape, TopAbs_WIRE); it.More(); it.Next())
        wires.push_back(TopoDS::Wire(it.Current()));
    Handle(TopTools_HSequenceOfShape) edges = new TopTools_HSequenceOfShape();
    for (TopExp_Explorer it(shape, TopAbs_EDGE, TopAbs_WIRE); it.More(); it.Next())
        edges->Append(it.Current());
    if (edges->IsEmpty())
        return wires;
    Handle(TopTools_HSequenceOfShape) joined;
    ShapeAnalysis_FreeBounds::ConnectEdgesToWires(edges, 10.0 * Precision::Confusion(), false, joined);
    for (int i = 1; !joined.IsNull() && i <= joined->Length(); ++i)
        wires.push_back(TopoDS::Wire(joined->Value(i)));
    return wires;
}

std::vector<bool> inside_is_left(const InputFace &input, const std::vector<TopoDS_Wire> &wires)
{
    std::vector<Polygon> polygons;
    std::vector<Eigen::Vector3d> areas;
    for (const TopoDS_Wire &wire : wires)
    {
        polygons.push_back(polygon_of(wire));
        const Polygon &polygon = polygons.back();
        const double size = polygon.empty() ? 0.0 : size_of(polygon);
        if (!(size > 0.0) || (polygon.front() - polygon.back()).norm() > same_point * size)
            return {};
        areas.push_back(area_of(polygon));
    }
    const Eigen::Vector3d normal = mean_normal(input);
    std::vector<bool> result;
    for (std::size_t k = 0; k < wires.size(); ++k)
    {
        const double along = areas[k].dot(normal);
        if (along == 0.0)
            return {};
        bool hole = false;
        for (std::size_t l = 0; l < wires.size(); ++l)
            if (l != k && encloses(polygons[l], polygons[k].front(), normal))
                hole = !hole;
        result.push_back((along > 0.0) != hole);
    }
    return result;
}

} // namespace laminate_offset
