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
        return input ? integrate_face(input.value()) : input.failure();
    }
    catch (const Standard_Failure &error)
    {
        return kernel_failure(error, Stage::Input);
    }
}

} // namespace laminate_offset
