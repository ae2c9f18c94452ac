// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! A spline surface that carries more knots than its shape needs, with as many of them taken out as a tolerance
//! allows (data reduction by knot removal, Lyche & Morken 1987).
#pragma once

#include "least_squares.h"
#include "tensor_spline.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace laminate_offset
{

struct ReducedSpline
{
    TensorSpline spline; //!< over some of the original knots, of the same degree
    //! Original minus reduced surface as poles over the original knots, in their order: exact up to rounding.
    std::vector<Eigen::Vector3d> change;
    double rounding = 0.0; //!< bound of the rounding of each coordinate of `change`
    double largest = 0.0;  //!< length of the longest change, its rounding included: nowhere do the two differ by more
};

//! Reduces one spline to several tolerances. The knots are chosen on some of the curves of its net; where the change
//! of all its poles then shows that these do not speak for the others, on all.
class DataReduction
{
public:
    //! \param spline has to outlive this.
    //! \param worthwhile largest part of the spans that may stay: with more the reduction is not worth its error.
    explicit DataReduction(const TensorSpline &spline, double worthwhile = 0.6);

    //! \param tolerance [mm] that no change of a pole may exceed.
    //! \param looser what a looser tolerance has led to: the search starts from its knots.
    //! \return nothing for a rational surface, or where fewer knots do not suffice.
    [[nodiscard]] std::optional<ReducedSpline> within(double tolerance, const ReducedSpline *looser = nullptr) const;

private:
    [[nodiscard]] std::optional<ReducedSpline> attempt(double tolerance, bool all_curves,
                                                       const ReducedSpline *looser) const;
    [[nodiscard]] std::optional<ReducedSpline> over(const KnotVector &u, const KnotVector &v) const;

    const TensorSpline &m_spline;
    double m_worthwhile;
    Eigen::Vector3d m_origin = Eigen::Vector3d::Zero();
    RowMatrix m_by_u; //!< poles relative to the origin: one row for each u pole, the points of all v poles in it
    RowMatrix m_by_v;
    double m_rounding = 0.0;
};

//! The same for one tolerance.
std::optional<ReducedSpline> reduced(const TensorSpline &spline, double tolerance, double worthwhile = 0.6);

} // namespace laminate_offset
