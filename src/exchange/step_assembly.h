// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! STEP files of assemblies whose parts have names and colours.
#pragma once

#include <TopoDS_Shape.hxx>

#include <array>
#include <string>
#include <vector>

namespace laminate_offset
{

//! One part of an assembly.
struct NamedPart
{
    TopoDS_Shape shape;           //!< in mm; its placement is that of the part in the assembly
    std::string name;             //!< UTF-8
    std::array<double, 3> colour; //!< red, green and blue as screens take them (sRGB), from 0 to 1
};

//! Application protocol of a STEP file.
enum class StepSchema
{
    Ap214, //!< automotive design; what most programs read
    Ap242  //!< managed model-based 3D engineering; its successor
};

//! Writes one assembly with its parts, in their order, as a STEP file in mm; replaces the file.
//! OpenCASCADE keeps its STEP settings in one place for the whole process: only one thread may be here at a time. They
//! are as before afterwards.
//! \throw std::invalid_argument when there is no part, or a shape is null.
//! \throw std::runtime_error when OpenCASCADE cannot write it, or would write it without a name or a colour; the file is
//! then as before.
void write_step_assembly(const std::string &path, const std::string &name, const std::vector<NamedPart> &parts,
                         StepSchema schema);

} // namespace laminate_offset
