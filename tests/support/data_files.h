// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Where tests find models, and how they read them.
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace test_support
{

//! The project's root folder.
std::filesystem::path project_dir();

//! Folder of the real models, which are not part of the project: the environment variable
//! LAMINATE_OFFSET_SHARED_DATA, else ../shared/data next to the project. Empty when there is none.
std::optional<std::filesystem::path> find_data_dir();

//! A real model by file name. Empty when the folder or the file is absent; the test should then skip.
std::optional<std::filesystem::path> find_data_file(const std::string &name);

//! A stored example of the project (resources/examples).
std::filesystem::path example_file(const std::string &name);

//! What a skipped test says.
std::string missing_data_message(const std::string &name);

//! The whole model of a STEP, IGES or BREP file.
//! \throw std::runtime_error when the file cannot be read.
TopoDS_Shape read_shape(const std::filesystem::path &path);

//! Its faces in FreeCAD's order (Face1 first), with location and orientation.
std::vector<TopoDS_Face> read_faces(const std::filesystem::path &path);

} // namespace test_support
