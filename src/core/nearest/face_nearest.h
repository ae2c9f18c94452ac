// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Nearest points of one face, in its local coordinates.
#pragma once

#include "../analysis/loop_region.h"
#include "../base/result.h"
#include "analytic_nearest.h"
#include "border_search.h"

#include <optional>

namespace laminate_offset
{

//! The surface on which the points of a face lie: its own one, or the plane, cylinder, sphere or torus that an offset of
//! such a one is. Refusal at Stage::Trimming: NotSupported for other offset surfaces.
Result<Handle(Geom_Surface)> true_surface(const InputFace &input);

//! The face's parameter box (as BRepTools::UVBounds and FreeCAD's ParameterRange have it), inside the surface's own domain
//! where that has ends.
ParameterBox domain_box(const InputFace &input, const Handle(Geom_Surface) & surface);

class FaceNearest
{
public:
    //! \param trimmed only the inside of the loops counts, else the surface over domain_box().
    //! Refusal at Stage::Trimming: NotSupported for a surface that is no spline and no exact_spline().
    static Result<FaceNearest> make(const InputFace &input, bool trimmed);

    //! The nearest point, within the search's slack() or 1e-14 of the distance of the least distance, whichever is more. The
    //! distance is infinite where it is too large for a number.
    //! Precondition: the point's coordinates are finite.
    [[nodiscard]] SurfaceFoot nearest(const Eigen::Vector3d &point) const;

    [[nodiscard]] const NearestSearch &search() const { return m_search; }

private:
    struct Trim
    {
        LoopRegion region;
        BorderSearch border;
        std::vector<char> touched;

        [[nodiscard]] NearestSearch::Region rule() const;
    };

    explicit FaceNearest(NearestSearch search) : m_search(std::move(search)), m_hull(m_search.hull()) {}

    [[nodiscard]] SurfaceFoot nearest_of_near(const Eigen::Vector3d &point) const;

    NearestSearch m_search;
    Eigen::AlignedBox3d m_hull;
    std::optional<AnalyticNearest> m_form; //!< in place of the search, where there is a closed form
    std::optional<Trim> m_trim;
};

} // namespace laminate_offset
