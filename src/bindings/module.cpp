// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The extension module laminate_offset._core. It holds no policy: the package around it converts
//! units, chooses the way of shape exchange and documents the interface.
#include "evaluate_face_binding.h"
#include "extend_face_binding.h"
#include "face_integrals_binding.h"
#include "nearest_point_binding.h"
#include "offset_face_binding.h"
#include "offset_limits_binding.h"
#include "offset_options_binding.h"
#include "offset_stack_binding.h"
#include "ply_solids_binding.h"
#include "ply_stack_binding.h"
#include "project_curve_binding.h"
#include "shape_exchange.h"
#include "step_assembly_binding.h"
#include "thread_limit_binding.h"
#include "watched_progress.h"
#include "without_gil.h"

#include <Standard_Failure.hxx>
#include <pybind11/pybind11.h>

#include <string>

namespace
{

//! OpenCASCADE's exceptions are no std::exception: without this they would end the process.
void translate_kernel_failure(std::exception_ptr raised)
{
    try
    {
        if (raised)
            std::rethrow_exception(raised);
    }
    catch (const Standard_Failure &failure)
    {
        const std::string text =
            std::string("OpenCASCADE: ") + failure.DynamicType()->Name() + ": " + failure.GetMessageString();
        PyErr_SetString(PyExc_RuntimeError, text.c_str());
    }
}

} // namespace

PYBIND11_MODULE(_core, module)
{
    module.doc() = "Compiled part of laminate_offset. Use the functions of laminate_offset instead.";
    module.attr("__version__") = LAMINATE_OFFSET_VERSION;
    pybind11::register_local_exception_translator(translate_kernel_failure);
    laminate_offset::python::bind_shape_exchange(module);
    laminate_offset::python::bind_offset_options(module);
    laminate_offset::python::bind_offset_face(module);
    laminate_offset::python::bind_offset_limits(module);
    laminate_offset::python::bind_extend_face(module);
    laminate_offset::python::bind_nearest_point(module);
    laminate_offset::python::bind_project_curve(module);
    laminate_offset::python::bind_offset_stack(module);
    laminate_offset::python::bind_face_integrals(module);
    laminate_offset::python::bind_ply_solids(module);
    laminate_offset::python::bind_evaluate_face(module);
    laminate_offset::python::bind_thread_limit(module);
    laminate_offset::python::bind_watched_progress(module);
    laminate_offset::python::bind_engine_niceness(module);
    laminate_offset::python::bind_ply_stack(module);
    laminate_offset::python::bind_step_assembly(module);
}
