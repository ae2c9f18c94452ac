// SPDX-License-Identifier: LGPL-2.1-or-later
#include "step_assembly.h"

#include "step_looks.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepData_StepModel.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDF_Label.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopLoc_Location.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <algorithm>
#include <stdexcept>

namespace laminate_offset
{
namespace
{

//! A document for as long as this object lives.
class Document
{
public:
    Document() { XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", m_document); }
    ~Document() { XCAFApp_Application::GetApplication()->Close(m_document); }
    Document(const Document &) = delete;
    Document &operator=(const Document &) = delete;

    const Handle(TDocStd_Document) & get() const { return m_document; }

private:
    Handle(TDocStd_Document) m_document;
};

//! One of OpenCASCADE's process-wide settings, changed for as long as this object lives.
class Setting
{
public:
    Setting(const char *name, const char *value) : m_name{name}, m_before{Interface_Static::CVal(name)}
    {
        if (!Interface_Static::SetCVal(name, value))
            throw std::runtime_error(std::string("OpenCASCADE does not know the setting ") + name + " = " + value);
    }
    ~Setting() { Interface_Static::SetCVal(m_name, m_before.c_str()); }
    Setting(const Setting &) = delete;
    Setting &operator=(const Setting &) = delete;

private:
    const char *m_name;
    std::string m_before;
};

void set_name(const TDF_Label &label, const std::string &name)
{
    TDataStd_Name::Set(label, TCollection_ExtendedString(name.c_str(), true));
}

void add_parts(const Handle(TDocStd_Document) & document, const std::string &name, const std::vector<NamedPart> &parts)
{
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const Handle(XCAFDoc_ColorTool) colours = XCAFDoc_DocumentTool::ColorTool(document->Main());
    const TDF_Label assembly = shapes->NewShape();
    set_name(assembly, name);
    for (const NamedPart &part : parts)
    {
        // Shapes of their own, on the same geometry: two parts that share a shape would become one with one name.
        BRepBuilderAPI_Copy copy(part.shape.Located(TopLoc_Location()), false);
        const TDF_Label label = shapes->AddShape(copy.Shape(), false);
        set_name(label, part.name);
        const Quantity_Color colour(part.colour[0], part.colour[1], part.colour[2], Quantity_TOC_sRGB);
        colours->SetColor(label, colour, XCAFDoc_ColorGen);
        set_name(shapes->AddComponent(assembly, label, part.shape.Location()), part.name);
    }
    shapes->UpdateAssemblies();
}

std::vector<std::string> names_of(const std::string &whole, const std::vector<NamedPart> &parts)
{
    std::vector<std::string> names{whole};
    for (const NamedPart &part : parts)
        names.push_back(part.name);
    return names;
}

void write(const std::string &path, const std::string &name, const std::vector<NamedPart> &parts, StepSchema schema)
{
    STEPCAFControl_Controller::Init();
    const Setting protocol("write.step.schema", schema == StepSchema::Ap242 ? "AP242DIS" : "AP214IS");
    const Setting unit("write.step.unit", "MM");
    // FreeCAD turns this off for good when it writes STEP: parts that stand elsewhere would lose their names
    const Setting groups("write.step.assembly", "Auto");
    const Document document;
    add_parts(document.get(), name, parts);
    STEPCAFControl_Writer writer;
    writer.SetColorMode(true);
    writer.SetNameMode(true);
    if (!writer.Transfer(document.get(), STEPControl_AsIs))
        throw std::runtime_error("OpenCASCADE could not write the assembly");
    check_looks(writer.ChangeWriter().Model(), names_of(name, parts));
    if (writer.Write(path.c_str()) != IFSelect_RetDone)
        throw std::runtime_error("OpenCASCADE could not write the assembly");
}

} // namespace

void write_step_assembly(const std::string &path, const std::string &name, const std::vector<NamedPart> &parts,
                         StepSchema schema)
{
    if (parts.empty() || std::any_of(parts.begin(), parts.end(), [](const auto &part) { return part.shape.IsNull(); }))
        throw std::invalid_argument("an assembly needs at least one part, and every part a shape");
    try
    {
        write(path, name, parts, schema);
    }
    catch (const Standard_Failure &failure)
    {
        throw std::runtime_error(std::string("OpenCASCADE could not write the assembly: ") +
                                 failure.GetMessageString());
    }
}

} // namespace laminate_offset
