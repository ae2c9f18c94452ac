// SPDX-License-Identifier: LGPL-2.1-or-later
// The engine has no state of its own: any number of faces in any number of threads gives the same results.
#include "support/random_cases.h"
#include "support/sample_faces.h"

#include <laminate_offset/offset_face.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools.hxx>
#include <gp_Pln.hxx>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <sstream>
#include <string>
#include <thread>
#include <vector>

using namespace laminate_offset;
using namespace test_support;

namespace
{

struct Job
{
    TopoDS_Face face;
    double distance = 0.0;
};

//! The whole result as text: the face with all its curves and poles, or the refusal.
std::string outcome(const Job &job)
{
    OffsetOptions options;
    options.distance = job.distance;
    const Result<OffsetResult> result = offset_face(job.face, options);
    if (!result.ok())
        return std::string(name(result.failure().status)) + ": " + result.failure().message;
    std::ostringstream text;
    BRepTools::Write(result.value().face(), text);
    return text.str();
}

//! Different kinds of faces, some of them sharing their geometry, and one that is refused.
std::vector<Job> jobs()
{
    RandomCases random;
    std::vector<Job> all;
    const TopoDS_Face panel = panel_with_hole();
    for (const TopoDS_Face &face : {panel, reversed(panel), located(panel), sphere_patch(50.0)})
        for (const double distance : {3.0, -3.0, 1e5})
            all.push_back({face, distance});
    for (int i = 0; i < 4; ++i)
        all.push_back({BRepBuilderAPI_MakeFace(random_surface(random, {.spans_u = 2, .height = 3.0}), 1e-7), 1.5});
    all.push_back({BRepBuilderAPI_MakeFace(gp_Pln(), 0.0, 5.0, 0.0, 5.0), 4.0});
    return all;
}

} // namespace

TEST(Concurrency, DifferentFacesInParallelAreAsOneByOne)
{
    const std::vector<Job> work = jobs();
    std::vector<std::string> alone, together(work.size());
    for (const Job &job : work)
        alone.push_back(outcome(job));
    tbb::parallel_for(std::size_t{0}, work.size(), [&](std::size_t i) { together[i] = outcome(work[i]); });
    int made = 0;
    for (std::size_t i = 0; i < work.size(); ++i)
    {
        EXPECT_EQ(together[i], alone[i]) << "job " << i;
        made += alone[i].find("TShapes") != std::string::npos ? 1 : 0;
    }
    EXPECT_GE(made, 10);
    EXPECT_LT(made, static_cast<int>(work.size())) << "a refusal should be among them";
}

TEST(Concurrency, OneFaceInManyThreadsGivesOneResult)
{
    const Job job{panel_with_hole(), 6.0};
    const std::string expected = outcome(job);
    std::vector<std::string> results(6);
    std::vector<std::thread> threads;
    for (std::string &result : results)
        threads.emplace_back([&result, &job] { result = outcome(job); });
    for (std::thread &thread : threads)
        thread.join();
    for (const std::string &result : results)
        EXPECT_EQ(result, expected);
}
