// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A shape that no other thread can change.
#pragma once

#include <TopoDS_Shape.hxx>

namespace laminate_offset::python
{

//! A face of its own topology over the same surface and curves. While the engine works without the
//! GIL, FreeCAD may mesh the original on another thread, which changes its TShape.
TopoDS_Shape detached(const TopoDS_Shape &shape);

} // namespace laminate_offset::python
