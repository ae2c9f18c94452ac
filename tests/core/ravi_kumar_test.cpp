// SPDX-License-Identifier: LGPL-2.1-or-later
// The paper's route: the interpolated surface, trimming curves in space and their offsets, and whole faces; judged by dense
// sampling with OpenCASCADE and by the oracle that shares no code with the engine.
#include "support/data_files.h"
#include "support/offset_oracle.h"
#include "support/offsets.h"
#include "support/parameters.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/analysis/surface_analysis.h>
#include <laminate_offset/extension/extended_offset.h>
#include <laminate_offset/offset_face.h>
#include <laminate_offset/projection/edge_images.h>
#include <laminate_offset/spline/monotone_map.h>
#include <laminate_offset/surface/certificate.h>
#include <laminate_offset/surface/piegl_tiller.h>
#include <laminate_offset/trimming/check_edges.h>
#include <laminate_offset/trimming/offset_trimming_curve.h>
#include <laminate_offset/trimming/space_curve.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

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

constexpr double rounding = 1e-9;

Handle(Geom_BSplineSurface) hills()
{
    return height_surface([](double x, double y) { return 40.0 * std::sin(x / 180.0) * std::cos(y / 150.0); }, 800.0,
                          500.0, 8, 8);
}

TopoDS_Face whole(const Handle(Geom_Surface) & surface) { return BRepBuilderAPI_MakeFace(surface, 1e-6).Face(); }

Result<OffsetResult> by_ravi_kumar(const TopoDS_Face &face, double distance, double tolerance, double extension = 0.0)
{
    OffsetOptions options;
    options.distance = distance;
    options.extension = extension;
    options.tolerance = tolerance;
    options.method = Method::RaviKumar;
    return offset_face(face, options);
}

//! S + d N by OpenCASCADE alone.
gp_Pnt exact_offset_point(const Handle(Geom_Surface) & surface, double u, double v, double distance)
{
    gp_Pnt p;
    gp_Vec su, sv;
    surface->D1(u, v, p, su, sv);
    return p.Translated(distance * su.Crossed(sv).Normalized());
}

//! A wavy polynomial pcurve inside the unit square.
Handle(Geom2d_Curve) wavy_pcurve()
{
    TColgp_Array1OfPnt2d poles(1, 6);
    const double heights[] = {0.2, 0.7, 0.1, 0.8, 0.3, 0.6};
    for (int i = 0; i < 6; ++i)
        poles(i + 1) = gp_Pnt2d(0.1 + 0.8 * i / 5.0, heights[i]);
    TColStd_Array1OfReal knots(1, 4);
    TColStd_Array1OfInteger multiplicities(1, 4);
    const double parameters[] = {0.0, 0.3, 0.7, 1.0};
    for (int i = 0; i < 4; ++i)
    {
        knots(i + 1) = parameters[i];
        multiplicities(i + 1) = i == 0 || i == 3 ? 4 : 1;
    }
    return new Geom2d_BSplineCurve(poles, knots, multiplicities, 3);
}

//! Largest distance at equal parameters of a curve from the exact offset of a pcurve.
double dense_deviation(const Handle(Geom_Curve) & curve, const CurveOnSurface &c, double distance)
{
    constexpr int samples = 5000;
    double worst = 0.0;
    for (int k = 0; k <= samples; ++k)
    {
        const double t = c.first + (c.last - c.first) * k / samples;
        const gp_Pnt2d uv = c.pcurve->Value(t);
        worst = std::max(worst, curve->Value(t).Distance(exact_offset_point(c.surface, uv.X(), uv.Y(), distance)));
    }
    return worst;
}

//! Signed area of every loop in the parameters of the face's surface, seen along the outward normal: positive for one that
//! runs anticlockwise. In the order of the face's wires.
std::vector<double> loop_areas(const TopoDS_Face &face)
{
    constexpr int samples = 64;
    std::vector<double> areas;
    const double side = face.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
    for (TopExp_Explorer wires(face, TopAbs_WIRE); wires.More(); wires.Next())
    {
        double area = 0.0;
        for (TopExp_Explorer edges(wires.Current(), TopAbs_EDGE); edges.More(); edges.Next())
        {
            const TopoDS_Edge &edge = TopoDS::Edge(edges.Current());
            double first, last;
            const Handle(Geom2d_Curve) c = BRep_Tool::CurveOnSurface(edge, face, first, last);
            const double sense = edge.Orientation() == TopAbs_REVERSED ? -side : side;
            for (int k = 0; k < samples; ++k)
            {
                const gp_Pnt2d a = c->Value(first + (last - first) * k / samples);
                const gp_Pnt2d b = c->Value(first + (last - first) * (k + 1) / samples);
                area += 0.5 * sense * (a.X() * b.Y() - b.X() * a.Y());
            }
        }
        areas.push_back(area);
    }
    return areas;
}

//! The outer loop of a face runs anticlockwise and all others clockwise.
testing::AssertionResult runs_as_the_paper_says(const TopoDS_Face &face)
{
    const std::vector<double> areas = loop_areas(face);
    const auto outer =
        std::max_element(areas.begin(), areas.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    for (auto area = areas.begin(); area != areas.end(); ++area)
        if ((*area > 0.0) != (area == outer))
            return testing::AssertionFailure() << "a loop of area " << *area << " runs the wrong way round";
    return testing::AssertionSuccess();
}

ParameterBox bounds_of(const TopoDS_Face &face)
{
    ParameterBox box;
    BRep_Tool::Surface(face)->Bounds(box.umin, box.umax, box.vmin, box.vmax);
    return box;
}

//! A result with an extended surface keeps all that is promised of one without.
void expect_extended(const TopoDS_Face &base, const Result<OffsetResult> &result, double distance, double length,
                     double tolerance)
{
    ASSERT_TRUE(result.ok()) << why(result);
    const OffsetReport &report = result.value().report;
    ASSERT_TRUE(report.extension.has_value());
    EXPECT_EQ(report.extension->length, length);
    ASSERT_EQ(report.extension->sides.size(), 4u);
    for (const ExtendedSide &side : report.extension->sides)
    {
        EXPECT_NEAR(side.mean_length, length, 0.01 * length);
        EXPECT_LE(side.join_angle, 1e-9);
        EXPECT_EQ(side.moved_edges, 0);
    }
    ASSERT_TRUE(report.certified_error.has_value());
    ASSERT_TRUE(report.edge_error.has_value());
    EXPECT_LE(*report.certified_error, tolerance);
    EXPECT_LE(*report.edge_error, tolerance);
    OracleOptions how;
    how.grid = 40;
    how.edge_points = 100;
    const OracleReport seen = measure_offset(base, result.value().face(), distance, how);
    EXPECT_GT(seen.points, 500);
    EXPECT_LE(seen.surface_error, *report.certified_error + rounding);
    EXPECT_LE(seen.converse_error, *report.certified_error + rounding);
    EXPECT_LE(seen.edge_error, *report.edge_error + rounding);
    EXPECT_LE(seen.edge_converse, *report.edge_error + rounding);
    EXPECT_GT(seen.least_cosine, 0.999);
    EXPECT_EQ(seen.untold_pcurve_error, 0.0);
    EXPECT_EQ(seen.loops, seen.base_loops);
    EXPECT_EQ(seen.edges, seen.base_edges);
    EXPECT_TRUE(seen.valid);
    EXPECT_TRUE(seen.orientation_kept);
    EXPECT_TRUE(seen.same_parameter);
    EXPECT_TRUE(runs_as_the_paper_says(result.value().face()));
}

//! A piecewise constant-speed line in the parameters of a surface, as a curve in space through many of its points.
Handle(Geom_BSplineCurve) interpolated(const Handle(Geom_Surface) & surface, const gp_Pnt2d &from, const gp_Pnt2d &to)
{
    constexpr int count = 60;
    const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, count + 1);
    for (int k = 0; k <= count; ++k)
    {
        const double t = static_cast<double>(k) / count;
        points->SetValue(k + 1, surface->Value(from.X() + t * (to.X() - from.X()), from.Y() + t * (to.Y() - from.Y())));
    }
    GeomAPI_Interpolate through(points, false, 1e-9);
    through.Perform();
    return through.Curve();
}

} // namespace

TEST(MonotoneMap, IncreasesAndTurnsAround)
{
    RandomCases random;
    int bent = 0;
    for (int round = 0; round < 200; ++round)
    {
        std::vector<MonotoneMap::Node> nodes;
        double parameter = random.uniform(-5.0, 5.0);
        double value = random.uniform(-5.0, 5.0);
        for (int i = 0; i < random.integer(2, 8); ++i)
        {
            const double slope = random.magnitude(1e-3, 1e3); // most are too steep or too flat
            nodes.push_back({parameter, value, slope, random.integer(0, 1) == 0 ? slope : random.magnitude(1e-3, 1e3)});
            parameter += random.magnitude(1e-2, 1e2);
            value += random.magnitude(1e-2, 1e2);
        }
        const MonotoneMap map(nodes);
        double last = -std::numeric_limits<double>::infinity();
        for (int k = 0; k <= 500; ++k)
        {
            const double x = nodes.front().parameter + (nodes.back().parameter - nodes.front().parameter) * k / 500.0;
            const double y = map.value(x);
            EXPECT_GT(y, last);
            EXPECT_NEAR(map.value(map.parameter(y)), y, 1e-12 * (1.0 + std::abs(y)));
            last = y;
        }
        bent += nodes.size() > 2 ? 1 : 0;
        for (const MonotoneMap::Node &node : nodes)
            EXPECT_DOUBLE_EQ(map.value(node.parameter), node.value);
    }
    EXPECT_GT(bent, 100);
}

TEST(Reparametrised, IsTheSurfaceThroughTheMap)
{
    RandomCases random;
    for (int round = 0; round < 30; ++round)
    {
        SurfaceKind kind;
        kind.degree_u = random.integer(1, 8);
        kind.degree_v = random.integer(1, 5);
        kind.spans_u = random.integer(1, 4);
        kind.rational = round % 3 == 0;
        const TensorSpline base = from_geom(random_surface(random, kind));
        const auto map = [&](const KnotVector &kv) {
            std::vector<MonotoneMap::Node> nodes;
            double parameter = 0.0;
            for (const double value : kv.breaks())
            {
                const double slope = random.magnitude(1e-3, 1e-1);
                nodes.push_back({parameter, value, slope, slope});
                parameter += random.magnitude(5.0, 50.0);
            }
            return MonotoneMap(nodes);
        };
        const ParameterMap maps{map(base.u), map(base.v)};
        const TensorSpline seen = reparametrised(base, maps);
        const double rounding_unit =
            reparametrisation_operations(base) * std::numeric_limits<double>::epsilon() * 100.0;
        for (int k = 0; k < 40; ++k)
        {
            const double x = random.uniform(seen.u.front(), seen.u.back());
            const double y = random.uniform(seen.v.front(), seen.v.back());
            const Eigen::Vector3d a = seen.jets({x}, {y}, 0).front().s;
            const Eigen::Vector3d b = base.jets({maps.u.value(x)}, {maps.v.value(y)}, 0).front().s;
            EXPECT_LT((a - b).norm(), 4.0 * rounding_unit);
        }
    }
}

TEST(Certificate, PaysForTheRoundingOfTheBase)
{
    const TensorSpline base = from_geom(hills());
    TensorSpline same = base;
    for (Eigen::Vector4d &pole : same.poles)
        pole.z() += 1e-7;
    const double plain = certify({base, same, 0.0, 1e-3, {}}).bound;
    const double paid = certify({base, same, 0.0, 1e-3, {}, 1e6}).bound;
    EXPECT_GT(paid, plain + 1e6 * std::numeric_limits<double>::epsilon() * 100.0);
}

TEST(PieglTiller, KeepsItsBoundOnBothSidesAtAllTolerances)
{
    const Result<InputFace> input = read_face(whole(hills()));
    ASSERT_TRUE(input.ok());
    int fewer = 0;
    for (const double distance : {-40.0, -1.0, 0.01, 10.0, 60.0})
        for (const double tolerance : {1.0, 1e-2, 1e-4})
        {
            SCOPED_TRACE(testing::Message() << "distance " << distance << " tolerance " << tolerance);
            const Result<SurfaceAnalysis> analysis = analyse(input.value(), distance, tolerance);
            ASSERT_TRUE(analysis.ok());
            const Result<OffsetSurface> made =
                piegl_tiller_offset(analysis.value(), input.value(), distance, tolerance, OffsetOptions());
            ASSERT_TRUE(made.ok()) << made.failure().message;
            const OffsetSurface &offset = made.value();
            ASSERT_TRUE(offset.certified_error.has_value());
            ASSERT_TRUE(offset.parameter_map != nullptr);
            EXPECT_LE(*offset.certified_error, tolerance);
            double worst = 0.0;
            double u0, u1, v0, v1;
            offset.geometry->Bounds(u0, u1, v0, v1);
            for (int i = 0; i <= 97; ++i)
                for (int j = 0; j <= 101; ++j)
                {
                    const double x = u0 + (u1 - u0) * i / 97.0;
                    const double y = v0 + (v1 - v0) * j / 101.0;
                    const gp_Pnt exact = exact_offset_point(input.value().surface, offset.parameter_map->u.value(x),
                                                            offset.parameter_map->v.value(y), distance);
                    worst = std::max(worst, exact.Distance(offset.geometry->Value(x, y)));
                }
            EXPECT_LE(worst, *offset.certified_error + rounding);
            PieglTillerOptions plain;
            plain.removal_share = 0.0;
            const Result<OffsetSurface> full =
                piegl_tiller_offset(analysis.value(), input.value(), distance, tolerance, OffsetOptions(), plain);
            ASSERT_TRUE(full.ok());
            const auto poles = [](const OffsetSurface &s) {
                const auto spline = Handle(Geom_BSplineSurface)::DownCast(s.geometry);
                return spline->NbUPoles() * spline->NbVPoles();
            };
            fewer += poles(offset) < poles(full.value()) ? 1 : 0;
        }
    EXPECT_GE(fewer, 10) << "knot removal takes hardly any knots";
}

TEST(PieglTiller, RefusesOptionsOutOfRange)
{
    const Result<InputFace> input = read_face(whole(hills()));
    const Result<SurfaceAnalysis> analysis = analyse(input.value(), 1.0, 1e-3);
    PieglTillerOptions degree, exponent, shares;
    degree.degree = 8;
    exponent.exponent = 0.7;
    shares.interpolation_share = 0.8;
    for (const PieglTillerOptions &how : {degree, exponent, shares})
    {
        const auto made = piegl_tiller_offset(analysis.value(), input.value(), 1.0, 1e-3, OffsetOptions(), how);
        ASSERT_FALSE(made.ok());
        EXPECT_EQ(made.failure().status, Status::InvalidOption);
        EXPECT_EQ(made.failure().stage, Stage::Options);
    }
}

TEST(PieglTiller, ExponentOfChordsNeedsManyMorePoles)
{
    const Result<InputFace> input = read_face(whole(hills()));
    const Result<SurfaceAnalysis> analysis = analyse(input.value(), 10.0, 1e-2);
    PieglTillerOptions chords;
    chords.exponent = 0.5;
    chords.removal_share = 0.0;
    PieglTillerOptions usual;
    usual.removal_share = 0.0;
    const auto poles = [&](const PieglTillerOptions &how) {
        const auto made = piegl_tiller_offset(analysis.value(), input.value(), 10.0, 1e-2, OffsetOptions(), how);
        const auto spline = Handle(Geom_BSplineSurface)::DownCast(made.value().geometry);
        return spline->NbUPoles() * spline->NbVPoles();
    };
    EXPECT_GT(poles(chords), 5 * poles(usual));
}

TEST(SpaceCurve, IsProvenWhereFourSamplesAreNot)
{
    const Handle(Geom_Surface) surface = hills();
    const std::optional<AnalyticSurface> form = AnalyticSurface::make(surface);
    const CurveOnSurface c{surface, wavy_pcurve(), 0.0, 1.0};
    const EdgeTarget target(c, &*form);
    for (const double tolerance : {1.0, 1e-2, 1e-4, 1e-6})
    {
        SCOPED_TRACE(tolerance);
        const auto proven = space_curve(target, tolerance);
        ASSERT_TRUE(proven.has_value());
        EXPECT_TRUE(proven->deviation.proven);
        EXPECT_LE(proven->deviation.bound, tolerance);
        const double seen = dense_deviation(proven->curve, c, 0.0);
        EXPECT_LE(seen, proven->deviation.bound + rounding);
        EXPECT_GE(seen, 0.01 * proven->deviation.bound) << "far too careful";
        SpaceCurveOptions paper;
        paper.check = PieceCheck::FourSamples;
        const auto sampled = space_curve(target, tolerance, paper);
        ASSERT_TRUE(sampled.has_value());
        EXPECT_LE(dense_deviation(sampled->curve, c, 0.0), sampled->deviation.bound + rounding);
    }
}

TEST(SpaceCurve, FourSamplesAcceptWhatTheProofRefuses)
{
    // Over one piece the pcurve's height vanishes twice at both ends and once at each of the paper's four samples, so that
    // its cubic is the straight line and the samples see no error at all.
    std::vector<double> height{1.0};
    const auto times = [&](double root) {
        std::vector<double> product(height.size() + 1, 0.0);
        for (std::size_t i = 0; i < height.size(); ++i)
        {
            product[i] -= root * height[i];
            product[i + 1] += height[i];
        }
        height = product;
    };
    for (const double root : {0.0, 0.0, 1.0, 1.0, 0.2, 0.4, 0.6, 0.8})
        times(root);
    constexpr int degree = 8;
    TColgp_Array1OfPnt2d poles(1, degree + 1);
    for (int j = 0; j <= degree; ++j)
    {
        double y = 0.0; // monomials into Bernstein polynomials
        double ratio = 1.0;
        for (int i = 0; i <= j; ++i)
        {
            y += ratio * height[static_cast<std::size_t>(i)];
            ratio *= static_cast<double>(j - i) / (degree - i);
        }
        poles(j + 1) = gp_Pnt2d(static_cast<double>(j) / degree, 0.5 + y);
    }
    const Handle(Geom_Surface) plane = height_surface([](double, double) { return 0.0; }, 100.0, 100.0, 4, 4);
    const std::optional<AnalyticSurface> form = AnalyticSurface::make(plane);
    const CurveOnSurface c{plane, new Geom2d_BezierCurve(poles), 0.0, 1.0};
    const EdgeTarget target(c, &*form);
    SpaceCurveOptions paper;
    paper.check = PieceCheck::FourSamples;
    const auto sampled = space_curve(target, 1e-3, paper);
    ASSERT_TRUE(sampled.has_value());
    EXPECT_EQ(Handle(Geom_BSplineCurve)::DownCast(sampled->curve)->NbKnots(), 2);
    const double missed = dense_deviation(sampled->curve, c, 0.0);
    EXPECT_GT(missed, 2e-3) << "the samples had a chance";
    EXPECT_GE(sampled->deviation.bound, missed - rounding) << "the report does not tell";
    const auto proven = space_curve(target, 1e-3);
    ASSERT_TRUE(proven.has_value());
    EXPECT_TRUE(proven->deviation.proven);
    EXPECT_LE(dense_deviation(proven->curve, c, 0.0), 1e-3);
}

TEST(SpaceCurve, IsTheIsoparametricCurveItself)
{
    const Handle(Geom_Surface) surface = hills();
    const std::optional<AnalyticSurface> form = AnalyticSurface::make(surface);
    const Handle(Geom2d_Curve) line = new Geom2d_Line(gp_Pnt2d(0.35, 0.0), gp_Dir2d(0.0, 1.0));
    const auto made = space_curve(EdgeTarget({surface, line, 0.1, 0.9}, &*form), 1e-6);
    ASSERT_TRUE(made.has_value());
    EXPECT_LE(made->deviation.bound, 1e-9);
}

TEST(OffsetTrimmingCurve, KeepsItsProvenBound)
{
    const Handle(Geom_Surface) surface = hills();
    const std::optional<AnalyticSurface> form = AnalyticSurface::make(surface);
    const BaseSurface base(surface, {0.0, 1.0, 0.0, 1.0});
    const Handle(Geom2d_Curve) circle = new Geom2d_Circle(gp_Ax2d(gp_Pnt2d(0.5, 0.5), gp_Dir2d(1.0, 0.0)), 0.3);
    const Handle(Geom2d_Curve) along = new Geom2d_Line(gp_Pnt2d(0.0, 0.2), gp_Dir2d(1.0, 0.0)); // on a knot line
    int compared = 0;
    for (const CurveOnSurface &c :
         {CurveOnSurface{surface, wavy_pcurve(), 0.0, 1.0}, CurveOnSurface{surface, circle, 0.0, 2.0 * M_PI},
          CurveOnSurface{surface, along, 0.0, 1.0}})
        for (const double distance : {-30.0, 0.5, 30.0, 300.0})
            for (const double tolerance : {1e-1, 1e-3, 1e-5})
            {
                SCOPED_TRACE(testing::Message() << "distance " << distance << " tolerance " << tolerance);
                const EdgeTarget target(c, &*form);
                const auto made = offset_trimming_curve({target, base, distance}, tolerance);
                ASSERT_TRUE(made.has_value());
                EXPECT_LE(made->deviation.bound, tolerance);
                const double seen = dense_deviation(made->curve, c, distance);
                EXPECT_LE(seen, tolerance);
                // at 300 mm and 1e-5 mm not every curve gets a proof; such a curve is said to be sampled
                if (distance < 100.0 || tolerance > 1e-4)
                {
                    EXPECT_TRUE(made->deviation.proven);
                }
                if (!made->deviation.proven)
                    continue;
                EXPECT_LE(seen, made->deviation.bound + rounding);
                ++compared;
            }
    EXPECT_GE(compared, 33);
}

TEST(OffsetTrimmingCurve, ProofRefusesTheWrongSideAndAShiftedCurve)
{
    const Handle(Geom_Surface) surface = hills();
    const std::optional<AnalyticSurface> form = AnalyticSurface::make(surface);
    const BaseSurface base(surface, {0.0, 1.0, 0.0, 1.0});
    const EdgeTarget target({surface, wavy_pcurve(), 0.0, 1.0}, &*form);
    const auto made = offset_trimming_curve({target, base, 5.0}, 1e-4);
    ASSERT_TRUE(made.has_value());
    EXPECT_GE(offset_deviation({target, base, -5.0}, made->curve, 1e-4).bound, 9.9);
    const auto moved = Handle(Geom_Curve)::DownCast(made->curve->Translated(gp_Vec(0.3, 0.0, 0.0)));
    EXPECT_GE(offset_deviation({target, base, 5.0}, moved, 1e-4).bound, 0.29);
}

TEST(RaviKumar, OffsetsAPanelWithAHole)
{
    for (const TopoDS_Face &face : {panel_with_hole(), reversed(panel_with_hole()), located(panel_with_hole())})
        for (const double distance : {5.0, -5.0, 40.0})
        {
            SCOPED_TRACE(distance);
            const Result<OffsetResult> result = by_ravi_kumar(face, distance, 1e-2);
            ASSERT_TRUE(result.ok()) << why(result);
            const OffsetReport &report = result.value().report;
            EXPECT_EQ(report.method, Method::RaviKumar);
            ASSERT_TRUE(report.certified_error.has_value());
            ASSERT_TRUE(report.edge_error.has_value());
            EXPECT_LE(*report.edge_error, 1e-2);
            OracleOptions how;
            how.grid = 60;
            const OracleReport seen = measure_offset(face, result.value().face(), distance, how);
            EXPECT_GT(seen.points, 1000);
            EXPECT_LE(seen.surface_error, *report.certified_error + rounding);
            EXPECT_LE(seen.converse_error, *report.certified_error + rounding);
            EXPECT_LE(seen.edge_error, *report.edge_error + rounding);
            EXPECT_GT(seen.least_cosine, 0.999);
            EXPECT_EQ(seen.untold_pcurve_error, 0.0);
            EXPECT_EQ(seen.loops, 2);
            EXPECT_EQ(seen.edges, 5);
            EXPECT_TRUE(seen.valid);
            EXPECT_TRUE(seen.orientation_kept);
            EXPECT_TRUE(seen.same_parameter);
        }
}

TEST(RaviKumar, ExtendsTheSurfaceUnderAPanelWithAHole)
{
    for (const TopoDS_Face &face : {panel_with_hole(), reversed(panel_with_hole()), located(panel_with_hole())})
        for (const double distance : {5.0, -40.0, 40.0})
        {
            const double tolerance = distance == 5.0 ? 1e-4 : 1e-2;
            SCOPED_TRACE(testing::Message() << "distance " << distance << " tolerance " << tolerance);
            const Result<OffsetResult> plain = by_ravi_kumar(face, distance, tolerance);
            ASSERT_TRUE(plain.ok()) << why(plain);
            const double length = std::abs(distance);
            const Result<OffsetResult> wider = by_ravi_kumar(face, distance, tolerance, length);
            expect_extended(face, wider, distance, length, tolerance);
            const ParameterBox before = bounds_of(plain.value().face());
            const ParameterBox after = bounds_of(wider.value().face());
            EXPECT_LT(after.umin, before.umin - 0.5 * length); // chord length, mm
            EXPECT_GT(after.umax, before.umax + 0.5 * length);
            EXPECT_LT(after.vmin, before.vmin - 0.5 * length);
            EXPECT_GT(after.vmax, before.vmax + 0.5 * length);
            EXPECT_TRUE(runs_as_the_paper_says(face)) << "the base itself";
            EXPECT_TRUE(runs_as_the_paper_says(plain.value().face()));
            EXPECT_NEAR(*wider.value().report.certified_error, *plain.value().report.certified_error, 1e-9);
        }
}

TEST(RaviKumar, ExtendsTheSurfaceUnderLoopsAlongItsBorder)
{
    const TopoDS_Face face = whole(hills());
    for (const double distance : {-30.0, 30.0})
        for (const double tolerance : {1.0, 1e-2, 1e-4})
        {
            SCOPED_TRACE(testing::Message() << "distance " << distance << " tolerance " << tolerance);
            expect_extended(face, by_ravi_kumar(face, distance, tolerance, 30.0), distance, 30.0, tolerance);
        }
}

// The offset's parameters are chord lengths from zero, wherever those of the base and its loops begin.
TEST(RaviKumar, ExtendsTheSurfaceWhereverTheParametersOfTheBaseBegin)
{
    const Handle(Geom_BSplineSurface) moved = hills();
    move_parameters(moved, 1e4, 800.0, -1e4, 500.0);
    for (const double distance : {-30.0, 30.0})
    {
        SCOPED_TRACE(testing::Message() << "distance " << distance);
        expect_extended(whole(moved), by_ravi_kumar(whole(moved), distance, 1e-2, 30.0), distance, 30.0, 1e-2);
    }
}

TEST(RaviKumar, ImagesGoOnWhereACurveLeavesTheUnextendedSurface)
{
    const Result<InputFace> input = read_face(whole(hills()));
    const double distance = 20.0, tolerance = 1e-2, accuracy = 1e-3;
    const Result<SurfaceAnalysis> analysis = analyse(input.value(), distance, tolerance);
    const Result<OffsetSurface> made =
        piegl_tiller_offset(analysis.value(), input.value(), distance, tolerance, OffsetOptions());
    ASSERT_TRUE(made.ok());
    const Result<ExtendedOffset> extended = extend_offset(input.value(), made.value(), distance, 50.0);
    ASSERT_TRUE(extended.ok());
    EXPECT_NEAR(*extended.value().surface.certified_error, *made.value().certified_error, 1e-9);
    EXPECT_GE(*extended.value().surface.certified_error, *made.value().certified_error);
    const Handle(Geom_Surface) wide = extended.value().surface.geometry;
    ParameterBox old;
    made.value().geometry->Bounds(old.umin, old.umax, old.vmin, old.vmax);
    const auto on_old = EdgeImages::make(made.value().geometry, old, input.value().diagonal);
    const auto on_wide = EdgeImages::make(wide, extended.value().box, input.value().diagonal);
    ASSERT_TRUE(on_old && on_wide);
    // across every side of the old border, and past a corner
    const gp_Pnt2d inside(0.5 * (old.umin + old.umax), 0.4 * old.vmin + 0.6 * old.vmax);
    for (const gp_Pnt2d &outside : {gp_Pnt2d(old.umin - 40.0, inside.Y()), gp_Pnt2d(old.umax + 40.0, inside.Y() + 20.0),
                                    gp_Pnt2d(inside.X(), old.vmin - 40.0), gp_Pnt2d(inside.X() + 30.0, old.vmax + 40.0),
                                    gp_Pnt2d(old.umax + 30.0, old.vmax + 30.0)})
    {
        SCOPED_TRACE(testing::Message() << outside.X() << " " << outside.Y());
        const Handle(Geom_Curve) curve = interpolated(wide, inside, outside);
        const double first = curve->FirstParameter(), last = curve->LastParameter();
        const Handle(Geom2d_Curve) image = on_wide->image({curve, first, last}, accuracy);
        ASSERT_FALSE(image.IsNull());
        EXPECT_LT(image->Value(first).Distance(inside), accuracy);
        EXPECT_LT(image->Value(last).Distance(outside), accuracy);
        double worst = 0.0;
        for (int k = 0; k <= 1000; ++k)
        {
            const double t = first + (last - first) * k / 1000.0;
            const gp_Pnt2d uv = image->Value(t);
            worst = std::max(worst, curve->Value(t).Distance(wide->Value(uv.X(), uv.Y())));
        }
        EXPECT_LT(worst, accuracy);
        const Handle(Geom2d_Curve) held = on_old->image({curve, first, last}, accuracy);
        if (held.IsNull())
            continue;
        const gp_Pnt2d end = held->Value(last);
        EXPECT_GT(curve->Value(last).Distance(made.value().geometry->Value(end.X(), end.Y())), 10.0);
    }
}

TEST(RaviKumar, ExtendsSpecialShapesInTheirOwnParameters)
{
    const TopoDS_Face face = sphere_patch(100.0);
    const Result<OffsetResult> result = by_ravi_kumar(face, 7.0, 1e-3, 10.0);
    ASSERT_TRUE(result.ok()) << why(result);
    EXPECT_EQ(result.value().report.surface->type, "sphere");
    EXPECT_EQ(result.value().report.extension->sides.size(), 4u);
    EXPECT_TRUE(confirms(measure_offset(face, result.value().face(), 7.0, {50, 60}), 1e-6));
    EXPECT_TRUE(runs_as_the_paper_says(result.value().face()));
}

TEST(RaviKumar, RefusesToExtendWhatIsClosedOrFolds)
{
    const TopoDS_Face tube = whole(wavy_tube(100.0));
    const Result<OffsetResult> closed = by_ravi_kumar(tube, 4.0, 1e-2, 4.0);
    ASSERT_FALSE(closed.ok());
    EXPECT_EQ(closed.failure().status, Status::SelfIntersection);
    // an arch that comes nearly round: long extensions meet
    const Result<OffsetResult> far = by_ravi_kumar(panel_with_hole(), 5.0, 1e-2, 1e5);
    ASSERT_FALSE(far.ok());
    for (const auto &[result, face] : {std::pair{&closed, tube}, std::pair{&far, panel_with_hole()}})
    {
        EXPECT_EQ(result->failure().stage, Stage::Extension);
        EXPECT_FALSE(result->failure().message.empty());
        ASSERT_TRUE(result->failure().where.has_value());
        const Where &where = *result->failure().where;
        const gp_Pnt on_base = BRep_Tool::Surface(face)->Value(where.uv.X(), where.uv.Y());
        EXPECT_LT(on_base.Distance(where.point), 1e-6) << "the place is not one of the base";
    }
}

TEST(RaviKumar, TakesSpecialShapesAsTheyAre)
{
    const Result<OffsetResult> result = by_ravi_kumar(sphere_patch(100.0), 7.0, 1e-3);
    ASSERT_TRUE(result.ok()) << why(result);
    EXPECT_EQ(result.value().report.surface->type, "sphere");
}

TEST(RaviKumar, ClosesATube)
{
    const TopoDS_Face face = whole(wavy_tube(100.0));
    for (const double distance : {4.0, -4.0})
    {
        const Result<OffsetResult> result = by_ravi_kumar(face, distance, 1e-2);
        ASSERT_TRUE(result.ok()) << why(result);
        EXPECT_TRUE(confirms(measure_offset(face, result.value().face(), distance, {50, 60}), 1e-2));
    }
}

TEST(RaviKumar, NamesThePlaceOfABadEdgeOnTheBase)
{
    const Result<InputFace> input = read_face(panel_with_hole());
    ASSERT_TRUE(input.ok());
    OffsetSurface surface;
    surface.certified_error = 0.01;
    for (int bad = 0; bad < 5; ++bad)
    {
        TrimLoops loops;
        gp_Pnt2d expected;
        for (const TrimmingLoop &loop : input.value().loops)
            for (const TrimmingCurve &curve : loop.curves)
            {
                const int k = loops.bases.Add(curve.edge) - 1;
                OffsetEdge edge;
                edge.own_parameters = true;
                edge.offset_error = k == bad ? 0.5 : 0.02;
                edge.deviation = {k == bad ? 0.0 : 0.06, true}; // from the surface, which has its own parameters
                edge.pcurve = wavy_pcurve();
                if (k == bad)
                    expected = curve.pcurve->Value(0.5 * (curve.first + curve.last));
                loops.edges.push_back(edge);
            }
        ASSERT_EQ(loops.edges.size(), 5u);
        const Result<bool> close = check_edges(input.value(), surface, loops, 0.1);
        ASSERT_FALSE(close.ok());
        EXPECT_EQ(close.failure().status, Status::EdgeToleranceNotReached);
        EXPECT_LT(close.failure().where->uv.Distance(expected), 1e-12);
        EXPECT_TRUE(check_edges(input.value(), surface, loops, 0.6).ok());
    }
}

TEST(RaviKumar, RefusesFoldsLikeTheOtherMethod)
{
    int refused = 0;
    for (const double distance : {-1000.0, 1000.0})
    {
        const Result<OffsetResult> usual = offset(panel_with_hole(), distance, 1e-2);
        if (usual.ok() || usual.failure().status != Status::CurvatureLimit)
            continue;
        const Result<OffsetResult> result = by_ravi_kumar(panel_with_hole(), distance, 1e-2);
        ASSERT_FALSE(result.ok());
        EXPECT_EQ(result.failure().status, Status::CurvatureLimit);
        EXPECT_EQ(result.failure().stage, Stage::Analysis);
        EXPECT_TRUE(result.failure().where.has_value());
        ++refused;
    }
    EXPECT_GE(refused, 1);
}

TEST(RaviKumar, OffsetsRealFuselages)
{
    int judged = 0;
    for (const char *name : {"derived_D150_fuselage_2p3m_1hole_6curves.step", "tigl_D150_fuselage_nose_shell.brep"})
    {
        const auto file = find_data_file(name);
        if (!file)
            continue;
        const TopoDS_Face face = read_faces(*file).front();
        for (const double distance : {20.0, -20.0})
        {
            SCOPED_TRACE(testing::Message() << name << " " << distance);
            const Result<OffsetResult> result = by_ravi_kumar(face, distance, 1e-1);
            ASSERT_TRUE(result.ok()) << why(result);
            OracleOptions how;
            how.grid = 50;
            const OracleReport seen = measure_offset(face, result.value().face(), distance, how);
            EXPECT_GT(seen.points, 500);
            EXPECT_LE(seen.surface_error, 0.1);
            EXPECT_LE(seen.converse_error, 0.1);
            EXPECT_LE(seen.edge_error, 0.1);
            EXPECT_TRUE(seen.valid);
            ++judged;
        }
    }
    if (judged == 0)
        GTEST_SKIP() << missing_data_message("fuselages");
}
