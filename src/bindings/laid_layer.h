// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Where a ply of a stack lies over its region, as Python passes it from stack_plies to ply_integrals.
#pragma once

#include <laminate_offset/ply_stack.h>

#include <memory>

namespace laminate_offset::python
{

//! See StackedPly.
struct LaidLayer
{
    std::shared_ptr<const ScalarSpline> distance;
    double thickness = 0.0;
};

} // namespace laminate_offset::python
