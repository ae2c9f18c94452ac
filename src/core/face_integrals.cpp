// SPDX-License-Identifier: LGPL-2.1-or-later
#include "face_integrals.h"

#include "input/input_face.h"

namespace laminate_offset
{

Result<FaceIntegrals> face_integrals(const TopoDS_Shape &face)
{
    try
    {
        const Result<InputFace> input = read_face(face);
        if (!input)
            return input.failure();
        return integrate_face(input.value());
    }
    catch (const Standard_Failure &error)
    {
        return kernel_failure(error, Stage::Input);
    }
}

Result<std::vector<PlyIntegrals>> ply_integrals(const TopoDS_Shape &region, const std::vector<PlyLayer> &layers)
{
    try
    {
        const Result<InputFace> input = read_face(region);
        if (!input)
            return input.failure();
        return integrate_plies(input.value(), layers);
    }
    catch (const Standard_Failure &error)
    {
        return kernel_failure(error, Stage::Input);
    }
}

} // namespace laminate_offset
