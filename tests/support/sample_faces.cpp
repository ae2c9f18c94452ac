// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sample_faces.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Line.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax1.hxx>
#include <gp_Sphere.hxx>
#include <gp_Trsf.hxx>

#include <cmath>

namespace test_support
{
namespace
{

struct Knots
{
    TColStd_Array1OfReal values;
    TColStd_Array1OfInteger multiplicities;
};

Knots uniform_knots(int poles, int degree)
{
    const int count = poles - degree + 1;
    Knots knots{TColStd_Array1OfReal(1, count), TColStd_Array1OfInteger(1, count)};
    for (int i = 1; i <= count; ++i)
    {
        knots.values(i) = static_cast<double>(i - 1) / (count - 1);
        knots.multiplicities(i) = i == 1 || i == count ? degree + 1 : 1;
    }
    return knots;
}

TopoDS_Wire elliptic_hole(const Handle(Geom_Surface) & surface, const gp_Pnt2d &centre, double radius_u,
                          double radius_v)
{
    const gp_Ax22d axes(centre, gp_Dir2d(1, 0), gp_Dir2d(0, -1)); // clockwise, as inner loops run
    const Handle(Geom2d_Ellipse) ellipse = new Geom2d_Ellipse(axes, radius_u, radius_v);
    TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(ellipse, surface);
    BRepLib::BuildCurve3d(edge);
    return BRepBuilderAPI_MakeWire(edge);
}

} // namespace

Handle(Geom_BSplineSurface) height_surface(const std::function<double(double, double)> &height, double size_u,
                                           double size_v, int poles_u, int poles_v, int degree)
{
    TColgp_Array2OfPnt poles(1, poles_u, 1, poles_v);
    for (int i = 1; i <= poles_u; ++i)
        for (int j = 1; j <= poles_v; ++j)
        {
            const double x = size_u * ((i - 1.0) / (poles_u - 1) - 0.5), y = size_v * ((j - 1.0) / (poles_v - 1) - 0.5);
            poles(i, j) = gp_Pnt(x, y, height(x, y));
        }
    const Knots u = uniform_knots(poles_u, degree), v = uniform_knots(poles_v, degree);
    return new Geom_BSplineSurface(poles, u.values, v.values, u.multiplicities, v.multiplicities, degree, degree);
}

Handle(Geom_BSplineSurface) wavy_tube(double radius)
{
    constexpr int around = 12, along = 6;
    TColgp_Array2OfPnt poles(1, around, 1, along);
    for (int i = 1; i <= around; ++i)
        for (int j = 1; j <= along; ++j)
        {
            const double angle = 2.0 * M_PI * i / around, r = radius * (1.0 + 0.08 * std::sin(2.0 * angle + j));
            poles(i, j) = gp_Pnt(r * std::cos(angle), r * std::sin(angle), 0.5 * radius * j);
        }
    TColStd_Array1OfReal u(1, around + 1), v(1, along - 2);
    TColStd_Array1OfInteger mu(1, around + 1), mv(1, along - 2);
    for (int i = 1; i <= u.Length(); ++i)
        u(i) = i - 1;
    mu.Init(1);
    for (int j = 1; j <= v.Length(); ++j)
        v(j) = j - 1;
    mv.Init(1);
    mv(1) = mv(v.Length()) = 4;
    return new Geom_BSplineSurface(poles, u, v, mu, mv, 3, 3, true, false);
}

TopoDS_Face rectangle_on(const Handle(Geom_Surface) & surface, double u0, double u1, double v0, double v1)
{
    const gp_Pnt2d corners[] = {{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}};
    BRepBuilderAPI_MakeWire wire;
    for (int i = 0; i < 4; ++i)
    {
        const gp_Vec2d way(corners[i], corners[(i + 1) % 4]);
        const TopoDS_Edge edge =
            BRepBuilderAPI_MakeEdge(new Geom2d_Line(corners[i], gp_Dir2d(way)), surface, 0.0, way.Magnitude());
        BRepLib::BuildCurve3d(edge);
        wire.Add(edge);
    }
    return BRepBuilderAPI_MakeFace(surface, wire.Wire(), true);
}

TopoDS_Face panel_with_hole()
{
    const auto height = [](double x, double y) {
        return 60.0 * std::cos(x / 250.0) - 1e-3 * y * y + 12.0 * std::sin(y / 140.0 + x / 300.0);
    };
    const Handle(Geom_BSplineSurface) surface = height_surface(height, 800.0, 500.0, 9, 7);
    BRepBuilderAPI_MakeFace maker(surface, 1e-7);
    maker.Add(elliptic_hole(surface, gp_Pnt2d(0.6, 0.45), 0.15, 0.1));
    return maker.Face();
}

TopoDS_Face reversed(const TopoDS_Face &face) { return TopoDS::Face(face.Reversed()); }

TopoDS_Face located(const TopoDS_Face &face)
{
    gp_Trsf turn, shift;
    turn.SetRotation(gp_Ax1(gp_Pnt(10, 20, 30), gp_Dir(1, 2, 3)), 0.7);
    shift.SetTranslation(gp_Vec(1000, -500, 250));
    return TopoDS::Face(face.Moved(TopLoc_Location(shift * turn)));
}

TopoDS_Face sphere_patch(double radius)
{
    return BRepBuilderAPI_MakeFace(gp_Sphere(gp_Ax3(), radius), 0.2, 1.4, -0.6, 0.7);
}

} // namespace test_support
