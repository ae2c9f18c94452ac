// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Samples of the exact offset for the fit.
#pragma once

#include "../analysis/base_surface.h"
#include "../spline/least_squares.h"

#include <mutex>
#include <optional>
#include <vector>

namespace laminate_offset
{

//! What stands below the fitted numerators.
enum class Denominator
{
    One,
    BaseWeight //!< the rational base's own weight function
};

//! Samples numerators of S + d N at one distance or more, relative to a point near the face, so that rounding scales
//! with the face and not with its distance from the origin. Safe to share between threads.
class OffsetSampler
{
public:
    //! \param distances d [mm], at least one.
    //! \param denominator BaseWeight only for a base that is a rational spline.
    OffsetSampler(const BaseSurface &base, std::vector<double> distances, Denominator denominator);

    //! One row for each u, the numerators of all v in it; transposed: one row for each v. Where there is no normal
    //! they are left at zero, and the place is kept.
    //! \param distance any, also one that is not among distances().
    RowMatrix rows(double distance, const std::vector<double> &us, const std::vector<double> &vs, bool transposed);

    //! The rows of all distances side by side, so that knots which serve them serve every distance.
    RowMatrix joined_rows(const std::vector<double> &us, const std::vector<double> &vs, bool transposed);

    //! The weight function on the same grid, each value the first of a triple: one row for each u.
    [[nodiscard]] RowMatrix weight_rows(const std::vector<double> &us, const std::vector<double> &vs) const;

    [[nodiscard]] const BaseSurface &base() const { return m_base; }
    [[nodiscard]] const std::vector<double> &distances() const { return m_distances; }
    [[nodiscard]] Denominator denominator() const { return m_denominator; }
    [[nodiscard]] const std::optional<gp_Pnt2d> &singular() const { return m_singular; }
    [[nodiscard]] const Eigen::Vector3d &origin() const { return m_origin; }

private:
    [[nodiscard]] std::vector<double> weights(const std::vector<double> &us, const std::vector<double> &vs) const;
    void keep(const gp_Pnt2d &singular);

    const BaseSurface &m_base;
    std::vector<double> m_distances;
    Denominator m_denominator;
    Eigen::Vector3d m_origin;
    std::mutex m_guard;
    std::optional<gp_Pnt2d> m_singular;
};

} // namespace laminate_offset
