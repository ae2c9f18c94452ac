// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ply_solids.h"

#include <TopoDS.hxx>

namespace laminate_offset
{

Result<std::vector<TopoDS_Solid>> ply_solids(const std::vector<TopoDS_Shape> &faces,
                                             const std::vector<SolidSpan> &spans)
{
    std::vector<TopoDS_Face> single;
    for (const TopoDS_Shape &face : faces)
    {
        if (face.IsNull() || face.ShapeType() != TopAbs_FACE)
            return Failure{
                Status::NotAFace, Stage::Topology,
                "A ply's surface is not a single face, so no single solid is made from it: the base has creases, at "
                "which its offsets are torn. Split the face at its creases and stack the parts.",
                std::nullopt, std::nullopt};
        single.push_back(TopoDS::Face(face));
    }
    try
    {
        return make_solids(single, spans);
    }
    catch (const Standard_Failure &error)
    {
        return kernel_failure(error, Stage::Topology);
    }
}

} // namespace laminate_offset
