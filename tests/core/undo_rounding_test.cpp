// SPDX-License-Identifier: LGPL-2.1-or-later
// What rounding has made of a base: tips whose poles miss each other, weights that differ in their last digits.
#include "support/offset_oracle.h"
#include "support/offsets.h"
#include "support/sample_faces.h"

#include <laminate_offset/analysis/base_surface.h>
#include <laminate_offset/spline/undo_rounding.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <gtest/gtest.h>

#include <random>

using namespace laminate_offset;
using namespace test_support;

namespace
{

struct Tip
{
    int order = 1;      //!< the width falls with this power of the distance from the tip
    double noise = 0.0; //!< largest miss of the poles that are meant to coincide [mm]
    bool along_v = false;
    bool at_start = false;
    double size = 20.0; //!< length of the patch [mm]
};

//! A bicubic patch over x from 0 to the size, bent along x and arched across, whose width vanishes at its end.
Handle(Geom_BSplineSurface) patch(const Tip &tip)
{
    const double width[2][4] = {{1.0, 2.0 / 3.0, 1.0 / 3.0, 0.0}, {1.0, 1.0 / 3.0, 0.0, 0.0}};
    const double arch[2][4] = {{1.0, 0.3, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}};
    const double bend[4] = {0.0, 0.0, 0.05, 0.15};
    const int k = tip.order - 1;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> part(-0.3, 0.3);
    TColgp_Array2OfPnt poles(1, 4, 1, 4);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
        {
            const double noise = width[k][i] == 0.0 ? tip.noise / tip.size : 0.0;
            const double across = 0.2 * width[k][i] * (j / 3.0 - 0.5);
            const gp_XYZ point(i / 3.0, across, bend[i] + 0.03 * arch[k][i] * (j == 1 || j == 2));
            poles(i + 1, j + 1) = gp_Pnt((point + gp_XYZ(part(random), part(random), part(random)) * noise) * tip.size);
        }
    const Handle(Geom_BSplineSurface) surface = GeomConvert::SurfaceToBSplineSurface(new Geom_BezierSurface(poles));
    if (tip.at_start)
        surface->UReverse();
    if (tip.along_v)
        surface->ExchangeUV();
    return surface;
}

TopoDS_Face face_of(const Tip &tip) { return BRepBuilderAPI_MakeFace(patch(tip), 1e-7).Face(); }

BaseSurface base_of(const Handle(Geom_BSplineSurface) & surface)
{
    return {surface, {0.0, 1.0, 0.0, 1.0}, ModelDemand{0.02, 1e-3}};
}

} // namespace

TEST(UndoRounding, TipsThatFilesHaveRoundedAreOffset)
{
    constexpr double tolerance = 1e-3;
    for (const int order : {1, 2})
        for (const double noise : {0.0, 1e-15, 1e-14, order == 1 ? 1e-13 : 3e-14})
            for (const bool along_v : {false, true})
                for (const bool at_start : {false, true})
                    for (const double distance : {-0.02, 0.02, order == 1 ? 0.3 : -0.03})
                    {
                        SCOPED_TRACE(testing::Message()
                                     << "order " << order << " noise " << noise << " along v " << along_v
                                     << " at start " << at_start << " distance " << distance);
                        const TopoDS_Face base = face_of({order, noise, along_v, at_start});
                        const auto made = offset(base, distance, tolerance);
                        ASSERT_TRUE(made.ok()) << why(made);
                        const OracleReport seen = measure_offset(base, made.value().face(), distance, {40, 40});
                        EXPECT_TRUE(confirms(seen, tolerance));
                        EXPECT_GT(seen.points, 1000);
                        const auto certified = made.value().report.certified_error;
                        ASSERT_TRUE(certified.has_value());
                        EXPECT_LE(*certified, tolerance);
                        EXPECT_LE(std::max(seen.surface_error, seen.converse_error), *certified);
                    }
}

namespace
{

//! S + distance N of a bicubic Bezier patch over [0, 1]^2, in extended precision.
gp_Pnt exact_offset(const Geom_BSplineSurface &patch, double u, double v, double distance, gp_Pnt &base)
{
    using Extended = long double;
    const auto weights = [](Extended t, Extended value[4], Extended slope[4]) {
        const Extended s = 1 - t;
        const Extended b[] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
        const Extended d[] = {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
        std::copy(b, b + 4, value);
        std::copy(d, d + 4, slope);
    };
    Extended bu[4], bv[4], du[4], dv[4], sum[3][3] = {};
    weights(u, bu, du);
    weights(v, bv, dv);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            for (int e = 0; e < 3; ++e)
            {
                const Extended pole = patch.Pole(i + 1, j + 1).Coord(e + 1);
                const Extended step_u = pole - patch.Pole(1, j + 1).Coord(e + 1);
                const Extended step_v = pole - patch.Pole(i + 1, 1).Coord(e + 1);
                sum[0][e] += bu[i] * bv[j] * pole;
                sum[1][e] += du[i] * bv[j] * step_u;
                sum[2][e] += bu[i] * dv[j] * step_v;
            }
    Extended n[3];
    for (int e = 0; e < 3; ++e)
        n[e] = sum[1][(e + 1) % 3] * sum[2][(e + 2) % 3] - sum[1][(e + 2) % 3] * sum[2][(e + 1) % 3];
    const Extended length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const auto point = [&](Extended d) {
        return gp_Pnt(static_cast<double>(sum[0][0] + d * n[0] / length),
                      static_cast<double>(sum[0][1] + d * n[1] / length),
                      static_cast<double>(sum[0][2] + d * n[2] / length));
    };
    base = point(0);
    return point(distance);
}

} // namespace

// The given surface's own normals, ever nearer to the tip: the certificate holds down to the tolerance, wherever the face lies.
TEST(UndoRounding, TheCertificateHoldsNearTipsWhereverTheyLie)
{
    int made = 0, judged = 0;
    for (const int order : {1, 2})
        for (const double away : {0.0, 1e2, 1e4})
            for (const double roundings : {0.0, 4.0, 30.0, 1000.0})
                for (const double distance : {-0.02, 0.02})
                    for (const double tolerance : {1e-2, 1e-4})
                    {
                        SCOPED_TRACE(testing::Message()
                                     << "order " << order << " away " << away << " roundings " << roundings
                                     << " distance " << distance << " tolerance " << tolerance);
                        const double noise = roundings * std::numeric_limits<double>::epsilon() * (20.0 + away);
                        const Handle(Geom_BSplineSurface) surface = patch({order, noise});
                        surface->Translate(gp_Vec(away, 0.3 * away, -away));
                        const auto result = offset(BRepBuilderAPI_MakeFace(surface, 1e-7).Face(), distance, tolerance);
                        if (!result.ok())
                            continue;
                        ++made;
                        const auto offset_surface = BRep_Tool::Surface(result.value().face());
                        const double certified = result.value().report.certified_error.value();
                        const gp_Pnt tip = surface->Value(1.0, 0.5);
                        for (double from = 1.0; from > 1e-9; from *= 0.6)
                            for (const double v : {0.1, 0.35, 0.6, 0.9})
                            {
                                gp_Pnt point;
                                const gp_Pnt exact = exact_offset(*surface, 1.0 - from, v, distance, point);
                                if (point.Distance(tip) <= tolerance)
                                    continue;
                                EXPECT_LE(exact.Distance(offset_surface->Value(1.0 - from, v)), certified + 1e-9)
                                    << "at " << from << ' ' << v;
                                ++judged;
                            }
                    }
    EXPECT_GE(made, 50);
    EXPECT_GE(judged, 2000);
}

TEST(UndoRounding, HowFarTheSurfaceMovesIsToldAndNoLess)
{
    for (const int order : {1, 2})
        for (const double noise : {1e-15, 1e-14, 1e-13})
        {
            SCOPED_TRACE(testing::Message() << "order " << order << " noise " << noise);
            const Handle(Geom_BSplineSurface) surface = patch({order, noise});
            const BaseSurface base = base_of(surface);
            EXPECT_GT(base.model_error().point, 0.0);
            EXPECT_LE(base.model_error().point, 2.0 * noise + 1e-5) << "a hundredth of the tolerance for the normals";
            const TensorSpline &closed = *base.spline();
            const double rounding = 1e-14;
            for (double u = 0.0; u <= 1.0; u += 0.0625)
                for (double v = 0.0; v <= 1.0; v += 0.125)
                {
                    const gp_Pnt point = surface->Value(u, v);
                    const Eigen::Vector3d moved = closed.jets({u}, {v}, 0).front().s;
                    EXPECT_LE((moved - Eigen::Vector3d(point.X(), point.Y(), point.Z())).norm(),
                              base.model_error().point + rounding);
                }
            for (int j = 1; j < closed.v.pole_count(); ++j)
                EXPECT_EQ(closed.pole(3, j), closed.pole(3, 0));
        }
}

// A side that is short but no point keeps its poles.
TEST(UndoRounding, ShortSidesStayAsTheyAre)
{
    for (const Tip &tip : {Tip{1, 1e-9}, Tip{2, 1e-5}, Tip{1, 1e-12, false, false, 0.02}})
    {
        SCOPED_TRACE(testing::Message() << "order " << tip.order << " noise " << tip.noise << " size " << tip.size);
        const Handle(Geom_BSplineSurface) surface = patch(tip);
        const BaseSurface base = base_of(surface);
        EXPECT_EQ(base.model_error().point, 0.0);
        const TensorSpline own = from_geom(surface);
        for (std::size_t i = 0; i < own.poles.size(); ++i)
            EXPECT_EQ(base.spline()->poles[i], own.poles[i]);
    }
}

namespace
{

//! A wavy net whose weights are one constant but for some digits.
Handle(Geom_BSplineSurface) nearly_even(double difference, double away = 0.0)
{
    const Handle(Geom_BSplineSurface) surface =
        height_surface([](double x, double y) { return std::sin(0.2 * x) * std::cos(0.15 * y); }, 20.0, 15.0, 6, 5);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> digit(0.0, difference);
    for (int i = 1; i <= surface->NbUPoles(); ++i)
        for (int j = 1; j <= surface->NbVPoles(); ++j)
        {
            surface->SetPole(i, j, surface->Pole(i, j).Translated(gp_Vec(away, 0.0, 0.0)));
            surface->SetWeight(i, j, 0.7 * (1.0 + digit(random)));
        }
    return surface;
}

} // namespace

TEST(UndoRounding, WeightsThatAreOneConstantAreOneWithinTheBound)
{
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    for (const double difference : {1e-15, 1e-14, 9e-14})
        for (const double away : {0.0, 1e3})
        {
            SCOPED_TRACE(testing::Message() << "difference " << difference << " away " << away);
            const Handle(Geom_BSplineSurface) given = nearly_even(difference, away);
            const TensorSpline before = from_geom(given);
            ASSERT_TRUE(before.rational);
            TensorSpline after = before;
            const UndoneRounding undone = undo_rounding(after, 1.0, 1e-3);
            EXPECT_FALSE(after.rational);
            double extent = 0.0, apart = 0.0;
            for (const Eigen::Vector4d &pole : after.poles)
            {
                EXPECT_EQ(pole.w(), 1.0);
                extent = std::max(extent, pole.head<3>().cwiseAbs().maxCoeff());
            }
            const double rounding = 100.0 * epsilon * extent;
            constexpr double shortest_span = 0.3;
            for (double u = 0.01; u < 1.0; u += 0.07)
                for (double v = 0.01; v < 1.0; v += 0.07)
                {
                    const SurfaceJet a = before.jets({u}, {v}, 1).front(), b = after.jets({u}, {v}, 1).front();
                    apart = std::max(apart, (a.s - b.s).norm());
                    const double of_derivative = 2.0 * 3.0 / shortest_span * undone.operations * epsilon * extent;
                    EXPECT_LE((a.u - b.u).norm(), of_derivative + 20.0 * rounding);
                    EXPECT_LE((a.v - b.v).norm(), of_derivative + 20.0 * rounding);
                }
            EXPECT_LE(apart, undone.moved + rounding);
            if (difference > 5e-14 && away == 0.0)
            {
                EXPECT_GT(apart, 1e-3 * undone.moved) << "the bound says something";
            }
        }
}

TEST(UndoRounding, WeightsThatDifferStayAsTheyAre)
{
    const Handle(Geom_BSplineSurface) given = nearly_even(1e-9);
    TensorSpline spline = from_geom(given);
    const UndoneRounding undone = undo_rounding(spline, 1.0, 1e-3);
    EXPECT_TRUE(spline.rational);
    EXPECT_EQ(undone.moved, 0.0);
    EXPECT_EQ(undone.operations, 0.0);
}

TEST(UndoRounding, OffsetsOfNearlyEvenWeightsArePolynomialAndProven)
{
    constexpr double tolerance = 1e-4;
    for (const double difference : {1e-14, 9e-14})
        for (const double distance : {-0.05, 0.05})
        {
            SCOPED_TRACE(testing::Message() << "difference " << difference << " distance " << distance);
            const TopoDS_Face base = BRepBuilderAPI_MakeFace(nearly_even(difference), 1e-7).Face();
            const auto made = offset(base, distance, tolerance);
            ASSERT_TRUE(made.ok()) << why(made);
            const OracleReport seen = measure_offset(base, made.value().face(), distance, {40, 40});
            EXPECT_TRUE(confirms(seen, tolerance));
            const auto &report = made.value().report;
            ASSERT_TRUE(report.certified_error.has_value());
            EXPECT_LE(std::max(seen.surface_error, seen.converse_error), *report.certified_error);
            EXPECT_FALSE(report.surface->rational);
        }
}
