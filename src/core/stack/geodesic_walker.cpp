// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geodesic_walker.h"

#include "../spline/geom_values.h"

#include <BRep_Tool.hxx>
#include <Eigen/Geometry>

namespace laminate_offset
{
namespace
{

constexpr int geodesic_steps = 12;

using Vector2 = Eigen::Vector2d;

struct Jet
{
    Eigen::Vector3d u, v, uu, uv, vv;

    //! The parameters' rates for given products with S_u and S_v.
    [[nodiscard]] Vector2 solve(const Vector2 &products) const
    {
        const double e = u.squaredNorm(), f = u.dot(v), g = v.squaredNorm();
        return Vector2(g * products.x() - f * products.y(), e * products.y() - f * products.x()) / (e * g - f * f);
    }
};

Jet jet_at(const Geom_Surface &surface, const Vector2 &uv)
{
    gp_Pnt p;
    gp_Vec u, v, uu, vv, mixed;
    surface.D2(uv.x(), uv.y(), p, u, v, uu, vv, mixed);
    return {vector(u.XYZ()), vector(v.XYZ()), vector(uu.XYZ()), vector(mixed.XYZ()), vector(vv.XYZ())};
}

} // namespace

GeodesicWalker::GeodesicWalker(const InputFace &input) : m_surface(BRep_Tool::Surface(input.face)) {}

Eigen::Vector3d GeodesicWalker::point(const Vector2 &uv) const
{
    return vector(m_surface->Value(uv.x(), uv.y()).XYZ());
}

Vector2 GeodesicWalker::in_parameters(const Vector2 &uv, const Eigen::Vector3d &direction) const
{
    const Jet jet = jet_at(*m_surface, uv);
    return jet.solve({jet.u.dot(direction), jet.v.dot(direction)});
}

Eigen::Vector3d GeodesicWalker::in_space(const Vector2 &uv, const Vector2 &speed, Eigen::Vector3d &normal) const
{
    const Jet jet = jet_at(*m_surface, uv);
    normal = jet.u.cross(jet.v).normalized();
    return speed.x() * jet.u + speed.y() * jet.v;
}

Vector2 GeodesicWalker::geodesic(const Vector2 &from, const Eigen::Vector3d &direction, double length) const
{
    Vector2 x = from;
    Vector2 v = in_parameters(from, direction);
    const double h = length / geodesic_steps;
    for (int i = 0; i < geodesic_steps; ++i)
    {
        const Vector2 a1 = bend(x, v);
        const Vector2 v2 = v + 0.5 * h * a1, a2 = bend(x + 0.5 * h * v, v2);
        const Vector2 v3 = v + 0.5 * h * a2, a3 = bend(x + 0.5 * h * v2, v3);
        const Vector2 v4 = v + h * a3, a4 = bend(x + h * v3, v4);
        x += h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
        v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    }
    return x;
}

//! Second derivative of a geodesic in the parameters: no acceleration is left in the tangent plane.
Vector2 GeodesicWalker::bend(const Vector2 &x, const Vector2 &v) const
{
    const Jet jet = jet_at(*m_surface, x);
    const Eigen::Vector3d turn = v.x() * v.x() * jet.uu + 2.0 * v.x() * v.y() * jet.uv + v.y() * v.y() * jet.vv;
    return -jet.solve({jet.u.dot(turn), jet.v.dot(turn)});
}

} // namespace laminate_offset
