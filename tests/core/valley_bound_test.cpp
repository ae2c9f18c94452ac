// SPDX-License-Identifier: LGPL-2.1-or-later
// The bound along a valley against dense samples: nothing below zero is passed, and a valley needs few parts.
#include "support/random_cases.h"

#include <laminate_offset/nearest/valley_bound.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace laminate_offset;
using test_support::RandomCases;

namespace
{

//! The polynomial with these coefficients.
Bernstein polynomial(int m, int n, const std::vector<double> &coefficients)
{
    Bernstein result(m, n);
    for (int i = 0; i <= m; ++i)
        for (int j = 0; j <= n; ++j)
            result.set_coefficient(i, j, coefficients[static_cast<std::size_t>(i * (n + 1) + j)]);
    return result;
}

double value(const Bernstein &h, double u, double v)
{
    double sum = 0.0;
    for (int i = 0; i <= h.degree_u(); ++i)
    {
        double row = 0.0;
        for (int j = 0; j <= h.degree_v(); ++j)
            row += h.scaled(i, j) * std::pow(v, j) * std::pow(1.0 - v, h.degree_v() - j);
        sum += row * std::pow(u, i) * std::pow(1.0 - u, h.degree_u() - i);
    }
    return sum;
}

Bernstein transposed(const Bernstein &h)
{
    Bernstein result(h.degree_v(), h.degree_u());
    for (int i = 0; i <= h.degree_u(); ++i)
        for (int j = 0; j <= h.degree_v(); ++j)
            result.scaled(j, i) = h.scaled(i, j);
    return result;
}

//! (v - a(u))^2 c(u, v) with a a parabola of the given bend and c > 0, plus `along` times a polynomial in u.
Bernstein valley(RandomCases &random, double bend, double variation, double along)
{
    const double start = random.uniform(-0.2, 1.2);
    const double end = random.uniform(-0.2, 1.2);
    const double middle = 0.5 * (start + end) + bend;
    const Bernstein q = polynomial(2, 1, {-start, 1.0 - start, -middle, 1.0 - middle, -end, 1.0 - end});
    std::vector<double> factors;
    for (int k = 0; k < 4; ++k)
        factors.push_back(1.0 + variation * random.uniform(-0.5, 0.5));
    Bernstein square;
    assign_product(q, q, square);
    Bernstein h;
    assign_product(square, polynomial(1, 1, factors), h);
    std::vector<double> rest;
    for (int k = 0; k < 4; ++k)
        rest.push_back(along * random.uniform(-1.0, 1.0));
    h.add_raised(1.0, polynomial(3, 0, rest));
    return h;
}

double least_sample(const Bernstein &h)
{
    constexpr int grid = 100;
    double least = value(h, 0.0, 0.0);
    for (int i = 0; i <= grid; ++i)
        for (int j = 0; j <= grid; ++j)
            least = std::min(least, value(h, static_cast<double>(i) / grid, static_cast<double>(j) / grid));
    return least;
}

//! Lower bound of h_vv by its coefficients.
double curvature_of(const Bernstein &h)
{
    Bernstein slope, second;
    slope.assign_derivative_v(h);
    second.assign_derivative_v(slope);
    return second.range().low;
}

//! Parts along u until all are proven to lie above -slack.
int parts_needed(Bernstein h, double slack, int depth)
{
    const double curvature = curvature_of(h);
    if (depth > 16 || (curvature > 0.0 && valley_is_above(h, slack, true, curvature)))
        return 1;
    Bernstein upper;
    h.halve(true, upper);
    return parts_needed(h, slack, depth + 1) + parts_needed(upper, slack, depth + 1);
}

} // namespace

TEST(ValleyBound, NothingBelowZeroIsPassed)
{
    RandomCases random;
    int proven = 0, tight = 0;
    for (int round = 0; round < 400; ++round)
    {
        const double bend = random.uniform(-0.3, 0.3);
        const Bernstein h = valley(random, bend, random.uniform(0.0, 1.0), random.magnitude(1e-9, 1e-1));
        const double curvature = curvature_of(h);
        if (!(curvature > 0.0))
            continue;
        const double least = least_sample(h);
        for (const double room : {-1e-2, -1e-5, -1e-9, 1e-6, 1e-3, 1e-1})
        {
            const bool above = valley_is_above(h, room - least, true, curvature);
            EXPECT_EQ(above, valley_is_above(transposed(h), room - least, false, curvature));
            EXPECT_FALSE(above && room < 0.0) << round << ' ' << room;
            proven += above ? 1 : 0;
            tight += above && room <= 1e-3 ? 1 : 0;
        }
    }
    EXPECT_GT(proven, 200);
    EXPECT_GT(tight, 50);
}

//! Coefficients alone would need parts of the square root of the slack, 3e5 of them.
TEST(ValleyBound, AValleyIsProvenInFewParts)
{
    RandomCases random;
    for (int round = 0; round < 30; ++round)
    {
        const Bernstein h = valley(random, 0.05, 0.3, 0.0);
        EXPECT_LE(parts_needed(h, 1e-11, 0), 200) << round;
    }
}

//! Valleys that reach below zero by twice their rounding: a lift of that rounding lets none pass.
TEST(ValleyBound, RoundingPassesNothing)
{
    RandomCases random;
    int tried = 0, with_lift = 0;
    for (int round = 0; round < 2000; ++round)
    {
        // straight, from side to side: the line is the valley itself
        const double start = random.uniform(0.05, 0.95);
        const double end = random.uniform(0.05, 0.95);
        const Bernstein q = polynomial(1, 1, {-start, 1.0 - start, -end, 1.0 - end});
        Bernstein square, h;
        assign_product(q, q, square);
        assign_product(square, polynomial(1, 1, {1.0, random.uniform(0.8, 1.2), 1.0, random.uniform(0.8, 1.2)}), h);
        const double scale = random.magnitude(1e-6, 1e6);
        Bernstein lowered(h.degree_u(), h.degree_v());
        lowered.add_raised(scale, h);
        const double unit = valley_rounding(std::max(h.degree_u(), h.degree_v())) * lowered.range().size();
        lowered.add_raised(1.0, polynomial(0, 0, {-2.0 * unit}));
        const double curvature = curvature_of(lowered);
        if (!(curvature > 0.0))
            continue;
        ++tried;
        EXPECT_FALSE(valley_is_above(lowered, unit, true, curvature)) << round;
        with_lift += valley_is_above(lowered, 8.0 * unit, true, curvature) ? 1 : 0;
    }
    EXPECT_GT(tried, 1000);
    EXPECT_GT(with_lift, tried / 2);
}
