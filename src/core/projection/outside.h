// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! What becomes of a curve where it leaves the surface it is put onto.
#pragma once

namespace laminate_offset
{

//! For the parts of a curve whose nearest points lie on the end of the surface.
enum class Outside
{
    Clip,  //!< they are left out
    Extend //!< the surface beyond the face's parameter box is used as far as it reaches; what lies past that is left out
};

} // namespace laminate_offset
