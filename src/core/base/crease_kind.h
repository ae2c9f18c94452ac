// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! What becomes of a crease of the base in its offset.
#pragma once

#include <string_view>

namespace laminate_offset
{

enum class CreaseKind
{
    Gap,     //!< the two sides move apart and leave a gap
    Overlap, //!< the two sides cross each other
    Both     //!< some creases, or parts of one, do the one and some the other
};

//! Stable identifier: "gap", "overlap" or "both".
std::string_view name(CreaseKind kind);

} // namespace laminate_offset
