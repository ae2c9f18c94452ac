// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Offsets one face of a ball of radius 10 mm by 2.5 mm outwards and inwards and checks the radius of what comes back.

#include <laminate_offset/offset_face.h>

#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <cmath>
#include <iostream>

namespace
{

//! \return true when the offset by distance [mm] is a sphere of radius 10 mm + distance.
bool check_sphere_offset(const TopoDS_Face &base, double distance)
{
    laminate_offset::OffsetOptions options;
    options.distance = distance;
    const auto result = laminate_offset::offset_face(base, options);
    if (!result)
    {
        std::cerr << "refused: " << result.failure().message << '\n';
        return false;
    }
    const Handle(Geom_SphericalSurface) sphere =
        Handle(Geom_SphericalSurface)::DownCast(BRep_Tool::Surface(result.value().face()));
    if (sphere.IsNull())
    {
        std::cerr << "the offset of a sphere is not a sphere\n";
        return false;
    }
    std::cout << "offset " << distance << " mm: radius " << sphere->Radius() << " mm\n";
    return std::abs(sphere->Radius() - (10.0 + distance)) < 1e-12;
}

} // namespace

int main()
{
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(10.0).Shape();
    const TopoDS_Face base = TopoDS::Face(TopExp_Explorer(ball, TopAbs_FACE).Current());
    const bool outwards = check_sphere_offset(base, 2.5);
    const bool inwards = check_sphere_offset(base, -2.5);
    return outwards && inwards ? 0 : 1;
}
