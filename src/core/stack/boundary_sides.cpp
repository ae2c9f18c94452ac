// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boundary_sides.h"

#include "../spline/geom_values.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Geom2d_Curve.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_FreeBounds.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_HSequenceOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <utility>

namespace laminate_offset
{
namespace
{

constexpr int samples_per_edge = 24;
constexpr double same_point = 1e-6; // of the polygon's size
// A wire that the face cuts off faces it by this much at least: its area against the mean normal along its image.
constexpr double least_facing = 0.2;

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

//! The image of a wire in the face's parameters.
struct ImagePolygon
{
    std::vector<Eigen::Vector2d> points;
    bool closed = false; //!< in the parameters
    bool round = false;  //!< closed in space only: it goes round a closed face
};

ImagePolygon traced(const InputFace &input, const TopoDS_Shape &image)
{
    ImagePolygon polygon;
    for (TopExp_Explorer it(image, TopAbs_EDGE); it.More(); it.Next())
    {
        double first = 0.0;
        double last = 0.0;
        const Handle(Geom2d_Curve) pcurve =
            BRep_Tool::CurveOnSurface(TopoDS::Edge(it.Current()), input.face, first, last);
        if (it.Current().Orientation() == TopAbs_REVERSED)
            std::swap(first, last);
        for (int i = 0; i <= samples_per_edge; ++i)
        {
            const gp_Pnt2d uv = pcurve->Value(first + (last - first) * i / samples_per_edge);
            polygon.points.emplace_back(uv.X(), uv.Y());
        }
    }
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d &point : polygon.points)
        box.extend(point);
    const Eigen::Vector2d gap = (polygon.points.front() - polygon.points.back()).cwiseAbs();
    polygon.closed = (gap.array() <= same_point * box.sizes().array()).all();
    const auto place = [&](const Eigen::Vector2d &uv) { return vector(input.surface->Value(uv.x(), uv.y()).XYZ()); };
    polygon.round = !polygon.closed && (place(polygon.points.front()) - place(polygon.points.back())).norm() <=
                                           same_point * input.diagonal;
    return polygon;
}

//! Twice the area that the image goes round to the left.
double area_of(const ImagePolygon &polygon)
{
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < polygon.points.size(); ++i)
    {
        const Eigen::Vector2d a = polygon.points[i] - polygon.points[0];
        const Eigen::Vector2d b = polygon.points[i + 1] - polygon.points[0];
        sum += a.x() * b.y() - a.y() * b.x();
    }
    return sum;
}

//! The same points in the plane z = 0.
Polygon flat(const ImagePolygon &polygon)
{
    Polygon points;
    for (const Eigen::Vector2d &point : polygon.points)
        points.emplace_back(point.x(), point.y(), 0.0);
    return points;
}

//! Mean of the face's unit normals S_u x S_v along an image, where the face stands.
Eigen::Vector3d mean_normal(const InputFace &input, const ImagePolygon &image)
{
    gp_Vec sum;
    for (const Eigen::Vector2d &uv : image.points)
    {
        gp_Pnt point;
        gp_Vec du, dv;
        input.surface->D1(uv.x(), uv.y(), point, du, dv);
        const gp_Vec normal = du.Crossed(dv);
        if (normal.Magnitude() > 0.0)
            sum += normal / (normal.Magnitude() * static_cast<double>(image.points.size()));
    }
    const gp_Trsf standing = input.location.Transformation();
    return vector(sum.Transformed(standing).XYZ()) * (standing.IsNegative() ? -1.0 : 1.0) /
           std::abs(standing.ScaleFactor());
}

Failure refusal(const char *message)
{
    return {Status::InvalidOption, Stage::Options, message, std::nullopt, std::nullopt};
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

Result<std::vector<bool>> inside_is_left(const InputFace &input, const std::vector<TopoDS_Wire> &wires,
                                         const std::vector<TopoDS_Shape> &images)
{
    std::vector<Polygon> polygons;
    std::vector<ImagePolygon> traces;
    for (std::size_t k = 0; k < wires.size(); ++k)
    {
        polygons.push_back(polygon_of(wires[k]));
        const Polygon &polygon = polygons.back();
        const double size = polygon.empty() ? 0.0 : size_of(polygon);
        if (!(size > 0.0) || (polygon.front() - polygon.back()).norm() > same_point * size)
            return refusal("A curve of it is open, so it has no inside; close it, or say which side the ply is on: "
                           "left, right, or the side next to a point.");
        traces.push_back(traced(input, images[k]));
        if (traces.back().round)
            return refusal("A curve of it goes round the face, or over a seam that cannot be moved, so it has no "
                           "inside; say which "
                           "side the ply is on (left, right, or the side next to a point), or keep it off the seam.");
    }
    std::vector<bool> result;
    for (std::size_t k = 0; k < wires.size(); ++k)
    {
        const Eigen::Vector3d normal = mean_normal(input, traces[k]);
        const Eigen::Vector3d area = area_of(polygons[k]);
        const double along = traces[k].closed ? area_of(traces[k]) : area.dot(normal);
        const bool clear = traces[k].closed ? along != 0.0 : std::abs(along) > least_facing * area.norm();
        if (!clear)
            return refusal(
                "A curve of it is cut off by the face's edges and stands across the face, so that its inside is "
                "not clear; say which side the ply is on: left, right, or the side next to a point.");
        bool hole = false;
        for (std::size_t l = 0; l < wires.size(); ++l)
            if (l != k && (traces[k].closed && traces[l].closed
                               ? encloses(flat(traces[l]), flat(traces[k]).front(), Eigen::Vector3d::UnitZ())
                               : encloses(polygons[l], polygons[k].front(), normal)))
                hole = !hole;
        result.push_back((along > 0.0) != hole);
    }
    return result;
}

} // namespace laminate_offset
