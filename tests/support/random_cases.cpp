// SPDX-License-Identifier: LGPL-2.1-or-later
#include "random_cases.h"

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace test_support
{
namespace
{

constexpr std::uint64_t usual_seed = 20031;

std::uint64_t chosen_seed()
{
    const char *given = std::getenv("LAMINATE_OFFSET_TEST_SEED");
    return given ? std::strtoull(given, nullptr, 10) : usual_seed;
}

//! The parameter at which pole i of a spline stands: reproduces straight lines (Greville).
double greville(const laminate_offset::KnotVector &kv, int i)
{
    double sum = 0.0;
    for (int k = 1; k <= kv.degree; ++k)
        sum += kv.knots[static_cast<std::size_t>(i + k)];
    return sum / kv.degree;
}

struct KnotArrays
{
    TColStd_Array1OfReal values;
    TColStd_Array1OfInteger multiplicities;

    explicit KnotArrays(const laminate_offset::KnotVector &kv)
        : values(1, static_cast<int>(kv.distinct().size())), multiplicities(1, values.Length())
    {
        int i = 0;
        for (const laminate_offset::Knot &knot : kv.distinct())
        {
            values(++i) = knot.parameter;
            multiplicities(i) = knot.multiplicity;
        }
    }
};

} // namespace

RandomCases::RandomCases() : m_engine(chosen_seed())
{
    std::cout << "random cases with LAMINATE_OFFSET_TEST_SEED=" << chosen_seed() << '\n';
    testing::Test::RecordProperty("seed", std::to_string(chosen_seed()));
}

double RandomCases::uniform(double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(m_engine);
}

double RandomCases::magnitude(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }

int RandomCases::integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_engine); }

laminate_offset::KnotVector random_knots(RandomCases &random, int degree, int spans, int most_repeated, double a,
                                         double b)
{
    std::vector<double> interior;
    for (int i = 1; i < spans; ++i)
    {
        const double t = a + (b - a) * (i + random.uniform(-0.35, 0.35)) / spans;
        interior.insert(interior.end(), static_cast<std::size_t>(random.integer(1, std::min(most_repeated, degree))),
                        t);
    }
    return laminate_offset::clamped_knots(degree, a, b, interior);
}

Handle(Geom_BSplineSurface) random_surface(RandomCases &random, const SurfaceKind &kind)
{
    const auto u = random_knots(random, kind.degree_u, kind.spans_u, kind.most_repeated, 0.0, 1.0);
    const auto v = random_knots(random, kind.degree_v, kind.spans_v, kind.most_repeated, 0.0, 1.0);
    const int nu = u.pole_count(), nv = v.pole_count();
    TColgp_Array2OfPnt poles(1, nu, 1, nv);
    TColStd_Array2OfReal weights(1, nu, 1, nv);
    const double stray_u = kind.jitter * kind.size / (nu - 1), stray_v = kind.jitter * kind.size / (nv - 1);
    for (int i = 1; i <= nu; ++i)
        for (int j = 1; j <= nv; ++j)
        {
            poles(i, j) = gp_Pnt(kind.size * greville(u, i - 1) + random.uniform(-stray_u, stray_u),
                                 kind.size * greville(v, j - 1) + random.uniform(-stray_v, stray_v),
                                 random.uniform(-kind.height, kind.height));
            weights(i, j) = kind.rational ? random.uniform(0.7, 1.4) : 1.0;
        }
    const KnotArrays ku(u), kv(v);
    if (!kind.rational)
        return new Geom_BSplineSurface(poles, ku.values, kv.values, ku.multiplicities, kv.multiplicities, u.degree,
                                       v.degree);
    return new Geom_BSplineSurface(poles, weights, ku.values, kv.values, ku.multiplicities, kv.multiplicities, u.degree,
                                   v.degree);
}

} // namespace test_support
