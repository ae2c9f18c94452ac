// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Many sampled rows of a surface reduced to their numerical rank, so that trial fits are cheap.
#pragma once

#include "least_squares.h"

#include <optional>
#include <vector>

namespace laminate_offset
{

//! Samples factored as factor * combination + remainder. Columns come in triples: the x, y, z of one
//! point. The remainder of every point is at most `remainder` long.
struct CompressedRows
{
    RowMatrix factor;      //!< samples x rank, orthogonal columns
    RowMatrix combination; //!< rank x columns
    double remainder = 0.0;
    std::vector<double> reach; //!< by rank: the longest point of that row of `combination`

    //! Longest point error, for each sample, of an error in the factor. Where a quick upper bound is
    //! already below `enough`, that bound is returned instead.
    [[nodiscard]] std::vector<double> point_errors(const RowMatrix &factor_error, double enough) const;

    //! A bound of the largest point error up to `most`; nothing if some point error is larger.
    [[nodiscard]] std::optional<double> largest_error(const RowMatrix &factor_error, double most) const;

private:
    [[nodiscard]] Eigen::VectorXd quick_bounds(const RowMatrix &factor_error) const;
    [[nodiscard]] double exact_error(const RowMatrix &factor_error, Eigen::Index row, Eigen::RowVectorXd &points) const;
};

//! Pivoted Gram-Schmidt, stopped as soon as what remains of every point is below `accuracy`.
CompressedRows compress(const RowMatrix &samples, double accuracy);

} // namespace laminate_offset
