// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Degree and knots of one parameter direction, with as few poles as the tolerance allows.
#pragma once

#include "least_squares.h"

#include <functional>
#include <optional>
#include <vector>

namespace laminate_offset
{

//! A parameter at which the data is only C^continuity.
struct DataBreak
{
    double parameter = 0.0;
    int continuity = 0;
};

//! Points on many curves with one common parameter, all to be fitted on the same knots.
struct KnotProblem
{
    double low = 0.0;
    double high = 1.0;
    std::vector<DataBreak> breaks; //!< interior, increasing
    //! Values at increasing parameters: one row a parameter, columns in triples (x, y, z of a curve).
    std::function<RowMatrix(const std::vector<double> &)> sample;
    double tolerance = 1e-3; //!< longest admissible point error
    int min_degree = 3;
    int max_degree = 7;
    int max_poles = 4000;
};

//! The chosen spline space and the largest error seen at the samples.
struct KnotChoice
{
    KnotVector knots;
    double error = 0.0;
};

//! Chooses the degree and knots with the fewest poles (the lower error on a tie).
//!
//! For each degree: start from the breaks at the multiplicity that the data's continuity needs, halve
//! the spans that fail, then remove knots in bisected batches ranked by the smallest change of the
//! poles that removes one (after Lyche & Morken 1987).
//! \return nothing when no admissible degree reaches the tolerance.
std::optional<KnotChoice> choose_knots(const KnotProblem &problem);

//! Parameters with `count` Chebyshev points inside each interval between breaks, and both ends.
std::vector<double> chebyshev_parameters(const std::vector<double> &breaks, int count);

} // namespace laminate_offset
