// SPDX-License-Identifier: LGPL-2.1-or-later
// The judge of all offsets must itself be right: it accepts exact offsets and measures known faults.
#include "support/data_files.h"
#include "support/offset_oracle.h"
#include "support/sample_faces.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <TopoDS.hxx>
#include <gp_Trsf.hxx>

#include <gtest/gtest.h>

using namespace test_support;

namespace
{

constexpr OracleOptions coarse{40, 30};

TopoDS_Face shifted(const TopoDS_Face &face, const gp_Vec &by)
{
    gp_Trsf shift;
    shift.SetTranslation(by);
    return TopoDS::Face(BRepBuilderAPI_Transform(face, shift, true).Shape());
}

} // namespace

TEST(OffsetOracle, AcceptsExactOffsetsOfASphereOnBothSides)
{
    for (const double distance : {25.0, -25.0})
    {
        const OracleReport report =
            measure_offset(sphere_patch(100.0), sphere_patch(100.0 + distance), distance, coarse);
        EXPECT_TRUE(confirms(report, 1e-9)) << to_text(report);
        EXPECT_GT(report.points, 1000);
        EXPECT_EQ(report.compared_edges, 4);
    }
}

TEST(OffsetOracle, TurnsTheDistanceWithAReversedFace)
{
    const TopoDS_Face base = reversed(sphere_patch(100.0));
    EXPECT_TRUE(confirms(measure_offset(base, reversed(sphere_patch(75.0)), 25.0, coarse), 1e-9));
    EXPECT_FALSE(confirms(measure_offset(base, reversed(sphere_patch(125.0)), 25.0, coarse), 1.0));
}

TEST(OffsetOracle, MeasuresAKnownSurfaceError)
{
    const OracleReport report = measure_offset(sphere_patch(100.0), sphere_patch(125.004), 25.0, coarse);
    EXPECT_NEAR(report.surface_error, 0.004, 1e-9);
    EXPECT_NEAR(report.converse_error, 0.004, 1e-9);
    EXPECT_NEAR(report.vertex_error, 0.004, 1e-9);
    EXPECT_NEAR(report.edge_converse, 0.004, 1e-9);
    EXPECT_GT(report.edge_error, 0.0039);
    EXPECT_FALSE(confirms(report, 0.003));
    EXPECT_TRUE(confirms(report, 0.005));
}

TEST(OffsetOracle, SeesASlippedEdgeThatTheSurfaceErrorHides)
{
    const auto flat = [](double, double) { return 0.0; };
    const TopoDS_Face base = BRepBuilderAPI_MakeFace(height_surface(flat, 100.0, 100.0, 4, 4), 1e-7);
    const OracleReport report = measure_offset(base, shifted(base, gp_Vec(0.5, 0.0, 10.0)), 10.0, coarse);
    EXPECT_NEAR(report.converse_error, 0.0, 1e-9);
    EXPECT_NEAR(report.edge_error, 0.5, 1e-9);
    EXPECT_NEAR(report.vertex_error, 0.5, 1e-9);
    EXPECT_FALSE(confirms(report, 0.1));
}

TEST(OffsetOracle, SeesAFlippedNormalAndALostLoop)
{
    const TopoDS_Face flipped = reversed(sphere_patch(125.0));
    EXPECT_FALSE(confirms(measure_offset(sphere_patch(100.0), flipped, 25.0, coarse), 1.0));
    const TopoDS_Face base = panel_with_hole();
    const OracleReport report = measure_offset(base, sphere_patch(100.0), 0.0, {10, 4});
    EXPECT_EQ(report.base_loops, 2);
    EXPECT_EQ(report.loops, 1);
    EXPECT_FALSE(confirms(report, 1e6));
}

TEST(OffsetOracle, AcceptsTheFaceItselfAtDistanceZeroWhereverItLies)
{
    const TopoDS_Face base = panel_with_hole();
    for (const TopoDS_Face &face : {base, reversed(base), located(base), reversed(located(base))})
    {
        const OracleReport report = measure_offset(face, face, 0.0, coarse);
        EXPECT_TRUE(confirms(report, 1e-5)) << to_text(report); // its own edge tolerance
        EXPECT_EQ(report.loops, 2);
        EXPECT_EQ(report.edges, 5);
    }
}

TEST(OffsetOracle, KnowsWhenAnOffsetFolds)
{
    EXPECT_NEAR(least_curvature_factor(sphere_patch(100.0), -60.0, 20), 0.4, 1e-9);
    EXPECT_LT(least_curvature_factor(sphere_patch(100.0), -101.0, 20), 0.0);
    EXPECT_GT(least_curvature_factor(reversed(sphere_patch(100.0)), -101.0, 20), 1.0);
    const TopoDS_Face panel = panel_with_hole();
    EXPECT_GT(least_curvature_factor(panel, 300.0), 0.0);
    EXPECT_GT(least_curvature_factor(panel, -300.0), 0.0);
}

TEST(DataFiles, ReadTheProjectsOwnExamples)
{
    const auto faces = read_faces(example_file("panel_two_holes.step"));
    ASSERT_EQ(faces.size(), 1u);
    const OracleReport report = measure_offset(faces[0], faces[0], 0.0, {20, 20});
    EXPECT_EQ(report.loops, 3);
    EXPECT_EQ(report.edges, 9);
    EXPECT_TRUE(confirms(report, 1e-4)) << to_text(report);
    EXPECT_GT(least_curvature_factor(faces[0], 343.0), 0.0);
    EXPECT_GT(least_curvature_factor(faces[0], -343.0), 0.0);
    EXPECT_THROW(read_faces(example_file("absent.step")), std::runtime_error);
}
