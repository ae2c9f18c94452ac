// SPDX-License-Identifier: LGPL-2.1-or-later
// Offsets of real and of the project's own trimmed faces, judged by an oracle that shares no code with the engine.
#include "support/data_files.h"
#include "support/offset_oracle.h"
#include "support/offsets.h"
#include "support/sample_faces.h"

#include <laminate_offset/analysis/analytic_form.h>
#include <laminate_offset/offset_face.h>

#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>

#include <gtest/gtest.h>

#include <map>

using namespace laminate_offset;
using namespace test_support;

namespace
{

constexpr double tolerance = 1e-3;
constexpr double clearly = 0.02;         // a curvature factor so far from zero leaves no doubt on a dense grid
constexpr double oracle_rounding = 1e-9; // mm, of the oracle's own evaluation and search on models of metres

bool is_spline_face(const TopoDS_Face &face)
{
    return !Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face)).IsNull();
}

//! Does the offset keep the base's own parameters, without a shift? A swept line or circle that is one of the five kinds
//! need not.
bool keeps_parameters(const TopoDS_Face &face)
{
    const auto form = analytic_form(read_face(face).value());
    return !form || form->shift.Magnitude() == 0.0;
}

//! A proven bound lies above whatever an independent measurement finds. Returns whether there was one to hold against.
bool expect_bounds_hold(const TopoDS_Face &face, const OffsetReport &proven, const OracleReport &seen)
{
    if (proven.certified_error)
    {
        EXPECT_LE(*proven.certified_error, tolerance);
        EXPECT_LE(seen.surface_error, *proven.certified_error + oracle_rounding);
        if (keeps_parameters(face))
        {
            EXPECT_LE(seen.parametric_error, *proven.certified_error + oracle_rounding) << "same-parameter offset";
        }
    }
    if (proven.edge_error)
    {
        EXPECT_LE(*proven.edge_error, tolerance);
        EXPECT_LE(seen.edge_error, *proven.edge_error + oracle_rounding);
    }
    return proven.certified_error && seen.points >= 50;
}

//! The offset must succeed and be right.
void expect_offset(const TopoDS_Face &face, double distance, int loops, int edges, const OracleOptions &how = {})
{
    SCOPED_TRACE("distance " + std::to_string(distance));
    const Result<OffsetResult> result = offset(face, distance);
    ASSERT_TRUE(result.ok()) << why(result);
    const OffsetResult &made = result.value();
    const OracleReport report = measure_offset(face, made.face(), distance, how);
    EXPECT_TRUE(confirms(report, tolerance));
    EXPECT_EQ(report.loops, loops);
    EXPECT_EQ(report.edges, edges);
    EXPECT_TRUE(is_spline_face(made.face()));
    EXPECT_EQ(made.report.loops, loops);
    EXPECT_EQ(made.report.edges, edges);
    EXPECT_EQ(made.report.status, Status::Ok);
    EXPECT_TRUE(expect_bounds_hold(face, made.report, report)) << "no proven bound on a spline face";
    testing::Test::RecordProperty("figures", to_text(report));
}

void expect_curvature_refusal(const TopoDS_Face &face, double distance)
{
    SCOPED_TRACE("distance " + std::to_string(distance));
    const Result<OffsetResult> result = offset(face, distance);
    ASSERT_FALSE(result.ok()) << "a folded offset was handed out";
    EXPECT_EQ(result.failure().status, Status::CurvatureLimit) << why(result);
    EXPECT_EQ(result.failure().stage, Stage::Analysis) << why(result);
    EXPECT_FALSE(result.failure().message.empty());
    EXPECT_TRUE(result.failure().where.has_value());
}

//! Right where a dense check of the curvature finds the offset regular, refused where it folds.
void expect_offset_or_limit(const TopoDS_Face &face, double distance, int loops, int edges)
{
    const double factor = least_curvature_factor(face, distance);
    ASSERT_GT(std::abs(factor), clearly) << "the distance " << distance << " is too near the limit to judge";
    if (factor > 0.0)
        expect_offset(face, distance, loops, edges);
    else
        expect_curvature_refusal(face, distance);
}

class RealModel : public testing::Test
{
protected:
    //! The only face of a real model; a null face (and the test skipped) where the model is absent.
    TopoDS_Face only_face(const std::string &name)
    {
        const auto path = find_data_file(name);
        if (!path)
            return {};
        const auto faces = read_faces(*path);
        EXPECT_EQ(faces.size(), 1u);
        return faces.empty() ? TopoDS_Face() : faces.front();
    }
};

//! Counts of what became of the faces of a model.
struct Outcome
{
    int made = 0, proven = 0, refused = 0;
};

//! Right, or refused with a reason that an independent check of the curvature shares.
void judge(const TopoDS_Face &face, double distance, Outcome &outcome)
{
    const Result<OffsetResult> result = offset(face, distance);
    if (result.ok())
    {
        ++outcome.made;
        const OracleReport seen = measure_offset(face, result.value().face(), distance, {40, 25});
        EXPECT_TRUE(confirms(seen, tolerance));
        outcome.proven += expect_bounds_hold(face, result.value().report, seen);
        return;
    }
    ++outcome.refused;
    const Failure &failure = result.failure();
    EXPECT_EQ(failure.status, Status::CurvatureLimit) << why(result);
    EXPECT_EQ(failure.stage, Stage::Analysis) << why(result);
    EXPECT_GT(failure.message.size(), 20u) << why(result);
    EXPECT_TRUE(failure.where.has_value()) << why(result);
    EXPECT_LT(least_curvature_factor(face, distance, 100), clearly) << "refused without need: " << why(result);
}

constexpr const char *one_hole = "derived_D150_fuselage_2p3m_1hole_6curves.step";
constexpr const char *two_holes = "derived_D150_fuselage_3p4m_2holes_9curves.step";
constexpr const char *mould = "psas_nose_mold.igs";

} // namespace

TEST_F(RealModel, FuselageNoseWithOneHole)
{
    const TopoDS_Face face = only_face(one_hole);
    if (face.IsNull())
        GTEST_SKIP() << missing_data_message(one_hole);
    expect_offset(face, 5.0, 2, 6);
    expect_offset(face, -5.0, 2, 6);
}

TEST_F(RealModel, FuselageNoseAtTheDistanceOfThePaper)
{
    const TopoDS_Face face = only_face(one_hole);
    if (face.IsNull())
        GTEST_SKIP() << missing_data_message(one_hole);
    for (const double distance : {227.0, -227.0})
    {
        ASSERT_GT(least_curvature_factor(face, distance), clearly) << "feasible, so it must be made";
        expect_offset(face, distance, 2, 6);
    }
}

TEST_F(RealModel, FuselageNoseRefusesADistancePastItsRadius)
{
    const TopoDS_Face face = only_face(one_hole);
    if (face.IsNull())
        GTEST_SKIP() << missing_data_message(one_hole);
    for (const double distance : {2000.0, -2000.0})
    {
        ASSERT_LT(least_curvature_factor(face, distance), -clearly);
        expect_curvature_refusal(face, distance);
    }
}

TEST_F(RealModel, FuselagePanelWithTwoHoles)
{
    const TopoDS_Face face = only_face(two_holes);
    if (face.IsNull())
        GTEST_SKIP() << missing_data_message(two_holes);
    expect_offset(face, 5.0, 3, 9);
    expect_offset(face, -5.0, 3, 9);
    expect_offset_or_limit(face, 343.0, 3, 9);
    expect_offset_or_limit(face, -343.0, 3, 9);
}

TEST_F(RealModel, EveryFaceOfTheNoseMouldIsRightOrRefusedWithAReason)
{
    const auto path = find_data_file(mould);
    if (!path)
        GTEST_SKIP() << missing_data_message(mould);
    const auto faces = read_faces(*path);
    ASSERT_EQ(faces.size(), 59u);
    // Thin laminates are made on every face; far past the tightest radii of 12 and 25 mm many faces fold.
    const std::map<double, Outcome> least = {{0.5, {59, 28, 0}},  {-0.5, {59, 28, 0}},   {2.0, {59, 28, 0}},
                                             {-2.0, {59, 28, 0}}, {227.0, {20, 20, 30}}, {-227.0, {50, 20, 3}}};
    for (const auto &[distance, at_least] : least)
    {
        Outcome outcome;
        for (size_t i = 0; i < faces.size(); ++i)
        {
            SCOPED_TRACE("face " + std::to_string(i + 1) + " distance " + std::to_string(distance));
            judge(faces[i], distance, outcome);
        }
        EXPECT_GE(outcome.made, at_least.made) << "of 59 faces at distance " << distance;
        EXPECT_GE(outcome.proven, at_least.proven) << "of 59 faces at distance " << distance;
        EXPECT_GE(outcome.refused, at_least.refused) << "the mould folds at distance " << distance;
        RecordProperty("made_at_" + std::to_string(distance), outcome.made);
    }
}

TEST(ProjectExamples, PanelWithTwoHoles)
{
    const TopoDS_Face face = read_faces(example_file("panel_two_holes.step")).at(0);
    for (const double distance : {5.0, -5.0, 343.0, -343.0})
        expect_offset(face, distance, 3, 9, {80, 100});
}

TEST(ProjectExamples, WingSkin)
{
    const TopoDS_Face face = read_faces(example_file("naca_wing_skin.step")).at(0);
    for (const double distance : {4.0, -4.0})
        expect_offset(face, distance, 2, 6, {80, 100});
    ASSERT_LT(least_curvature_factor(face, -60.0), -clearly);
    expect_curvature_refusal(face, -60.0);
}

TEST(ProjectExamples, WigleyHull)
{
    const TopoDS_Face face = read_faces(example_file("wigley_hull.step")).at(0);
    for (const double distance : {12.0, -12.0})
        expect_offset(face, distance, 2, 6, {80, 100});
}

TEST(GeneratedFaces, ReversedAndLocatedFacesKeepTheMeaningOfTheSign)
{
    const TopoDS_Face panel = panel_with_hole();
    for (const TopoDS_Face &face : {panel, reversed(panel), located(panel), reversed(located(panel))})
        for (const double distance : {7.0, -7.0})
            expect_offset(face, distance, 2, 5, {60, 60});
}

TEST(GeneratedFaces, ReversingTheFaceEqualsTurningTheDistance)
{
    const TopoDS_Face panel = panel_with_hole();
    const auto outward = offset(reversed(panel), 7.0);
    ASSERT_TRUE(outward.ok()) << why(outward);
    const OracleReport same_place = measure_offset(panel, reversed(outward.value().face()), -7.0, {60, 60});
    EXPECT_TRUE(confirms(same_place, tolerance));
}

TEST(GeneratedFaces, TheBaseIsLeftAsItWas)
{
    const TopoDS_Face panel = panel_with_hole();
    const OracleReport before = measure_offset(panel, panel, 0.0, {20, 20});
    ASSERT_TRUE(offset(panel, 7.0).ok());
    const OracleReport after = measure_offset(panel, panel, 0.0, {20, 20});
    EXPECT_EQ(to_text(before), to_text(after));
}
