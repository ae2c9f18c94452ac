// SPDX-License-Identifier: LGPL-2.1-or-later
// Control points of Bernstein pieces against those of the blossom in extended precision.
#include "support/random_cases.h"

#include <laminate_offset/input/input_face.h>
#include <laminate_offset/spline/spline_pieces.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace laminate_offset;
using namespace test_support;

namespace
{

using Extended = long double;
using Point = std::array<Extended, 3>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

//! The blossom of a curve over a span, by de Boor's recursion with one argument a level.
Point blossom(const KnotVector &kv, int span, std::vector<Point> points, const std::vector<Extended> &arguments)
{
    const int p = kv.degree;
    for (int level = 1; level <= p; ++level)
        for (int k = p; k >= level; --k)
        {
            const Extended low = kv.knots[static_cast<std::size_t>(span - p + k)];
            const Extended high = kv.knots[static_cast<std::size_t>(span + 1 + k - level)];
            const Extended part = (arguments[static_cast<std::size_t>(level - 1)] - low) / (high - low);
            for (std::size_t e = 0; e < 3; ++e)
                points[static_cast<std::size_t>(k)][e] = (1 - part) * points[static_cast<std::size_t>(k - 1)][e] +
                                                         part * points[static_cast<std::size_t>(k)][e];
        }
    return points.back();
}

//! Arguments of control point r over [a, b].
std::vector<Extended> corner(int degree, int r, double a, double b)
{
    std::vector<Extended> arguments;
    for (int k = 0; k < degree; ++k)
        arguments.push_back(k < degree - r ? a : b);
    return arguments;
}

//! Control point (r, s) over a rectangle, relative to the origin.
Point control(const TensorSpline &spline, const ParameterBox &box, int r, int s, const Eigen::Vector3d &origin)
{
    const int p = spline.u.degree, q = spline.v.degree;
    const int span_u = spline.u.span(0.5 * (box.umin + box.umax)), span_v = spline.v.span(0.5 * (box.vmin + box.vmax));
    std::vector<Point> rows;
    for (int k = 0; k <= p; ++k)
    {
        std::vector<Point> row;
        for (int l = 0; l <= q; ++l)
        {
            const Eigen::Vector4d &pole = spline.pole(span_u - p + k, span_v - q + l);
            row.push_back(
                {Extended(pole.x()) - origin.x(), Extended(pole.y()) - origin.y(), Extended(pole.z()) - origin.z()});
        }
        rows.push_back(blossom(spline.v, span_v, row, corner(q, s, box.vmin, box.vmax)));
    }
    return blossom(spline.u, span_u, rows, corner(p, r, box.umin, box.umax));
}

//! A surface of the size with knots in u that nearly coincide, at a distance from the origin.
TensorSpline sliver(RandomCases &random, double gap, double size, double away)
{
    const int p = random.integer(2, 5), q = random.integer(1, 5);
    const double knot = random.uniform(0.2, 0.7);
    TensorSpline spline;
    spline.u = clamped_knots(p, 0.0, 1.0, {knot, knot + gap, 0.9});
    spline.v = clamped_knots(q, 0.0, 1.0, {0.4});
    for (int i = 0; i < spline.u.pole_count(); ++i)
        for (int j = 0; j < spline.v.pole_count(); ++j)
            spline.poles.emplace_back(away + 1e-2 * size * (i + random.uniform(-0.2, 0.2)), away + size * j,
                                      1e-3 * size * random.uniform(-1.0, 1.0), 1.0);
    return spline;
}

Extended length(const Point &a, const Point &b, const Eigen::Vector3d &seen)
{
    Extended square = 0;
    for (std::size_t e = 0; e < 3; ++e)
        square += std::pow(b[e] - a[e] - seen[static_cast<Eigen::Index>(e)], 2);
    return std::sqrt(square);
}

} // namespace

TEST(SplinePieces, NeighboursOfNarrowPiecesPartByWhatIsPromised)
{
    RandomCases random;
    double largest_share = 0.0;
    for (int run = 0; run < 200; ++run)
    {
        const TensorSpline spline = sliver(random, random.magnitude(1e-12, 1e-2), random.magnitude(1.0, 1e4),
                                           run % 2 == 0 ? 0.0 : random.magnitude(1.0, 1e6));
        const int p = spline.u.degree, q = spline.v.degree;
        const std::vector<double> us = spline.u.breaks();
        const std::vector<double> vs = merged_breaks(spline.v.breaks(), {0.15, 0.2});
        SplinePieces pieces(spline, us, vs);
        for (std::size_t i = 0; i + 1 < us.size(); ++i)
            for (std::size_t j = 0; j + 1 < vs.size(); ++j)
            {
                SCOPED_TRACE(testing::Message() << "run " << run << " piece " << i << ' ' << j);
                const Eigen::Vector3d origin = pieces.near_point(i, j);
                RationalPiece piece;
                pieces.cut(i, j, origin, piece);
                const PieceReach reach = pieces.reach();
                const auto seen = [&](int r, int s) {
                    return Eigen::Vector3d(piece.numerator[0].coefficient(r, s), piece.numerator[1].coefficient(r, s),
                                           piece.numerator[2].coefficient(r, s));
                };
                const double local = longest(piece.numerator);
                const double extraction = 8.0 * (p + q + 1.0); // roundings
                const double in_u = epsilon * 2.0 * (2.0 * local + extraction * reach.across_u);
                const double in_v = epsilon * 2.0 * (2.0 * local + extraction * (reach.along_v + reach.across_u));
                const ParameterBox box{us[i], us[i + 1], vs[j], vs[j + 1]};
                for (int r = 0; r <= p; ++r)
                    for (int s = 0; s <= q; ++s)
                    {
                        const Point here = control(spline, box, r, s, origin);
                        if (r > 0)
                        {
                            const Extended off =
                                length(control(spline, box, r - 1, s, origin), here, seen(r, s) - seen(r - 1, s));
                            EXPECT_LE(off, in_u);
                            largest_share = std::max(largest_share, static_cast<double>(off) / in_u);
                        }
                        if (s > 0)
                            EXPECT_LE(length(control(spline, box, r, s - 1, origin), here, seen(r, s) - seen(r, s - 1)),
                                      in_v);
                    }
            }
    }
    EXPECT_GT(largest_share, 1e-2) << "the bound says something";
}

// Poles that are off move the control points of a piece, and neighbours apart by what the weights change.
TEST(SplinePieces, PolesThatAreOffPartNeighboursByTheChangeOfTheirWeights)
{
    RandomCases random;
    for (int run = 0; run < 60; ++run)
    {
        const double gap = random.magnitude(1e-9, 1e-2), off = 1e-3;
        const TensorSpline given = sliver(random, gap, 10.0, 0.0);
        TensorSpline moved = given;
        for (Eigen::Vector4d &pole : moved.poles)
            for (Eigen::Index e = 0; e < 3; ++e)
                pole[e] += off * random.sign();
        const std::vector<double> us = given.u.breaks(), vs = given.v.breaks();
        SplinePieces before(given, us, vs), after(moved, us, vs);
        for (std::size_t i = 0; i + 1 < us.size(); ++i)
        {
            RationalPiece a, b;
            before.cut(i, 0, Eigen::Vector3d::Zero(), a);
            after.cut(i, 0, Eigen::Vector3d::Zero(), b);
            const PieceReach reach = before.reach();
            EXPECT_LE(reach.change_u, 2.0 + 1e-12);
            for (int r = 1; r <= given.u.degree; ++r)
                for (int s = 0; s <= given.v.degree; ++s)
                    for (std::size_t e = 0; e < 3; ++e)
                    {
                        const auto apart = [&](const RationalPiece &piece) {
                            return piece.numerator[e].coefficient(r, s) - piece.numerator[e].coefficient(r - 1, s);
                        };
                        EXPECT_LE(std::abs(apart(b) - apart(a)), reach.change_u * off + 1e-12);
                    }
        }
    }
}
