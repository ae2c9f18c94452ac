// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Integrals of curvature and position over a trimmed face: all that areas, volumes and centres of gravity between
//! any two of its offsets need. One quadrature serves a whole stack, without a mesh.
#pragma once

#include "../base/result.h"
#include "../input/input_face.h"

#include <gp_XYZ.hxx>

#include <array>

namespace laminate_offset
{

//! Integrals over a face, where it stands. N is its outward normal; mean curvature H and Gaussian curvature K are those
//! of the signed distance t along N: the point S + t N has the area element (1 - 2 H t + K t^2) dA, so that H is negative
//! on a sphere seen from outside. Distances are signed along N [mm], inside the face's feasible range.
struct FaceIntegrals
{
    double area = 0.0;               //!< of 1 [mm^2]
    double mean_curvature = 0.0;     //!< of H [mm]
    double gaussian_curvature = 0.0; //!< of K, without a unit
    std::array<gp_XYZ, 3> position;  //!< of S, S H and S K
    std::array<gp_XYZ, 3> normal;    //!< of N, N H and N K
    //! Estimated error of the worst of them, relative to the integral of its size: the difference of two Gauss rules,
    //! which is that of the coarser one. Not a proven bound.
    double relative_error = 0.0;

    //! Of the offset at a distance [mm^2].
    [[nodiscard]] double area_at(double distance) const;
    //! Between two offsets [mm^3]; negative where low > high.
    [[nodiscard]] double volume(double low, double high) const;
    //! Integral of the position over that volume [mm^4]; divided by the volume it is the centre of gravity.
    [[nodiscard]] gp_XYZ first_moment(double low, double high) const;
};

//! Integrates over the inside of the pcurves. The area integral becomes one over rectangles between knots and over the
//! strips between a knot line and a piece of a pcurve (Green's theorem), each by Gauss rules of 7 x 7 and 10 x 10
//! points, quartered until both agree to 1e-10. Works on all cores; the sum does not depend on their number.
FaceIntegrals integrate_face(const InputFace &input);

} // namespace laminate_offset
