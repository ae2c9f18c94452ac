// SPDX-License-Identifier: LGPL-2.1-or-later
// Models that OpenCASCADE made without names or colours are found out before they are written.
#include <exchange/step_looks.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <StepData_StepModel.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace laminate_offset
{
namespace
{

using testing::HasSubstr;

//! A box in an assembly, as OpenCASCADE writes it after other code chose whether assemblies are kept ("Auto" or "Off").
class WrittenBox
{
public:
    WrittenBox(const char *assemblies, bool colours)
    {
        STEPCAFControl_Controller::Init();
        Interface_Static::SetCVal("write.step.assembly", assemblies);
        Handle(TDocStd_Document) document;
        XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
        fill(document->Main());
        m_writer.SetColorMode(colours);
        EXPECT_TRUE(m_writer.Transfer(document, STEPControl_AsIs));
        EXPECT_GT(model()->NbEntities(), 100);
        XCAFApp_Application::GetApplication()->Close(document);
        Interface_Static::SetCVal("write.step.assembly", "Auto");
    }

    //! Lives no longer than this object.
    Handle(StepData_StepModel) model() { return m_writer.ChangeWriter().Model(); }

private:
    static void fill(const TDF_Label &main)
    {
        const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(main);
        const TDF_Label whole = shapes->NewShape();
        const TDF_Label box = shapes->AddShape(BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape(), false);
        TDataStd_Name::Set(whole, "whole");
        TDataStd_Name::Set(box, "box");
        const Quantity_Color red(Quantity_NOC_RED);
        XCAFDoc_DocumentTool::ColorTool(main)->SetColor(box, red, XCAFDoc_ColorGen);
        gp_Trsf elsewhere;
        elsewhere.SetTranslation(gp_Vec(100.0, 0.0, 0.0));
        shapes->AddComponent(whole, box, TopLoc_Location(elsewhere));
        shapes->UpdateAssemblies();
    }

    STEPCAFControl_Writer m_writer;
};

//! What is told of a model; empty when nothing is lost.
std::string loss(const Handle(StepData_StepModel) & model, const std::vector<std::string> &names)
{
    try
    {
        check_looks(model, names);
    }
    catch (const std::runtime_error &error)
    {
        return error.what();
    }
    return "";
}

TEST(StepLooks, NamesAndColoursThatAreThereAreFound)
{
    WrittenBox written("Auto", true);
    EXPECT_EQ(loss(written.model(), {"whole", "box"}), "");
    EXPECT_EQ(loss(written.model(), {"box", "whole"}), "");
}

TEST(StepLooks, LostNamesAreTold)
{
    EXPECT_THAT(loss(WrittenBox("Off", true).model(), {"whole", "box"}), HasSubstr("without the name \"box\""));
    WrittenBox named("Auto", true);
    EXPECT_THAT(loss(named.model(), {"whole", "ball"}), HasSubstr("without the name \"ball\""));
    // One product does not answer for two parts.
    EXPECT_THAT(loss(named.model(), {"whole", "box", "box"}), HasSubstr("without the name \"box\""));
}

TEST(StepLooks, LostColoursAreTold)
{
    EXPECT_THAT(loss(WrittenBox("Auto", false).model(), {"whole", "box"}), HasSubstr("only 0 of 1 parts"));
}

} // namespace
} // namespace laminate_offset
