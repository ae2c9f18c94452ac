// SPDX-License-Identifier: LGPL-2.1-or-later
#include "extension_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace laminate_offset
{
namespace
{

bool same_text(std::string_view a, std::string_view b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

template <typename Value, std::size_t count>
std::optional<Value> named(std::string_view text, const std::array<Value, count> &values)
{
    for (const Value value : values)
        if (same_text(text, name(value)))
            return value;
    return std::nullopt;
}

} // namespace

std::string_view name(Side side)
{
    constexpr std::array<std::string_view, 4> names{"u-min", "u-max", "v-min", "v-max"};
    return names[static_cast<std::size_t>(side)];
}

std::string_view name(Continuity continuity) { return continuity == Continuity::G1 ? "G1" : "natural"; }
std::string_view name(LengthRule rule) { return rule == LengthRule::Mean ? "mean" : "at-least"; }

std::optional<Side> side_named(std::string_view text) { return named(text, all_sides); }

std::optional<Continuity> continuity_named(std::string_view text)
{
    return named(text, std::array{Continuity::G1, Continuity::Natural});
}

std::optional<LengthRule> length_rule_named(std::string_view text)
{
    return named(text, std::array{LengthRule::Mean, LengthRule::AtLeast});
}

Result<bool> check(const ExtensionOptions &options)
{
    const auto refusal = [](std::string message) {
        return Failure{Status::InvalidOption, Stage::Options, std::move(message), std::nullopt, std::nullopt};
    };
    if (!std::isfinite(options.length) || options.length <= 0.0)
        return refusal(fmt::format("The length {} mm of the extension must be finite and above zero.", options.length));
    if (options.sides.empty())
        return refusal("No side to extend was given; name at least one of u-min, u-max, v-min and v-max.");
    return true;
}

} // namespace laminate_offset
