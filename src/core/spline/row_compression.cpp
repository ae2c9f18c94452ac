// SPDX-License-Identifier: LGPL-2.1-or-later
#include "row_compression.h"

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

double longest_point(const RowMatrix &rows)
{
    double longest = 0.0;
    for (Eigen::Index r = 0; r < rows.rows(); ++r)
        for (Eigen::Index c = 0; c + 2 < rows.cols(); c += 3)
            longest = std::max(longest, rows.row(r).segment<3>(c).squaredNorm());
    return std::sqrt(longest);
}

} // namespace

std::vector<double> CompressedRows::point_errors(const RowMatrix &factor_error, double enough) const
{
    std::vector<double> errors(static_cast<std::size_t>(factor_error.rows()));
    Eigen::RowVectorXd point_row(combination.cols());
    const Eigen::Map<const Eigen::VectorXd> reaches(reach.data(), static_cast<Eigen::Index>(reach.size()));
    for (Eigen::Index r = 0; r < factor_error.rows(); ++r)
    {
        double &error = errors[static_cast<std::size_t>(r)];
        error = factor_error.row(r).cwiseAbs().dot(reaches.transpose()) + remainder;
        if (error <= enough)
            continue;
        point_row.noalias() = factor_error.row(r) * combination;
        double longest = 0.0;
        for (Eigen::Index c = 0; c + 2 < point_row.size(); c += 3)
            longest = std::max(longest, point_row.segment<3>(c).squaredNorm());
        error = std::sqrt(longest) + remainder;
    }
    return errors;
}

CompressedRows compress(const RowMatrix &samples, double accuracy)
{
    const Eigen::Index rank_limit = std::min(samples.rows(), samples.cols());
    Eigen::MatrixXd remaining = samples; // column-major: the work goes column by column
    std::vector<Eigen::VectorXd> directions;
    std::vector<Eigen::RowVectorXd> combinations;
    Eigen::VectorXd weights = remaining.colwise().squaredNorm().transpose();
    CompressedRows result;
    while (static_cast<Eigen::Index>(directions.size()) < rank_limit)
    {
        Eigen::Index pivot = 0;
        // a point is three columns and at most all samples: stop when no column can hold more than the accuracy
        if (weights.maxCoeff(&pivot) <= accuracy * accuracy / 3.0)
            break;
        const Eigen::VectorXd direction = remaining.col(pivot).normalized();
        const Eigen::RowVectorXd row = direction.transpose() * remaining;
        remaining.noalias() -= direction * row;
        weights = remaining.colwise().squaredNorm().transpose();
        directions.push_back(direction);
        combinations.push_back(row);
    }
    const Eigen::Index rank = static_cast<Eigen::Index>(directions.size());
    result.factor.resize(samples.rows(), rank);
    result.combination.resize(rank, samples.cols());
    for (Eigen::Index k = 0; k < rank; ++k)
    {
        result.factor.col(k) = directions[static_cast<std::size_t>(k)];
        result.combination.row(k) = combinations[static_cast<std::size_t>(k)];
        result.reach.push_back(longest_point(result.combination.row(k)));
    }
    result.remainder = longest_point(remaining);
    return result;
}

} // namespace laminate_offset
