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
    //! Data reduction (Lyche & Morken 1987): where given, the curves are splines over these knots, `sample` returns
    //! their poles, and the tolerance bounds the change of every pole, which bounds the curves' everywhere.
    //! The chosen knots are some of these; the degree is theirs and `breaks` are their interior knots.
    const KnotVector *fine = nullptr;
    //! Where given, the chosen space holds the splines of `required_degree` over these interior knots.
    std::vector<Knot> required;
    int required_degree = 1;
    //! Where given, the search stays at its degree and starts from it: what a looser tolerance has led to.
    const KnotVector *start = nullptr;
    double tolerance = 1e-3; //!< longest admissible point error
    int min_degree = 1;
    int max_degree = 7;
    int max_poles = 4000;
    bool two_at_once = false; //!< try two degrees at a time, each on a thread of its own
};

//! The chosen spline space and the largest error seen at the samples.
struct KnotChoice
{
    KnotVector knots;
    double error = 0.0;
};

//! Chooses the degree and knots with the fewest poles; the middle degrees are tried first and win a tie.
//!
//! For each degree: spans that fail get a knot at the break nearest to their middle, then, when no break
//! is left inside, the full multiplicity that the data's continuity needs at their ends, then a knot
//! in the middle; afterwards knots are removed in bisected batches ranked by the smallest change of
//! the poles that lets one go (after Lyche & Morken 1987). A base with many more knots than its shape
//! needs is never fitted at full size this way. Degrees that cannot win any more are left early.
//! \return nothing when no admissible degree reaches the tolerance.
std::optional<KnotChoice> choose_knots(const KnotProblem &problem);

//! Parameters with `count` Chebyshev points inside each interval between breaks, and both ends.
std::vector<double> chebyshev_parameters(const std::vector<double> &breaks, int count);

//! Parameters inside each interval of two merged lists of breaks, and both ends: at least `per_span` in
//! every span of the knots and `per_interval` in every interval.
std::vector<double> span_parameters(const KnotVector &kv, const std::vector<double> &breaks, int per_span,
                                    int per_interval);

} // namespace laminate_offset
