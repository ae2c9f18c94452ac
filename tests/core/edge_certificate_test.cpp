// SPDX-License-Identifier: LGPL-2.1-or-later
// The bound of edge curves is one: dense sampling by OpenCASCADE never exceeds it, whatever the curve.
#include "support/data_files.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/offset_face.h>
#include <laminate_offset/trimming/edge_certificate.h>
#include <laminate_offset/trimming/edge_curve.h>

#include <BRepBndLib.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom2dConvert.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Hyperbola.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_OffsetCurve.hxx>
#include <Geom2d_Parabola.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace laminate_offset;
using namespace test_support;

namespace
{

constexpr double tolerance = 1e-3;

struct NamedPcurve
{
    std::string name;
    Handle(Geom2d_Curve) curve;
    double first = 0.0, last = 1.0;
};

Handle(Geom2d_Curve) random_spline(RandomCases &random, int degree)
{
    TColgp_Array1OfPnt2d poles(1, degree + 4);
    for (int i = 1; i <= poles.Length(); ++i)
        poles(i) = gp_Pnt2d(0.1 + 0.8 * (i - 1) / (poles.Length() - 1), random.uniform(0.1, 0.9));
    TColStd_Array1OfReal knots(1, 5);
    TColStd_Array1OfInteger multiplicities(1, 5);
    for (int i = 1; i <= 5; ++i)
    {
        knots(i) = 0.25 * (i - 1);
        multiplicities(i) = i == 1 || i == 5 ? degree + 1 : 1;
    }
    return new Geom2d_BSplineCurve(poles, knots, multiplicities, degree);
}

//! Every kind of pcurve inside the unit square.
std::vector<NamedPcurve> pcurves(RandomCases &random)
{
    const gp_Ax22d axes(gp_Pnt2d(0.5, 0.5), gp_Dir2d(1.0, random.uniform(-0.5, 0.5)));
    const Handle(Geom2d_Curve) circle = new Geom2d_Circle(axes, random.uniform(0.1, 0.4));
    const double turn = 2.0 * M_PI;
    return {
        {"line", new Geom2d_Line(gp_Pnt2d(0.05, 0.1), gp_Dir2d(1.0, random.uniform(0.2, 0.9))), 0.0, 0.9},
        {"isoparametric line", new Geom2d_Line(gp_Pnt2d(0.37, 0.1), gp_Dir2d(0.0, 1.0)), 0.0, 0.8},
        {"circle", circle, 0.0, turn},
        {"arc past the turn", circle, 5.0, 9.0},
        {"ellipse", new Geom2d_Ellipse(axes, 0.4, random.uniform(0.05, 0.3)), 0.3, turn},
        {"hyperbola", new Geom2d_Hyperbola(axes, 0.1, 0.15), -1.1, 1.2},
        {"parabola", new Geom2d_Parabola(axes, 0.3), -0.4, 0.4},
        {"quadratic spline", random_spline(random, 2), 0.0, 1.0},
        {"cubic spline", random_spline(random, 3), 0.1, 0.93},
        {"quintic spline", random_spline(random, 5), 0.0, 1.0},
        {"rational spline", Geom2dConvert::CurveToBSplineCurve(new Geom2d_TrimmedCurve(circle, 0.2, 4.0)), 0.2, 4.0}};
}

Handle(Geom_Surface) turned(const gp_Ax2 &circle, double radius, const gp_Ax3 &axis)
{
    const Handle(Geom_Curve) arc = new Geom_TrimmedCurve(new Geom_Circle(circle, radius), -0.5, 1.5);
    return new Geom_SurfaceOfRevolution(arc, gp_Ax1(axis.Location(), axis.Direction()));
}

std::vector<std::pair<std::string, Handle(Geom_Surface)>> surfaces(RandomCases &random)
{
    const gp_Ax3 axes(gp_Pnt(3, -2, 1), gp_Dir(0.2, 0.3, 1.0));
    return {{"cubic", random_surface(random, {.spans_u = 4, .spans_v = 3, .most_repeated = 2})},
            {"degree 5 x 7", random_surface(random, {.degree_u = 5, .degree_v = 7, .spans_u = 2, .spans_v = 2})},
            {"rational", random_surface(random, {.rational = true})},
            {"plane", new Geom_Plane(axes)},
            {"cylinder", new Geom_CylindricalSurface(axes, 40.0)},
            {"cone", new Geom_ConicalSurface(axes, 0.4, 30.0)},
            {"sphere", new Geom_SphericalSurface(axes, 50.0)},
            {"torus", new Geom_ToroidalSurface(axes, 60.0, 20.0)},
            {"turned circle", turned(gp_Ax2(gp_Pnt(40, 5, 9), gp_Dir(0.3, -1.0, 0.6)), 25.0, axes)},
            {"turned circle about its centre", turned(gp_Ax2(axes.Location(), gp_Dir(1.0, 0.1, 0.5)), 25.0, axes)}};
}

//! Largest distance of the curve from the surface along its pcurve, by OpenCASCADE.
double seen(const Handle(Geom_Curve) & curve, const CurveOnSurface &c, double first, double last, int count = 4001)
{
    double worst = 0.0;
    for (int k = 0; k <= count; ++k)
    {
        const double t = first + (last - first) * k / count;
        worst = std::max(worst, curve->Value(t).Distance(c.value(t)));
    }
    return worst;
}

//! Largest distance of the edges from the exact offset of the base's pcurves, and from their own surface.
struct SeenEdges
{
    double from_exact = 0.0;
    double untold = 0.0; //!< part of the distance from the own surface that the tolerance does not admit
    int points = 0;
};

SeenEdges look_at_edges(const TopoDS_Face &base, const TopoDS_Face &made, double distance, int count)
{
    SeenEdges result;
    const double d = base.Orientation() == TopAbs_REVERSED ? -distance : distance;
    TopLoc_Location place;
    const Handle(Geom_Surface) from = BRep_Tool::Surface(base, place);
    const Handle(Geom_Surface) to = BRep_Tool::Surface(made, place);
    TopExp_Explorer ours(made, TopAbs_EDGE);
    for (TopExp_Explorer theirs(base, TopAbs_EDGE); theirs.More() && ours.More(); theirs.Next(), ours.Next())
    {
        double first, last, a, b;
        const TopoDS_Edge edge = TopoDS::Edge(ours.Current());
        const auto pcurve = BRep_Tool::CurveOnSurface(TopoDS::Edge(theirs.Current()), base, first, last);
        const auto own = BRep_Tool::CurveOnSurface(edge, made, a, b);
        TopLoc_Location edge_place;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, edge_place, a, b);
        if (curve.IsNull() || pcurve.IsNull() || own.IsNull())
            continue;
        for (int k = 0; k <= count; ++k)
        {
            const double t = first + (last - first) * k / count;
            const gp_Pnt2d uv = pcurve->Value(t);
            const gp_Pnt2d on_own = own->Value(t);
            const gp_Pnt p = curve->Value(t);
            result.untold =
                std::max(result.untold, p.Distance(to->Value(on_own.X(), on_own.Y())) - BRep_Tool::Tolerance(edge));
            GeomLProp_SLProps exact(from, uv.X(), uv.Y(), 1, 1e-12);
            if (!exact.IsNormalDefined())
                continue;
            result.from_exact =
                std::max(result.from_exact, p.Distance(exact.Value().Translated(d * gp_Vec(exact.Normal()))));
            ++result.points;
        }
    }
    return result;
}

//! Offsets the face; edge_error must be proven and hold.
void expect_proven_edges(const TopoDS_Face &face, double distance, int count = 500)
{
    OffsetOptions options;
    options.distance = distance;
    options.tolerance = tolerance;
    const auto made = offset_face(face, options);
    ASSERT_TRUE(made.ok()) << made.failure().message;
    const OffsetReport &report = made.value().report;
    ASSERT_TRUE(report.edge_error.has_value());
    EXPECT_LE(*report.edge_error, tolerance);
    EXPECT_GE(*report.edge_error, *report.certified_error);
    EXPECT_GE(*report.edge_error, *report.sampled_edge_error);
    const SeenEdges edges = look_at_edges(face, made.value().face(), distance, count);
    EXPECT_GT(edges.points, count);
    EXPECT_LE(edges.from_exact, *report.edge_error);
    EXPECT_LE(edges.untold, 0.0);
}

} // namespace

TEST(EdgeCertificate, HoldsForEveryKindOfPcurveAndSurface)
{
    RandomCases random;
    int compared = 0;
    double loosest = 1.0;
    for (const auto &[kind, surface] : surfaces(random))
    {
        const std::optional<AnalyticSurface> form = AnalyticSurface::make(surface);
        ASSERT_TRUE(form.has_value()) << kind;
        for (const NamedPcurve &p : pcurves(random))
        {
            SCOPED_TRACE(kind + ", " + p.name);
            const CurveOnSurface c{surface, p.curve, p.first, p.last};
            const auto edge = edge_curve(EdgeTarget(c, &*form), 1e-4);
            ASSERT_TRUE(edge.has_value());
            EXPECT_TRUE(edge->deviation.proven);
            EXPECT_LE(edge->deviation.bound, 1e-4);
            const double worst = seen(edge->curve, c, c.first, c.last);
            EXPECT_LE(worst, edge->deviation.bound);
            if (worst > 1e-6)
                loosest = std::max(loosest, edge->deviation.bound / worst);
            ++compared;
        }
    }
    EXPECT_EQ(compared, 110);
    EXPECT_LE(loosest, 1.3);
}

TEST(CurvePiece, ARangeHoldsTheCurveAndEndsWhereItEnds)
{
    RandomCases random;
    int monotone = 0;
    for (int round = 0; round < 8; ++round)
        for (const NamedPcurve &pcurve : pcurves(random))
        {
            const auto curve = AnalyticCurve::make(pcurve.curve, pcurve.first, pcurve.last);
            ASSERT_TRUE(curve) << pcurve.name;
            for (const double part : {1.0, 0.3, 1e-3})
            {
                const double a = pcurve.first + random.uniform(0.0, 1.0 - part) * (pcurve.last - pcurve.first);
                std::vector<double> ends = analytic_ends(*curve, a, a + part * (pcurve.last - pcurve.first));
                for (std::size_t i = 0; i + 1 < ends.size(); ++i)
                {
                    const CurvePiece piece(*curve, ends[i], ends[i + 1]);
                    const CurveRange range = piece.range();
                    const Eigen::Vector3d start = piece.value(ends[i]);
                    const Eigen::Vector3d slack = 2.0 * piece.rounding();
                    for (int k = 0; k <= 200; ++k)
                    {
                        const Eigen::Vector3d value = piece.value(ends[i] + (ends[i + 1] - ends[i]) * k / 200);
                        ASSERT_TRUE(((value - range.low + slack).array() >= 0.0).all()) << pcurve.name;
                        ASSERT_TRUE(((range.high - value + slack).array() >= 0.0).all()) << pcurve.name;
                    }
                    // a short piece that runs to one side ends its range with its own end
                    const bool hyperbola = pcurve.name == "hyperbola";
                    const double run = piece.value(ends[i + 1]).x() - start.x();
                    if (part < 0.01 && !hyperbola && std::abs(run) > 1e-6)
                    {
                        ++monotone;
                        const double end = run > 0.0 ? range.low.x() : range.high.x();
                        EXPECT_NEAR(end, start.x(), slack.x()) << pcurve.name;
                    }
                }
            }
        }
    EXPECT_GT(monotone, 40);
}

TEST(EdgeCertificate, BadCurvesAreNeverProven)
{
    RandomCases random;
    for (const auto &[kind, surface] : surfaces(random))
        for (const NamedPcurve &p : pcurves(random))
        {
            SCOPED_TRACE(kind + ", " + p.name);
            const AnalyticSurface form = *AnalyticSurface::make(surface);
            const CurveOnSurface c{surface, p.curve, p.first, p.last};
            const EdgeTarget target(c, &form);
            const auto edge = edge_curve(target, 1e-5);
            ASSERT_TRUE(edge.has_value());
            const auto good = Handle(Geom_BSplineCurve)::DownCast(edge->curve);
            if (good.IsNull())
                continue;
            // a narrow bump that samples of the whole curve do not meet
            const auto bad = Handle(Geom_BSplineCurve)::DownCast(good->Copy());
            const double at = random.uniform(c.first + 0.1 * (c.last - c.first), c.last - 0.1 * (c.last - c.first));
            const double width = 1e-5 * (c.last - c.first);
            for (int k = -3; k <= 3; ++k)
                bad->InsertKnot(at + k * width, 1, 0.0);
            const gp_Vec bump(0.0, 0.0, 2e-3);
            int moved = 0, last_moved = 0;
            bad->LocateU(at, 0.0, moved, last_moved);
            int pole = 0;
            for (int i = 1; i <= moved; ++i)
                pole += bad->Multiplicity(i);
            pole -= (bad->Degree() + 1) / 2;
            bad->SetPole(pole, bad->Pole(pole).Translated(bump));
            const double worst = seen(bad, c, at - 4.0 * width, at + 4.0 * width);
            ASSERT_GT(worst, 2e-4) << "the bump is not there";
            const Deviation deviation = target.deviation(bad, 1e-5);
            EXPECT_GE(deviation.bound, worst);
            EXPECT_GT(deviation.bound, 1e-5);
            bad->SetPole(pole, gp_Pnt(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0));
            EXPECT_FALSE(target.deviation(bad, 1e-5).proven);
        }
}

TEST(EdgeCertificate, SaysWhatItCannotProve)
{
    RandomCases random;
    const Handle(Geom_Surface) surface(random_surface(random, {}));
    const AnalyticSurface form = *AnalyticSurface::make(surface);
    const Handle(Geom2d_Curve) parallel =
        new Geom2d_OffsetCurve(new Geom2d_Ellipse(gp_Ax22d(gp_Pnt2d(0.5, 0.5), gp_Dir2d(1, 0)), 0.3, 0.2), 0.05);
    const auto edge = edge_curve(EdgeTarget({surface, parallel, 0.0, 2.0}, &form), 1e-3);
    ASSERT_TRUE(edge.has_value());
    EXPECT_FALSE(edge->deviation.proven);
    // outside the surface's own parameters nothing is certified
    const Handle(Geom2d_Curve) outside = new Geom2d_Line(gp_Pnt2d(-0.1, 0.5), gp_Dir2d(1, 0));
    const EdgeTarget target({surface, outside, 0.0, 0.5}, &form);
    EXPECT_FALSE(target.deviation(gp_Pnt(0, 0, 0), 1e-3).proven);
}

TEST(EdgeCertificate, AlongAKnotLineAndGrazingIt)
{
    RandomCases random;
    const auto spline = random_surface(random, {.spans_u = 4, .spans_v = 4});
    const Handle(Geom_Surface) surface(spline);
    const AnalyticSurface form = *AnalyticSurface::make(surface);
    const double knot = spline->UKnot(3);
    for (const double off : {0.0, 1e-15, -1e-13, 1e-10, -1e-7})
        for (const bool round : {false, true})
        {
            // a circle that touches the knot line, or a line along it
            const Handle(Geom2d_Curve) pcurve =
                round ? Handle(Geom2d_Curve)(
                            new Geom2d_Circle(gp_Ax22d(gp_Pnt2d(knot + off - 0.2, 0.5), gp_Dir2d(1, 0)), 0.2))
                      : Handle(Geom2d_Curve)(new Geom2d_Line(gp_Pnt2d(knot + off, 0.1), gp_Dir2d(0, 1)));
            const CurveOnSurface c{surface, pcurve, round ? -1.0 : 0.0, round ? 1.0 : 0.8};
            const auto edge = edge_curve(EdgeTarget(c, &form), 1e-5);
            ASSERT_TRUE(edge.has_value()) << off;
            EXPECT_TRUE(edge->deviation.proven) << off;
            EXPECT_LE(seen(edge->curve, c, c.first, c.last), edge->deviation.bound);
        }
}

TEST(EdgeCertificate, OfSeamsPolesAndHoles)
{
    expect_proven_edges(BRepPrimAPI_MakeSphere(20.0).Face(), 3.0);
    expect_proven_edges(BRepPrimAPI_MakeTorus(40.0, 12.0).Face(), -3.0);
    const TopoDS_Face panel = panel_with_hole();
    for (const TopoDS_Face &face : {panel, reversed(panel), located(panel)})
        for (const double distance : {6.0, -6.0})
            expect_proven_edges(face, distance);
}

TEST(EdgeCertificate, OfRealFaces)
{
    if (!find_data_dir())
        GTEST_SKIP() << missing_data_message("models");
    int made = 0, certified = 0, proven = 0;
    for (const char *file : {"derived_D150_fuselage_2p3m_1hole_6curves.step", "cpacs_seat.stp", "dealii_wing.iges",
                             "nist_MBE_PMI_5.stp", "tigl_D150_fuselage_nose_shell.brep", "tigl_nacelle.stp",
                             "axom_boxed_sphere.step", "inducer_betterplane_fuselage.brep"})
    {
        const auto path = find_data_file(file);
        if (!path)
            continue;
        const auto faces = read_faces(*path);
        for (size_t i = 0; i < faces.size(); i += 1 + faces.size() / 12)
        {
            SCOPED_TRACE(std::string(file) + " face " + std::to_string(i + 1));
            Bnd_Box box;
            BRepBndLib::Add(faces[i], box);
            OffsetOptions options;
            options.distance = 1e-3 * std::sqrt(box.SquareExtent());
            options.tolerance = tolerance;
            const auto result = offset_face(faces[i], options);
            if (!result.ok())
                continue;
            const OffsetReport &report = result.value().report;
            ++made;
            certified += report.certified_error ? 1 : 0;
            if (!report.edge_error)
                continue;
            ++proven;
            const SeenEdges edges = look_at_edges(faces[i], result.value().face(), options.distance, 200);
            EXPECT_LE(edges.from_exact, *report.edge_error);
            EXPECT_LE(edges.untold, 0.0);
        }
    }
    RecordProperty("faces", made);
    RecordProperty("edges_proven", proven);
    EXPECT_GT(made, 30);
    EXPECT_EQ(proven, certified) << "wherever the surface is proven, so are the edges";
}
