// SPDX-License-Identifier: LGPL-2.1-or-later
// Tensor splines against OpenCASCADE's surfaces: values, derivatives, and the way there and back.
#include "support/random_cases.h"

#include <laminate_offset/spline/tensor_spline.h>

#include <GeomConvert.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <gtest/gtest.h>

#include <cmath>

using namespace laminate_offset;
using namespace test_support;

namespace
{

Eigen::Vector3d vector(const gp_XYZ &p) { return {p.X(), p.Y(), p.Z()}; }

void expect_near(const Eigen::Vector3d &a, const Eigen::Vector3d &b, double tolerance, const char *what)
{
    EXPECT_LE((a - b).norm(), tolerance * (1.0 + b.norm())) << what << " " << a.transpose() << " / " << b.transpose();
}

//! Parameters inside the spans and at both ends, where no side has to be chosen.
std::vector<double> smooth_parameters(const KnotVector &kv)
{
    std::vector<double> result{kv.front()};
    const std::vector<double> breaks = kv.breaks();
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        for (const double x : {0.21, 0.64})
            result.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * x);
    result.push_back(kv.back());
    return result;
}

//! Both surfaces have the same points and derivatives at the same parameters. \return places compared
int expect_same(const TensorSpline &spline, const Handle(Geom_BSplineSurface) & surface, double tolerance = 1e-10)
{
    const std::vector<double> us = smooth_parameters(spline.u), vs = smooth_parameters(spline.v);
    const std::vector<SurfaceJet> jets = spline.jets(us, vs, 2);
    EXPECT_EQ(jets.size(), us.size() * vs.size());
    for (std::size_t k = 0; k < jets.size(); ++k)
    {
        gp_Pnt s;
        gp_Vec u, v, uu, vv, uv;
        surface->D2(us[k / vs.size()], vs[k % vs.size()], s, u, v, uu, vv, uv);
        expect_near(jets[k].s, vector(s.XYZ()), tolerance, "S");
        expect_near(jets[k].u, vector(u.XYZ()), tolerance, "S_u");
        expect_near(jets[k].v, vector(v.XYZ()), tolerance, "S_v");
        expect_near(jets[k].uu, vector(uu.XYZ()), tolerance, "S_uu");
        expect_near(jets[k].uv, vector(uv.XYZ()), tolerance, "S_uv");
        expect_near(jets[k].vv, vector(vv.XYZ()), tolerance, "S_vv");
    }
    return static_cast<int>(jets.size());
}

//! A cubic surface over knots of multiplicity 1 everywhere: its domain is the inner part of the knots.
Handle(Geom_BSplineSurface) unclamped_surface(RandomCases &random)
{
    constexpr int poles = 7, degree = 3;
    TColgp_Array2OfPnt net(1, poles, 1, poles);
    for (int i = 1; i <= poles; ++i)
        for (int j = 1; j <= poles; ++j)
            net(i, j) = gp_Pnt(10.0 * i, 10.0 * j, random.uniform(-4, 4));
    TColStd_Array1OfReal knots(1, poles + degree + 1);
    TColStd_Array1OfInteger multiplicities(1, poles + degree + 1);
    multiplicities.Init(1);
    for (int i = 1; i <= knots.Length(); ++i)
        knots(i) = i + random.uniform(-0.2, 0.2);
    return new Geom_BSplineSurface(net, knots, knots, multiplicities, multiplicities, degree, degree);
}

} // namespace

TEST(TensorSpline, HasThePointsAndDerivativesOfOpenCascadesSurface)
{
    RandomCases random;
    int places = 0;
    for (const bool rational : {false, true})
        for (const auto &[degree_u, degree_v] : {std::pair{1, 1}, {2, 3}, {3, 3}, {5, 2}, {7, 4}, {9, 9}})
            for (const int repeated : {1, 9})
            {
                SCOPED_TRACE(testing::Message() << degree_u << "x" << degree_v << (rational ? " rational" : ""));
                SurfaceKind kind{.degree_u = degree_u, .degree_v = degree_v, .rational = rational};
                kind.most_repeated = repeated;
                const Handle(Geom_BSplineSurface) surface = random_surface(random, kind);
                const TensorSpline spline = from_geom(surface);
                EXPECT_EQ(spline.rational, rational);
                places += expect_same(spline, surface, 1e-9);
            }
    EXPECT_GT(places, 1000);
}

TEST(TensorSpline, FillsOnlyTheDerivativesThatWereAskedForTheSameWay)
{
    RandomCases random;
    const TensorSpline spline = from_geom(random_surface(random, {.rational = true}));
    const std::vector<double> us{0.1, 0.6}, vs{0.2, 0.3, 0.9};
    const auto points = spline.jets(us, vs, 0), tangents = spline.jets(us, vs, 1), all = spline.jets(us, vs, 2);
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        EXPECT_EQ(points[i].s, all[i].s);
        EXPECT_EQ(tangents[i].s, all[i].s);
        EXPECT_EQ(tangents[i].u, all[i].u);
        EXPECT_EQ(tangents[i].v, all[i].v);
    }
    EXPECT_TRUE(spline.jets({}, vs, 2).empty());
}

TEST(TensorSpline, IsTheSameOnAGridAndPointByPoint)
{
    RandomCases random;
    const TensorSpline spline = from_geom(random_surface(random, {.spans_u = 6, .spans_v = 5}));
    std::vector<double> us, vs;
    for (int i = 0; i <= 90; ++i)
    {
        us.push_back(i / 90.0);
        vs.push_back(i * i / 8100.0);
    }
    const auto grid = spline.jets(us, vs, 2);
    for (std::size_t k = 0; k < grid.size(); k += 37)
    {
        const auto one = spline.jets({us[k / vs.size()]}, {vs[k % vs.size()]}, 2).front();
        EXPECT_EQ(one.s, grid[k].s);
        EXPECT_EQ(one.uv, grid[k].uv);
    }
}

TEST(TensorSpline, ComesBackFromOpenCascadeAsItWas)
{
    RandomCases random;
    for (const bool rational : {false, true})
    {
        const TensorSpline spline = from_geom(random_surface(random, {.degree_u = 4, .rational = rational}));
        const TensorSpline again = from_geom(to_geom(spline));
        EXPECT_EQ(again.u.knots, spline.u.knots);
        EXPECT_EQ(again.v.knots, spline.v.knots);
        EXPECT_EQ(again.u.degree, 4);
        EXPECT_EQ(again.v.degree, 3);
        EXPECT_EQ(again.rational, rational);
        ASSERT_EQ(again.poles.size(), spline.poles.size());
        for (std::size_t i = 0; i < spline.poles.size(); ++i)
            EXPECT_LE((again.poles[i] - spline.poles[i]).norm(), 1e-12 * spline.poles[i].norm());
    }
}

TEST(TensorSpline, ForgetsWeightsThatAreAllEqual)
{
    RandomCases random;
    const Handle(Geom_BSplineSurface) surface = random_surface(random, {});
    for (int i = 1; i <= surface->NbUPoles(); ++i)
        for (int j = 1; j <= surface->NbVPoles(); ++j)
            surface->SetWeight(i, j, 2.5);
    const TensorSpline spline = from_geom(surface);
    EXPECT_FALSE(spline.rational);
    for (const Eigen::Vector4d &pole : spline.poles)
        EXPECT_EQ(pole.w(), 1.0);
    EXPECT_GT(expect_same(spline, surface), 20);
}

TEST(TensorSpline, ReadsPeriodicSurfacesOnTheirWholeDomain)
{
    for (const bool torus : {false, true})
    {
        const Handle(Geom_Surface) round = torus ? Handle(Geom_Surface)(new Geom_ToroidalSurface(gp_Ax3(), 50.0, 12.0))
                                                 : Handle(Geom_Surface)(new Geom_SphericalSurface(gp_Ax3(), 40.0));
        const Handle(Geom_BSplineSurface) surface = GeomConvert::SurfaceToBSplineSurface(round);
        ASSERT_TRUE(surface->IsUPeriodic());
        const TensorSpline spline = from_geom(surface);
        EXPECT_TRUE(surface->IsUPeriodic()) << "the base was changed";
        double u0, u1, v0, v1;
        surface->Bounds(u0, u1, v0, v1);
        EXPECT_NEAR(spline.u.front(), u0, 1e-14);
        EXPECT_NEAR(spline.u.back(), u1, 1e-14);
        EXPECT_EQ(spline.u.distinct().front().multiplicity, spline.u.degree + 1);
        EXPECT_GT(expect_same(spline, surface), 30);
        const auto ends = spline.jets({u0, u1}, {0.5 * (v0 + v1)}, 0);
        expect_near(ends[0].s, ends[1].s, 1e-13, "the ends meet");
    }
}

TEST(TensorSpline, ClampsUnclampedSurfacesWithoutChangingThem)
{
    RandomCases random;
    for (int i = 0; i < 5; ++i)
    {
        const Handle(Geom_BSplineSurface) surface = unclamped_surface(random);
        double u0, u1, v0, v1;
        surface->Bounds(u0, u1, v0, v1);
        const TensorSpline spline = from_geom(surface);
        EXPECT_EQ(spline.u.front(), u0);
        EXPECT_EQ(spline.u.back(), u1);
        EXPECT_EQ(spline.v.distinct().front().multiplicity, 4);
        EXPECT_EQ(spline.v.distinct().back().multiplicity, 4);
        EXPECT_GT(expect_same(spline, surface), 50);
        EXPECT_EQ(surface->UMultiplicity(1), 1) << "the base was changed";
    }
}
