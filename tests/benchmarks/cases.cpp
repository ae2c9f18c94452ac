// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cases.h"

#include "support/data_files.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <set>

namespace benchmark
{
namespace
{

using Shape = std::function<gp_Pnt(double u, double v)>;

constexpr int curvature_grid = 90;
constexpr unsigned noise_seed = 3;

//! A clamped uniform knot vector on [0, 1] as OpenCASCADE takes it.
struct Knots
{
    TColStd_Array1OfReal values;
    TColStd_Array1OfInteger multiplicities;
    int degree;

    Knots(int poles, int degree_)
        : values(1, poles - degree_ + 1), multiplicities(1, poles - degree_ + 1), degree(degree_)
    {
        for (int i = values.Lower(); i <= values.Upper(); ++i)
        {
            values(i) = static_cast<double>(i - 1) / (values.Upper() - 1);
            multiplicities(i) = i == 1 || i == values.Upper() ? degree + 1 : 1;
        }
    }

    //! The parameter of pole i (from 0) that reproduces straight lines.
    [[nodiscard]] double greville(int i) const
    {
        const int last = values.Upper() - 1;
        double sum = 0.0;
        for (int k = 1; k <= degree; ++k)
            sum += static_cast<double>(std::clamp(i + k - degree, 0, last)) / last;
        return sum / degree;
    }
};

TopoDS_Face whole(const Handle(Geom_Surface) & surface) { return BRepBuilderAPI_MakeFace(surface, 1e-7); }

//! Poles of the shape at the Greville parameters, moved up or down by at most `noise` mm.
TopoDS_Face net(const Shape &shape, int nu, int nv, int degree = 3, double noise = 0.0)
{
    const Knots u(nu, degree), v(nv, degree);
    std::mt19937 engine(noise_seed);
    std::uniform_real_distribution<double> stray(-1.0, 1.0);
    TColgp_Array2OfPnt poles(1, nu, 1, nv);
    for (int i = 0; i < nu; ++i)
        for (int j = 0; j < nv; ++j)
            poles(i + 1, j + 1) =
                shape(u.greville(i), v.greville(j)).Translated(gp_Vec(0.0, 0.0, noise * stray(engine)));
    return whole(
        new Geom_BSplineSurface(poles, u.values, v.values, u.multiplicities, v.multiplicities, degree, degree));
}

gp_Pnt panel(double u, double v)
{
    return {500.0 * u, 300.0 * v, 60.0 * std::sin(2.2 * u + 0.3) * std::cos(1.7 * v - 0.4) + 20.0 * u * v};
}

gp_Pnt wavy(double u, double v) { return {500.0 * u, 300.0 * v, 15.0 * std::sin(9.0 * u) * std::cos(7.0 * v)}; }

//! Upper skin of a tapered, twisted wing from 3 to 95 percent of a chord of 900 to 500 mm, 2.5 m long.
gp_Pnt wing(double u, double v)
{
    const double x = 0.03 + 0.92 * u;
    const double thickness =
        0.6 * (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x + 0.2843 * x * x * x - 0.1036 * x * x * x * x);
    const double camber = 0.08 * x * (1.0 - x);
    const double chord = 900.0 - 400.0 * v, twist = -0.06 * v;
    const double along = chord * (x - 0.3), up = chord * (thickness + camber);
    return {along * std::cos(twist) + up * std::sin(twist) + 300.0 * v, 2500.0 * v,
            up * std::cos(twist) - along * std::sin(twist) + 120.0 * v * v};
}

struct WeightedPole
{
    double x, y, weight;
};

//! A half turn, given by the poles of the unit half circle, of a cubic profile with 8 poles.
TopoDS_Face half_turn(const std::vector<WeightedPole> &circle, const TColStd_Array1OfReal &ku,
                      const TColStd_Array1OfInteger &mu, int degree_u)
{
    constexpr int nv = 8;
    const Knots v(nv, 3);
    TColgp_Array2OfPnt poles(1, static_cast<int>(circle.size()), 1, nv);
    TColStd_Array2OfReal weights(1, static_cast<int>(circle.size()), 1, nv);
    for (int i = 1; i <= poles.UpperRow(); ++i)
        for (int j = 0; j < nv; ++j)
        {
            const WeightedPole &at = circle[static_cast<std::size_t>(i) - 1];
            const double t = v.greville(j), radius = 60.0 + 15.0 * std::sin(3.0 * t + 0.4);
            poles(i, j + 1) = gp_Pnt(radius * at.x, radius * at.y, 200.0 * t);
            weights(i, j + 1) = at.weight;
        }
    return whole(new Geom_BSplineSurface(poles, weights, ku, v.values, mu, v.multiplicities, degree_u, 3));
}

//! Two rational quadratic quarters; formally C0 between them, which OpenCASCADE refuses.
TopoDS_Face revolution_of_quarters()
{
    const double half = std::sqrt(0.5);
    TColStd_Array1OfReal ku(1, 3);
    TColStd_Array1OfInteger mu(1, 3);
    for (int i = 1; i <= 3; ++i)
    {
        ku(i) = 0.5 * (i - 1);
        mu(i) = i == 2 ? 2 : 3;
    }
    return half_turn({{1, 0, 1}, {1, 1, half}, {0, 1, 1}, {-1, 1, half}, {-1, 0, 1}}, ku, mu, 2);
}

//! One rational cubic, smooth throughout.
TopoDS_Face revolution_in_one()
{
    TColStd_Array1OfReal ku(1, 2);
    TColStd_Array1OfInteger mu(1, 2);
    ku(1) = 0.0;
    ku(2) = 1.0;
    mu(1) = mu(2) = 4;
    return half_turn({{1, 0, 1}, {1, 2, 1.0 / 3.0}, {-1, 2, 1.0 / 3.0}, {-1, 0, 1}}, ku, mu, 3);
}

const std::map<std::string, std::function<TopoDS_Face()>> &generators()
{
    static const std::map<std::string, std::function<TopoDS_Face()>> table{
        {"panel 8x8", [] { return net(panel, 8, 8); }},
        {"panel 14x14", [] { return net(panel, 14, 14); }},
        {"panel 32x32", [] { return net(panel, 32, 32); }},
        {"panel 60x60", [] { return net(panel, 60, 60); }},
        {"panel 128x128", [] { return net(panel, 128, 128); }},
        {"wing 20x8", [] { return net(wing, 20, 8); }},
        {"wavy 16x12", [] { return net(wavy, 16, 12); }},
        {"wavy 60x60", [] { return net(wavy, 60, 60); }},
        {"noisy 12x12", [] { return net(panel, 12, 12, 3, 1.0); }},
        {"biquintic 8x8", [] { return net(panel, 8, 8, 5); }},
        {"biquintic 6x6", [] { return net(panel, 6, 6, 5); }},
        {"revolution 5x8", revolution_of_quarters},
        {"revolution 4x8", revolution_in_one},
    };
    return table;
}

bool is_free_form(const TopoDS_Face &face)
{
    switch (GeomAdaptor_Surface(unwrapped(BRep_Tool::Surface(face))).GetType())
    {
    case GeomAbs_Plane:
    case GeomAbs_Cylinder:
    case GeomAbs_Cone:
    case GeomAbs_Sphere:
    case GeomAbs_Torus: return false;
    default: return true;
    }
}

int pole_count(const Handle(Geom_Surface) & surface)
{
    if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface))
        return spline->NbUPoles() * spline->NbVPoles();
    if (const auto bezier = Handle(Geom_BezierSurface)::DownCast(surface))
        return bezier->NbUPoles() * bezier->NbVPoles();
    return 0;
}

void find_curvatures(BaseFace &base)
{
    double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
    BRepTools::UVBounds(base.face, u0, u1, v0, v1);
    BRepTopAdaptor_FClass2d inside(base.face, 1e-9);
    GeomLProp_SLProps local(BRep_Tool::Surface(base.face), 2, 1e-9);
    const double sign = base.face.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
    for (int i = 0; i < curvature_grid; ++i)
        for (int j = 0; j < curvature_grid; ++j)
        {
            const double u = u0 + (u1 - u0) * (i + 0.5) / curvature_grid;
            const double v = v0 + (v1 - v0) * (j + 0.5) / curvature_grid;
            if (inside.Perform(gp_Pnt2d(u, v)) != TopAbs_IN)
                continue;
            local.SetParameters(u, v);
            if (!local.IsCurvatureDefined())
                continue;
            for (const double k : {sign * local.MinCurvature(), sign * local.MaxCurvature()})
            {
                base.lowest_curvature = std::min(base.lowest_curvature, k);
                base.highest_curvature = std::max(base.highest_curvature, k);
            }
        }
}

void append_faces(const std::filesystem::path &path, bool free_form_only, std::vector<BaseFace> &result)
{
    int number = 0;
    for (const TopoDS_Face &face : test_support::read_faces(path))
    {
        ++number;
        if (free_form_only && !is_free_form(face))
            continue;
        result.push_back({path.filename().string() + "#" + std::to_string(number), face});
    }
}

} // namespace

Handle(Geom_Surface) unwrapped(const Handle(Geom_Surface) & surface)
{
    Handle(Geom_Surface) inner = surface;
    while (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(inner))
        inner = trimmed->BasisSurface();
    return inner;
}

BaseFace describe(const std::string &name, const TopoDS_Face &face)
{
    BaseFace base{name, face};
    base.poles = pole_count(unwrapped(BRep_Tool::Surface(face)));
    base.free_form = is_free_form(face);
    Bnd_Box box;
    BRepBndLib::AddOptimal(face, box, false, false);
    base.diagonal = std::sqrt(box.SquareExtent());
    try
    {
        find_curvatures(base);
    }
    catch (const Standard_Failure &error)
    {
        std::cerr << name << ": curvatures unknown, " << error.GetMessageString() << '\n';
    }
    return base;
}

std::vector<BaseFace> generated_faces()
{
    std::vector<BaseFace> result;
    for (const char *name : {"panel 8x8", "panel 14x14", "panel 32x32", "panel 128x128", "wing 20x8", "wavy 16x12",
                             "noisy 12x12", "biquintic 8x8", "revolution 5x8", "revolution 4x8"})
        result.push_back(generated_face(name));
    return result;
}

BaseFace generated_face(const std::string &name) { return describe(name, generators().at(name)()); }

std::vector<BaseFace> real_faces(bool free_form_only, int stride)
{
    std::vector<BaseFace> all;
    const auto folder = test_support::find_data_dir();
    if (!folder)
        return all;
    std::set<std::filesystem::path> files;
    for (const auto &entry : std::filesystem::directory_iterator(*folder))
        if (const auto kind = entry.path().extension();
            kind == ".step" || kind == ".stp" || kind == ".iges" || kind == ".igs" || kind == ".brep")
            files.insert(entry.path());
    for (const auto &file : files)
        append_faces(file, free_form_only, all);
    std::vector<BaseFace> result;
    for (std::size_t i = 0; i < all.size(); i += static_cast<std::size_t>(stride))
        result.push_back(describe(all[i].name, all[i].face));
    return result;
}

} // namespace benchmark
