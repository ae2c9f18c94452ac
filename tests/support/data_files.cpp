// SPDX-License-Identifier: LGPL-2.1-or-later
#include "data_files.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <stdexcept>

namespace test_support
{
namespace
{

std::string lower_extension(const std::filesystem::path &path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

TopoDS_Shape transfer(XSControl_Reader &reader, const std::filesystem::path &path)
{
    if (reader.ReadFile(path.string().c_str()) != IFSelect_RetDone)
        throw std::runtime_error("cannot read " + path.string());
    reader.TransferRoots();
    return reader.OneShape();
}

TopoDS_Shape read_brep(const std::filesystem::path &path)
{
    TopoDS_Shape shape;
    BRep_Builder builder;
    if (!BRepTools::Read(shape, path.string().c_str(), builder))
        throw std::runtime_error("cannot read " + path.string());
    return shape;
}

} // namespace

std::filesystem::path project_dir() { return LAMINATE_OFFSET_PROJECT_DIR; }

std::optional<std::filesystem::path> find_data_dir()
{
    const char *override_dir = std::getenv("LAMINATE_OFFSET_SHARED_DATA");
    const std::filesystem::path dir =
        override_dir ? std::filesystem::path(override_dir) : project_dir() / ".." / "shared" / "data";
    if (!std::filesystem::is_directory(dir))
        return std::nullopt;
    return dir;
}

std::optional<std::filesystem::path> find_data_file(const std::string &name)
{
    const auto dir = find_data_dir();
    if (!dir || !std::filesystem::exists(*dir / name))
        return std::nullopt;
    return *dir / name;
}

std::filesystem::path example_file(const std::string &name) { return project_dir() / "resources" / "examples" / name; }

std::string missing_data_message(const std::string &name)
{
    return "the real model " + name +
           " is not here: put it into ../shared/data or point LAMINATE_OFFSET_SHARED_DATA to its folder";
}

TopoDS_Shape read_shape(const std::filesystem::path &path)
{
    const std::string extension = lower_extension(path);
    if (extension == ".step" || extension == ".stp")
    {
        STEPControl_Reader reader;
        return transfer(reader, path);
    }
    if (extension == ".igs" || extension == ".iges")
    {
        IGESControl_Reader reader;
        reader.SetReadVisible(true); // as FreeCAD reads: construction elements are left out
        return transfer(reader, path);
    }
    if (extension == ".brep" || extension == ".brp")
        return read_brep(path);
    throw std::runtime_error("unknown kind of model file: " + path.string());
}

std::vector<TopoDS_Face> read_faces(const std::filesystem::path &path)
{
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(read_shape(path), TopAbs_FACE, map);
    std::vector<TopoDS_Face> faces;
    for (int i = 1; i <= map.Extent(); ++i)
        faces.push_back(TopoDS::Face(map(i)));
    return faces;
}

} // namespace test_support
