// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The inside of the trimming loops as a set of parameters.
#pragma once

#include "../input/input_face.h"

#include <BRepTopAdaptor_FClass2d.hxx>

namespace laminate_offset
{

//! Answers whether parameters lie inside the trimming loops or on them. Not for use by two threads at once.
class LoopRegion
{
public:
    explicit LoopRegion(const InputFace &input);

    [[nodiscard]] bool contains(const gp_Pnt2d &uv) const;

private:
    mutable BRepTopAdaptor_FClass2d m_classifier; // its Perform is not const, though it changes nothing seen here
};

} // namespace laminate_offset
