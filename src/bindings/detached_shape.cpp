// SPDX-License-Identifier: LGPL-2.1-or-later
#include "detached_shape.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>

namespace laminate_offset::python
{
namespace
{

bool has_surface(const TopoDS_Shape &shape)
{
    if (shape.IsNull() || shape.ShapeType() != TopAbs_FACE)
        return false;
    TopLoc_Location location;
    return !BRep_Tool::Surface(TopoDS::Face(shape), location).IsNull();
}

} // namespace

TopoDS_Shape detached(const TopoDS_Shape &shape)
{
    if (!has_surface(shape))
        return shape;
    try
    {
        return BRepBuilderAPI_Copy(shape, /*copyGeom=*/false, /*copyMesh=*/false).Shape();
    }
    catch (const Standard_Failure &)
    {
        return shape; // too broken to copy: the engine says what is wrong with it
    }
}

} // namespace laminate_offset::python
