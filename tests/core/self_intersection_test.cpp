// SPDX-License-Identifier: LGPL-2.1-or-later
// Distant parts of an offset that meet, against known gaps and against OpenCASCADE's own offset points.
#include "support/data_files.h"
#include "support/offsets.h"
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/analysis/patch_tree.h>
#include <laminate_offset/analysis/self_intersection.h>
#include <laminate_offset/base/options.h>
#include <laminate_offset/offset_face.h>
#include <laminate_offset/offset_limits.h>
#include <laminate_offset/surface/offset_surface.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepClass_FaceClassifier.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace laminate_offset;
using namespace test_support;

namespace
{

constexpr double tolerance = 1e-3;

Handle(Geom_BSplineCurve) curve_through(const std::vector<gp_Pnt> &points)
{
    const Handle(TColgp_HArray1OfPnt) array = new TColgp_HArray1OfPnt(1, static_cast<int>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
        array->SetValue(static_cast<int>(i) + 1, points[i]);
    GeomAPI_Interpolate interpolation(array, false, 1e-9);
    interpolation.Perform();
    return interpolation.Curve();
}

//! The surface between two curves with the same knots.
Handle(Geom_BSplineSurface) ruled(const Handle(Geom_BSplineCurve) & low, const Handle(Geom_BSplineCurve) & high)
{
    TColgp_Array2OfPnt poles(1, low->NbPoles(), 1, 2);
    for (int i = 1; i <= low->NbPoles(); ++i)
    {
        poles(i, 1) = low->Pole(i);
        poles(i, 2) = high->Pole(i);
    }
    TColStd_Array1OfReal knots(1, 2);
    knots(1) = 0.0;
    knots(2) = 1.0;
    TColStd_Array1OfInteger ends(1, 2);
    ends.Init(2);
    return new Geom_BSplineSurface(poles, low->Knots(), knots, low->Multiplicities(), ends, low->Degree(), 1);
}

Handle(Geom_BSplineSurface) extruded(const Handle(Geom_BSplineCurve) & profile, double height)
{
    const auto top = Handle(Geom_BSplineCurve)::DownCast(profile->Translated(gp_Vec(0, 0, height)));
    return ruled(profile, top);
}

//! A bulb of radius 20 about the origin that narrows to a throat and flares again.
Handle(Geom_BSplineCurve) bottle()
{
    std::vector<gp_Pnt> points{gp_Pnt(-14, 46, 0), gp_Pnt(-7.5, 37, 0), gp_Pnt(-5, 29, 0), gp_Pnt(-7, 22.5, 0)};
    for (int degrees = 125; degrees <= 415; degrees += 10)
        points.emplace_back(20 * std::cos(degrees * M_PI / 180), 20 * std::sin(degrees * M_PI / 180), 0);
    for (const gp_Pnt &p : {gp_Pnt(7, 22.5, 0), gp_Pnt(5, 29, 0), gp_Pnt(7.5, 37, 0), gp_Pnt(14, 46, 0)})
        points.push_back(p);
    return curve_through(points);
}

//! Half of the bottle's gap at its throat, from its right leg.
double half_gap(const Handle(Geom_BSplineCurve) & profile)
{
    double least = 1e9;
    for (int i = 0; i <= 20000; ++i)
    {
        const double t = profile->FirstParameter() +
                         (profile->LastParameter() - profile->FirstParameter()) * (0.75 + 0.25 * i / 20000.0);
        if (const gp_Pnt p = profile->Value(t); p.Y() > 22 && p.X() > 0)
            least = std::min(least, p.X());
    }
    return least;
}

//! The exact offset of a place, from OpenCASCADE, in the face's position.
gp_Pnt exact_offset_point(const TopoDS_Face &face, const gp_Pnt2d &uv, double distance)
{
    TopLoc_Location location;
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, location);
    const double sign = face.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
    gp_Pnt point;
    gp_Vec u, v;
    surface->D1(uv.X(), uv.Y(), point, u, v);
    return point.Translated(sign * distance * u.Crossed(v).Normalized()).Transformed(location.Transformation());
}

//! The second place stands in the refusal's message.
gp_Pnt2d second_place(const std::string &message)
{
    double u = 0.0, v = 0.0;
    const std::size_t at = message.find("u=");
    EXPECT_NE(at, std::string::npos) << message;
    EXPECT_EQ(std::sscanf(message.c_str() + at, "u=%lf, v=%lf", &u, &v), 2) << message;
    return {u, v};
}

//! A refusal is right only if the exact offset takes two places inside the loops to one point.
void expect_true_meeting(const TopoDS_Face &face, double distance, const Failure &failure)
{
    EXPECT_EQ(failure.status, Status::SelfIntersection) << failure.message;
    EXPECT_EQ(failure.stage, Stage::Surface);
    ASSERT_TRUE(failure.where.has_value());
    const gp_Pnt2d first = failure.where->uv, second = second_place(failure.message);
    const double rounded = 1e-4 * std::abs(distance) + 1e-4 * first.Distance(second); // six digits in the message
    EXPECT_LT(exact_offset_point(face, first, distance).Distance(exact_offset_point(face, second, distance)),
              3 * tolerance + 30 * rounded);
    const gp_Pnt a = exact_offset_point(face, first, 0.0), b = exact_offset_point(face, second, 0.0);
    EXPECT_LT(a.Distance(failure.where->point), 1e-9 * (1 + a.XYZ().Modulus()));
    EXPECT_GT(a.Distance(b), 0.19 * std::abs(distance)) << "neighbours are no meeting";
    for (const gp_Pnt2d &place : {first, second})
        EXPECT_NE(BRepClass_FaceClassifier(face, place, 1e-6).State(), TopAbs_OUT);
}

void expect_meeting(const TopoDS_Face &face, double distance)
{
    SCOPED_TRACE("distance " + std::to_string(distance));
    const Result<OffsetResult> result = offset(face, distance);
    ASSERT_FALSE(result.ok()) << "an offset that meets itself was handed out";
    expect_true_meeting(face, distance, result.failure());
}

void expect_clear(const TopoDS_Face &face, double distance)
{
    SCOPED_TRACE("distance " + std::to_string(distance));
    const Result<OffsetResult> result = offset(face, distance);
    EXPECT_TRUE(result.ok()) << why(result);
}

TopoDS_Face face_of(const Handle(Geom_Surface) & surface) { return BRepBuilderAPI_MakeFace(surface, 1e-7); }

} // namespace

TEST(SelfIntersection, ABottlesThroatClosesAtHalfItsGap)
{
    const Handle(Geom_BSplineCurve) profile = bottle();
    const double gap = half_gap(profile);
    ASSERT_GT(gap, 4.0);
    ASSERT_LT(gap, 6.0);
    const TopoDS_Face face = face_of(extruded(profile, 30));
    const Result<OffsetLimits> limits = offset_limits(face);
    ASSERT_TRUE(limits.ok());
    // seen along its normal the inside of the bulb is the negative side
    ASSERT_TRUE(limits.value().negative.has_value());
    ASSERT_LT(limits.value().negative->distance, -1.3 * gap);
    for (const TopoDS_Face &each : {face, located(face)})
    {
        expect_clear(each, -(gap - 0.02));
        expect_meeting(each, -(gap + 0.02));
        expect_meeting(each, -1.25 * gap);
        expect_clear(each, 0.5);
        expect_clear(reversed(each), gap - 0.02);
        expect_meeting(reversed(each), gap + 0.02);
    }
}

TEST(SelfIntersection, AThroatOutsideTheLoopsDoesNotMatter)
{
    const Handle(Geom_BSplineCurve) profile = bottle();
    const auto surface = extruded(profile, 30);
    const double first = profile->FirstParameter(), last = profile->LastParameter();
    const TopoDS_Face left_out = BRepBuilderAPI_MakeFace(surface, first + 0.2 * (last - first), last, 0.0, 1.0, 1e-7);
    expect_clear(left_out, -1.1 * half_gap(profile));
}

TEST(SelfIntersection, SheetsThatStayParallelNeverMeet)
{
    std::vector<gp_Pnt> spiral, ring;
    for (int degrees = 0; degrees <= 900; degrees += 10)
    {
        const double t = degrees * M_PI / 180, r = 20 + 6 * t / (2 * M_PI);
        spiral.emplace_back(r * std::cos(t), r * std::sin(t), 0);
        if (degrees <= 340)
            ring.emplace_back(20 * std::cos(t), 20 * std::sin(t), 0);
    }
    const TopoDS_Face roll = face_of(extruded(curve_through(spiral), 40));
    for (const double distance : {2.9, 5.5, 12.0, -2.9, -5.5, -12.0})
        expect_clear(roll, distance);
    const TopoDS_Face open = face_of(extruded(curve_through(ring), 40));
    for (const double distance : {5.0, 50.0, -5.0, -15.0})
        expect_clear(open, distance);
}

TEST(SelfIntersection, AHelicalStairNeverMeetsItself)
{
    std::vector<gp_Pnt> inner, outer;
    for (int degrees = 0; degrees <= 800; degrees += 10)
    {
        const double t = degrees * M_PI / 180, z = 15 * t / (2 * M_PI);
        inner.emplace_back(20 * std::cos(t), 20 * std::sin(t), z);
        outer.emplace_back(40 * std::cos(t), 40 * std::sin(t), z);
    }
    const Handle(Geom_BSplineCurve) low = curve_through(inner);
    TopoDS_Face face;
    {
        // the same knots for both curves: the outer one scales the inner one's poles about the axis
        const auto high = Handle(Geom_BSplineCurve)::DownCast(low->Copy());
        for (int i = 1; i <= high->NbPoles(); ++i)
            high->SetPole(i, gp_Pnt(2 * low->Pole(i).X(), 2 * low->Pole(i).Y(), low->Pole(i).Z()));
        face = face_of(ruled(low, high));
    }
    for (const double distance : {4.0, -4.0, 9.0, -9.0})
        expect_clear(face, distance);
}

TEST(SelfIntersection, SeamsAndPolesAreNoMeetings)
{
    const auto spline = [](const Handle(Geom_Surface) & surface, double v0, double v1) {
        double u0, u1, low, high;
        surface->Bounds(u0, u1, low, high);
        if (v0 < v1)
            return GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(surface, u0, u1, v0, v1));
        return GeomConvert::SurfaceToBSplineSurface(surface);
    };
    struct Case
    {
        const char *what;
        Handle(Geom_BSplineSurface) surface;
        double inwards;
        double outwards;
    };
    const std::vector<Case> cases{{"cylinder", spline(new Geom_CylindricalSurface(gp_Ax3(), 10.0), 0, 30), -8, 40},
                                  {"cone", spline(new Geom_ConicalSurface(gp_Ax3(), 0.3, 10.0), 0, 30), -8, 40},
                                  {"torus", spline(new Geom_ToroidalSurface(gp_Ax3(), 30, 8), 0, 0), -6, 16},
                                  {"sphere", spline(new Geom_SphericalSurface(gp_Ax3(), 25), 0, 0), -20, 40}};
    for (const Case &each : cases)
        for (const double distance : {each.inwards, each.outwards})
        {
            SCOPED_TRACE(each.what);
            const Result<OffsetResult> result = offset(face_of(each.surface), distance);
            EXPECT_TRUE(result.ok() || result.failure().status != Status::SelfIntersection) << why(result);
            EXPECT_TRUE(result.ok()) << why(result);
        }
}

namespace
{

//! The radii and heights of two circles about the z axis.
struct Frustum
{
    double radius[2];
    double height[2];
};

//! Parametrised like a cylinder; a negative radius lies beyond the axis.
Handle(Geom_BSplineSurface) between_circles(const Frustum &frustum)
{
    const Handle(Geom_BSplineSurface) surface = GeomConvert::SurfaceToBSplineSurface(
        new Geom_RectangularTrimmedSurface(new Geom_CylindricalSurface(gp_Ax3(), 1.0), 0.0, 2.0 * M_PI, 0.0, 1.0));
    surface->SetUNotPeriodic();
    for (int i = 1; i <= surface->NbUPoles(); ++i)
        for (int j = 1; j <= 2; ++j)
        {
            const gp_Pnt unit = surface->Pole(i, j);
            const double radius = frustum.radius[j - 1];
            surface->SetPole(i, j, gp_Pnt(radius * unit.X(), radius * unit.Y(), frustum.height[j - 1]));
        }
    return surface;
}

} // namespace

// On the open side of a flat cone's tip the offset leaves a small hole, about which all normals point nearly the same way: it is
// settled at once. On the other side it runs through the axis and comes out again, which is no cap.
TEST(SelfIntersection, TheHoleOfAnOpenedTipIsOneCapAndATurnedTipIsNot)
{
    for (const double slope : {0.02, 0.1, 0.4})
        for (const double distance : {0.2, 0.5, 2.0})
        {
            SCOPED_TRACE(testing::Message() << "slope " << slope << " distance " << distance);
            const double out = distance * std::sin(slope), down = distance * std::cos(slope);
            const double height = 20.0 * std::tan(slope);
            const TopoDS_Face face =
                BRepBuilderAPI_MakeFace(between_circles({{0.0, 20.0}, {0.0, height}}), 1e-6).Face();
            const Result<InputFace> input = read_face(face);
            ASSERT_TRUE(input.ok()) << input.failure().message;
            for (const double side : {1.0, -1.0})
            {
                const Result<SurfaceAnalysis> analysis = analyse(input.value(), side * distance, tolerance);
                ASSERT_TRUE(analysis.ok()) << analysis.failure().message;
                const TensorSpline offset =
                    from_geom(between_circles({{side * out, 20.0 + side * out}, {-side * down, height - side * down}}));
                const SelfIntersectionSearch search =
                    find_self_intersection({analysis.value(), input.value(), offset, side * distance, tolerance});
                const bool is_cap = side > 0.0 || 2.0 * out * std::sin(slope) < 2.0 * tolerance;
                EXPECT_EQ(search.settled && !search.meeting, is_cap);
                if (is_cap)
                {
                    EXPECT_LT(search.pairs, 100);
                }
            }
        }
}

TEST(SelfIntersection, WavySurfacesThatAreGraphsNeverMeet)
{
    RandomCases random;
    int made = 0;
    for (int i = 0; i < 12; ++i)
    {
        const TopoDS_Face face =
            face_of(random_surface(random, {.spans_u = 2 + i % 5, .height = 4.0, .rational = i % 2 == 1}));
        const Result<OffsetLimits> limits = offset_limits(face);
        ASSERT_TRUE(limits.ok() && limits.value().negative && limits.value().positive);
        for (const double distance : {0.8 * limits.value().negative->distance, 0.8 * limits.value().positive->distance})
        {
            const Result<OffsetResult> result = offset(face, distance);
            if (result.ok())
                ++made;
            else if (result.failure().status == Status::SelfIntersection)
                expect_true_meeting(face, distance, result.failure());
        }
    }
    EXPECT_GT(made, 12);
}

TEST(SelfIntersection, RefusalsOfRealFacesAreTrueMeetings)
{
    const auto folder = find_data_dir();
    if (!folder)
        GTEST_SKIP() << missing_data_message("the folder of real models");
    int faces = 0, refused = 0;
    for (const char *model : {"psas_nose_mold.igs", "derived_D150_fuselage_2p3m_1hole_6curves.step",
                              "derived_D150_fuselage_3p4m_2holes_9curves.step"})
        if (const auto path = find_data_file(model))
            for (const TopoDS_Face &face : read_faces(*path))
                for (const double distance : {2.0, -2.0})
                {
                    ++faces;
                    const Result<OffsetResult> result = offset(face, distance);
                    if (result.ok() || result.failure().status != Status::SelfIntersection)
                        continue;
                    ++refused;
                    expect_true_meeting(face, distance, result.failure());
                }
    EXPECT_GT(faces, 50);
    RecordProperty("refused", refused);
}

TEST(PatchBounds, OneToOneNeedsIndependentDerivatives)
{
    const auto box = [](double x, double y, double z, double half) {
        const Eigen::Vector3d middle(x, y, z), width(half, half, half);
        return Eigen::AlignedBox3d(middle - width, middle + width);
    };
    PatchBounds bounds{box(0, 0, 0, 1), box(1, 0, 0, 0.3), box(0, 5, 0, 1.5)};
    EXPECT_TRUE(bounds.one_to_one());
    bounds.du = box(1, 0, 0, 1.0); // may vanish
    EXPECT_FALSE(bounds.one_to_one());
    bounds.du = box(1, 5, 0, 0.3); // may be parallel to the other
    EXPECT_FALSE(bounds.one_to_one());
}

TEST(PatchTree, EnclosesPointsAndDerivatives)
{
    RandomCases random;
    for (const bool rational : {false, true})
    {
        const TensorSpline spline = from_geom(random_surface(random, {.spans_u = 4, .rational = rational}));
        PatchTree tree(spline);
        const PatchBounds whole = whole_bounds(spline);
        for (int i = 0; i < 200; ++i)
        {
            const double u = random.uniform(0.01, 0.99), v = random.uniform(0.01, 0.99);
            const SurfaceJet jet = spline.jets({u}, {v}, 1).front();
            const ParameterBox around{u - 0.01, u + 0.01, v - 0.01, v + 0.01};
            const PatchBounds found = tree.bounds_over(around);
            EXPECT_LT(found.du.exteriorDistance(jet.u), 1e-9);
            EXPECT_LT(found.dv.exteriorDistance(jet.v), 1e-9);
            EXPECT_LT(whole.point.exteriorDistance(jet.s), 1e-9);
            EXPECT_LT(whole.du.exteriorDistance(jet.u), 1e-9);
            EXPECT_LT(whole.dv.exteriorDistance(jet.v), 1e-9);
        }
        tree.split(PatchTree::root());
        EXPECT_GE(tree.node(PatchTree::root()).lower, 0);
    }
}

TEST(PatchTree, HalvedPiecesEncloseTheirOwnPart)
{
    RandomCases random;
    for (int run = 0; run < 20; ++run)
    {
        const TensorSpline spline = from_geom(random_surface(random, {.spans_u = 3, .rational = run % 2 == 1}));
        PatchTree tree(spline);
        int index = PatchTree::root();
        for (int level = 0; level < 16; ++level)
        {
            if (level % 2 == 0)
                tree.split(index);
            else
                tree.split_where_it_bends(index);
            index = random.integer(0, 1) == 0 ? tree.node(index).lower : tree.node(index).upper;
            const PatchNode &node = tree.node(index);
            const double u = random.uniform(node.box.umin, node.box.umax);
            const double v = random.uniform(node.box.vmin, node.box.vmax);
            const SurfaceJet jet = spline.jets({u}, {v}, 1).front();
            EXPECT_LT(node.bounds.du.exteriorDistance(jet.u), 1e-9 * jet.u.norm());
            EXPECT_LT(node.bounds.dv.exteriorDistance(jet.v), 1e-9 * jet.v.norm());
        }
        const PatchNode &node = tree.node(index);
        EXPECT_TRUE(node.is_piece());
        EXPECT_LT(node.bounds.du.sizes().norm(), 0.5 * node.bounds.du.center().norm()) << "the enclosure says nothing";
        EXPECT_LT(node.bounds.dv.sizes().norm(), 0.5 * node.bounds.dv.center().norm());
    }
}

TEST(PatchTree, HalvesALongPieceAcrossItsBend)
{
    TensorSpline spline{clamped_knots(3, 0.0, 1.0, {}), clamped_knots(1, 0.0, 1.0, {}), {}, false};
    for (const auto &[x, z] : {std::pair{0.0, 1.0}, {0.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}})
        for (const double y : {0.0, 1000.0})
            spline.poles.emplace_back(x, y, z, 1.0);
    PatchTree bent(spline), halved(spline);
    bent.split_where_it_bends(PatchTree::root());
    EXPECT_EQ(bent.node(bent.node(PatchTree::root()).lower).box.umax, 0.5);
    halved.split(PatchTree::root());
    EXPECT_EQ(halved.node(halved.node(PatchTree::root()).lower).box.vmax, 0.5);
}

TEST(PatchBounds, AWholeTubeIsNotOneToOneButAQuarterIs)
{
    for (const double radius : {1e-3, 1.0, 1e4})
        for (const double turn : {0.2, 0.5 * M_PI, 2.0 * M_PI})
            for (const bool rational : {true, false})
            {
                const Handle(Geom_Surface) tube = new Geom_RectangularTrimmedSurface(
                    new Geom_CylindricalSurface(gp_Ax3(), radius), 0.0, turn, 0.0, 3.0 * radius);
                TensorSpline spline = from_geom(GeomConvert::SurfaceToBSplineSurface(tube));
                ASSERT_TRUE(spline.rational);
                if (!rational)
                    for (Eigen::Vector4d &pole : spline.poles)
                        pole /= pole.w();
                spline.rational = rational;
                EXPECT_EQ(one_to_one_whole(spline), turn < 2.0) << radius << " " << turn << " " << rational;
            }
}
