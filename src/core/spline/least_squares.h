// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! End-interpolating least squares in a B-spline space, by banded Cholesky.
#pragma once

#include "knot_vector.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace laminate_offset
{

//! Row-major, so that one sample (or one pole) of all columns lies together.
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

//! Points on a grid, one row of points for each row, as one row for each column.
RowMatrix transposed_points(const RowMatrix &points);

//! The factorised normal equations of one spline space and one set of sample parameters. The first
//! and the last sample must lie at the ends of the knot vector and are interpolated.
class LeastSquaresFit
{
public:
    //! \return nothing when the samples do not determine the poles (Schoenberg-Whitney).
    static std::optional<LeastSquaresFit> make(const KnotVector &kv, const std::vector<double> &parameters);

    //! Of data that is given by poles over finer knots: "samples" are those poles, residuals their changes.
    static std::optional<LeastSquaresFit> make_reduction(const KnotVector &coarse, const KnotVector &fine);

    //! Poles (pole_count x columns) that fit `samples` (parameters x columns).
    [[nodiscard]] RowMatrix solve(const RowMatrix &samples) const;

    //! samples - spline(poles) at the parameters.
    [[nodiscard]] RowMatrix residual(const RowMatrix &poles, const RowMatrix &samples) const;

    [[nodiscard]] const BasisRows &basis() const { return m_basis; }

private:
    LeastSquaresFit(int poles, BasisRows basis);
    bool factorise();
    void substitute(RowMatrix &poles) const;

    int m_poles = 0;
    BasisRows m_basis;
    std::vector<double> m_band; //!< lower Cholesky factor of the inner poles, row by row, diagonal first
};

} // namespace laminate_offset
