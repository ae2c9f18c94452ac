// SPDX-License-Identifier: LGPL-2.1-or-later
#include "step_looks.h"

#include <StepBasic_Product.hxx>
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

//! What a model will have in its file.
struct Looks
{
    std::multiset<std::string> products;
    std::size_t coloured{0}; //!< items with a colour
};

Looks looks_of(const Handle(Interface_InterfaceModel) & model)
{
    Looks looks;
    for (int number = 1; number <= model->NbEntities(); ++number)
    {
        const auto product = Handle(StepBasic_Product)::DownCast(model->Value(number));
        if (!product.IsNull() && !product->Name().IsNull())
            looks.products.insert(product->Name()->ToCString());
        if (model->Value(number)->IsKind(STANDARD_TYPE(StepVisual_StyledItem)))
            ++looks.coloured;
    }
    return looks;
}

} // namespace

void check_looks(const Handle(Interface_InterfaceModel) & model, const std::vector<std::string> &names)
{
    Looks looks = looks_of(model);
    for (const std::string &name : names)
    {
        const auto place = looks.products.find(name);
        if (place == looks.products.end())
            throw std::runtime_error("the file would be without the name \"" + name + "\"" + remedy);
        looks.products.erase(place);
    }
    if (const std::size_t parts = names.size() - 1; looks.coloured < parts)
        throw std::runtime_error("only " + std::to_string(looks.coloured) + " of " + std::to_string(parts) +
                                 " parts would have their colour in the file" + remedy);
}

} // namespace laminate_offset
