// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hidden_shape.h"

#include <Eigen/QR>
#include <Eigen/SVD>

#include <cmath>
#include <optional>

namespace laminate_offset
{
namespace
{

// Normals that spread less than this [rad] say nothing about a radius.
constexpr double least_spread = 1e-7;

//! The unit vector that a's rows have the smallest products with.
Eigen::Vector3d least_direction(const Eigen::MatrixX3d &a)
{
    return Eigen::JacobiSVD<Eigen::MatrixXd>(a, Eigen::ComputeThinV).matrixV().col(2);
}

Eigen::MatrixX3d about(const Eigen::MatrixX3d &rows, const Eigen::Vector3d &centre)
{
    return rows.rowwise() - centre.transpose();
}

Eigen::MatrixX3d across(const Eigen::MatrixX3d &rows, const Eigen::Vector3d &axis)
{
    return rows - (rows * axis) * axis.transpose();
}

//! Least squares p = centre + radius n.
struct Ball
{
    Eigen::Vector3d centre;
    double radius = 0.0;
    double residual = 0.0;
};

std::optional<Ball> regress(const Eigen::MatrixX3d &points, const Eigen::MatrixX3d &normals)
{
    const Eigen::Vector3d mean_point = points.colwise().mean();
    const Eigen::Vector3d mean_normal = normals.colwise().mean();
    const Eigen::MatrixX3d p = about(points, mean_point);
    const Eigen::MatrixX3d n = about(normals, mean_normal);
    const double spread = n.squaredNorm();
    if (!(spread > least_spread * least_spread * static_cast<double>(n.rows())))
        return std::nullopt;
    Ball ball;
    ball.radius = p.cwiseProduct(n).sum() / spread;
    ball.centre = mean_point - ball.radius * mean_normal;
    ball.residual = (p - ball.radius * n).rowwise().norm().maxCoeff();
    return ball;
}

std::optional<HiddenShape> plane(const ShapeSamples &s, double tolerance)
{
    HiddenShape shape;
    shape.kind = HiddenShape::Kind::Plane;
    shape.origin = s.points.colwise().mean();
    const Eigen::MatrixX3d points = about(s.points, shape.origin);
    shape.axis = least_direction(points);
    if (shape.axis.dot(s.normals.colwise().sum()) < 0.0)
        shape.axis = -shape.axis;
    if ((points * shape.axis).cwiseAbs().maxCoeff() > tolerance)
        return std::nullopt;
    return shape;
}

std::optional<HiddenShape> sphere(const ShapeSamples &s, double tolerance)
{
    const std::optional<Ball> ball = regress(s.points, s.normals);
    if (!ball || ball->residual > tolerance)
        return std::nullopt;
    HiddenShape shape;
    shape.kind = HiddenShape::Kind::Sphere;
    shape.origin = ball->centre;
    shape.radius = ball->radius;
    return shape;
}

std::optional<HiddenShape> cylinder(const ShapeSamples &s, double tolerance)
{
    HiddenShape shape;
    shape.kind = HiddenShape::Kind::Cylinder;
    shape.axis = least_direction(s.normals);
    const std::optional<Ball> ball = regress(across(s.points, shape.axis), across(s.normals, shape.axis));
    if (!ball || ball->residual > tolerance)
        return std::nullopt;
    shape.origin = ball->centre;
    shape.radius = ball->radius;
    return shape;
}

std::optional<HiddenShape> cone(const ShapeSamples &s, double tolerance)
{
    HiddenShape shape;
    shape.kind = HiddenShape::Kind::Cone;
    const Eigen::Vector3d mean_normal = s.normals.colwise().mean();
    shape.axis = least_direction(about(s.normals, mean_normal));
    shape.axial = mean_normal.dot(shape.axis);
    const double radial = std::sqrt(std::max(0.0, 1.0 - shape.axial * shape.axial));
    if (!(radial > least_spread))
        return std::nullopt;
    const Eigen::Vector3d centre = s.points.colwise().mean();
    const Eigen::MatrixX3d points = about(s.points, centre);
    const Eigen::MatrixX3d p = across(points, shape.axis);
    const Eigen::MatrixX3d n = across(s.normals, shape.axis) / radial;
    // p = q + b0 n + b1 h n: the unknowns are q, b0 and b1, a row a coordinate
    const Eigen::VectorXd h = points * shape.axis;
    const Eigen::Index count = p.rows();
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(3 * count, 5);
    Eigen::VectorXd b(3 * count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
        a.block<3, 3>(3 * i, 0).setIdentity();
        a.block<3, 1>(3 * i, 3) = n.row(i).transpose();
        a.block<3, 1>(3 * i, 4) = h(i) * n.row(i).transpose();
        b.segment<3>(3 * i) = p.row(i).transpose();
    }
    const Eigen::VectorXd x = a.colPivHouseholderQr().solve(b);
    if (!((a * x - b).cwiseAbs().maxCoeff() <= tolerance))
        return std::nullopt;
    shape.origin = centre + x.head<3>();
    shape.outward = x(3) > 0.0 ? radial : -radial;
    return shape;
}

//! The line that all normals' lines meet: c turns about it where n.v + c.(x cross n) = 0 for some vector v.
std::optional<HiddenShape> axis_of_revolution(const ShapeSamples &s)
{
    const Eigen::Vector3d centre = s.points.colwise().mean();
    const Eigen::MatrixX3d x = about(s.points, centre);
    const double size = x.rowwise().norm().maxCoeff();
    if (!(size > 0.0))
        return std::nullopt;
    Eigen::MatrixX3d moments(x.rows(), 3);
    for (Eigen::Index i = 0; i < x.rows(); ++i)
        moments.row(i) = (x.row(i) / size).cross(s.normals.row(i));
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> on_normals(s.normals);
    if (on_normals.rank() < 3)
        return std::nullopt;
    const Eigen::Matrix3d part = on_normals.solve(moments);
    const Eigen::MatrixX3d rest = moments - s.normals * part;
    HiddenShape shape;
    shape.kind = HiddenShape::Kind::Torus;
    shape.axis = least_direction(rest);
    const Eigen::Vector3d v = -(part * shape.axis);
    shape.origin = centre + size * shape.axis.cross(v);
    return shape;
}

std::optional<HiddenShape> torus(const ShapeSamples &s, double tolerance)
{
    std::optional<HiddenShape> shape = axis_of_revolution(s);
    if (!shape)
        return std::nullopt;
    // distance from the axis and height, of points and normals
    const Eigen::MatrixX3d points = about(s.points, shape->origin);
    const Eigen::MatrixX3d away = across(points, shape->axis);
    const Eigen::VectorXd distances = away.rowwise().norm();
    if (!(distances.minCoeff() > 0.0))
        return std::nullopt;
    Eigen::MatrixX3d p = Eigen::MatrixX3d::Zero(points.rows(), 3);
    Eigen::MatrixX3d n = p;
    p.col(0) = distances;
    p.col(1) = points * shape->axis;
    n.col(0) = s.normals.cwiseProduct(away).rowwise().sum().cwiseQuotient(distances);
    n.col(1) = s.normals * shape->axis;
    const std::optional<Ball> tube = regress(p, n);
    if (!tube || tube->residual > tolerance)
        return std::nullopt;
    shape->major = tube->centre.x();
    shape->origin += tube->centre.y() * shape->axis;
    shape->radius = tube->radius;
    return shape;
}

} // namespace

std::vector<HiddenShape> recognise(const ShapeSamples &samples, double tolerance)
{
    std::vector<HiddenShape> shapes;
    for (const auto &kind : {plane, sphere, cylinder, cone, torus})
        if (const std::optional<HiddenShape> shape = kind(samples, tolerance))
            shapes.push_back(*shape);
    return shapes;
}

} // namespace laminate_offset
