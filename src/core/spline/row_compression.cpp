// SPDX-License-Identifier: LGPL-2.1-or-later
#include "row_compression.h"

#include "vector_kernels.h"

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

Eigen::VectorXd CompressedRows::quick_bounds(const RowMatrix &factor_error) const
{
    const Eigen::Map<const Eigen::VectorXd> reaches(reach.data(), static_cast<Eigen::Index>(reach.size()));
    return (factor_error.cwiseAbs() * reaches).array() + remainder;
}

double CompressedRows::exact_error(const RowMatrix &factor_error, Eigen::Index row, Eigen::RowVectorXd &points) const
{
    points.setZero(combination.cols()); // the error's sign does not matter
    subtract_combination(factor_error.row(row).data(), static_cast<int>(factor_error.cols()), combination.data(),
                         points.data(), static_cast<int>(points.size()));
    double longest = 0.0;
    for (Eigen::Index c = 0; c + 2 < points.size(); c += 3)
        longest = std::max(longest, points.segment<3>(c).squaredNorm());
    return std::sqrt(longest) + remainder;
}

std::vector<double> CompressedRows::point_errors(const RowMatrix &factor_error, double enough) const
{
    const Eigen::VectorXd quick = quick_bounds(factor_error);
    std::vector<double> errors(quick.begin(), quick.end());
    Eigen::RowVectorXd points;
    for (Eigen::Index r = 0; r < factor_error.rows(); ++r)
        if (double &error = errors[static_cast<std::size_t>(r)]; error > enough)
            error = exact_error(factor_error, r, points);
    return errors;
}

std::optional<double> CompressedRows::largest_error(const RowMatrix &factor_error, double most) const
{
    // the row that looks worst first: it settles most refusals
    Eigen::VectorXd quick = quick_bounds(factor_error);
    Eigen::RowVectorXd points;
    double largest = 0.0;
    Eigen::Index worst = 0;
    while (quick.maxCoeff(&worst) > most)
    {
        const double error = exact_error(factor_error, worst, points);
        if (error > most)
            return std::nullopt;
        largest = std::max(largest, error);
        quick[worst] = 0.0;
    }
    return std::max(largest, quick[worst]);
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
        for (Eigen::Index c = 0; c < remaining.cols(); ++c)
        {
            add_multiple(-row[c], direction.data(), remaining.col(c).data(), static_cast<int>(remaining.rows()));
            weights[c] = remaining.col(c).squaredNorm();
        }
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
