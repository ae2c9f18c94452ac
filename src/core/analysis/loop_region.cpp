// SPDX-License-Identifier: LGPL-2.1-or-later
#include "loop_region.h"

#include <Precision.hxx>

namespace laminate_offset
{

LoopRegion::LoopRegion(const InputFace &input) : m_classifier(input.face, Precision::PConfusion()) {}

bool LoopRegion::contains(const gp_Pnt2d &uv) const { return m_classifier.Perform(uv) != TopAbs_OUT; }

} // namespace laminate_offset
