// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! How the surfaces of a stack are fitted.
#pragma once

namespace laminate_offset
{

enum class StackFit
{
    Shared, //!< all are members of one family: one fit, common knots
    Each    //!< each has the fewest poles that its own distance needs, by a fit of its own; costs a fit for each
};

} // namespace laminate_offset
