// SPDX-License-Identifier: LGPL-2.1-or-later
// Models that OpenCASCADE made without names or colours are found out before they are written.
#include <exchange/step_looks.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <StepData_StepModel.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace laminate_offset
{
namespace
{

using testing::HasSubstr;

//! What of a box has a colour in the document.
enum class Coloured
{
    Nothing,
    Whole,
    Faces
};

struct Box
{
    const char *name;
    Coloured coloured;
};

//! Boxes in an assembly, as OpenCASCADE writes it after other code chose whether assemblies are kept ("Auto" or "Off"). All of
//! them have the same colour.
class WrittenBoxes
{
public:
    WrittenBoxes(const char *assemblies, bool colours, const std::vector<Box> &boxes = {{"box", Coloured::Whole}})
    {
        STEPCAFControl_Controller::Init();
        Interface_Static::SetCVal("write.step.assembly", assemblies);
        Handle(TDocStd_Document) document;
        XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
        fill(document->Main(), boxes);
        m_writer.SetColorMode(colours);
        EXPECT_TRUE(m_writer.Transfer(document, STEPControl_AsIs));
        EXPECT_GT(model()->NbEntities(), 100);
        XCAFApp_Application::GetApplication()->Close(document);
        Interface_Static::SetCVal("write.step.assembly", "Auto");
    }

    //! Lives no longer than this object.
    Handle(StepData_StepModel) model() { return m_writer.ChangeWriter().Model(); }

private:
    static void fill(const TDF_Label &main, const std::vector<Box> &boxes)
    {
        const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(main);
        const TDF_Label whole = shapes->NewShape();
        TDataStd_Name::Set(whole, "whole");
        double place = 100.0;
        for (const Box &box : boxes)
        {
            const TopoDS_Shape shape = BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape();
            const TDF_Label label = shapes->AddShape(shape, false);
            TDataStd_Name::Set(label, box.name);
            colour(main, shape, label, box.coloured);
            gp_Trsf elsewhere;
            elsewhere.SetTranslation(gp_Vec(place, 0.0, 0.0));
            shapes->AddComponent(whole, label, TopLoc_Location(elsewhere));
            place += 100.0;
        }
        shapes->UpdateAssemblies();
    }

    static void colour(const TDF_Label &main, const TopoDS_Shape &shape, const TDF_Label &label, Coloured coloured)
    {
        const Handle(XCAFDoc_ColorTool) colours = XCAFDoc_DocumentTool::ColorTool(main);
        const Quantity_Color red(Quantity_NOC_RED);
        if (coloured == Coloured::Whole)
            colours->SetColor(label, red, XCAFDoc_ColorGen);
        if (coloured == Coloured::Faces)
            for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
                colours->SetColor(XCAFDoc_DocumentTool::ShapeTool(main)->AddSubShape(label, face.Current()), red,
                                  XCAFDoc_ColorSurf);
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
    WrittenBoxes written("Auto", true);
    EXPECT_EQ(loss(written.model(), {"whole", "box"}), "");
    EXPECT_EQ(loss(written.model(), {"box", "whole"}), "");
}

TEST(StepLooks, LostNamesAreTold)
{
    EXPECT_THAT(loss(WrittenBoxes("Off", true).model(), {"whole", "box"}), HasSubstr("without the name \"box\""));
    WrittenBoxes named("Auto", true);
    EXPECT_THAT(loss(named.model(), {"whole", "ball"}), HasSubstr("without the name \"ball\""));
    // One product does not answer for two parts.
    EXPECT_THAT(loss(named.model(), {"whole", "box", "box"}), HasSubstr("without the name \"box\""));
}

TEST(StepLooks, LostColoursAreTold)
{
    EXPECT_THAT(loss(WrittenBoxes("Auto", false).model(), {"whole", "box"}), HasSubstr("only 0 of 1 parts"));
}

//! How many entities of a type the model has.
template <class Entity> int count_of(const Handle(StepData_StepModel) & model)
{
    int count = 0;
    for (int number = 1; number <= model->NbEntities(); ++number)
        count += model->Value(number)->IsKind(STANDARD_TYPE(Entity)) ? 1 : 0;
    return count;
}

TEST(StepLooks, PartsThatShareAStyleAllHaveTheirColour)
{
    WrittenBoxes written("Auto", true, {{"a", Coloured::Whole}, {"b", Coloured::Faces}, {"c", Coloured::Whole}});
    Handle(StepVisual_StyledItem) first;
    int sharing = 0;
    for (int number = 1; number <= written.model()->NbEntities(); ++number)
    {
        const auto styled = Handle(StepVisual_StyledItem)::DownCast(written.model()->Value(number));
        if (styled.IsNull())
            continue;
        first = first.IsNull() ? styled : first;
        styled->SetStyles(first->Styles());
        ++sharing;
    }
    EXPECT_EQ(sharing, 8); // two whole parts and six faces
    EXPECT_EQ(loss(written.model(), {"whole", "a", "b", "c"}), "");
}

TEST(StepLooks, ManyColouredFacesOfOnePartDoNotStandForAnotherOne)
{
    WrittenBoxes written("Auto", true, {{"a", Coloured::Faces}, {"b", Coloured::Nothing}, {"c", Coloured::Whole}});
    ASSERT_EQ(count_of<StepVisual_StyledItem>(written.model()), 7); // six faces and a whole part: more than parts
    EXPECT_THAT(loss(written.model(), {"whole", "a", "b", "c"}), HasSubstr("only 2 of 3 parts"));
    WrittenBoxes named_alike("Auto", true, {{"a", Coloured::Faces}, {"a", Coloured::Nothing}});
    EXPECT_THAT(loss(named_alike.model(), {"whole", "a", "a"}), HasSubstr("only 1 of 2 parts"));
}

} // namespace
} // namespace laminate_offset
