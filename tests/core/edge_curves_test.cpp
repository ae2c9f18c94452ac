// SPDX-License-Identifier: LGPL-2.1-or-later
// Edge curves take the simplest form there is: straight pcurves become lines, parallelograms carry images of whole
// splines, and a smooth fit needs few poles. Dense samples say how far that leads away.
#include "support/random_cases.h"

#include <laminate_offset/spline/knot_choice.h>
#include <laminate_offset/trimming/edge_curve.h>
#include <laminate_offset/trimming/edge_fit.h>
#include <laminate_offset/trimming/straight_pcurve.h>

#include <Geom2dConvert.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

using namespace laminate_offset;
using namespace test_support;

namespace
{

//! The segment from a to b over [first, last] with needless degree and knots; one inner pole moved by `bend`.
Handle(Geom2d_BSplineCurve) laboured_segment(const gp_XY &a, const gp_XY &b, double first, double last, double bend)
{
    TColgp_Array1OfPnt2d poles(1, 2);
    poles(1) = gp_Pnt2d(a);
    poles(2) = gp_Pnt2d(b);
    TColStd_Array1OfReal knots(1, 2);
    knots(1) = first;
    knots(2) = last;
    TColStd_Array1OfInteger multiplicities(1, 2);
    multiplicities.Init(2);
    const Handle(Geom2d_BSplineCurve) curve = new Geom2d_BSplineCurve(poles, knots, multiplicities, 1);
    curve->IncreaseDegree(3);
    curve->InsertKnot(first + 0.3 * (last - first), 2);
    curve->SetPole(3, curve->Pole(3).XY() + gp_XY(bend, -bend));
    return curve;
}

double seen(const Handle(Geom2d_Curve) & a, const Handle(Geom2d_Curve) & b, double first, double last)
{
    double worst = 0.0;
    for (int k = 0; k <= 1000; ++k)
    {
        const double t = first + (last - first) * k / 1000;
        worst = std::max(worst, a->Value(t).Distance(b->Value(t)));
    }
    return worst;
}

//! The corner points o, o + a, o + b, o + a + b + twist over [u0, u1] x [v0, v1].
Handle(Geom_BSplineSurface) parallelogram(const gp_XYZ &o, const gp_XYZ &a, const gp_XYZ &b, const gp_XYZ &twist,
                                          const gp_XY &u, const gp_XY &v)
{
    TColgp_Array2OfPnt poles(1, 2, 1, 2);
    poles(1, 1) = gp_Pnt(o);
    poles(2, 1) = gp_Pnt(o + a);
    poles(1, 2) = gp_Pnt(o + b);
    poles(2, 2) = gp_Pnt(o + a + b + twist);
    TColStd_Array1OfReal us(1, 2), vs(1, 2);
    us(1) = u.X();
    us(2) = u.Y();
    vs(1) = v.X();
    vs(2) = v.Y();
    TColStd_Array1OfInteger multiplicities(1, 2);
    multiplicities.Init(2);
    return new Geom_BSplineSurface(poles, us, vs, multiplicities, multiplicities, 1, 1);
}

std::optional<EdgeCurve> curve_on(const Handle(Geom_Surface) & surface, const Handle(Geom2d_Curve) & pcurve,
                                  double first, double last, double tolerance)
{
    const auto form = AnalyticSurface::make(surface);
    return edge_curve(EdgeTarget({surface, pcurve, first, last}, &*form), tolerance);
}

int poles_of(const EdgeCurve &edge)
{
    const auto spline = Handle(Geom_BSplineCurve)::DownCast(edge.curve);
    return spline.IsNull() ? 0 : spline->NbPoles();
}

//! Points of a curve in space as a fit takes them.
template <class Curve> SmoothCurve smooth(const Curve &curve)
{
    return {[curve](const std::vector<double> &parameters) {
                RowMatrix rows(static_cast<Eigen::Index>(parameters.size()), 3);
                for (std::size_t i = 0; i < parameters.size(); ++i)
                    rows.row(static_cast<Eigen::Index>(i)) = curve(parameters[i]).transpose();
                return rows;
            },
            {0.0, 1.0}};
}

Eigen::Vector3d bump(double t)
{
    return {100.0 * t, 10.0 / (1.0 + 100.0 * (t - 0.3) * (t - 0.3)), 5.0 * std::sin(6.0 * t)};
}

} // namespace

TEST(StraightPcurve, BecomesALineWithABoundThatHolds)
{
    RandomCases random;
    for (const double scale : {1e-3, 1.0, 1e4})
        for (const double bend : {0.0, 1e-13, 1e-11})
            for (const double speed : {1.0, 0.37, 12.0})
            {
                const gp_XY a(scale * random.uniform(-1.0, 1.0), scale * random.uniform(-1.0, 1.0));
                const double turn = random.uniform(0.0, 6.0);
                const gp_XY b = a + scale * gp_XY(std::cos(turn), std::sin(turn));
                const double first = random.uniform(-2.0, 3.0);
                const double last = first + scale / speed;
                const auto given = laboured_segment(a, b, first, last, bend * scale);
                const auto made = straight_pcurve(given, first, last);
                ASSERT_TRUE(made) << scale << ' ' << bend << ' ' << speed;
                EXPECT_EQ(speed == 1.0, !Handle(Geom2d_Line)::DownCast(made->curve).IsNull());
                EXPECT_LE(seen(given, made->curve, first, last), made->deviation);
                EXPECT_LE(made->deviation, 3.0 * bend * scale + 1e-13 * (scale + 5.0 * std::max(1.0, speed)));
            }
}

TEST(StraightPcurve, LeavesBentUnevenAndRationalCurvesAlone)
{
    const gp_XY a(0.1, 0.2);
    const gp_XY b(0.9, 0.4);
    EXPECT_FALSE(straight_pcurve(laboured_segment(a, b, 0.0, 1.0, 1e-7), 0.0, 1.0));
    EXPECT_FALSE(straight_pcurve(new Geom2d_Circle(gp_Ax22d(), 1.0), 0.0, 1.0));
    const auto uneven = laboured_segment(a, b, 0.0, 1.0, 0.0);
    uneven->SetPole(3, gp_Pnt2d(uneven->Pole(3).XY() + 1e-4 * (b - a)));
    EXPECT_FALSE(straight_pcurve(uneven, 0.0, 1.0));
    const auto rational = laboured_segment(a, b, 0.0, 1.0, 0.0);
    rational->SetWeight(3, 1.5);
    EXPECT_FALSE(straight_pcurve(rational, 0.0, 1.0));
}

TEST(EdgeCurves, ParallelogramsCarryTheImagesOfSplines)
{
    RandomCases random;
    const Handle(Geom2d_Curve) arc = Geom2dConvert::CurveToBSplineCurve(
        new Geom2d_TrimmedCurve(new Geom2d_Circle(gp_Ax22d(gp_Pnt2d(3.0, 4.0), gp_Dir2d(1, 0)), 0.8), 0.2, 3.0));
    const int arc_poles = Handle(Geom2d_BSplineCurve)::DownCast(arc)->NbPoles();
    for (const double size : {1e-2, 1.0, 1e3})
    {
        const gp_XYZ o(size * random.uniform(-5, 5), size, -size);
        const gp_XYZ a(size, random.uniform(0.0, 0.3) * size, 0.0);
        const gp_XYZ b(0.1 * size, size, 0.4 * size);
        const double tolerance = 1e-5 * size;
        const auto flat = parallelogram(o, a, b, {0, 0, 0}, {2, 4}, {3, 5});
        const auto image = curve_on(flat, arc, arc->FirstParameter(), arc->LastParameter(), tolerance);
        ASSERT_TRUE(image);
        EXPECT_EQ(poles_of(*image), arc_poles);
        EXPECT_TRUE(image->deviation.proven);
        EXPECT_LE(image->deviation.bound, 1e-3 * tolerance);
        const CurveOnSurface on_surface{Handle(Geom_Surface)(flat), arc, arc->FirstParameter(), arc->LastParameter()};
        EXPECT_LE(largest_distance(image->curve, on_surface), image->deviation.bound);
        // a twist that counts makes it a fit
        const auto twisted = parallelogram(o, a, b, {0, 0, 0.1 * size}, {2, 4}, {3, 5});
        const auto fit = curve_on(twisted, arc, arc->FirstParameter(), arc->LastParameter(), tolerance);
        ASSERT_TRUE(fit);
        EXPECT_NE(poles_of(*fit), arc_poles);
        EXPECT_LE(fit->deviation.bound, tolerance);
    }
}

TEST(EdgeTarget, ManyPointsAreThoseOfEachParameter)
{
    RandomCases random;
    const Handle(Geom2d_Curve) circle = new Geom2d_Circle(gp_Ax22d(gp_Pnt2d(3.0, 4.0), gp_Dir2d(1, 0)), 0.8);
    const Handle(Geom2d_Curve) spline = Geom2dConvert::CurveToBSplineCurve(new Geom2d_TrimmedCurve(circle, 0.2, 3.0));
    const Handle(Geom2d_Curve) line = new Geom2d_Line(gp_Pnt2d(2.1, 3.2), gp_Dir2d(1.0, 0.7));
    const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), 7.0);
    const Handle(Geom_BSplineSurface) patch = parallelogram({1, 2, 3}, {9, 1, 0}, {0, 8, 1}, {1, 2, 6}, {2, 4}, {3, 5});
    patch->IncreaseDegree(3, 2);
    patch->InsertUKnot(2.9, 2, 1e-9, false);
    patch->InsertVKnot(4.2, 1, 1e-9, false);
    patch->SetPole(3, 2, patch->Pole(3, 2).Translated(gp_Vec(0.3, -0.2, 1.0)));
    for (const Handle(Geom_Surface) & surface : {Handle(Geom_Surface)(patch), cylinder})
        for (const Handle(Geom2d_Curve) & pcurve : {circle, spline, line})
        {
            const double first = pcurve == spline ? spline->FirstParameter() : 0.1;
            const double last = pcurve == spline ? spline->LastParameter() : 1.5;
            const auto form = AnalyticSurface::make(surface);
            const EdgeTarget target({surface, pcurve, first, last}, &*form);
            for (const int count : {1, 7, 8, 9, 250})
            {
                std::vector<double> parameters{first, last};
                for (int i = 2; i < count; ++i)
                    parameters.push_back(random.uniform(first, last));
                std::sort(parameters.begin(), parameters.end());
                const Eigen::Vector3d origin(1.0, -2.0, 0.5);
                const RowMatrix rows = target.values(parameters, origin);
                ASSERT_EQ(rows.rows(), static_cast<Eigen::Index>(parameters.size()));
                for (std::size_t i = 0; i < parameters.size(); ++i)
                {
                    const Eigen::Vector3d at = rows.row(static_cast<Eigen::Index>(i)).transpose() + origin;
                    const gp_Pnt own = target.on_surface().value(parameters[i]);
                    EXPECT_LE((at - Eigen::Vector3d(own.X(), own.Y(), own.Z())).norm(), 1e-13 * 20.0);
                }
            }
        }
}

TEST(EdgeTarget, AnEdgeThatEndsARoundingBehindItsPcurveIsProven)
{
    const Handle(Geom2d_Curve) pcurve = Geom2dConvert::CurveToBSplineCurve(
        new Geom2d_TrimmedCurve(new Geom2d_Circle(gp_Ax22d(gp_Pnt2d(3.0, 4.0), gp_Dir2d(1, 0)), 0.8), 0.2, 3.0));
    const Handle(Geom_Surface) patch = parallelogram({1, 2, 3}, {9, 1, 0}, {0, 8, 1}, {1, 2, 6}, {2, 4}, {3, 5});
    const auto form = AnalyticSurface::make(patch);
    const double low = pcurve->FirstParameter(), high = pcurve->LastParameter();
    const double ulp = std::numeric_limits<double>::epsilon() * high;
    for (const auto &[before, behind] :
         {std::pair{0.0, 0.0}, std::pair{ulp, 0.0}, std::pair{0.0, ulp}, std::pair{3.0 * ulp, 5.0 * ulp}})
    {
        const EdgeTarget target({patch, pcurve, low - before, high + behind}, &*form);
        const auto edge = edge_curve(target, 1e-4);
        ASSERT_TRUE(edge);
        EXPECT_TRUE(edge->deviation.proven) << before << " before, " << behind << " behind";
        EXPECT_LE(edge->deviation.bound, 1e-4);
        EXPECT_LE(largest_distance(edge->curve, target.on_surface()), edge->deviation.bound);
    }
}

TEST(EdgeCurves, IsoparametricCurvesAreExactWhereEndsAreRoundedOutwards)
{
    RandomCases random;
    const Handle(Geom_BSplineSurface) surface = random_surface(random, {.spans_u = 4, .spans_v = 3});
    double u0, u1, v0, v1;
    surface->Bounds(u0, u1, v0, v1);
    const double over = 1e-14 * (v1 - v0);
    const Handle(Geom2d_Curve) line = new Geom2d_Line(gp_Pnt2d(0.4 * u0 + 0.6 * u1, v0 - over), gp_Dir2d(0, 1));
    const auto edge = curve_on(surface, line, 0.0, v1 - v0 + 2.0 * over, 1e-9);
    ASSERT_TRUE(edge);
    EXPECT_EQ(poles_of(*edge), surface->NbVPoles());
    EXPECT_TRUE(edge->deviation.proven);
    EXPECT_LE(edge->deviation.bound, 1e-9);
}

TEST(EdgeCurves, RulingsHaveTwoPoles)
{
    const gp_Ax3 axes(gp_Pnt(3, -2, 1), gp_Dir(0.2, 0.3, 1.0));
    for (const Handle(Geom_Surface) & surface : std::initializer_list<Handle(Geom_Surface)>{
             new Geom_CylindricalSurface(axes, 40.0), new Geom_ConicalSurface(axes, 0.4, 30.0)})
    {
        const auto pcurve = laboured_segment({1.3, -5.0}, {1.3, 60.0}, 0.0, 1.0, 0.0);
        const auto edge = curve_on(surface, pcurve, 0.0, 1.0, 1e-6);
        ASSERT_TRUE(edge);
        EXPECT_EQ(poles_of(*edge), 2);
        EXPECT_TRUE(edge->deviation.proven);
        EXPECT_LE(edge->deviation.bound, 1e-10);
    }
}

TEST(SmoothFit, ReachesToleranceWithFewPoles)
{
    for (const double tolerance : {1e-1, 1e-3, 1e-5, 1e-7})
    {
        const SmoothCurve curve = smooth(bump);
        const auto fit = smooth_fit(curve, tolerance);
        ASSERT_TRUE(fit) << tolerance;
        EXPECT_LE(fit->error, tolerance);
        std::vector<double> parameters;
        for (int k = 0; k <= 4000; ++k)
            parameters.push_back(k / 4000.0);
        const BasisRows rows(fit->knots, parameters);
        double worst = 0.0;
        for (int k = 0; k < rows.rows(); ++k)
        {
            Eigen::RowVector3d point = Eigen::RowVector3d::Zero();
            for (int i = 0; i < rows.width(); ++i)
                point += rows.row(k)[i] * fit->poles.row(rows.first(k) + i);
            worst = std::max(worst, (point.transpose() - bump(parameters[static_cast<std::size_t>(k)])).norm());
        }
        EXPECT_LE(worst, 1.2 * tolerance);
        KnotProblem thorough;
        thorough.sample = curve.sample;
        thorough.tolerance = tolerance;
        thorough.min_degree = 3;
        thorough.max_degree = 5;
        const auto choice = choose_knots(thorough);
        ASSERT_TRUE(choice);
        EXPECT_LE(fit->knots.pole_count(), 1.3 * choice->knots.pole_count() + 4.0) << tolerance;
    }
}

//! A cubic spline of little waves over many simple knots, as approximations leave them: C2 and no smoother.
struct WavyCubic
{
    KnotVector knots;
    RowMatrix poles;

    explicit WavyCubic(int spans) : knots(clamped_knots(3, 0.0, 1.0, even(spans)))
    {
        RandomCases random;
        poles.resize(knots.pole_count(), 3);
        for (int i = 0; i < knots.pole_count(); ++i)
            poles.row(i) << 100.0 * i / knots.pole_count(), random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1);
    }

    static std::vector<double> even(int spans)
    {
        std::vector<double> interior;
        for (int k = 1; k < spans; ++k)
            interior.push_back(static_cast<double>(k) / spans);
        return interior;
    }

    [[nodiscard]] RowMatrix values(const std::vector<double> &parameters) const
    {
        const BasisRows rows(knots, parameters);
        RowMatrix points = RowMatrix::Zero(rows.rows(), 3);
        for (int k = 0; k < rows.rows(); ++k)
            for (int i = 0; i < rows.width(); ++i)
                points.row(k) += rows.row(k)[i] * poles.row(rows.first(k) + i);
        return points;
    }
};

TEST(JoinedFit, FollowsACurveThatIsTwiceDifferentiableWithItsOwnPoles)
{
    for (const int spans : {5, 40, 90})
    {
        const WavyCubic wavy(spans);
        SmoothCurve curve{[&](const std::vector<double> &t) { return wavy.values(t); }, wavy.knots.breaks()};
        std::vector<DataBreak> joins;
        for (const double knot : WavyCubic::even(spans))
            joins.push_back({knot, 2});
        const auto fit = joined_fit(curve, joins, 1e-9);
        ASSERT_TRUE(fit) << spans;
        EXPECT_EQ(fit->knots.degree, 3);
        EXPECT_EQ(fit->knots.pole_count(), wavy.knots.pole_count());
        EXPECT_LT((fit->poles - wavy.poles).cwiseAbs().maxCoeff(), 1e-8);
    }
}

TEST(SmoothFit, GivesKinksUp)
{
    const auto kinked = [](double t) -> Eigen::Vector3d { return {100.0 * t, 20.0 * std::abs(t - 0.37), 0.0}; };
    EXPECT_FALSE(smooth_fit(smooth(kinked), 1e-6));
}
