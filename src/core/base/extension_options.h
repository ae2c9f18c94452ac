// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! What a caller of an extension may ask for. Every option states its unit, range, default and cost.
#pragma once

#include "result.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace laminate_offset
{

//! A side of the rectangle of parameters that holds the face.
enum class Side
{
    UMin,
    UMax,
    VMin,
    VMax
};

inline constexpr std::array<Side, 4> all_sides{Side::UMin, Side::UMax, Side::VMin, Side::VMax};

//! How an extension goes on past the join. Planes, cylinders, cones, spheres, tori and swept surfaces go on as
//! themselves in both cases, wherever their own parameters do.
enum class Continuity
{
    G1,     //!< mirror image of the part next to the join: tangents are continuous, curvature as a rule too (default)
    Natural //!< the last polynomial piece goes on: every derivative is continuous
};

//! What the length of an extension is, measured on eight iso-curves.
enum class LengthRule
{
    Mean,   //!< their mean length is the length asked for (the paper's rule, default)
    AtLeast //!< the shortest of them has the length asked for
};

//! Stable identifiers: "u-min", "u-max", "v-min", "v-max"; "G1", "natural"; "mean", "at-least".
std::string_view name(Side side);
std::string_view name(Continuity continuity);
std::string_view name(LengthRule rule);

//! The value of an identifier, letter case ignored; nothing for any other text.
std::optional<Side> side_named(std::string_view text);
std::optional<Continuity> continuity_named(std::string_view text);
std::optional<LengthRule> length_rule_named(std::string_view text);

struct ExtensionOptions
{
    //! Arc length [mm] of the extension past each side. Range: > 0. No default. Past the length of the face itself,
    //! a G1 extension costs twice the poles for every doubling.
    double length = 0.0;

    //! Sides to extend, in the face's parameters. Default: all four. At least one.
    std::vector<Side> sides{all_sides.begin(), all_sides.end()};

    //! Default G1. A G1 extension adds poles; a natural one does not, but swings out with the surface's derivatives.
    Continuity continuity = Continuity::G1;

    //! Default Mean.
    LengthRule rule = LengthRule::Mean;
};

//! Checks the ranges above. \return Ok value true, or a Failure at Stage::Options.
Result<bool> check(const ExtensionOptions &options);

} // namespace laminate_offset
