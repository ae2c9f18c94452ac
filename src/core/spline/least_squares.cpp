// SPDX-License-Identifier: LGPL-2.1-or-later
#include "least_squares.h"

#include "vector_kernels.h"

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

// Below this pivot, relative to the largest, a pole is not determined by the samples.
constexpr double smallest_pivot = 1e-13;

} // namespace

RowMatrix transposed_points(const RowMatrix &points)
{
    RowMatrix result(points.cols() / 3, 3 * points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        for (Eigen::Index j = 0; j < result.rows(); ++j)
            result.row(j).segment<3>(3 * i) = points.row(i).segment<3>(3 * j);
    return result;
}

LeastSquaresFit::LeastSquaresFit(int poles, BasisRows basis) : m_poles(poles), m_basis(std::move(basis)) {}

std::optional<LeastSquaresFit> LeastSquaresFit::make(const KnotVector &kv, const std::vector<double> &parameters)
{
    if (static_cast<int>(parameters.size()) < kv.pole_count())
        return std::nullopt;
    LeastSquaresFit fit(kv.pole_count(), BasisRows(kv, parameters));
    if (!fit.factorise())
        return std::nullopt;
    return fit;
}

std::optional<LeastSquaresFit> LeastSquaresFit::make_reduction(const KnotVector &coarse, const KnotVector &fine)
{
    LeastSquaresFit fit(coarse.pole_count(), BasisRows::insertion(coarse, fine));
    if (!fit.factorise())
        return std::nullopt;
    return fit;
}

bool LeastSquaresFit::factorise()
{
    const int inner = std::max(0, m_poles - 2);
    const int width = m_basis.width();
    m_band.assign(static_cast<std::size_t>(inner) * width, 0.0);
    const auto at = [&](int row, int column) -> double & {
        return m_band[static_cast<std::size_t>(row) * width + (row - column)];
    };
    for (int r = 0; r < m_basis.rows(); ++r)
    {
        const double *n = m_basis.row(r);
        const int first = m_basis.first(r) - 1;
        for (int i = std::max(0, -first); i < width && first + i < inner; ++i)
            for (int j = std::max(0, -first); j <= i; ++j)
                at(first + i, first + j) += n[i] * n[j];
    }
    double largest = 0.0;
    for (int i = 0; i < inner; ++i)
        largest = std::max(largest, at(i, i));
    for (int i = 0; i < inner; ++i)
        for (int j = std::max(0, i - width + 1); j <= i; ++j)
        {
            double sum = at(i, j);
            for (int k = std::max(0, i - width + 1); k < j; ++k)
                sum -= at(i, k) * at(j, k);
            if (i != j)
                at(i, j) = sum / at(j, j);
            else if (sum > smallest_pivot * largest)
                at(i, i) = std::sqrt(sum);
            else
                return false;
        }
    return true;
}

RowMatrix LeastSquaresFit::solve(const RowMatrix &samples) const
{
    const int width = m_basis.width();
    const int columns = static_cast<int>(samples.cols());
    const Eigen::Index last = samples.rows() - 1;
    RowMatrix poles = RowMatrix::Zero(m_poles, columns);
    Eigen::RowVectorXd target(columns);
    for (int r = 0; r < m_basis.rows(); ++r)
    {
        const double *n = m_basis.row(r);
        const int first = m_basis.first(r);
        target = samples.row(r);
        if (first == 0)
            target -= n[0] * samples.row(0);
        if (first + width == m_poles)
            target -= n[width - 1] * samples.row(last);
        add_outer_product(n, width, target.data(), poles.row(first).data(), columns);
    }
    substitute(poles);
    poles.row(0) = samples.row(0);
    poles.row(m_poles - 1) = samples.row(last);
    return poles;
}

//! Forward and backward substitution; the rows of the end poles are left alone.
void LeastSquaresFit::substitute(RowMatrix &poles) const
{
    const int inner = std::max(0, m_poles - 2);
    const int width = m_basis.width();
    const int columns = static_cast<int>(poles.cols());
    const auto factor = [&](int row, int column) {
        return m_band[static_cast<std::size_t>(row) * width + (row - column)];
    };
    for (int i = 0; i < inner; ++i)
    {
        for (int k = std::max(0, i - width + 1); k < i; ++k)
            add_multiple(-factor(i, k), poles.row(k + 1).data(), poles.row(i + 1).data(), columns);
        poles.row(i + 1) /= factor(i, i);
    }
    for (int i = inner - 1; i >= 0; --i)
    {
        for (int k = i + 1; k < std::min(inner, i + width); ++k)
            add_multiple(-factor(k, i), poles.row(k + 1).data(), poles.row(i + 1).data(), columns);
        poles.row(i + 1) /= factor(i, i);
    }
}

RowMatrix LeastSquaresFit::residual(const RowMatrix &poles, const RowMatrix &samples) const
{
    RowMatrix result = samples;
    for (int r = 0; r < m_basis.rows(); ++r)
        subtract_combination(m_basis.row(r), m_basis.width(), poles.row(m_basis.first(r)).data(), result.row(r).data(),
                             static_cast<int>(result.cols()));
    return result;
}

} // namespace laminate_offset
