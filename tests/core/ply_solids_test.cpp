// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids between the surfaces of a stack: validity, closure, volume and shared faces, judged by OpenCASCADE alone.
#include "support/data_files.h"
#include "support/sample_faces.h"

#include <laminate_offset/face_integrals.h>
#include <laminate_offset/offset_stack.h>
#include <laminate_offset/ply_solids.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <oneapi/tbb/global_control.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace laminate_offset;
using namespace test_support;

namespace
{

constexpr double pi = std::numbers::pi;

//! Solids between neighbouring distances, and one between the first and the last.
struct Laid
{
    StackResult stack;
    std::vector<TopoDS_Solid> solids;
};

Laid laid(const TopoDS_Face &face, const std::vector<double> &distances, double tolerance)
{
    OffsetOptions options;
    options.tolerance = tolerance;
    const Result<StackResult> stack = offset_stack(face, distances, options);
    EXPECT_TRUE(stack) << (stack ? "" : stack.failure().message);
    if (!stack)
        return {};
    std::vector<TopoDS_Shape> faces;
    for (const OffsetResult &surface : stack.value().surfaces)
        faces.push_back(surface.shape);
    std::vector<SolidSpan> spans;
    for (std::size_t i = 0; i + 1 < faces.size(); ++i)
        spans.push_back({i, i + 1});
    spans.push_back({0, faces.size() - 1});
    const Result<std::vector<TopoDS_Solid>> solids = ply_solids(faces, spans);
    EXPECT_TRUE(solids) << (solids ? "" : solids.failure().message);
    return {stack.value(), solids ? solids.value() : std::vector<TopoDS_Solid>{}};
}

double volume_of(const TopoDS_Shape &solid, double accuracy)
{
    constexpr double margin = 0.01; // OpenCASCADE's accuracy is a wish: it misses 1e-6 by a factor of 25
    GProp_GProps properties;
    BRepGProp::VolumeProperties(solid, properties, margin * accuracy);
    return properties.Mass();
}

int edges_used_otherwise_than_twice(const TopoDS_Shape &solid)
{
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(solid, TopAbs_EDGE, edges);
    std::vector<int> sums(static_cast<std::size_t>(edges.Extent()), 0);
    std::vector<int> counts(sums);
    for (TopExp_Explorer it(solid, TopAbs_EDGE); it.More(); it.Next())
    {
        const auto k = static_cast<std::size_t>(edges.FindIndex(it.Current())) - 1;
        sums[k] += it.Current().Orientation() == TopAbs_FORWARD ? 1 : -1;
        ++counts[k];
    }
    int wrong = 0;
    for (std::size_t k = 0; k < sums.size(); ++k)
        if (!BRep_Tool::Degenerated(TopoDS::Edge(edges(static_cast<int>(k) + 1))) && (sums[k] != 0 || counts[k] != 2))
            ++wrong;
    return wrong;
}

//! Every solid valid, closed, outward and as large as the integrals of the base say.
void expect_right(const TopoDS_Face &face, const std::vector<double> &distances, double tolerance,
                  double accuracy = 1e-7)
{
    const Laid made = laid(face, distances, tolerance);
    ASSERT_EQ(made.solids.size(), distances.size());
    const Result<FaceIntegrals> base = face_integrals(face);
    ASSERT_TRUE(base);
    for (std::size_t i = 0; i < made.solids.size(); ++i)
    {
        const bool whole = i + 1 == distances.size();
        const double low = whole ? distances.front() : distances[i];
        const double high = whole ? distances.back() : distances[i + 1];
        const TopoDS_Solid &solid = made.solids[i];
        EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
        const TopoDS_Shell shell = TopoDS::Shell(TopExp_Explorer(solid, TopAbs_SHELL).Current());
        EXPECT_TRUE(BRep_Tool::IsClosed(shell));
        EXPECT_EQ(edges_used_otherwise_than_twice(solid), 0);
        const double volume = base.value().volume(low, high);
        const double fitted = made.stack.one_fit ? 2.0 * tolerance * base.value().area : 0.0;
        EXPECT_GT(volume, 0.0);
        EXPECT_NEAR(volume_of(solid, accuracy), volume, fitted + 10.0 * accuracy * volume) << "solid " << i;
    }
}

Handle(Geom_Surface) handle(Geom_Surface *surface) { return surface; }

TopoDS_Face patch(Geom_Surface *surface, double u0, double u1, double v0, double v1)
{
    return BRepBuilderAPI_MakeFace(handle(surface), u0, u1, v0, v1, 1e-7).Face();
}

} // namespace

TEST(PlySolids, FreeFormPanelWithAHole)
{
    const TopoDS_Face panel = panel_with_hole();
    for (const TopoDS_Face &face : {panel, reversed(panel), located(panel)})
        for (const std::vector<double> &distances :
             {std::vector<double>{0.0, 0.25, 0.5, 2.0}, {-3.0, -1.0, 0.0, 0.125}})
            expect_right(face, distances, 1e-5, 1e-6);
}

TEST(PlySolids, AnalyticFaces)
{
    const std::vector<double> distances{-0.5, 0.0, 0.25, 1.0};
    const TopoDS_Face faces[] = {
        patch(new Geom_Plane(gp_Ax3()), 0.0, 40.0, 0.0, 30.0),
        patch(new Geom_CylindricalSurface(gp_Ax3(), 20.0), 0.2, 2.0, 0.0, 30.0),
        patch(new Geom_CylindricalSurface(gp_Ax3(), 20.0), 0.0, 2.0 * pi, 0.0, 30.0),
        patch(new Geom_ConicalSurface(gp_Ax3(), 0.3, 20.0), 0.2, 2.0, 0.0, 30.0),
        patch(new Geom_ConicalSurface(gp_Ax3(), 0.3, 20.0), 0.0, 2.0 * pi, 0.0, 30.0),
        sphere_patch(50.0),
        patch(new Geom_SphericalSurface(gp_Ax3(), 30.0), 0.0, 2.0 * pi, 0.0, 0.5 * pi),  // a pole, a seam, a plane side
        patch(new Geom_SphericalSurface(gp_Ax3(), 30.0), 0.0, 2.0 * pi, -0.7, 0.5 * pi), // a pole, a seam, a cone
        patch(new Geom_SphericalSurface(gp_Ax3(), 30.0), 0.3, 1.1, 0.2, 0.5 * pi),       // a pole in a corner
        patch(new Geom_ToroidalSurface(gp_Ax3(), 60.0, 20.0), 0.3, 1.1, 0.2, 2.9),
        patch(new Geom_ToroidalSurface(gp_Ax3(), 60.0, 20.0), 0.0, 2.0 * pi, 0.2, 2.9),
    };
    int number = 0;
    for (const TopoDS_Face &base : faces)
        for (const TopoDS_Face &face : {base, reversed(base), located(base)})
        {
            SCOPED_TRACE("face " + std::to_string(number++));
            expect_right(face, distances, 1e-3, 1e-9);
        }
}

TEST(PlySolids, AFaceUnderAMirror)
{
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(0, 0, 5), gp_Dir(0, 1, 1)));
    constexpr bool refuse_mirrors = false;
    expect_right(TopoDS::Face(panel_with_hole().Located(TopLoc_Location(mirror), refuse_mirrors)), {0.0, 0.5, 1.0},
                 1e-5, 1e-6);
}

TEST(PlySolids, PeriodicSpline)
{
    const TopoDS_Face tube = BRepBuilderAPI_MakeFace(handle(wavy_tube(50.0).get()), 1e-7).Face();
    expect_right(tube, {-0.5, 0.0, 0.25, 1.0}, 1e-5, 1e-6);
}

TEST(PlySolids, NeighboursShareTheirFaceAndHaveOnlyTheSidesOfTheirEdges)
{
    const Laid made = laid(panel_with_hole(), {0.0, 0.25, 0.5}, 1e-3);
    ASSERT_EQ(made.solids.size(), 3u);
    TopTools_IndexedMapOfShape lower, upper, whole;
    TopExp::MapShapes(made.solids[0], TopAbs_FACE, lower);
    TopExp::MapShapes(made.solids[1], TopAbs_FACE, upper);
    TopExp::MapShapes(made.solids[2], TopAbs_FACE, whole);
    EXPECT_EQ(lower.Extent(), 7); // two faces, four sides outside, one inside the hole
    int shared = 0;
    for (int i = 1; i <= upper.Extent(); ++i)
        if (const int index = lower.FindIndex(upper(i)))
        {
            ++shared;
            EXPECT_NE(lower(index).Orientation(), upper(i).Orientation());
        }
    EXPECT_EQ(shared, 1);
    int ends = 0;
    for (int i = 1; i <= whole.Extent(); ++i)
        ends += (lower.Contains(whole(i)) || upper.Contains(whole(i))) ? 1 : 0;
    EXPECT_EQ(ends, 2);
}

TEST(PlySolids, TheFacesGivenAreNotTouched)
{
    OffsetOptions options;
    const Result<StackResult> stack = offset_stack(panel_with_hole(), {0.0, 1.0}, options);
    ASSERT_TRUE(stack);
    const std::vector<TopoDS_Shape> faces{stack.value().surfaces[0].shape, stack.value().surfaces[1].shape};
    const auto pcurves = [&] {
        int count = 0;
        for (TopExp_Explorer it(faces[0], TopAbs_EDGE); it.More(); it.Next())
            for (int index = 1; index < 9; ++index)
            {
                Handle(Geom2d_Curve) curve;
                Handle(Geom_Surface) surface;
                TopLoc_Location place;
                double first, last;
                BRep_Tool::CurveOnSurface(TopoDS::Edge(it.Current()), curve, surface, place, first, last, index);
                count += curve.IsNull() ? 0 : 1;
            }
        return count;
    };
    const int before = pcurves();
    ASSERT_TRUE(ply_solids(faces, {{0, 1}}));
    EXPECT_EQ(pcurves(), before);
}

TEST(PlySolids, TheNumberOfThreadsChangesNothing)
{
    std::vector<std::vector<gp_Pnt>> corners;
    for (const std::size_t threads : {1, 2, 4})
    {
        const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism, threads);
        corners.emplace_back();
        for (const TopoDS_Solid &solid : laid(panel_with_hole(), {0.0, 0.7, 1.9}, 1e-3).solids)
            for (TopExp_Explorer it(solid, TopAbs_VERTEX); it.More(); it.Next())
                corners.back().push_back(BRep_Tool::Pnt(TopoDS::Vertex(it.Current())));
    }
    for (const std::vector<gp_Pnt> &other : corners)
    {
        ASSERT_EQ(other.size(), corners.front().size());
        ASSERT_GT(other.size(), 30u);
        for (std::size_t i = 0; i < other.size(); ++i)
            EXPECT_EQ(other[i].Distance(corners.front()[i]), 0.0);
    }
}

TEST(PlySolids, ShippedPanelAndRealFuselages)
{
    std::vector<std::filesystem::path> paths{example_file("panel_two_holes.step")};
    for (const char *name :
         {"derived_D150_fuselage_2p3m_1hole_6curves.step", "derived_D150_fuselage_3p4m_2holes_9curves.step"})
        if (const auto path = find_data_file(name))
            paths.push_back(*path);
    for (const std::filesystem::path &path : paths)
    {
        SCOPED_TRACE(path.filename().string());
        expect_right(read_faces(path).front(), {0.0, 0.125, 0.25, 0.375}, 1e-3, 1e-5);
    }
}

TEST(PlySolidsRefusal, FacesThatDoNotBelongTogether)
{
    OffsetOptions options;
    const Result<StackResult> stack = offset_stack(panel_with_hole(), {0.0, 1.0}, options);
    ASSERT_TRUE(stack);
    const TopoDS_Shape a = stack.value().surfaces[0].shape;
    const TopoDS_Shape b = stack.value().surfaces[1].shape;
    const auto status = [](const Result<std::vector<TopoDS_Solid>> &result) {
        return result.ok() ? Status::Ok : result.failure().status;
    };
    EXPECT_EQ(status(ply_solids({a, b}, {{0, 1}})), Status::Ok);
    EXPECT_EQ(status(ply_solids({a, b}, {{0, 2}})), Status::InvalidOption);
    EXPECT_EQ(status(ply_solids({a, b}, {{1, 1}})), Status::InvalidOption);
    EXPECT_EQ(status(ply_solids({a, b.Reversed()}, {{0, 1}})), Status::NotSupported);
    EXPECT_EQ(status(ply_solids({a, sphere_patch(10.0)}, {{0, 1}})), Status::NotSupported);
    EXPECT_EQ(status(ply_solids({a, a}, {{0, 1}})), Status::NotSupported);
    EXPECT_EQ(status(ply_solids({a, TopoDS_Shape()}, {{0, 1}})), Status::NotAFace);
}
