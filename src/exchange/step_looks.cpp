// SPDX-License-Identifier: LGPL-2.1-or-later
#include "step_looks.h"

#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepRepr_CharacterizedDefinition.hxx>
#include <StepRepr_PropertyDefinition.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationRelationship.hxx>
#include <StepRepr_RepresentationRelationshipWithTransformation.hxx>
#include <StepRepr_RepresentedDefinition.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>

#include <set>
#include <stdexcept>

namespace laminate_offset
{
namespace
{

constexpr const char *remedy =
    ". Parts without faces lose them; else write it from a newly started FreeCAD, where no other "
    "program has changed the settings of STEP";

std::string name_of(const Handle(StepBasic_Product) & product)
{
    return product->Name().IsNull() ? std::string() : product->Name()->ToCString();
}

//! Climbs from coloured items to the products that they belong to. A file may colour a part as a whole or face by face, and
//! a part of several bodies by the products that these became, so items cannot be counted.
class ColouredProducts
{
public:
    explicit ColouredProducts(const Handle(Interface_InterfaceModel) & model) : m_graph(model, false)
    {
        for (int number = 1; number <= model->NbEntities(); ++number)
            if (const auto styled = Handle(StepVisual_StyledItem)::DownCast(model->Value(number)); !styled.IsNull())
                visit(styled->Item());
        while (!m_open.empty())
        {
            const Handle(Standard_Transient) entity = m_open.back();
            m_open.pop_back();
            for (Interface_EntityIterator user = m_graph.Sharings(entity); user.More(); user.Next())
                climb(entity, user.Value());
        }
    }

    const std::set<Handle(StepBasic_Product)> &products() const { return m_products; }

private:
    void visit(const Handle(Standard_Transient) & entity)
    {
        if (!entity.IsNull() && m_seen.insert(entity).second)
            m_open.push_back(entity);
    }

    void climb(const Handle(Standard_Transient) & entity, const Handle(Standard_Transient) & user)
    {
        if (user->IsKind(STANDARD_TYPE(StepVisual_StyledItem)))
            return; // what else that colour stands on has its own way up
        if (const auto shape = Handle(StepShape_ShapeDefinitionRepresentation)::DownCast(user); !shape.IsNull())
            add(shape->Definition().PropertyDefinition());
        else if (const auto relation = Handle(StepRepr_RepresentationRelationship)::DownCast(user); relation.IsNull())
            visit(user);
        else
            cross(*relation, entity);
    }

    //! Between two forms of one shape both ways; from a part to the whole it is placed in, which stands second.
    void cross(const StepRepr_RepresentationRelationship &relation, const Handle(Standard_Transient) & from)
    {
        if (relation.Rep1() == from)
            visit(relation.Rep2());
        else if (!relation.IsKind(STANDARD_TYPE(StepRepr_RepresentationRelationshipWithTransformation)))
            visit(relation.Rep1());
    }

    void add(const Handle(StepRepr_PropertyDefinition) & property)
    {
        if (property.IsNull())
            return;
        const Handle(StepBasic_ProductDefinition) definition = property->Definition().ProductDefinition();
        if (!definition.IsNull())
            m_products.insert(definition->Formation()->OfProduct());
    }

    Interface_Graph m_graph;
    std::set<Handle(Standard_Transient)> m_seen;
    std::vector<Handle(Standard_Transient)> m_open;
    std::set<Handle(StepBasic_Product)> m_products;
};

std::multiset<std::string> product_names(const Handle(Interface_InterfaceModel) & model)
{
    std::multiset<std::string> names;
    for (int number = 1; number <= model->NbEntities(); ++number)
        if (const auto product = Handle(StepBasic_Product)::DownCast(model->Value(number)); !product.IsNull())
            names.insert(name_of(product));
    return names;
}

//! Takes one of the names out. \return whether it was there.
bool take(std::multiset<std::string> &names, const std::string &name)
{
    const auto place = names.find(name);
    if (place == names.end())
        return false;
    names.erase(place);
    return true;
}

} // namespace

void check_looks(const Handle(Interface_InterfaceModel) & model, const std::vector<std::string> &names)
{
    std::multiset<std::string> products = product_names(model);
    for (const std::string &name : names)
        if (!take(products, name))
            throw std::runtime_error("the file would be without the name \"" + name + "\"" + remedy);
    const ColouredProducts climbed(model);
    std::multiset<std::string> coloured;
    for (const Handle(StepBasic_Product) & product : climbed.products())
        coloured.insert(name_of(product));
    const std::size_t parts = names.size() - 1;
    std::size_t found = 0;
    for (std::size_t part = 1; part < names.size(); ++part)
        found += take(coloured, names[part]) ? 1 : 0;
    if (found < parts)
        throw std::runtime_error("only " + std::to_string(found) + " of " + std::to_string(parts) +
                                 " parts would have their colour in the file" + remedy);
}

} // namespace laminate_offset
