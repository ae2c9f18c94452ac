// SPDX-License-Identifier: LGPL-2.1-or-later
#include "strip_quadrature.h"

#include <cmath>
#include <numbers>

namespace laminate_offset
{
namespace
{

constexpr int coarse_points = 7;
constexpr int fine_points = 10;

//! The Gauss-Legendre rule, by Newton's iteration on the Legendre polynomial.
GaussRule gauss_rule(int count)
{
    GaussRule rule;
    for (int i = 0; i < count; ++i)
    {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
        double slope = 1.0;
        for (int step = 0; step < 20; ++step)
        {
            double before = 1.0;
            double here = x;
            for (int k = 2; k <= count; ++k)
                before = std::exchange(here, ((2.0 * k - 1.0) * x * here - (k - 1.0) * before) / k);
            slope = count * (x * here - before) / (x * x - 1.0);
            x -= here / slope;
        }
        rule.nodes.push_back(0.5 * (1.0 - x));
        rule.weights.push_back(1.0 / ((1.0 - x * x) * slope * slope));
    }
    return rule;
}

} // namespace

const GaussRule &coarse_rule()
{
    static const GaussRule rule = gauss_rule(coarse_points);
    return rule;
}

const GaussRule &fine_rule()
{
    static const GaussRule rule = gauss_rule(fine_points);
    return rule;
}

} // namespace laminate_offset
