// SPDX-License-Identifier: LGPL-2.1-or-later
#include "binary_exchange.h"

#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

//! A file of a unique name, in memory where the system offers that, removed at the end.
class TemporaryFile
{
public:
    TemporaryFile()
    {
        const py::tuple made = py::module_::import("tempfile").attr("mkstemp")(".bin", "laminate_offset_", folder());
        py::module_::import("os").attr("close")(made[0]);
        m_path = made[1].cast<std::string>();
    }

    ~TemporaryFile() { std::remove(m_path.c_str()); }

    TemporaryFile(const TemporaryFile &) = delete;
    TemporaryFile &operator=(const TemporaryFile &) = delete;

    [[nodiscard]] const std::string &path() const { return m_path; }

private:
    static py::object folder()
    {
        const char *in_memory = "/dev/shm";
        std::error_code ignored;
        if (!std::filesystem::is_directory(in_memory, ignored))
            return py::none();
        const py::module_ os = py::module_::import("os");
        return os.attr("access")(in_memory, os.attr("W_OK")).cast<bool>() ? py::cast(in_memory) : py::none();
    }

    std::string m_path;
};

TopoDS_Shape read(std::istream &stream)
{
    BinTools_ShapeSet shapes;
    shapes.Read(stream);
    int root = 0;
    int location = 0;
    int orientation = 0;
    BinTools::GetInteger(stream, root);
    BinTools::GetInteger(stream, location);
    BinTools::GetInteger(stream, orientation);
    if (!stream || root < 1 || root > shapes.NbShapes())
        throw std::runtime_error("FreeCAD's binary file of the shape could not be read.");
    TopoDS_Shape shape = shapes.Shape(root);
    shape.Location(shapes.Locations().Location(location));
    shape.Orientation(static_cast<TopAbs_Orientation>(orientation));
    return shape;
}

void write(const TopoDS_Shape &shape, std::ostream &stream)
{
    BinTools_ShapeSet shapes;
    const int root = shapes.Add(shape);
    const int location = shapes.Locations().Index(shape.Location());
    shapes.SetFormatNb(BinTools_FormatVersion_VERSION_3);
    shapes.Write(stream);
    BinTools::PutInteger(stream, root);
    BinTools::PutInteger(stream, location);
    BinTools::PutInteger(stream, static_cast<int>(shape.Orientation()));
    stream.flush();
    if (!stream)
        throw std::runtime_error("The temporary file for the shape could not be written; is the disk full?");
}

} // namespace

TopoDS_Shape binary_from_part(const py::object &part_shape)
{
    const TemporaryFile file;
    part_shape.attr("exportBinary")(file.path());
    std::ifstream stream(file.path(), std::ios::binary);
    return read(stream);
}

py::object binary_to_part(const TopoDS_Shape &shape)
{
    const TemporaryFile file;
    {
        std::ofstream stream(file.path(), std::ios::binary);
        write(shape, stream);
    }
    py::object part_shape = py::module_::import("Part").attr("Shape")();
    part_shape.attr("importBinary")(file.path());
    return part_shape;
}

} // namespace laminate_offset::python
