// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Parametric images of offset trimming curves on the extended offset surface (Ravi Kumar, Shastry & Prakash 2003, 3.4).
#pragma once

#include "curve_image.h"

#include <optional>

namespace laminate_offset
{

//! One surface on which curves lie up to the tolerance of an offset. Safe to share between threads.
class EdgeImages
{
public:
    //! \param box the part of the surface that counts.
    //! \param size of the face [mm].
    //! \return nothing for a procedural surface.
    static std::optional<EdgeImages> make(const Handle(Geom_Surface) & surface, const ParameterBox &box, double size);

    //! The image of a curve, with the curve's parameter: dropped along the surface's normal and seen at samples to be
    //! within `accuracy` [mm] of the feet.
    //! \return null where the accuracy is not reached or a seam splits the image.
    [[nodiscard]] Handle(Geom2d_Curve) image(const SpaceCurve &curve, double accuracy) const;

private:
    EdgeImages(NearestSearch search, const Handle(Geom_Surface) & surface, const ParameterBox &box, double size);

    NearestSearch m_search;
    Handle(Geom_Surface) m_surface;
    ParameterBox m_box;
    double m_size;
};

} // namespace laminate_offset
