// SPDX-License-Identifier: LGPL-2.1-or-later
// An assembly that is written as STEP comes back part by part: names, colours, places, shapes.
#include <exchange/step_assembly.h>

#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace laminate_offset
{
namespace
{

struct ReadPart
{
    std::string name;
    std::array<double, 3> colour{-1.0, -1.0, -1.0};
    gp_Pnt centre;
    double area{0.0};
};

struct ReadAssembly
{
    std::string name;
    std::vector<ReadPart> parts;
};

class StepAssembly : public testing::Test
{
protected:
    StepAssembly()
    {
        const testing::TestInfo *const test = testing::UnitTest::GetInstance()->current_test_info();
        m_path = std::filesystem::temp_directory_path() / (std::string("step_assembly_") + test->name() + ".step");
    }
    ~StepAssembly() override { std::filesystem::remove(m_path); }

    std::string path() const { return m_path.string(); }

    std::string text() const
    {
        std::stringstream content;
        content << std::ifstream(m_path).rdbuf();
        return content.str();
    }

private:
    std::filesystem::path m_path;
};

TopoDS_Shape face_of(const TopoDS_Shape &shape) { return TopExp_Explorer(shape, TopAbs_FACE).Current(); }

TopoDS_Shape moved(const TopoDS_Shape &shape, double x)
{
    gp_Trsf transformation;
    transformation.SetTranslation(gp_Vec(x, 0.0, 0.0));
    return shape.Located(TopLoc_Location(transformation));
}

std::string name_of(const TDF_Label &label)
{
    Handle(TDataStd_Name) name;
    if (!label.FindAttribute(TDataStd_Name::GetID(), name))
        return "";
    std::string text(static_cast<std::size_t>(name->Get().LengthOfCString()), '\0');
    Standard_PCharacter start = text.data();
    name->Get().ToUTF8CString(start);
    return text;
}

//! The colour of a label's shape, or of the first of its faces that has one.
std::array<double, 3> colour_of(const Handle(XCAFDoc_ColorTool) & colours, const TopoDS_Shape &shape)
{
    Quantity_Color colour;
    bool found =
        colours->GetColor(shape, XCAFDoc_ColorSurf, colour) || colours->GetColor(shape, XCAFDoc_ColorGen, colour);
    for (TopExp_Explorer face(shape, TopAbs_FACE); !found && face.More(); face.Next())
        found = colours->GetColor(face.Current(), XCAFDoc_ColorSurf, colour);
    std::array<double, 3> values{-1.0, -1.0, -1.0};
    if (found)
        colour.Values(values[0], values[1], values[2], Quantity_TOC_sRGB);
    return values;
}

ReadPart read_part(const Handle(XCAFDoc_ColorTool) & colours, const TDF_Label &component)
{
    ReadPart part;
    TDF_Label referred;
    XCAFDoc_ShapeTool::GetReferredShape(component, referred);
    part.name = name_of(referred);
    part.colour = colour_of(colours, XCAFDoc_ShapeTool::GetShape(referred));
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(XCAFDoc_ShapeTool::GetShape(component), properties);
    part.area = properties.Mass();
    part.centre = properties.CentreOfMass();
    return part;
}

ReadAssembly read(const std::string &path)
{
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
    STEPCAFControl_Reader reader;
    reader.SetColorMode(true);
    reader.SetNameMode(true);
    EXPECT_EQ(reader.ReadFile(path.c_str()), IFSelect_RetDone);
    EXPECT_TRUE(reader.Transfer(document));
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const Handle(XCAFDoc_ColorTool) colours = XCAFDoc_DocumentTool::ColorTool(document->Main());
    TDF_LabelSequence roots;
    shapes->GetFreeShapes(roots);
    EXPECT_EQ(roots.Length(), 1);
    ReadAssembly assembly;
    assembly.name = name_of(roots.First());
    EXPECT_TRUE(XCAFDoc_ShapeTool::IsAssembly(roots.First()));
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(roots.First(), components);
    for (const TDF_Label &component : components)
        assembly.parts.push_back(read_part(colours, component));
    XCAFApp_Application::GetApplication()->Close(document);
    return assembly;
}

TEST_F(StepAssembly, PartsComeBackInOrderWithNamesColoursAndPlaces)
{
    const TopoDS_Shape cylinder = face_of(BRepPrimAPI_MakeCylinder(10.0, 20.0).Shape());
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape();
    const std::vector<NamedPart> parts{{cylinder, "P1 0\u00b0 Gr\u00f6\u00dfe", {0.1, 0.45, 0.7}},
                                       {moved(box, 100.0), "P2, 45 'core'", {0.9, 0.6, 0.0}},
                                       {face_of(box), "P3", {0.0, 0.62, 0.45}}};
    for (const StepSchema schema : {StepSchema::Ap214, StepSchema::Ap242})
    {
        write_step_assembly(path(), "Stack", parts, schema);
        EXPECT_THAT(text(), testing::HasSubstr(schema == StepSchema::Ap214 ? "AUTOMOTIVE_DESIGN" : "AP242"));
        EXPECT_THAT(text(), testing::HasSubstr("SI_UNIT(.MILLI.,.METRE.)"));
        const ReadAssembly assembly = read(path());
        EXPECT_EQ(assembly.name, "Stack");
        ASSERT_EQ(assembly.parts.size(), parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i)
        {
            EXPECT_EQ(assembly.parts[i].name, parts[i].name);
            for (std::size_t channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(assembly.parts[i].colour[channel], parts[i].colour[channel], 1e-4) << parts[i].name;
        }
        EXPECT_NEAR(assembly.parts[0].area, 400.0 * M_PI, 1e-6);
        EXPECT_NEAR(assembly.parts[1].area, 2200.0, 1e-9);
        EXPECT_NEAR(assembly.parts[1].centre.X(), 105.0, 1e-9);
        EXPECT_NEAR(assembly.parts[2].area, 600.0, 1e-9);
    }
}

TEST_F(StepAssembly, OneShapeMayBeTwoParts)
{
    const TopoDS_Shape face = face_of(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape());
    const NamedPart first{face, "first", {1.0, 0.0, 0.0}};
    const NamedPart second{moved(face, 5.0), "second", {0.0, 0.0, 1.0}};
    write_step_assembly(path(), "twins", {first, second}, StepSchema::Ap214);
    const ReadAssembly assembly = read(path());
    ASSERT_EQ(assembly.parts.size(), 2U);
    EXPECT_EQ(assembly.parts[0].name, "first");
    EXPECT_EQ(assembly.parts[1].name, "second");
    EXPECT_NEAR(assembly.parts[1].centre.X() - assembly.parts[0].centre.X(), 5.0, 1e-9);
}

TEST_F(StepAssembly, SettingsAreAsBeforeAfterwards)
{
    STEPCAFControl_Controller::Init();
    Interface_Static::SetCVal("write.step.schema", "AP203");
    Interface_Static::SetCVal("write.step.unit", "INCH");
    Interface_Static::SetCVal("write.step.assembly", "Off"); // FreeCAD does
    const TopoDS_Shape box = moved(BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape(), 100.0);
    write_step_assembly(path(), "whole", {{box, "box", {0.0, 0.0, 0.0}}}, StepSchema::Ap242);
    EXPECT_THAT(text(), testing::Not(testing::HasSubstr("PRODUCT('Open CASCADE")));
    EXPECT_EQ(read(path()).parts.at(0).name, "box");
    EXPECT_STREQ(Interface_Static::CVal("write.step.assembly"), "Off");
    EXPECT_STREQ(Interface_Static::CVal("write.step.schema"), "AP203");
    EXPECT_STREQ(Interface_Static::CVal("write.step.unit"), "INCH");
    Interface_Static::SetCVal("write.step.schema", "AP214IS");
    Interface_Static::SetCVal("write.step.unit", "MM");
    Interface_Static::SetCVal("write.step.assembly", "Auto");
}

TEST_F(StepAssembly, PartsMayHaveOneNameAndThatOfTheWhole)
{
    const NamedPart box{BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape(), "box", {0.0, 0.0, 0.0}};
    write_step_assembly(path(), "box", {box, box}, StepSchema::Ap214);
    EXPECT_EQ(read(path()).parts.size(), 2U);
}

TEST_F(StepAssembly, WhatWouldLoseItsColourIsRefusedAndTheFileIsAsBefore)
{
    TopoDS_Compound nothing;
    BRep_Builder().MakeCompound(nothing);
    const NamedPart box{BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape(), "box", {0.0, 0.0, 0.0}};
    std::ofstream(path()) << "old";
    for (const StepSchema schema : {StepSchema::Ap214, StepSchema::Ap242})
        EXPECT_THAT(
            [&] {
                write_step_assembly(path(), "whole", {box, {nothing, "hollow", {}}}, schema);
            },
            testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("without faces")));
    EXPECT_EQ(text(), "old");
}

TEST_F(StepAssembly, WhatCannotBeWrittenIsThrown)
{
    const NamedPart box{BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape(), "box", {0.0, 0.0, 0.0}};
    EXPECT_THROW(write_step_assembly(path(), "none", {}, StepSchema::Ap214), std::invalid_argument);
    EXPECT_THROW(write_step_assembly(path(), "null", {box, {{}, "null", {0.0, 0.0, 0.0}}}, StepSchema::Ap214),
                 std::invalid_argument);
    EXPECT_THROW(write_step_assembly("/proc/no/such.step", "box", {box}, StepSchema::Ap214), std::runtime_error);
}

} // namespace
} // namespace laminate_offset
