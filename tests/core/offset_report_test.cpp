// SPDX-License-Identifier: LGPL-2.1-or-later
// The report's JSON: the names that users rely on, and nothing that is not a number.
#include "support/sample_faces.h"

#include <laminate_offset/offset_face.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <set>
#include <string>

using namespace laminate_offset;
using namespace test_support;

namespace
{

using Json = nlohmann::ordered_json;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::set<std::string> keys(const Json &json)
{
    std::set<std::string> result;
    for (const auto &item : json.items())
        result.insert(item.key());
    return result;
}

//! Keys may be added, never dropped.
void expect_keys(const Json &json, const std::set<std::string> &wanted)
{
    const std::set<std::string> present = keys(json);
    for (const std::string &key : wanted)
        EXPECT_TRUE(present.count(key)) << "no key " << key;
}

const std::set<std::string> fixed_names{
    "status",          "stage",         "message",    "where",   "method", "distance",      "tolerance",
    "certified_error", "sampled_error", "edge_error", "surface", "limits", "limits_proven", "self_intersection",
    "loops",           "edges",         "faces",      "gap",     "crease", "elapsed_ms"};

Json report_of(const TopoDS_Shape &shape, double distance)
{
    OffsetOptions options;
    options.distance = distance;
    const Result<OffsetResult> result = offset_face(shape, options);
    const OffsetReport report = result.ok() ? result.value().report : refusal_report(result.failure(), options);
    return Json::parse(to_json_text(report));
}

} // namespace

TEST(OffsetReport, WhatIsNotSettledIsSaid)
{
    OffsetReport report;
    report.limits = FeasibleRange{};
    Json json = Json::parse(to_json_text(report));
    EXPECT_EQ(json["self_intersection"], "none");
    EXPECT_EQ(json["limits_proven"], true);
    report.apart = false;
    report.limits_proven = false;
    json = Json::parse(to_json_text(report));
    EXPECT_EQ(json["self_intersection"], "undecided");
    EXPECT_EQ(json["limits_proven"], false);
    EXPECT_NE(to_text(report).find("not settled"), std::string::npos);
    report.status = Status::CurvatureLimit;
    report.limits.reset();
    json = Json::parse(to_json_text(report));
    EXPECT_TRUE(json["self_intersection"].is_null());
    EXPECT_TRUE(json["limits_proven"].is_null());
}

TEST(OffsetReport, OfAFittedFaceHasEveryFixedName)
{
    const Json json = report_of(panel_with_hole(), 5.0);
    expect_keys(json, fixed_names);
    EXPECT_EQ(json["status"], "ok");
    EXPECT_EQ(json["method"], "same-parameter");
    EXPECT_EQ(json["distance"], 5.0);
    EXPECT_EQ(json["tolerance"], 1e-3);
    EXPECT_TRUE(json["where"].is_null());
    expect_keys(json["surface"], {"type", "degree_u", "degree_v", "poles_u", "poles_v", "rational"});
    EXPECT_EQ(json["surface"]["type"], "bspline");
    EXPECT_GE(json["surface"]["degree_u"].get<int>(), 3);
    EXPECT_GE(json["surface"]["poles_u"].get<int>(), 4);
    EXPECT_FALSE(json["surface"]["rational"].get<bool>());
    expect_keys(json["limits"], {"negative", "positive"});
    EXPECT_EQ(json["loops"], 2);
    EXPECT_EQ(json["edges"], 5);
    expect_keys(json["elapsed_ms"], {"total", "input", "analysis", "surface", "trimming", "topology"});
    double sum = 0.0;
    for (const auto &item : json["elapsed_ms"].items())
        sum += item.key() == "total" ? 0.0 : item.value().get<double>();
    EXPECT_NEAR(json["elapsed_ms"]["total"].get<double>(), sum, 1e-6 * sum);
    EXPECT_FALSE(json["message"].get<std::string>().empty());
}

TEST(OffsetReport, ErrorsAreWithinTheTolerance)
{
    const Json json = report_of(panel_with_hole(), 5.0);
    EXPECT_FALSE(json["certified_error"].is_null() && json["sampled_error"].is_null());
    for (const char *key : {"certified_error", "sampled_error", "edge_error", "sampled_edge_error"})
    {
        SCOPED_TRACE(key);
        if (json[key].is_null())
            continue;
        EXPECT_GE(json[key].get<double>(), 0.0);
        EXPECT_LE(json[key].get<double>(), 1e-3);
    }
}

TEST(OffsetReport, OfAnExactFaceNamesItsKind)
{
    const Json tube = report_of(BRepBuilderAPI_MakeFace(gp_Cylinder(gp_Ax3(), 20.0), 0.0, 1.0, 0.0, 9.0).Face(), 5.0);
    EXPECT_EQ(tube["surface"]["type"], "cylinder");
    EXPECT_EQ(tube["surface"]["poles_u"], 0);
    EXPECT_LT(tube["certified_error"].get<double>(), 1e-10);
    EXPECT_TRUE(tube["sampled_error"].is_null());
    EXPECT_NEAR(tube["limits"]["negative"].get<double>(), -20.0, 0.4);
    EXPECT_TRUE(tube["limits"]["positive"].is_null()) << "unbounded outwards";
    const Json plate = report_of(BRepBuilderAPI_MakeFace(gp_Pln(), 0.0, 9.0, 0.0, 9.0).Face(), 5.0);
    EXPECT_EQ(plate["surface"]["type"], "plane");
    EXPECT_TRUE(plate["limits"]["negative"].is_null() && plate["limits"]["positive"].is_null());
}

TEST(OffsetReport, OfARefusalHasTheSameNames)
{
    const Json json = report_of(panel_with_hole(), -1e5);
    expect_keys(json, fixed_names);
    EXPECT_EQ(json["status"], "curvature-limit");
    EXPECT_EQ(json["stage"], "analysis");
    EXPECT_EQ(json["distance"], -1e5);
    expect_keys(json["where"], {"u", "v", "x", "y", "z"});
    EXPECT_LT(json["limits"]["negative"].get<double>(), 0.0);
    EXPECT_TRUE(json["surface"].is_null());
    EXPECT_TRUE(json["certified_error"].is_null());
    const Json nothing = report_of(TopoDS_Shape(), 1.0);
    EXPECT_EQ(nothing["status"], "null-shape");
    EXPECT_EQ(nothing["stage"], "input");
    EXPECT_TRUE(nothing["where"].is_null());
    EXPECT_TRUE(nothing["limits"].is_null());
    expect_keys(nothing, fixed_names);
}

TEST(OffsetReport, NeverWritesWhatIsNotANumber)
{
    for (const double bad : {not_a_number, infinity, -infinity})
    {
        OffsetReport report;
        report.distance = bad;
        report.tolerance = bad;
        report.certified_error = bad;
        report.sampled_error = bad;
        report.edge_error = bad;
        report.sampled_edge_error = bad;
        report.where = Where{gp_Pnt2d(bad, bad), gp_Pnt(bad, bad, bad)};
        report.limits = FeasibleRange{bad, bad};
        const std::string text = to_json_text(report);
        const Json json = Json::parse(text);
        for (const char *key : {"distance", "tolerance", "certified_error", "sampled_error", "edge_error"})
            EXPECT_TRUE(json[key].is_null()) << key;
        EXPECT_TRUE(json["limits"]["negative"].is_null());
        EXPECT_EQ(text.find("nan"), std::string::npos);
        EXPECT_EQ(text.find("inf"), std::string::npos);
    }
}

TEST(OffsetReport, EveryStatusAndStageHasANameOfItsOwnAndSaysWhatToDo)
{
    std::set<std::string_view> names, sentences;
    for (int i = 0; i <= static_cast<int>(Status::Cancelled); ++i)
    {
        const auto status = static_cast<Status>(i);
        names.insert(name(status));
        sentences.insert(sentence(status));
        EXPECT_NE(name(status), "unknown");
        EXPECT_FALSE(remedy(status).empty());
    }
    EXPECT_EQ(names.size(), static_cast<std::size_t>(Status::Cancelled) + 1);
    EXPECT_EQ(sentences.size(), names.size());
    std::set<std::string_view> stages;
    for (int i = 0; i <= static_cast<int>(Stage::Report); ++i)
        stages.insert(name(static_cast<Stage>(i)));
    EXPECT_EQ(stages.size(), static_cast<std::size_t>(Stage::Report) + 1);
    EXPECT_EQ(stages.count("unknown"), 0u);
}

TEST(OffsetReport, IsReadableForAPersonToo)
{
    OffsetOptions options;
    options.distance = 5.0;
    const std::string done = to_text(offset_face(panel_with_hole(), options).value().report);
    EXPECT_NE(done.find("5 mm"), std::string::npos) << done;
    EXPECT_NE(done.find("2 loops"), std::string::npos) << done;
    const auto refused = offset_face(TopoDS_Shape(), options);
    const std::string reason = to_text(refusal_report(refused.failure(), options));
    EXPECT_NE(reason.find("null-shape"), std::string::npos) << reason;
    EXPECT_NE(reason.find(refused.failure().message), std::string::npos) << reason;
}
