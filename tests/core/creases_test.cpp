// SPDX-License-Identifier: LGPL-2.1-or-later
// Creased faces become shells: every part right on its own, the tear between them bounded.
#include "support/data_files.h"
#include "support/offset_oracle.h"
#include "support/offsets.h"
#include "support/sample_faces.h"

#include <laminate_offset/offset_face.h>
#include <laminate_offset/offset_limits.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Ellipse.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp.hxx>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace laminate_offset;
using namespace test_support;

namespace
{

constexpr double tolerance = 1e-3;
constexpr double rounding = 1e-9;

using Point = std::function<gp_Pnt(double, double)>;

struct Direction
{
    std::vector<double> knots; //!< distinct
    std::vector<int> multiplicities;
    int degree = 3;
    bool periodic = false;
};

//! Piecewise cubic with full multiplicity at the inner knots.
Direction broken(const std::vector<double> &knots, int inner_multiplicity)
{
    Direction direction{knots, std::vector<int>(knots.size(), inner_multiplicity)};
    direction.multiplicities.front() = direction.multiplicities.back() = direction.degree + 1;
    return direction;
}

std::vector<double> greville(const Direction &d)
{
    std::vector<double> flat;
    for (std::size_t i = 0; i < d.knots.size(); ++i)
        flat.insert(flat.end(), static_cast<std::size_t>(d.multiplicities[i]), d.knots[i]);
    std::vector<double> places;
    for (std::size_t i = 1; i + static_cast<std::size_t>(d.degree) < flat.size(); ++i)
    {
        double sum = 0.0;
        for (int k = 0; k < d.degree; ++k)
            sum += flat[i + static_cast<std::size_t>(k)];
        places.push_back(sum / d.degree);
    }
    return places;
}

//! The spline whose poles are the points at the knot averages.
Handle(Geom_BSplineSurface) spline(const Direction &u, const Direction &v, const Point &point)
{
    const std::vector<double> us = greville(u), vs = greville(v);
    TColgp_Array2OfPnt poles(1, static_cast<int>(us.size()), 1, static_cast<int>(vs.size()));
    for (int i = 1; i <= poles.ColLength(); ++i)
        for (int j = 1; j <= poles.RowLength(); ++j)
            poles(i, j) = point(us[static_cast<std::size_t>(i) - 1], vs[static_cast<std::size_t>(j) - 1]);
    const auto reals = [](const std::vector<double> &values) {
        TColStd_Array1OfReal array(1, static_cast<int>(values.size()));
        for (int i = 1; i <= array.Length(); ++i)
            array(i) = values[static_cast<std::size_t>(i) - 1];
        return array;
    };
    const auto integers = [](const std::vector<int> &values) {
        TColStd_Array1OfInteger array(1, static_cast<int>(values.size()));
        for (int i = 1; i <= array.Length(); ++i)
            array(i) = values[static_cast<std::size_t>(i) - 1];
        return array;
    };
    return new Geom_BSplineSurface(poles, reals(u.knots), reals(v.knots), integers(u.multiplicities),
                                   integers(v.multiplicities), u.degree, v.degree);
}

//! A curved sheet over [0, 1] x [0, 1], 100 x 60, folded along u = 0.4: upwards for a positive slope, which makes a
//! valley seen from above.
Handle(Geom_BSplineSurface) folded_sheet(double slope)
{
    return spline(broken({0.0, 0.4, 1.0}, 3), broken({0.0, 0.5, 1.0}, 1), [slope](double u, double v) {
        return gp_Pnt(100.0 * u, 60.0 * v, slope * 100.0 * std::abs(u - 0.4) + 6.0 * v * (1.0 - v) - 4.0 * u * u);
    });
}

TopoDS_Face face_on(const Handle(Geom_Surface) & surface) { return BRepBuilderAPI_MakeFace(surface, 1e-7); }

TopoDS_Face with_hole(const Handle(Geom_Surface) & surface, const gp_Pnt2d &centre, double radius_u, double radius_v)
{
    BRepBuilderAPI_MakeFace maker(surface, 1e-7);
    const Handle(Geom2d_Ellipse) ellipse =
        new Geom2d_Ellipse(gp_Ax22d(centre, gp_Dir2d(1, 0), gp_Dir2d(0, -1)), radius_u, radius_v);
    TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(ellipse, surface);
    BRepLib::BuildCurve3d(edge);
    maker.Add(BRepBuilderAPI_MakeWire(edge).Wire());
    return maker.Face();
}

std::vector<TopoDS_Face> parts_of(const TopoDS_Shape &shape)
{
    std::vector<TopoDS_Face> faces;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
        faces.push_back(TopoDS::Face(it.Current()));
    return faces;
}

//! Calls visit(face, uv) for the points of a grid over the face that lie inside its loops, and not beside them.
int for_each_inside(const TopoDS_Face &face, int grid, const std::function<void(const gp_Pnt2d &)> &visit)
{
    double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    const BRepTopAdaptor_FClass2d inside(face, 1e-9);
    int points = 0;
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j)
        {
            const gp_Pnt2d uv(u0 + (u1 - u0) * (i + 0.5) / grid, v0 + (v1 - v0) * (j + 0.5) / grid);
            if (inside.Perform(uv) != TopAbs_IN)
                continue;
            visit(uv);
            ++points;
        }
    return points;
}

gp_Vec outward_normal(const TopoDS_Face &face, const gp_Pnt2d &uv)
{
    gp_Pnt p;
    gp_Vec du, dv;
    BRep_Tool::Surface(face)->D1(uv.X(), uv.Y(), p, du, dv);
    const gp_Vec normal = du.Crossed(dv).Normalized();
    return face.Orientation() == TopAbs_REVERSED ? -normal : normal;
}

//! The parts keep the base's parameters: every one is within its bound of the exact offset there, and together they
//! have the base's points, each in one part.
void expect_parts_right(const TopoDS_Face &base, const OffsetResult &result, double distance, int parts)
{
    const std::vector<TopoDS_Face> faces = parts_of(result.shape);
    ASSERT_EQ(static_cast<int>(faces.size()), parts);
    EXPECT_EQ(result.report.faces, parts);
    ASSERT_TRUE(result.report.certified_error && result.report.edge_error);
    EXPECT_LE(*result.report.edge_error, tolerance);
    double area = 0.0;
    for (const TopoDS_Face &face : faces)
    {
        EXPECT_TRUE(BRepCheck_Analyzer(face).IsValid());
        EXPECT_EQ(face.Orientation(), base.Orientation());
        double worst = 0.0;
        const int points = for_each_inside(face, 60, [&](const gp_Pnt2d &uv) {
            const gp_Pnt exact =
                BRep_Tool::Surface(base)->Value(uv.X(), uv.Y()).Translated(distance * outward_normal(base, uv));
            worst = std::max(worst, exact.Distance(BRep_Tool::Surface(face)->Value(uv.X(), uv.Y())));
        });
        EXPECT_GE(points, 500);
        EXPECT_LE(worst, *result.report.certified_error + rounding);
        double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
        BRepTools::UVBounds(face, u0, u1, v0, v1);
        area += (u1 - u0) * (v1 - v0) * points / 3600.0;
    }
    double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
    BRepTools::UVBounds(base, u0, u1, v0, v1);
    const double whole = (u1 - u0) * (v1 - v0) * for_each_inside(base, 60, [](const gp_Pnt2d &) {}) / 3600.0;
    EXPECT_NEAR(area / whole, 1.0, 0.02) << "the parts do not make up the base";
}

//! Distances between the offsets of both sides along an isoparametric line, from the base alone.
struct SeenTear
{
    double widest = 0.0;
    bool gap = false;
    bool overlap = false;
};

SeenTear seen_tear(const TopoDS_Face &base, bool constant_u, double parameter, double low, double high, double distance)
{
    constexpr double step = 1e-9;
    SeenTear tear;
    const auto uv = [&](double t, double side) {
        return constant_u ? gp_Pnt2d(parameter + side * step, t) : gp_Pnt2d(t, parameter + side * step);
    };
    for (int i = 0; i <= 2000; ++i)
    {
        const double t = low + (high - low) * i / 2000;
        const Handle(Geom_Surface) surface = BRep_Tool::Surface(base);
        const gp_Vec before = outward_normal(base, uv(t, -1.0)), after = outward_normal(base, uv(t, 1.0));
        const gp_Vec across(surface->Value(uv(t, -1e5).X(), uv(t, -1e5).Y()),
                            surface->Value(uv(t, 1e5).X(), uv(t, 1e5).Y()));
        const gp_Vec tear_vector = distance * (after - before);
        tear.widest = std::max(tear.widest, tear_vector.Magnitude());
        if (tear_vector.Magnitude() > tolerance)
            (tear_vector.Dot(across) > 0.0 ? tear.gap : tear.overlap) = true;
    }
    return tear;
}

void expect_tear(const OffsetReport &report, const SeenTear &seen)
{
    ASSERT_TRUE(report.gap.has_value());
    EXPECT_GE(*report.gap, seen.widest - 2.0 * tolerance);
    // the bound of a difference of curves overstates by 0.5 percent for polynomials, by a sixth for others
    const double overstates = report.surface->rational ? 1.0 + 1.0 / 6.0 : 1.006;
    EXPECT_LE(*report.gap, overstates * seen.widest + 2.0 * tolerance);
    ASSERT_TRUE(report.crease.has_value());
    EXPECT_EQ(*report.crease, seen.gap && seen.overlap ? CreaseKind::Both
                              : seen.gap               ? CreaseKind::Gap
                                                       : CreaseKind::Overlap);
}

} // namespace

TEST(CreasedFace, AFoldedSheetBecomesTwoFaces)
{
    for (const double slope : {0.02, 0.3, 1.5, -0.3})
        for (const double distance : {0.4, -0.4, 3.0, -3.0})
            for (const bool turned : {false, true})
            {
                SCOPED_TRACE(testing::Message()
                             << "slope " << slope << " distance " << distance << " turned " << turned);
                const TopoDS_Face sheet = face_on(folded_sheet(slope));
                const TopoDS_Face base = turned ? reversed(sheet) : sheet;
                const auto result = offset(base, distance, tolerance);
                ASSERT_TRUE(result.ok()) << why(result);
                const OffsetReport &report = result.value().report;
                EXPECT_EQ(result.value().shape.ShapeType(), TopAbs_SHELL);
                expect_parts_right(base, result.value(), distance, 2);
                const SeenTear seen = seen_tear(base, true, 0.4, 0.0, 1.0, distance);
                expect_tear(report, seen);
                // upwards a valley closes up and a ridge opens
                const bool upwards = (distance > 0.0) != turned;
                EXPECT_EQ(*report.crease, upwards == (slope > 0.0) ? CreaseKind::Overlap : CreaseKind::Gap);
                EXPECT_TRUE(report.apart) << "the parts meet at their crease only";
                EXPECT_EQ(report.loops, 1);
                EXPECT_EQ(report.edges, 4);
            }
}

TEST(CreasedFace, AHoleAcrossTheCreaseIsCutAndOneBesideItIsKept)
{
    for (const double centre : {0.4, 0.45, 0.7})
        for (const double distance : {1.0, -1.0})
        {
            SCOPED_TRACE(testing::Message() << "centre " << centre << " distance " << distance);
            const TopoDS_Face base = with_hole(folded_sheet(0.4), gp_Pnt2d(centre, 0.5), 0.2, 0.1);
            const auto result = offset(base, distance, tolerance);
            ASSERT_TRUE(result.ok()) << why(result);
            expect_parts_right(base, result.value(), distance, 2);
            EXPECT_EQ(result.value().report.loops, 2);
            EXPECT_EQ(result.value().report.edges, 5);
            int loops = 0;
            for (TopExp_Explorer it(result.value().shape, TopAbs_WIRE); it.More(); it.Next())
                ++loops;
            EXPECT_EQ(loops, centre == 0.7 ? 3 : 2);
        }
}

TEST(CreasedFace, TwoCreasesThatCrossMakeFourFaces)
{
    const auto surface = spline(broken({0.0, 0.4, 1.0}, 3), broken({0.0, 0.7, 1.0}, 3), [](double u, double v) {
        return gp_Pnt(100.0 * u, 60.0 * v, 20.0 * std::abs(u - 0.4) - 15.0 * std::abs(v - 0.7) + 5.0 * u * v);
    });
    for (const double distance : {2.0, -2.0})
    {
        const TopoDS_Face base = located(face_on(surface));
        const auto result = offset(base, distance, tolerance);
        ASSERT_TRUE(result.ok()) << why(result);
        ASSERT_EQ(result.value().report.faces, 4);
        EXPECT_EQ(*result.value().report.crease, CreaseKind::Both);
        const TopoDS_Face local = face_on(surface);
        const double seen = std::max(seen_tear(local, true, 0.4, 0.0, 1.0, distance).widest,
                                     seen_tear(local, false, 0.7, 0.0, 1.0, distance).widest);
        EXPECT_NEAR(*result.value().report.gap / seen, 1.0, 0.01);
        expect_parts_right(base, result.value(), distance, 4);
    }
}

TEST(CreasedFace, ACreaseAroundOrAlongAClosedTubeKeepsItsSeam)
{
    TColgp_Array1OfPnt poles(1, 7);
    const double heights[] = {0, 10, 20, 30, 40, 50, 60}, radii[] = {20, 21, 23, 26, 22, 20, 19};
    for (int i = 1; i <= 7; ++i)
        poles(i) = gp_Pnt(radii[i - 1], 0.0, heights[i - 1]);
    TColStd_Array1OfReal knots(1, 3);
    TColStd_Array1OfInteger multiplicities(1, 3);
    knots(1) = 0.0, knots(2) = 1.0, knots(3) = 2.0;
    multiplicities(1) = multiplicities(3) = 4, multiplicities(2) = 3;
    const Handle(Geom_BSplineCurve) profile = new Geom_BSplineCurve(poles, knots, multiplicities, 3);
    const Handle(Geom_Surface) revolved = new Geom_SurfaceOfRevolution(profile, gp::OZ());
    for (const Handle(Geom_Surface) & surface :
         {revolved, Handle(Geom_Surface)(GeomConvert::SurfaceToBSplineSurface(
                        new Geom_RectangularTrimmedSurface(revolved, 0.0, 2.0 * M_PI, 0.0, 2.0)))})
        for (const double distance : {1.0, -1.0})
        {
            SCOPED_TRACE(testing::Message() << surface->DynamicType()->Name() << " distance " << distance);
            const TopoDS_Face base = face_on(surface);
            const auto result = offset(base, distance, tolerance);
            ASSERT_TRUE(result.ok()) << why(result);
            ASSERT_EQ(result.value().report.faces, 2);
            expect_tear(result.value().report, seen_tear(base, false, 1.0, 0.0, 2.0 * M_PI, distance));
            for (const TopoDS_Face &part : parts_of(result.value().shape))
            {
                EXPECT_TRUE(BRepCheck_Analyzer(part).IsValid());
                int seams = 0;
                for (TopExp_Explorer it(part, TopAbs_EDGE); it.More(); it.Next())
                    seams += BRep_Tool::IsClosed(TopoDS::Edge(it.Current()), part) ? 1 : 0;
                EXPECT_EQ(seams, 2) << "the seam stands twice in the loop";
                double worst = 0.0;
                for_each_inside(part, 40, [&](const gp_Pnt2d &uv) {
                    const gp_Pnt exact = surface->Value(uv.X(), uv.Y()).Translated(distance * outward_normal(base, uv));
                    worst = std::max(worst, exact.Distance(BRep_Tool::Surface(part)->Value(uv.X(), uv.Y())));
                });
                EXPECT_LE(worst, result.value().report.certified_error.value_or(tolerance) + rounding);
            }
        }
}

//! A closed spline with a kink at 1, smooth at its seam, in the plane of two axes.
Handle(Geom_Curve) closed_profile(const gp_Ax2 &axes)
{
    const double x[] = {0, 15, 25, 40, 25, 15, 0, -15, -15, 0}, y[] = {-12, -12, -10, 0, 10, 12, 12, 12, -12, -12};
    TColgp_Array1OfPnt poles(1, 10);
    for (int i = 1; i <= 10; ++i)
        poles(i) = axes.Location().XYZ() + x[i - 1] * axes.XDirection().XYZ() + y[i - 1] * axes.YDirection().XYZ();
    TColStd_Array1OfReal knots(1, 4);
    TColStd_Array1OfInteger multiplicities(1, 4);
    for (int i = 1; i <= 4; ++i)
    {
        knots(i) = i - 1;
        multiplicities(i) = i == 1 || i == 4 ? 4 : 3;
    }
    return new Geom_BSplineCurve(poles, knots, multiplicities, 3);
}

TEST(CreasedFace, AClosedProfileWithAKinkIsSplitThereAndAtItsSeam)
{
    const Handle(Geom_Curve) profile = closed_profile(gp_Ax2(gp::Origin(), gp::DZ(), gp::DX()));
    const TopoDS_Face base =
        BRepBuilderAPI_MakeFace(new Geom_SurfaceOfLinearExtrusion(profile, gp::DZ()), 0.0, 3.0, 0.0, 50.0, 1e-7);
    for (const double distance : {0.5, -0.5})
    {
        const auto result = offset(base, distance, tolerance);
        ASSERT_TRUE(result.ok()) << why(result);
        expect_parts_right(base, result.value(), distance, 2);
        expect_tear(result.value().report, seen_tear(base, true, 1.0, 0.0, 50.0, distance));
    }
}

//! A profile turned all round the z axis as BRepPrimAPI does it: in the loop both circles come before both sides of the seam.
TopoDS_Face swept_round(const Handle(Geom_Curve) & profile)
{
    return TopoDS::Face(BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeEdge(profile).Edge(), gp::OZ(), 2.0 * M_PI).Shape());
}

TEST(CreasedFace, RingsOfAKinkedProfileAreSplitHoweverTheirLoopsAreWritten)
{
    const Handle(Geom_Curve) profile = closed_profile(gp_Ax2(gp_Pnt(100, 0, 0), -gp::DY(), gp::DX()));
    for (const TopoDS_Face &base : {swept_round(profile), face_on(new Geom_SurfaceOfRevolution(profile, gp::OZ()))})
        for (const double distance : {0.5, -0.5})
        {
            SCOPED_TRACE(distance);
            const auto result = offset(base, distance, tolerance);
            ASSERT_TRUE(result.ok()) << why(result);
            expect_parts_right(base, result.value(), distance, 2);
            expect_tear(result.value().report, seen_tear(base, false, 1.0, 0.0, 2.0 * M_PI, distance));
        }
}

//! A closed section, 100 long and smooth but for its sharp tail, where it begins and ends; 30 from the z axis or more.
Handle(Geom_BSplineCurve) teardrop()
{
    const double x[] = {130, 110, 80, 45, 30, 30, 30, 45, 80, 110, 130};
    const double z[] = {0, 3, 12, 16, 10, 0, -10, -16, -12, -3, 0};
    TColgp_Array1OfPnt poles(1, 11);
    for (int i = 1; i <= 11; ++i)
        poles(i) = gp_Pnt(x[i - 1], 0.0, z[i - 1]);
    TColStd_Array1OfReal knots(1, 9);
    TColStd_Array1OfInteger multiplicities(1, 9);
    for (int i = 1; i <= 9; ++i)
    {
        knots(i) = i - 1;
        multiplicities(i) = i == 1 || i == 9 ? 4 : 1;
    }
    return new Geom_BSplineCurve(poles, knots, multiplicities, 3);
}

TEST(CreasedFace, ASharpSeamIsOpened)
{
    const Handle(Geom_Surface) wing = new Geom_SurfaceOfLinearExtrusion(teardrop(), gp::DY());
    const Handle(Geom_Surface) ring = new Geom_SurfaceOfRevolution(teardrop(), gp::OZ());
    const Handle(Geom_Surface) spline_wing =
        GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(wing, 0.0, 8.0, 0.0, 200.0));
    const auto turned = Handle(Geom_BSplineSurface)::DownCast(spline_wing->Copy());
    turned->ExchangeUV();
    struct Case
    {
        const char *name;
        TopoDS_Face face;
        bool constant_u;
    };
    const Case cases[] = {{"extrusion", BRepBuilderAPI_MakeFace(wing, 0.0, 8.0, 0.0, 200.0, 1e-7), true},
                          {"spline", face_on(spline_wing), true},
                          {"spline with u and v exchanged", face_on(turned), false},
                          {"ring", face_on(ring), false},
                          {"ring as a sweep makes it", swept_round(teardrop()), false}};
    for (const Case &tube : cases)
        for (const double distance : {0.4, -0.4, 2.0, -2.0})
        {
            SCOPED_TRACE(testing::Message() << tube.name << " distance " << distance);
            const auto result = offset(tube.face, distance, tolerance);
            ASSERT_TRUE(result.ok()) << why(result);
            expect_parts_right(tube.face, result.value(), distance, 2);
            double u0, u1, v0, v1;
            BRepTools::UVBounds(tube.face, u0, u1, v0, v1);
            const gp_Pnt2d low(u0, v0), high = tube.constant_u ? gp_Pnt2d(u1, v0) : gp_Pnt2d(u0, v1);
            const gp_Vec apart = outward_normal(tube.face, low) - outward_normal(tube.face, high);
            ASSERT_GT(apart.Magnitude(), 1.5) << "the tail is sharp";
            EXPECT_NEAR(*result.value().report.gap, std::abs(distance) * apart.Magnitude(), 0.02 * std::abs(distance));
            // into the section the sides meet, out of it they part
            const gp_Pnt tail = BRep_Tool::Surface(tube.face)->Value(u0, v0);
            gp_Pnt2d beside = tube.constant_u ? gp_Pnt2d(u0 + 0.3, v0) : gp_Pnt2d(u0, v0 + 0.3);
            const gp_Pnt side = BRep_Tool::Surface(tube.face)->Value(beside.X(), beside.Y());
            const bool outwards = (distance * outward_normal(tube.face, beside)).Z() * (side.Z() - tail.Z()) > 0.0;
            EXPECT_EQ(*result.value().report.crease, outwards ? CreaseKind::Gap : CreaseKind::Overlap);
            const auto limits = offset_limits(tube.face);
            ASSERT_TRUE(limits.ok());
            EXPECT_TRUE(limits.value().negative && limits.value().positive);
        }
}

TEST(CreasedFace, ASmoothSeamIsNoCreaseHoweverSmallTheTolerance)
{
    // the nose of a flat ellipse turns fast beside the seam
    const gp_Ax2 axes(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 0));
    const Handle(Geom_Surface) ellipse =
        new Geom_SurfaceOfLinearExtrusion(new Geom_Ellipse(axes, 500.0, 20.0), gp::DY());
    const Handle(Geom_Surface) spline =
        GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(ellipse, 0.0, 2.0 * M_PI, 0.0, 300.0));
    const TopoDS_Face faces[] = {
        BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(), 1000.0), 0.0, 2.0 * M_PI, 0.0, 300.0, 1e-7),
        BRepBuilderAPI_MakeFace(new Geom_SphericalSurface(gp_Ax3(), 1000.0), 1e-7),
        BRepBuilderAPI_MakeFace(new Geom_ToroidalSurface(gp_Ax3(), 1000.0, 300.0), 1e-7),
        BRepBuilderAPI_MakeFace(ellipse, 0.0, 2.0 * M_PI, 0.0, 300.0, 1e-7), face_on(spline)};
    for (const TopoDS_Face &face : faces)
        for (const double wanted : {1e-3, 1e-5, 1e-6})
        {
            SCOPED_TRACE(testing::Message() << BRep_Tool::Surface(face)->DynamicType()->Name() << " " << wanted);
            const auto result = offset(face, 100.0, wanted);
            ASSERT_TRUE(result.ok()) << why(result);
            EXPECT_EQ(result.value().report.faces, 1);
            EXPECT_FALSE(result.value().report.gap.has_value());
        }
}

//! Two parts of a tube that is cut opposite its seam: each has its own half of the poles; where they lie on the surface that
//! was fitted to the whole, they agree at the cut to rounding, else to what was asked.
void expect_one_surface(const std::vector<TopoDS_Face> &faces, double cut, bool fitted_whole)
{
    Handle(Geom_Surface) halves[2];
    for (int i = 0; i < 2; ++i)
    {
        halves[i] = BRep_Tool::Surface(faces[static_cast<std::size_t>(i)]);
        double u0, u1, v0, v1;
        halves[i]->Bounds(u0, u1, v0, v1);
        EXPECT_LT(u1 - u0, 0.6 * 2.0 * cut);
    }
    double apart = 0.0;
    for (int i = 0; i <= 50; ++i)
        apart = std::max(apart, halves[0]->Value(cut, 2.0 * i).Distance(halves[1]->Value(cut, 2.0 * i)));
    EXPECT_LE(apart, fitted_whole ? rounding : 2.0 * tolerance);
}

TEST(CreasedFace, ASeamThatIsSmoothEnoughStaysClosed)
{
    // a tube whose sides meet at the seam under a small angle
    for (const auto &[angle, parts] : {std::pair(0.0, 1), {1e-5, 1}, {2.2e-4, 2}, {1e-2, 2}})
    {
        SCOPED_TRACE(angle);
        TColgp_Array1OfPnt poles(1, 9);
        const double x[] = {40, 40, 20, -20, -40, -20, 20, 40, 40}, z[] = {0, 20, 40, 40, 0, -40, -40, -20, 0};
        for (int i = 1; i <= 9; ++i)
            poles(i) = gp_Pnt(x[i - 1], 0.0, z[i - 1]);
        poles(2).SetX(40.0 + 20.0 * std::tan(angle));
        TColStd_Array1OfReal knots(1, 7);
        TColStd_Array1OfInteger multiplicities(1, 7);
        for (int i = 1; i <= 7; ++i)
        {
            knots(i) = i - 1;
            multiplicities(i) = i == 1 || i == 7 ? 4 : 1;
        }
        const Handle(Geom_Curve) section = new Geom_BSplineCurve(poles, knots, multiplicities, 3);
        const TopoDS_Face base =
            BRepBuilderAPI_MakeFace(new Geom_SurfaceOfLinearExtrusion(section, gp::DY()), 0.0, 6.0, 0.0, 100.0, 1e-7);
        for (const double distance : {2.0, -2.0})
        {
            const auto result = offset(base, distance, tolerance);
            ASSERT_TRUE(result.ok()) << why(result);
            EXPECT_EQ(result.value().report.faces,
                      parts); // the third: half a tolerance is too much beside the fit's own
            EXPECT_LE(result.value().report.edge_error.value_or(1.0), tolerance);
            expect_parts_right(base, result.value(), distance, parts);
            if (parts == 1)
                continue;
            EXPECT_NEAR(*result.value().report.gap, std::abs(distance) * angle,
                        0.02 * std::abs(distance) * angle + 1e-6);
            EXPECT_TRUE(result.value().report.apart);
            ASSERT_TRUE(result.value().report.crease);
            EXPECT_EQ(*result.value().report.crease, distance > 0.0 ? CreaseKind::Gap : CreaseKind::Overlap);
            expect_one_surface(parts_of(result.value().shape), 3.0, angle < 1e-3);
        }
    }
}

TEST(CreasedFace, ACreaseOfAFewKnotSpansIsSeen)
{
    constexpr int spans = 200;
    std::vector<double> many;
    for (int i = 0; i <= spans; ++i)
        many.push_back(static_cast<double>(i) / spans);
    // a flat sheet with a fold in it that begins and ends within 4 of 200 spans; and a tube with such a fold in its seam
    const auto folded_at = [](double v, double from) { return v > from - 1e-9 && v < from + 0.9 / spans; };
    for (const double from : {0.1, 0.485, 0.77})
    {
        const Handle(Geom_BSplineSurface) sheet =
            spline(broken({0.0, 0.5, 1.0}, 3), broken(many, 1), [&](double u, double v) {
                return gp_Pnt(100.0 * u, 1000.0 * v, folded_at(v, from) ? 10.0 * std::abs(u - 0.5) : 0.0);
            });
        const Handle(Geom_BSplineSurface) tube =
            spline(broken({0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0}, 1), broken(many, 1), [&](double u, double v) {
                const bool seam = u < 1e-9 || u > 6.0 - 1e-9, beside = !seam && (u < 0.5 || u > 5.5);
                const double angle = u / 6.0 * 2.0 * M_PI;
                const double x = seam && folded_at(v, from) ? 42.0 : seam || beside ? 40.0 : 40.0 * std::cos(angle);
                return gp_Pnt(x, 1000.0 * v, seam ? 0.0 : 40.0 * std::sin(angle));
            });
        for (const Handle(Geom_BSplineSurface) & surface : {sheet, tube})
            for (const double distance : {1.0, -1.0})
            {
                SCOPED_TRACE(testing::Message()
                             << (surface == sheet ? "sheet " : "tube ") << from << " at " << distance);
                const TopoDS_Face base = face_on(surface);
                const auto result = offset(base, distance, tolerance);
                ASSERT_TRUE(result.ok()) << why(result);
                EXPECT_EQ(result.value().report.faces, 2);
                ASSERT_TRUE(result.value().report.gap.has_value());
                EXPECT_GT(*result.value().report.gap, 0.1);
            }
    }
}

TEST(CreasedFace, WhereOnlyTheParametrisationKinksItStaysOneFace)
{
    // along u the same straight pace before and after 0.4 in space, but not in the parameter: G1 and no more
    const auto bent = [](double u) { return u < 0.4 ? u : 0.4 + 2.0 * (u - 0.4); };
    const auto surface = spline(broken({0.0, 0.4, 1.0}, 3), broken({0.0, 0.5, 1.0}, 1), [&](double u, double v) {
        const double x = bent(u);
        return gp_Pnt(50.0 * x, 60.0 * v,
                      6.0 * v * (1.0 - v) + (u < 0.4 ? 0.0 : 3.0 * std::pow(std::max(0.0, u - 0.6), 2)));
    });
    const TopoDS_Face base = face_on(surface);
    const auto result = offset(base, 2.0, tolerance);
    ASSERT_TRUE(result.ok()) << why(result);
    EXPECT_EQ(result.value().shape.ShapeType(), TopAbs_FACE);
    EXPECT_EQ(result.value().report.faces, 1);
    EXPECT_FALSE(result.value().report.gap || result.value().report.crease);
    EXPECT_TRUE(confirms(measure_offset(base, result.value().face(), 2.0, {60, 60}), tolerance));
}

TEST(CreasedFace, ACreaseIntoAnApexSplitsTheApex)
{
    // two fans of rulings from (0, 0, 40) that meet in a ridge at v = 0.5
    const auto surface = spline(broken({0.0, 1.0}, 1), broken({0.0, 0.5, 1.0}, 3), [](double u, double v) {
        const double y = 60.0 * (v - 0.5);
        const gp_XYZ foot(50.0 - 0.01 * y * y - 0.8 * std::abs(y), y, 0.0), apex(0.0, 0.0, 40.0);
        return gp_Pnt(apex + u * (foot - apex));
    });
    const TopoDS_Face base = face_on(surface);
    int made = 0;
    for (const double distance : {0.5, -0.5})
    {
        const auto result = offset(base, distance, tolerance);
        if (!result.ok())
        {
            EXPECT_EQ(result.failure().status, Status::CurvatureLimit) << why(result);
            continue;
        }
        ++made;
        expect_parts_right(base, result.value(), distance, 2);
        EXPECT_EQ(*result.value().report.crease, CreaseKind::Gap);
    }
    EXPECT_EQ(made, 1);
}

TEST(CreasedFace, IsRefusedWhereAPartIsWithWhatAllPartsPermit)
{
    const auto surface = spline(broken({0.0, 0.5, 1.0}, 3), broken({0.0, 1.0}, 1), [](double u, double v) {
        const double x = u - 0.5; // radii of about 50 on one side, and of about 100 bent the other way on the other
        return gp_Pnt(100.0 * u, 60.0 * v, u < 0.5 ? 100.0 * x * x : 20.0 * x - 50.0 * x * x);
    });
    const TopoDS_Face base = face_on(surface);
    const Result<OffsetLimits> limits = offset_limits(base);
    ASSERT_TRUE(limits.ok()) << limits.failure().message;
    ASSERT_TRUE(limits.value().negative && limits.value().positive);
    for (const double distance : {1.2 * limits.value().positive->distance, 1.2 * limits.value().negative->distance})
    {
        const auto result = offset(base, distance, tolerance);
        ASSERT_FALSE(result.ok());
        EXPECT_EQ(result.failure().status, Status::CurvatureLimit) << why(result);
        ASSERT_TRUE(result.failure().feasible_range && result.failure().where);
        ASSERT_TRUE(result.failure().feasible_range->negative && result.failure().feasible_range->positive);
        EXPECT_NEAR(*result.failure().feasible_range->negative / limits.value().negative->distance, 1.0, 0.02);
        EXPECT_NEAR(*result.failure().feasible_range->positive / limits.value().positive->distance, 1.0, 0.02);
    }
    const auto fits = offset(base, 0.5 * limits.value().positive->distance, tolerance);
    EXPECT_TRUE(fits.ok()) << why(fits);
}

TEST(CreasedFace, RealOnesBecomeShells)
{
    struct Case
    {
        const char *file;
        std::size_t face;
        double distance;
        int parts;
    };
    for (const Case &c :
         {Case{"dealii_DTMB5415_bulbous_bow.iges", 1, 0.5, 3}, Case{"tigl_resultShape.brep", 1, 0.01, 3},
          Case{"pygem_pipe_hollow_out_true.iges", 1, 0.5, 2}, Case{"pygem_pipe_hollow_out_true.iges", 2, -0.5, 2},
          Case{"pygem_pipe_hollow_out_true.iges", 3, 20.0, 2}, Case{"pygem_pipe_hollow_out_true.iges", 4, -2.0, 2}})
    {
        SCOPED_TRACE(testing::Message() << c.file << " face " << c.face);
        const auto file = find_data_file(c.file);
        if (!file)
            GTEST_SKIP() << missing_data_message(c.file);
        const TopoDS_Face base = read_faces(*file).at(c.face - 1);
        const auto result = offset(base, c.distance, tolerance);
        ASSERT_TRUE(result.ok()) << why(result);
        expect_parts_right(base, result.value(), c.distance, c.parts);
        ASSERT_TRUE(result.value().report.gap.has_value());
        EXPECT_GT(*result.value().report.gap, 0.5 * tolerance);
    }
}
