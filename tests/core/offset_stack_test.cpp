// SPDX-License-Identifier: LGPL-2.1-or-later
// Stacks of offsets from one fit: every member is judged by itself with OpenCASCADE alone.
#include "support/data_files.h"
#include "support/offset_oracle.h"
#include "support/offsets.h"
#include "support/sample_faces.h"

#include <laminate_offset/offset_stack.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Cone.hxx>
#include <oneapi/tbb/global_control.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace laminate_offset;
using namespace test_support;

namespace
{

Result<StackResult> stack(const TopoDS_Face &face, const std::vector<double> &distances, double tolerance = 1e-3)
{
    OffsetOptions options;
    options.tolerance = tolerance;
    return offset_stack(face, distances, options);
}

std::string why(const Result<StackResult> &result)
{
    return result.ok() ? "ok"
                       : std::string(name(result.failure().status)) + " at " +
                             std::string(name(result.failure().stage)) + ": " + result.failure().message;
}

//! Every member within the tolerance, valid, and within its own proven bounds.
void expect_right(const TopoDS_Face &base, const std::vector<double> &distances, const StackResult &stack,
                  double tolerance)
{
    ASSERT_EQ(stack.surfaces.size(), distances.size());
    for (std::size_t i = 0; i < distances.size(); ++i)
    {
        const OffsetResult &member = stack.surfaces[i];
        const OracleReport seen = measure_offset(base, member.face(), distances[i], {40, 60});
        EXPECT_TRUE(confirms(seen, tolerance)) << "member " << i << " at " << distances[i] << " mm";
        EXPECT_GT(seen.points, 400);
        EXPECT_EQ(member.report.distance, distances[i]);
        ASSERT_TRUE(member.report.certified_error);
        ASSERT_TRUE(member.report.edge_error);
        EXPECT_LE(*member.report.edge_error, tolerance);
        EXPECT_LE(seen.surface_error, *member.report.certified_error + 1e-9);
        EXPECT_LE(seen.edge_error, *member.report.edge_error + 1e-9);
    }
}

} // namespace

TEST(OffsetStack, EveryMemberOfAFreeFormStackIsRightOnItsOwn)
{
    const TopoDS_Face base = panel_with_hole();
    for (const TopoDS_Face &face : {base, reversed(base), located(base)})
        for (const std::vector<double> &distances :
             {std::vector<double>{0.0, 0.125, 0.25, 2.0}, {-1.0, -0.5, 0.5, 1.0}, {3.0, 1.0, 2.0}})
            for (const double tolerance : {1e-1, 1e-3, 1e-5})
            {
                const Result<StackResult> made = stack(face, distances, tolerance);
                ASSERT_TRUE(made) << why(made);
                EXPECT_TRUE(made.value().one_fit);
                expect_right(face, distances, made.value(), tolerance);
            }
}

TEST(OffsetStack, MembersOfOneFitShareKnotsAndAreLinearInTheDistance)
{
    const Result<StackResult> made = stack(panel_with_hole(), {0.0, 1.0, 2.0});
    ASSERT_TRUE(made) << why(made);
    std::vector<Handle(Geom_BSplineSurface)> surfaces;
    for (const OffsetResult &member : made.value().surfaces)
        surfaces.push_back(Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(member.face())));
    for (int i = 1; i <= surfaces[0]->NbUPoles(); ++i)
        for (int j = 1; j <= surfaces[0]->NbVPoles(); ++j)
        {
            const gp_XYZ middle = 0.5 * (surfaces[0]->Pole(i, j).XYZ() + surfaces[2]->Pole(i, j).XYZ());
            EXPECT_LT((surfaces[1]->Pole(i, j).XYZ() - middle).Modulus(), 1e-10);
        }
    for (TopExp_Explorer a(made.value().surfaces[0].shape, TopAbs_EDGE), b(made.value().surfaces[2].shape, TopAbs_EDGE);
         a.More(); a.Next(), b.Next())
    {
        double first = 0.0;
        double last = 0.0;
        const Handle(Geom2d_Curve) low =
            BRep_Tool::CurveOnSurface(TopoDS::Edge(a.Current()), made.value().surfaces[0].face(), first, last);
        const Handle(Geom2d_Curve) high =
            BRep_Tool::CurveOnSurface(TopoDS::Edge(b.Current()), made.value().surfaces[2].face(), first, last);
        for (const double part : {0.0, 0.3, 1.0})
            EXPECT_LT(low->Value(first + part * (last - first)).Distance(high->Value(first + part * (last - first))),
                      1e-12);
    }
}

TEST(OffsetStack, AnalyticBasesStayAnalytic)
{
    const TopoDS_Face sphere = sphere_patch(100.0);
    const std::vector<double> distances{0.0, 0.5, -2.0, 30.0};
    const Result<StackResult> made = stack(sphere, distances);
    ASSERT_TRUE(made) << why(made);
    EXPECT_FALSE(made.value().one_fit);
    expect_right(sphere, distances, made.value(), 1e-3);
    for (std::size_t i = 0; i < distances.size(); ++i)
        EXPECT_EQ(made.value().surfaces[i].report.surface->type, "sphere");
}

TEST(OffsetStack, AStackOfOneIsAnOffset)
{
    const TopoDS_Face face = panel_with_hole();
    const Result<StackResult> made = stack(face, {1.5, 1.5});
    const auto single = offset(face, 1.5);
    ASSERT_TRUE(made) << why(made);
    ASSERT_TRUE(single) << test_support::why(single);
    for (const OffsetResult &member : made.value().surfaces)
    {
        EXPECT_EQ(member.report.surface->poles_u, single.value().report.surface->poles_u);
        EXPECT_EQ(member.report.certified_error, single.value().report.certified_error);
    }
}

TEST(OffsetStack, TheNumberOfThreadsChangesNothing)
{
    std::vector<std::vector<gp_Pnt>> poles;
    for (const std::size_t threads : {1, 2, 4})
    {
        const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism, threads);
        const Result<StackResult> made = stack(panel_with_hole(), {0.0, 0.7, 1.9});
        ASSERT_TRUE(made) << why(made);
        poles.emplace_back();
        for (const OffsetResult &member : made.value().surfaces)
        {
            const auto surface = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(member.face()));
            for (int i = 1; i <= surface->NbUPoles(); ++i)
                for (int j = 1; j <= surface->NbVPoles(); ++j)
                    poles.back().push_back(surface->Pole(i, j));
        }
    }
    for (const std::vector<gp_Pnt> &other : poles)
    {
        ASSERT_EQ(other.size(), poles.front().size());
        for (std::size_t i = 0; i < other.size(); ++i)
            EXPECT_EQ(other[i].Distance(poles.front()[i]), 0.0);
    }
}

TEST(OffsetStack, EachSurfaceByItselfHasNoMorePolesThanTheFamily)
{
    const std::vector<double> distances{0.0, 0.125, 0.5, 2.0, 8.0};
    const Result<StackResult> family = stack(panel_with_hole(), distances);
    OffsetOptions options;
    options.tolerance = 1e-3;
    const Result<StackResult> each = offset_stack(panel_with_hole(), distances, options, StackFit::Each);
    ASSERT_TRUE(family) << why(family);
    ASSERT_TRUE(each) << why(each);
    EXPECT_FALSE(each.value().one_fit);
    expect_right(panel_with_hole(), distances, each.value(), options.tolerance);
    int fewer = 0;
    for (std::size_t i = 0; i < distances.size(); ++i)
    {
        const auto poles = [&](const StackResult &made) {
            return made.surfaces[i].report.surface->poles_u * made.surfaces[i].report.surface->poles_v;
        };
        EXPECT_LE(poles(each.value()), poles(family.value())) << distances[i];
        fewer += poles(each.value()) < poles(family.value()) ? 1 : 0;
    }
    EXPECT_GE(fewer, 2);
}

TEST(OffsetStack, TwoHundredPliesOnARealNose)
{
    const std::string name = "derived_D150_fuselage_2p3m_1hole_6curves.step";
    const auto path = find_data_file(name);
    if (!path)
        GTEST_SKIP() << missing_data_message(name);
    const TopoDS_Face face = read_faces(*path).front();
    std::vector<double> distances;
    for (int ply = 0; ply <= 200; ++ply)
        distances.push_back(0.125 * ply);
    const Result<StackResult> made = stack(face, distances);
    ASSERT_TRUE(made) << why(made);
    EXPECT_TRUE(made.value().one_fit);
    for (const OffsetResult &member : made.value().surfaces)
        EXPECT_TRUE(BRepCheck_Analyzer(member.shape).IsValid());
    expect_right(
        face, {0.0, 8.0, 25.0},
        StackResult{{made.value().surfaces[0], made.value().surfaces[64], made.value().surfaces[200]}, true, {}}, 1e-3);
}

TEST(OffsetStackRefusal, NamesTheDistanceThatIsOutOfReach)
{
    const TopoDS_Face sphere = sphere_patch(10.0);
    for (const std::vector<double> &distances : {std::vector<double>{0.0, -11.0}, {1.0, -12.0, 2.0}})
    {
        const Result<StackResult> made = stack(sphere, distances);
        ASSERT_FALSE(made);
        EXPECT_EQ(made.failure().status, Status::CurvatureLimit);
        EXPECT_TRUE(made.failure().where);
        ASSERT_TRUE(made.failure().feasible_range);
        EXPECT_NEAR(*made.failure().feasible_range->negative, -10.0, 1e-6);
    }
}

TEST(OffsetStackRefusal, BadArguments)
{
    const TopoDS_Face face = panel_with_hole();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(stack(face, {}).failure().status, Status::InvalidOption);
    EXPECT_EQ(stack(face, {0.0, nan}).failure().status, Status::InvalidDistance);
    EXPECT_EQ(stack(face, {0.0, 1.0}, 0.0).failure().status, Status::InvalidTolerance);
    EXPECT_EQ(offset_stack(TopoDS_Shape(), {1.0}, {}).failure().status, Status::NullShape);
}

TEST(OffsetStackRefusal, CancellingLeavesNothing)
{
    for (const double from : {0.0, 0.2, 0.6})
    {
        OffsetOptions options;
        std::atomic<int> calls{0};
        options.progress = [&](double fraction) {
            ++calls;
            EXPECT_GE(fraction, 0.0);
            EXPECT_LE(fraction, 1.0);
            return fraction < from;
        };
        const Result<StackResult> made = offset_stack(panel_with_hole(), {0.0, 1.0, 2.0, 3.0}, options);
        ASSERT_FALSE(made);
        EXPECT_EQ(made.failure().status, Status::Cancelled);
        EXPECT_GT(calls, 0);
    }
}
