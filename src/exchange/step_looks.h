// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Looks into a STEP model, before it is written, for names and colours that got lost.
#pragma once

#include <Interface_InterfaceModel.hxx>

#include <string>
#include <vector>

namespace laminate_offset
{

//! Names and colours hang on settings that the whole process shares, so that other code may have made OpenCASCADE drop them.
//! \param names of the assembly, then of its parts, in UTF-8; one name may stand there several times.
//! \throw std::runtime_error when the model has no product for one of the names, or a part of which nothing is coloured; the
//! text tells which or how many, and the remedy.
void check_looks(const Handle(Interface_InterfaceModel) & model, const std::vector<std::string> &names);

} // namespace laminate_offset
