// SPDX-License-Identifier: LGPL-2.1-or-later
#include "crease_kind.h"

namespace laminate_offset
{

std::string_view name(CreaseKind kind)
{
    switch (kind)
    {
    case CreaseKind::Gap: return "gap";
    case CreaseKind::Overlap: return "overlap";
    case CreaseKind::Both: break;
    }
    return "both";
}

} // namespace laminate_offset
