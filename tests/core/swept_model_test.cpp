// SPDX-License-Identifier: LGPL-2.1-or-later
// Splines that stand for surfaces of revolution and extruded conics, against OpenCASCADE's evaluation of the
// surfaces themselves; the functions below them in long double; offsets and limits against closed forms.
#include "support/deviation.h"
#include "support/offset_oracle.h"
#include "support/offsets.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/analysis/curvature.h>
#include <laminate_offset/analysis/swept_model.h>
#include <laminate_offset/offset_limits.h>
#include <laminate_offset/spline/conic_functions.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Dense>
#include <GeomLProp_SLProps.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace laminate_offset;
using namespace test_support;

namespace
{

constexpr double turn = 2.0 * M_PI;

struct Sample
{
    std::string name;
    Handle(Geom_Surface) surface;
    ParameterBox box;
    double size = 1.0;      //!< [mm] of the face, for distances
    bool one_point = false; //!< a side is a point
};

//! Axes in the x-z plane: the first one away from the axis of revolution, the second one along it.
gp_Ax2 meridian(double x, double z = 0.0) { return {gp_Pnt(x, 0.0, z), gp_Dir(0.0, -1.0, 0.0), gp_Dir(1.0, 0.0, 0.0)}; }

gp_Ax1 axis(double s) { return {gp_Pnt(0.0, 0.0, 0.3 * s), gp_Dir(0.0, 0.0, 1.0)}; }

Handle(Geom_BezierCurve) bezier(double s, const std::vector<gp_XYZ> &points, const std::vector<double> &weights = {})
{
    TColgp_Array1OfPnt poles(1, static_cast<int>(points.size()));
    TColStd_Array1OfReal w(1, poles.Length());
    for (int i = 1; i <= poles.Length(); ++i)
    {
        poles(i) = gp_Pnt(s * points[static_cast<std::size_t>(i) - 1]);
        w(i) = weights.empty() ? 1.0 : weights[static_cast<std::size_t>(i) - 1];
    }
    return weights.empty() ? new Geom_BezierCurve(poles) : new Geom_BezierCurve(poles, w);
}

Handle(Geom_BSplineCurve) cubic(double s, const std::vector<gp_XYZ> &points)
{
    TColgp_Array1OfPnt poles(1, static_cast<int>(points.size()));
    for (int i = 1; i <= poles.Length(); ++i)
        poles(i) = gp_Pnt(s * points[static_cast<std::size_t>(i) - 1]);
    const int spans = poles.Length() - 3;
    TColStd_Array1OfReal knots(1, spans + 1);
    TColStd_Array1OfInteger multiplicities(1, spans + 1);
    for (int i = 0; i <= spans; ++i)
    {
        knots(i + 1) = 0.5 * i;
        multiplicities(i + 1) = i == 0 || i == spans ? 4 : 1;
    }
    return new Geom_BSplineCurve(poles, knots, multiplicities, 3);
}

Handle(Geom_Surface) turned(const Handle(Geom_Curve) & profile, double s)
{
    return new Geom_SurfaceOfRevolution(profile, axis(s));
}

Handle(Geom_Surface) extruded(const Handle(Geom_Curve) & profile)
{
    return new Geom_SurfaceOfLinearExtrusion(profile, gp_Dir(0.2, -0.1, 1.0));
}

std::vector<Sample> revolutions(double s)
{
    const auto vase = cubic(s, {{30, 0, 0}, {42, 0, 20}, {28, 0, 45}, {26, 0, 70}, {35, 0, 100}});
    const auto skew = cubic(s, {{30, 0, 0}, {42, 10, 20}, {28, 20, 45}, {26, 22, 70}, {35, 15, 100}});
    const auto nose = bezier(s, {{0, 0, 100}, {25, 0, 100}, {45, 0, 60}, {50, 0, 0}});
    const auto rational = bezier(s, {{40, 0, 0}, {60, 0, 30}, {35, 0, 80}}, {1.0, 0.7, 1.3});
    const Handle(Geom_Ellipse) ellipse = new Geom_Ellipse(meridian(0.0), 50 * s, 30 * s);
    const Handle(Geom_Parabola) parabola =
        new Geom_Parabola(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 0), gp_Dir(0, 0, 1)), 20 * s);
    return {
        {"vase, full turn", turned(vase, s), {0.0, turn, 0.0, 1.0}, 60 * s},
        {"vase, part", turned(vase, s), {0.7, 2.9, 0.1, 0.9}, 60 * s},
        {"vase, across the seam", turned(vase, s), {5.9, 7.1, 0.1, 0.9}, 60 * s},
        {"skew profile", turned(skew, s), {0.0, turn, 0.0, 1.0}, 60 * s},
        {"nose with a pole", turned(nose, s), {0.0, turn, 0.0, 1.0}, 60 * s, true},
        {"rational profile", turned(rational, s), {-0.5, 1.5, 0.0, 1.0}, 60 * s},
        {"circle off the axis", turned(new Geom_Circle(meridian(50 * s), 12 * s), s), {0.0, turn, -1.0, 2.0}, 20 * s},
        {"ellipse off the axis",
         turned(new Geom_Ellipse(meridian(90 * s, s), 50 * s, 30 * s), s),
         {0.1, 2.0, 0.0, turn},
         60 * s},
        {"ellipsoid with poles",
         turned(new Geom_TrimmedCurve(ellipse, 1.5 * M_PI, 2.5 * M_PI), s),
         {0.0, turn, 1.5 * M_PI, 2.5 * M_PI},
         50 * s,
         true},
        {"ellipsoid's belt", turned(ellipse, s), {0.0, 3.0, -1.2, 1.1}, 50 * s},
        {"hyperboloid", turned(new Geom_Hyperbola(meridian(0.0), 50 * s, 30 * s), s), {0.0, turn, -1.0, 1.2}, 50 * s},
        {"paraboloid with a pole",
         turned(new Geom_TrimmedCurve(parabola, 0.0, 50 * s), s),
         {0.0, turn, 0.0, 50 * s},
         50 * s,
         true},
        {"cone of a line",
         turned(new Geom_Line(gp_Pnt(20 * s, 0, 0), gp_Dir(1, 0, 2)), s),
         {0.0, turn, 0.0, 60 * s},
         60 * s},
        {"hyperboloid of a line",
         turned(new Geom_Line(gp_Pnt(30 * s, 0, 0), gp_Dir(0.1, 1, 1)), s),
         {0.0, 4.0, -20 * s, 60 * s},
         60 * s},
    };
}

std::vector<Sample> extrusions(double s)
{
    const gp_Ax2 plane(gp_Pnt(5 * s, 0, 0), gp_Dir(0, 0.3, 1));
    return {
        {"extruded circle", extruded(new Geom_Circle(plane, 40 * s)), {0.0, turn, 0.0, 70 * s}, 50 * s},
        {"extruded ellipse", extruded(new Geom_Ellipse(plane, 50 * s, 30 * s)), {0.3, 4.0, 0.0, 70 * s}, 50 * s},
        {"extruded hyperbola", extruded(new Geom_Hyperbola(plane, 50 * s, 30 * s)), {-1.0, 1.3, 0.0, 70 * s}, 50 * s},
        {"extruded parabola", extruded(new Geom_Parabola(plane, 20 * s)), {-40 * s, 60 * s, 0.0, 70 * s}, 50 * s},
        {"extruded line",
         extruded(new Geom_Line(gp_Pnt(0, 0, 0), gp_Dir(1, 1, 0))),
         {0.0, 60 * s, 0.0, 70 * s},
         50 * s},
    };
}

std::vector<Sample> samples(double s)
{
    std::vector<Sample> all = revolutions(s);
    for (const Sample &sample : extrusions(s))
        all.push_back(sample);
    return all;
}

TopoDS_Face face_of(const Sample &sample)
{
    return BRepBuilderAPI_MakeFace(sample.surface, sample.box.umin, sample.box.umax, sample.box.vmin, sample.box.vmax,
                                   1e-7);
}

std::vector<double> spread(double low, double high, int count, double first)
{
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(low + (high - low) * std::fmod(first + 0.6180339887498949 * i, 1.0));
    values.push_back(low);
    values.push_back(high);
    std::sort(values.begin(), values.end());
    return values;
}

//! The model's points, normals and curvatures against those of the surface.
void expect_model(const Sample &sample, const ModelDemand &demand)
{
    SCOPED_TRACE(testing::Message() << sample.name << " distance " << demand.distance << " tolerance "
                                    << demand.tolerance);
    const std::optional<SweptModel> model = swept_model(sample.surface, sample.box, demand);
    ASSERT_TRUE(model.has_value());
    EXPECT_LE(model->error.of_offset(demand.distance), 0.1 * demand.tolerance);
    const std::vector<double> us = spread(sample.box.umin, sample.box.umax, 41, 0.1);
    const std::vector<double> vs = spread(sample.box.vmin, sample.box.vmax, 37, 0.2);
    const std::vector<SurfaceJet> jets = model->spline.jets(us, vs, 1);
    // what OpenCASCADE's own evaluation rounds
    const double rounding = 1e-14 * (sample.size + std::abs(sample.box.vmax));
    int normals = 0;
    for (std::size_t k = 0; k < jets.size(); ++k)
    {
        const double u = us[k / vs.size()];
        const double v = vs[k % vs.size()];
        gp_Pnt p;
        gp_Vec du, dv;
        sample.surface->D1(u, v, p, du, dv);
        const SurfaceJet &jet = jets[k];
        ASSERT_LE((jet.s - Eigen::Vector3d(p.X(), p.Y(), p.Z())).norm(), model->error.point + rounding)
            << u << " " << v;
        const gp_Vec cross = du.Crossed(dv);
        if (du.Magnitude() * (sample.box.umax - sample.box.umin) < 1e-3 * sample.size)
            continue;
        const Eigen::Vector3d n = Eigen::Vector3d(cross.X(), cross.Y(), cross.Z()).normalized();
        ASSERT_LE((jet.u.cross(jet.v).normalized() - n).norm(), model->error.normal + 1e-12) << u << " " << v;
        ++normals;
    }
    EXPECT_GT(normals, static_cast<int>(jets.size()) / 2);
}

//! Curvatures on the strip's middle line.
void expect_strip(const Sample &sample, const ModelDemand &demand)
{
    SCOPED_TRACE(sample.name);
    const std::optional<SweptModel> model = swept_model(sample.surface, sample.box, demand);
    ASSERT_TRUE(model.has_value());
    const CurvatureStrip &strip = model->strip;
    const ParameterBox &box = sample.box;
    int compared = 0;
    for (const double t : spread(strip.along_u ? box.umin : box.vmin, strip.along_u ? box.umax : box.vmax, 50, 0.3))
    {
        const double across = strip.along_u ? 0.4 * box.vmin + 0.6 * box.vmax : 0.4 * box.umin + 0.6 * box.umax;
        GeomLProp_SLProps local(sample.surface, strip.along_u ? t : across, strip.along_u ? across : t, 2, 1e-12);
        gp_Vec du = local.D1U();
        if (du.Magnitude() * (box.umax - box.umin) < 1e-3 * sample.size)
            continue;
        const std::vector<double> along{t};
        const std::vector<double> middle{strip.middle};
        SurfaceJet jet =
            (strip.along_u ? strip.spline.jets(along, middle, 2) : strip.spline.jets(middle, along, 2)).front();
        const auto k = principal_curvatures(jet);
        ASSERT_TRUE(k.has_value());
        const double low = std::min(local.MinCurvature(), local.MaxCurvature());
        const double high = std::max(local.MinCurvature(), local.MaxCurvature());
        const double largest = std::max(std::abs(low), std::abs(high));
        const double room = model->error.curvature + (model->error.curvature_ratio + 1e-9) * largest;
        EXPECT_NEAR(k->first, low, room) << t;
        EXPECT_NEAR(k->second, high, room) << t;
        ++compared;
    }
    EXPECT_GT(compared, 30);
}

//! Proven bounds that hold against dense sampling of the surface itself.
void expect_proven(const TopoDS_Face &face, double distance, double tolerance)
{
    SCOPED_TRACE(testing::Message() << "distance " << distance << " tolerance " << tolerance);
    const auto result = offset(face, distance, tolerance);
    ASSERT_TRUE(result.ok()) << why(result);
    const OffsetReport &report = result.value().report;
    ASSERT_TRUE(report.certified_error && report.edge_error);
    EXPECT_LE(*report.certified_error, tolerance);
    EXPECT_LE(*report.edge_error, tolerance);
    if (report.surface->type != "bspline") // a plane, cylinder, cone, sphere or torus in disguise
        return;
    Rectangle box;
    BRepTools::UVBounds(face, box.u0, box.u1, box.v0, box.v1);
    const double along = face.Orientation() == TopAbs_REVERSED ? -distance : distance;
    const Deviation d = deviation(BRep_Tool::Surface(face), BRep_Tool::Surface(result.value().face()), box, along, 53);
    EXPECT_GT(d.points, 53 * 53 / 2);
    EXPECT_GE(*report.certified_error * (1.0 + 1e-9) + 1e-13, d.largest) << "the proven bound is none";
    EXPECT_GT(d.least_cosine, 0.99);
}

} // namespace

TEST(ConicFunctions, StayWithinTheirErrors)
{
    RandomCases random;
    for (int i = 0; i < 60; ++i)
    {
        const ConicKind kind = i % 2 == 0 ? ConicKind::Circle : ConicKind::Hyperbola;
        const double low = random.uniform(-4.0, 2.0);
        const double high = i % 6 == 0 ? low + turn : low + random.magnitude(1e-3, 6.0);
        const double value = random.magnitude(1e-12, 1e-2);
        const ConicErrors wanted{value, 30.0 * value, std::max(1e-9, 1e3 * value)};
        SCOPED_TRACE(testing::Message() << i << " on " << low << ".." << high << " within " << value);
        const std::optional<ConicSpline> spline = conic_spline(kind, low, high, wanted);
        if (!spline)
        {
            EXPECT_LT(value, 1e-10) << "only rounding may forbid it";
            continue;
        }
        EXPECT_LE(spline->errors.value, wanted.value);
        EXPECT_LE(spline->errors.slope, wanted.slope);
        EXPECT_LE(spline->errors.bend, wanted.bend);
        const int degree = spline->knots.degree;
        std::vector<double> basis(static_cast<std::size_t>(3 * (degree + 1)));
        for (const double t : spread(low, high, 400, 0.37))
        {
            const int span = spline->knots.span(t);
            basis_derivatives(spline->knots, span, t, 2, basis.data());
            const long double c = kind == ConicKind::Circle ? std::cos(static_cast<long double>(t))
                                                            : std::cosh(static_cast<long double>(t));
            const long double s = kind == ConicKind::Circle ? std::sin(static_cast<long double>(t))
                                                            : std::sinh(static_cast<long double>(t));
            const long double sign = kind == ConicKind::Circle ? -1.0L : 1.0L;
            const long double exact[3][2] = {{c, s}, {sign * s, c}, {sign * c, sign * s}};
            const double bounds[3] = {spline->errors.value, spline->errors.slope, spline->errors.bend};
            for (int d = 0; d < 3; ++d)
            {
                long double x = -exact[d][0];
                long double y = -exact[d][1];
                for (int k = 0; k <= degree; ++k)
                {
                    const Eigen::Vector2d &pole = spline->poles[static_cast<std::size_t>(span - degree + k)];
                    x += static_cast<long double>(basis[static_cast<std::size_t>(d * (degree + 1) + k)]) * pole.x();
                    y += static_cast<long double>(basis[static_cast<std::size_t>(d * (degree + 1) + k)]) * pole.y();
                }
                const long double scale = kind == ConicKind::Circle ? 1.0L : c;
                ASSERT_LE(std::hypot(x, y) / scale, bounds[d] * 1.001L) << "derivative " << d << " at " << t;
            }
        }
    }
}

TEST(ConicFunctions, CloseAFullTurnExactly)
{
    for (const double first : {0.0, 0.7, -3.0, 5.0})
    {
        const auto circle = conic_spline(ConicKind::Circle, first, first + turn, {1e-6, 1e-5, 1e-3});
        ASSERT_TRUE(circle.has_value());
        EXPECT_EQ(circle->poles.front(), circle->poles.back());
    }
    const auto quarter = conic_spline(ConicKind::Circle, 0.0, 0.5 * M_PI, {1e-6, 1e-5, 1e-3});
    ASSERT_TRUE(quarter.has_value());
    EXPECT_EQ(quarter->poles.front(), Eigen::Vector2d(1.0, 0.0));
    EXPECT_EQ(quarter->poles.back(), Eigen::Vector2d(0.0, 1.0));
}

TEST(SweptModel, StaysWithinItsErrorsForEveryProfileAndTolerance)
{
    for (const Sample &sample : samples(1.0))
        for (const double tolerance : {1e-1, 1e-3, 1e-6})
            expect_model(sample, {2.0, tolerance});
}

TEST(SweptModel, WorksForEverySize)
{
    for (const double scale : {1e-5, 1e-2, 1e2, 1e4})
        for (const Sample &sample : samples(scale))
            for (const double part : {1e-3, 1e-5})
                expect_model(sample, {0.05 * sample.size, part * sample.size});
}

TEST(SweptModel, HasTheSurfacesCurvaturesOnItsStrip)
{
    for (const Sample &sample : samples(1.0))
        expect_strip(sample, {2.0, 1e-3});
}

TEST(SweptModel, ClosesItsSeamAndItsPolesExactly)
{
    for (const Sample &sample : revolutions(1.0))
    {
        SCOPED_TRACE(sample.name);
        const std::optional<SweptModel> model = swept_model(sample.surface, sample.box, {2.0, 1e-3});
        ASSERT_TRUE(model.has_value());
        const TensorSpline &s = model->spline;
        const int last_u = s.u.pole_count() - 1;
        const int last_v = s.v.pole_count() - 1;
        const bool full_turn = sample.box.umax - sample.box.umin == turn;
        for (int j = 0; full_turn && j <= last_v; ++j)
            EXPECT_EQ(s.pole(0, j), s.pole(last_u, j));
        bool collapsed = false;
        for (const int j : {0, last_v})
        {
            bool same = true;
            for (int i = 1; i <= last_u; ++i)
                same = same && s.pole(i, j) == s.pole(0, j);
            collapsed = collapsed || same;
        }
        EXPECT_EQ(collapsed, sample.one_point);
    }
}

TEST(SweptModel, IsNotClaimedWhereItCannotBeProven)
{
    const ModelDemand demand{2.0, 1e-3};
    const Handle(Geom_Curve) arc = new Geom_TrimmedCurve(new Geom_Circle(meridian(50.0), 12.0), 0.1, 1.0);
    const Handle(Geom_Curve) beside = new Geom_OffsetCurve(arc, 3.0, gp_Dir(0, 1, 0));
    EXPECT_FALSE(swept_model(turned(beside, 1.0), {0.0, 1.0, 0.1, 1.0}, demand)) << "an offset curve";
    const Handle(Geom_Surface) spindle = turned(new Geom_Circle(meridian(5.0), 12.0), 1.0);
    EXPECT_FALSE(swept_model(spindle, {0.0, 1.0, 0.1, 3.0}, demand)) << "a circle across the axis";
    const Sample vase = samples(1.0).front();
    EXPECT_FALSE(swept_model(vase.surface, vase.box, {2.0, 1e-16})) << "below rounding";
    EXPECT_FALSE(swept_model(vase.surface, {0.0, 0.0, 0.0, 1.0}, demand)) << "an empty box";
}

TEST(SweptOffset, IsProvenForEveryProfileOnBothSides)
{
    for (const Sample &sample : samples(1.0))
        for (const double distance : {1.5, -1.5})
        {
            SCOPED_TRACE(sample.name);
            expect_proven(face_of(sample), distance, 1e-3);
        }
}

TEST(SweptOffset, IsProvenAtEveryTolerance)
{
    const std::vector<Sample> all = samples(1.0);
    for (const std::size_t i : {std::size_t{1}, std::size_t{5}, std::size_t{15}})
        for (const double tolerance : {1e-1, 1e-2, 1e-4, 1e-6})
        {
            SCOPED_TRACE(all[i].name);
            expect_proven(face_of(all[i]), -2.0, tolerance);
        }
}

TEST(SweptOffset, IsConfirmedByTheOracleInEveryPosition)
{
    const std::vector<Sample> all = samples(1.0);
    for (const std::size_t i : {std::size_t{0}, std::size_t{3}, std::size_t{16}})
        for (const TopoDS_Face &face :
             {face_of(all[i]), reversed(face_of(all[i])), located(face_of(all[i])), reversed(located(face_of(all[i])))})
        {
            SCOPED_TRACE(all[i].name);
            const auto result = offset(face, 1.5, 1e-3);
            ASSERT_TRUE(result.ok()) << why(result);
            const OracleReport report = measure_offset(face, result.value().face(), 1.5, {40, 40});
            EXPECT_TRUE(confirms(report, 1e-3)) << to_text(report);
        }
}

TEST(SweptOffset, OfAnOffsetCurveIsStillSampled)
{
    const Handle(Geom_Curve) arc = new Geom_TrimmedCurve(new Geom_Circle(meridian(50.0), 12.0), 0.1, 1.0);
    const Handle(Geom_Curve) beside = new Geom_OffsetCurve(arc, 3.0, gp_Dir(0, 1, 0));
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(turned(beside, 1.0), 0.0, 1.0, 0.1, 1.0, 1e-7);
    const auto result = offset(face, 2.0, 1e-3);
    ASSERT_TRUE(result.ok()) << why(result);
    EXPECT_FALSE(result.value().report.certified_error.has_value());
    EXPECT_TRUE(result.value().report.sampled_error.has_value());
}

namespace
{

//! The limits are proven, never past the true ones, and give little away. S_u x S_v decides the side.
void expect_limits(const Sample &sample, std::optional<double> along, std::optional<double> against, bool proven = true)
{
    SCOPED_TRACE(sample.name);
    const auto limits = offset_limits(face_of(sample));
    ASSERT_TRUE(limits.ok()) << limits.failure().message;
    EXPECT_EQ(limits.value().proven, proven);
    const auto expect = [](const std::optional<OffsetLimit> &limit, const std::optional<double> &radius) {
        ASSERT_EQ(limit.has_value(), radius.has_value());
        if (!radius)
            return;
        EXPECT_LE(limit->distance / *radius, 1.0 + 1e-12);
        EXPECT_GE(limit->distance / *radius, 1.0 - 2e-3);
    };
    expect(limits.value().positive, along);
    expect(limits.value().negative, against);
}

} // namespace

TEST(SweptLimits, AreThoseOfATorus)
{
    // S_u x S_v points outwards; the inner side of the tube bends the other way with radius R / cos - r
    const Handle(Geom_Surface) tube = turned(new Geom_Circle(meridian(50.0), 12.0), 1.0);
    expect_limits({"whole", tube, {0.0, turn, 0.0, turn}}, 38.0, -12.0);
    expect_limits({"outer side", tube, {0.0, 2.0, -1.4, 1.4}}, std::nullopt, -12.0);
}

TEST(SweptLimits, AreThoseOfAnEllipsoidAndItsBelt)
{
    // radii a = 50 across and b = 30 along: the meridian bends most at the equator, b b / a = 18
    const Handle(Geom_Ellipse) ellipse = new Geom_Ellipse(meridian(0.0), 50.0, 30.0);
    expect_limits({"belt", turned(ellipse, 1.0), {0.0, turn, -1.0, 1.2}}, std::nullopt, -18.0);
    // away from the equator the meridian's radius at v is (a a sin^2 + b b cos^2)^(3/2) / (a b)
    const double radius = std::pow(std::pow(50.0 * std::sin(0.6), 2) + std::pow(30.0 * std::cos(0.6), 2), 1.5) / 1500.0;
    expect_limits({"part", turned(ellipse, 1.0), {0.2, 1.0, 0.6, 1.2}}, std::nullopt, -radius);
}

TEST(SweptLimits, AreThoseOfExtrudedConics)
{
    const gp_Ax2 plane(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
    const auto straight = [](const Handle(Geom_Curve) & profile) -> Handle(Geom_Surface) {
        return new Geom_SurfaceOfLinearExtrusion(profile, gp_Dir(0, 0, 1));
    };
    for (const double scale : {1e-2, 1.0, 1e2, 1e4})
        expect_limits(
            {"ellipse", straight(new Geom_Ellipse(plane, 50 * scale, 30 * scale)), {0.0, turn, 0.0, 40.0 * scale}},
            std::nullopt, -18.0 * scale);
    expect_limits({"parabola", straight(new Geom_Parabola(plane, 20)), {-30.0, 40.0, 0.0, 40.0}}, 40.0, std::nullopt);
    expect_limits({"hyperbola", straight(new Geom_Hyperbola(plane, 50, 30)), {-1.0, 0.7, 0.0, 40.0}}, 18.0,
                  std::nullopt);
    expect_limits({"line", straight(new Geom_Line(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0))), {0.0, 30.0, 0.0, 40.0}},
                  std::nullopt, std::nullopt);
}
