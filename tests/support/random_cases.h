// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Random knots, surfaces and numbers that can be repeated: every use prints its seed.
#pragma once

#include <laminate_offset/spline/knot_vector.h>

#include <Geom_BSplineSurface.hxx>

#include <cstdint>
#include <random>
#include <vector>

namespace test_support
{

//! A stream of random numbers. The seed is fixed unless the environment variable LAMINATE_OFFSET_TEST_SEED
//! gives another one; it is printed and recorded with the running test.
class RandomCases
{
public:
    RandomCases();

    double uniform(double low, double high);
    //! Uniform in the logarithm; both ends positive.
    double magnitude(double low, double high);
    //! Both ends included.
    int integer(int low, int high);
    double sign() { return integer(0, 1) == 0 ? -1.0 : 1.0; }

private:
    std::mt19937_64 m_engine;
};

//! A clamped knot vector of `spans` spans on [a, b], interior knots repeated up to `most_repeated` times.
laminate_offset::KnotVector random_knots(RandomCases &random, int degree, int spans, int most_repeated, double a,
                                         double b);

//! What a random surface looks like. Lengths in mm.
struct SurfaceKind
{
    int degree_u = 3;
    int degree_v = 3;
    int spans_u = 3;
    int spans_v = 3;
    double size = 100.0;   //!< side of the square below it
    double height = 8.0;   //!< poles stand up to so much above and below the square
    double jitter = 0.1;   //!< poles stray sideways by this part of their distance
    bool rational = false; //!< weights between 0.7 and 1.4
    int most_repeated = 1;
};

//! A spline surface over [0, 1] x [0, 1]: a square with random heights, sheared by its jitter.
Handle(Geom_BSplineSurface) random_surface(RandomCases &random, const SurfaceKind &kind);

} // namespace test_support
