// SPDX-License-Identifier: LGPL-2.1-or-later
#include "undo_rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace laminate_offset
{
namespace
{

Eigen::Vector3d point_of(const Eigen::Vector4d &pole) { return pole.head<3>() / pole.w(); }

//! Makes every step-th pole from the first on one point, where they miss it by no more than \p near.
//! \return how far they have moved [mm], nothing where they miss it by more.
std::optional<double> close_row(std::vector<Eigen::Vector4d> &poles, std::size_t first, std::size_t step,
                                std::size_t count, double near)
{
    const Eigen::Vector3d meant = point_of(poles[first]);
    double moved = 0.0;
    for (std::size_t k = 0; k < count; ++k)
        moved = std::max(moved, (point_of(poles[first + k * step]) - meant).norm());
    if (!(moved <= near))
        return std::nullopt;
    for (std::size_t k = 0; k < count; ++k)
        poles[first + k * step].head<3>() = poles[first + k * step].w() * meant;
    return moved;
}

//! Closes a side that is meant to be a point, and the rows behind it that are points as well: the surface runs out into a
//! cusp there. \return how far the surface has moved [mm].
double close_side(TensorSpline &spline, bool along_u, bool at_end, double near)
{
    const std::size_t nu = spline.u.pole_count();
    const std::size_t nv = spline.v.pole_count();
    const std::size_t rows = along_u ? nv : nu;
    const std::size_t between = along_u ? 1 : nv;
    const std::size_t step = along_u ? nv : 1;
    double moved = 0.0;
    for (std::size_t k = 0; k < rows; ++k)
    {
        const std::optional<double> here =
            close_row(spline.poles, (at_end ? rows - 1 - k : k) * between, step, along_u ? nu : nv, near);
        if (!here)
            break;
        moved = std::max(moved, *here);
    }
    return moved;
}

double close_sides(TensorSpline &spline, double near)
{
    double moved = 0.0;
    for (const bool along_u : {true, false})
        for (const bool at_end : {false, true})
            moved += close_side(spline, along_u, at_end, near);
    return moved;
}

//! With P the points and w (1 + e) the weights, S - S* = sum e_ij B_ij (P_ij - S*) / (1 + sum e_ij B_ij), whose size is at most
//! that of the largest e times that of the net, and whose derivatives are bounded like those of a net so far off.
UndoneRounding even_weights(TensorSpline &spline, double extent)
{
    const auto by_weight = [](const Eigen::Vector4d &a, const Eigen::Vector4d &b) { return a.w() < b.w(); };
    const auto [low, high] = std::minmax_element(spline.poles.begin(), spline.poles.end(), by_weight);
    const double difference = high->w() / low->w() - 1.0;
    if (!spline.rational || !(difference <= one_weight))
        return {};
    for (Eigen::Vector4d &pole : spline.poles)
        pole << point_of(pole), 1.0;
    spline.rational = false;
    // the net is no longer than twice its largest coordinates' diagonal, in each of the two terms of a derivative
    const double share = 2.0 * std::sqrt(3.0) * difference;
    return {share * extent, 2.0 * share / std::numeric_limits<double>::epsilon()};
}

} // namespace

UndoneRounding undo_rounding(TensorSpline &spline)
{
    double extent = 0.0;
    for (const Eigen::Vector4d &pole : spline.poles)
        extent = std::max(extent, point_of(pole).cwiseAbs().maxCoeff());
    UndoneRounding undone = even_weights(spline, extent);
    undone.moved += close_sides(spline, meant_as_point * extent);
    return undone;
}

} // namespace laminate_offset
