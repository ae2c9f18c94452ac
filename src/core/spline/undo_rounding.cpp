// SPDX-License-Identifier: LGPL-2.1-or-later
#include "undo_rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace laminate_offset
{
namespace
{

Eigen::Vector3d point_of(const Eigen::Vector4d &pole) { return pole.head<3>() / pole.w(); }

//! Rows of poles from a side of the surface on.
class Rows
{
public:
    Rows(TensorSpline &spline, bool along_u, bool at_end) : m_poles(spline.poles), m_at_end(at_end)
    {
        const auto nu = static_cast<std::size_t>(spline.u.pole_count());
        const auto nv = static_cast<std::size_t>(spline.v.pole_count());
        m_rows = along_u ? nv : nu;
        m_count = along_u ? nu : nv;
        m_between = along_u ? 1 : nv;
        m_step = along_u ? nv : 1;
        m_degree = along_u ? spline.v.degree : spline.u.degree;
    }

    [[nodiscard]] std::size_t rows() const { return m_rows; }
    //! Of the curves that leave the side.
    [[nodiscard]] int degree() const { return m_degree; }

    //! The largest distance of a row's points from a point [mm].
    [[nodiscard]] double reach(std::size_t row, const Eigen::Vector3d &from) const
    {
        double reach = 0.0;
        for (std::size_t k = 0; k < m_count; ++k)
            reach = std::max(reach, (point_of(m_poles[index(row, k)]) - from).norm());
        return reach;
    }

    [[nodiscard]] Eigen::Vector3d first(std::size_t row) const { return point_of(m_poles[index(row, 0)]); }

    //! Moves a row's points to its first one.
    void close(std::size_t row)
    {
        const Eigen::Vector3d meant = first(row);
        for (std::size_t k = 0; k < m_count; ++k)
            m_poles[index(row, k)].head<3>() = m_poles[index(row, k)].w() * meant;
    }

private:
    [[nodiscard]] std::size_t index(std::size_t row, std::size_t k) const
    {
        return (m_at_end ? m_rows - 1 - row : row) * m_between + k * m_step;
    }

    std::vector<Eigen::Vector4d> &m_poles;
    bool m_at_end;
    std::size_t m_rows, m_count, m_between, m_step;
    int m_degree;
};

//! Closes a side that is meant to be a point, and the rows behind it that are points as well. At the part s of the way to
//! the first row with a width, that width counts with s^n for n closed rows, against which their misses turn the normal.
//! \return how far the surface, and by its normals an offset, has moved [mm].
double close_side(Rows rows, double near, double distance, double tolerance)
{
    constexpr double share = 0.01; // of the tolerance, by which the turned normals may move the offset
    std::size_t closed = 0;
    double missed = 0.0;
    for (; closed < rows.rows(); ++closed)
    {
        const double miss = rows.reach(closed, rows.first(closed));
        if (!(miss <= near))
            break;
        missed = std::max(missed, miss);
    }
    if (missed == 0.0 || closed == rows.rows())
        return 0.0;
    const double width = rows.reach(closed, rows.first(closed));
    const double length = rows.degree() * rows.reach(closed, rows.first(0));
    const double part = std::min(1.0, tolerance / length); // of the way, from which on all is as it is meant
    const double turned = 4.0 * missed * std::abs(distance) / (width * std::pow(part, static_cast<double>(closed)));
    if (!(turned <= share * tolerance))
        return 0.0;
    for (std::size_t row = 0; row < closed; ++row)
        rows.close(row);
    return missed + turned;
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
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    constexpr double division = 2.0; // roundings of a pole
    const double share = 2.0 * std::sqrt(3.0) * difference + division * epsilon;
    return {share * extent, 2.0 * share / epsilon};
}

} // namespace

double largest_coordinate(const TensorSpline &spline)
{
    double largest = 0.0;
    for (const Eigen::Vector4d &pole : spline.poles)
        largest = std::max(largest, point_of(pole).cwiseAbs().maxCoeff());
    return largest;
}

UndoneRounding undo_rounding(TensorSpline &spline, double distance, double tolerance)
{
    const double extent = largest_coordinate(spline);
    UndoneRounding undone = even_weights(spline, extent);
    for (const bool along_u : {true, false})
        for (const bool at_end : {false, true})
            undone.moved += close_side({spline, along_u, at_end}, meant_as_point * extent, distance, tolerance);
    return undone;
}

} // namespace laminate_offset
