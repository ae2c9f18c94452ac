// SPDX-License-Identifier: LGPL-2.1-or-later
#include "zero_copy_exchange.h"

// Generated: defines a few hundred static functions of which this file uses five.
#include <swigpyrun.h>

#include <memory>
#include <stdexcept>

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

constexpr const char *shape_type_name = "TopoDS_Shape *";

//! FreeCAD looks its pointer type up by name in a ring of module tables that all SWIG modules of the
//! process share. pythonOCC would have put the type there; this table holds just that one type.
//! SWIG keeps pointers into it until the interpreter ends, so it is static.
class ShapeTypeTable
{
public:
    ShapeTypeTable()
    {
        m_cast.type = &m_type;
        m_type.name = "_p_TopoDS_Shape";
        m_type.str = shape_type_name;
        m_type.cast = &m_cast;
        m_module.types = m_types;
        m_module.size = 1;
        m_module.type_initial = m_types;
        m_module.cast_initial = m_casts;
        m_module.next = &m_module;
    }

    //! Adds the table to the ring, or opens the ring with it.
    swig_type_info *join_ring()
    {
        if (swig_module_info *ring = SWIG_GetModule(nullptr))
        {
            m_module.next = ring->next;
            ring->next = &m_module;
        }
        else
        {
            SWIG_SetModule(nullptr, &m_module);
        }
        return &m_type;
    }

private:
    swig_type_info m_type{};
    swig_cast_info m_cast{};
    swig_type_info *m_types[2] = {&m_type, nullptr};
    swig_cast_info *m_casts[2] = {&m_cast, nullptr};
    swig_module_info m_module{};
};

swig_type_info *find_shape_type()
{
    swig_module_info *ring = SWIG_GetModule(nullptr);
    return ring ? SWIG_TypeQueryModule(ring, ring, shape_type_name) : nullptr;
}

swig_type_info *shape_type()
{
    static swig_type_info *type = nullptr;
    if (!type)
        type = find_shape_type();
    if (!type)
    {
        static ShapeTypeTable table;
        type = table.join_ring();
    }
    return type;
}

} // namespace

TopoDS_Shape zero_copy_from_part(const py::object &part_shape)
{
    // The type must be in the ring before FreeCAD looks for it.
    swig_type_info *type = shape_type();
    const py::object pointer = py::module_::import("Part").attr("__toPythonOCC__")(part_shape);
    void *content = nullptr;
    if (!SWIG_IsOK(SWIG_ConvertPtr(pointer.ptr(), &content, type, SWIG_POINTER_DISOWN)) || !content)
        throw std::runtime_error("FreeCAD's pointer to the shape is not of the expected SWIG type.");
    // FreeCAD made this TopoDS_Shape for us on the heap, and disowning it made us its owner.
    const std::unique_ptr<TopoDS_Shape> owned(static_cast<TopoDS_Shape *>(content));
    return *owned;
}

py::object zero_copy_to_part(const TopoDS_Shape &shape)
{
    TopoDS_Shape lent = shape; // FreeCAD copies from it before the pointer object dies
    const auto pointer = py::reinterpret_steal<py::object>(SWIG_NewPointerObj(&lent, shape_type(), 0));
    if (!pointer)
        throw py::error_already_set();
    return py::module_::import("Part").attr("__fromPythonOCC__")(pointer);
}

} // namespace laminate_offset::python
