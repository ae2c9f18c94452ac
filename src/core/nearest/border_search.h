// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The nearest point of a face's trimming loops, taken as curves on the surface.
//!
//! The curves are cut into short parts, each within `sag` of its chord; the sag is the largest one seen at samples,
//! doubled. Parts whose chord is too far are passed over, in the others the distance is minimised.
#pragma once

#include "nearest_search.h"

namespace laminate_offset
{

class BorderSearch
{
public:
    BorderSearch(const InputFace &input, const Handle(Geom_Surface) & surface);

    //! Infinitely far where the face has no loops.
    [[nodiscard]] SurfaceFoot nearest(const Eigen::Vector3d &point) const;

private:
    struct Curve
    {
        Handle(Geom2d_Curve) pcurve;
        double first = 0.0;
        double last = 0.0;
    };
    struct Chord
    {
        std::size_t curve = 0;
        double low = 0.0;
        double high = 0.0;
        Eigen::Vector3d start;
        Eigen::Vector3d end;
        double sag = 0.0;
    };
    struct Node
    {
        Eigen::AlignedBox3d hull;
        std::size_t first = 0; //!< chords
        std::size_t last = 0;
        int lower = -1; //!< children; -1 where there are none
        int upper = -1;
    };

    void cut(std::size_t curve, double low, double high, double admissible, int depth);
    int build(std::size_t first, std::size_t last);
    [[nodiscard]] Eigen::Vector3d value(std::size_t curve, double t) const;
    void try_chord(const Chord &chord, const Eigen::Vector3d &point, SurfaceFoot &best) const;

    Handle(Geom_Surface) m_surface;
    std::vector<Curve> m_curves;
    std::vector<Chord> m_chords;
    std::vector<Node> m_nodes;
};

} // namespace laminate_offset
