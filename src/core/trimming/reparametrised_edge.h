// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Edges of an offset surface that has parameters of its own (Method::RaviKumar): the curve in space is the offset of the
//! trimming curve, made from the base alone, and the pcurve is its image on the offset surface.
#pragma once

#include "trim_loops.h"

namespace laminate_offset
{

//! Serves all edges of one face.
class ReparametrisedEdges
{
public:
    //! \param context with a parameter map.
    //! \param form of the offset surface.
    ReparametrisedEdges(const EdgeContext &context, const AnalyticSurface *form);

    //! Refusal: EdgeToleranceNotReached.
    [[nodiscard]] Result<OffsetEdge> make(const TrimmingCurve &base) const;

    //! Adds the pcurve on the other side of a seam; the edge's deviations hold for both.
    //! Refusal: EdgeToleranceNotReached.
    [[nodiscard]] Result<bool> add_second_side(const TrimmingCurve &base, OffsetEdge &edge) const;

private:
    [[nodiscard]] CurveOnSurface on_base(const TrimmingCurve &base) const;
    [[nodiscard]] Handle(Geom2d_Curve) image(const TrimmingCurve &base) const;
    [[nodiscard]] Failure refusal(const TrimmingCurve &base) const;
    //! An edge that is a point on the base.
    [[nodiscard]] Result<OffsetEdge> make_degenerated(const TrimmingCurve &base, OffsetEdge edge) const;

    const EdgeContext &m_context;
    const AnalyticSurface *m_form;
    Handle(Geom_Surface) m_base;
    std::optional<AnalyticSurface> m_base_form;
};

} // namespace laminate_offset
