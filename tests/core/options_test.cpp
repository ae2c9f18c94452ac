// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The documented defaults of OffsetOptions are the real ones, and check() accepts exactly the documented ranges.

#include <laminate_offset/base/options.h>

#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string>

namespace laminate_offset
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

//! The word after "Default " in a comment, without the full stop; empty when there is none.
std::string documented_default(const std::string &comment)
{
    const std::string key = "Default ";
    const std::size_t start = comment.find(key);
    if (start == std::string::npos)
    {
        return {};
    }
    std::string word;
    std::istringstream(comment.substr(start + key.size())) >> word;
    while (!word.empty() && std::string(".,;:)").find(word.back()) != std::string::npos)
    {
        word.pop_back();
    }
    return word;
}

//! The name a member declaration ends in: "double tolerance = 1e-3;" gives "tolerance".
std::string declared_name(const std::string &line)
{
    std::string head = line.substr(0, line.find_first_of("={;"));
    while (!head.empty() && std::isspace(static_cast<unsigned char>(head.back())) != 0)
    {
        head.pop_back();
    }
    return head.substr(head.find_last_of(" \t") + 1);
}

//! Option name -> documented default, read from the comments of struct OffsetOptions in the header.
std::map<std::string, std::string> documented_defaults()
{
    std::ifstream header(LAMINATE_OFFSET_PROJECT_DIR "/src/core/base/options.h");
    std::map<std::string, std::string> defaults;
    std::string line;
    std::string comment;
    bool inside = false;
    while (std::getline(header, line))
    {
        if (line.rfind("struct OffsetOptions", 0) == 0)
        {
            inside = true;
        }
        else if (inside && line.rfind("};", 0) == 0)
        {
            break;
        }
        else if (const std::size_t mark = line.find("//!"); inside && mark != std::string::npos)
        {
            comment += line.substr(mark + 3);
        }
        else if (inside && line.find(';') != std::string::npos)
        {
            defaults[declared_name(line)] = documented_default(comment);
            comment.clear();
        }
    }
    return defaults;
}

//! Option names used up one by one, so that an undocumented or unchecked option shows.
class DocumentedDefaults
{
public:
    void expect(const std::string &option, double actual)
    {
        const std::string word = take(option);
        std::size_t used = 0;
        ASSERT_NO_THROW(EXPECT_EQ(std::stod(word, &used), actual) << option) << option << " documents: " << word;
        EXPECT_EQ(used, word.size()) << option << " documents: " << word;
    }

    void expect(const std::string &option, const std::string &actual) { EXPECT_EQ(take(option), actual) << option; }

    [[nodiscard]] const std::map<std::string, std::string> &left() const { return m_defaults; }

private:
    std::string take(const std::string &option)
    {
        const auto node = m_defaults.extract(option);
        return node.empty() ? "(no such option)" : node.mapped();
    }

    std::map<std::string, std::string> m_defaults = documented_defaults();
};

TEST(OffsetOptions, documented_defaults_are_the_real_ones)
{
    const OffsetOptions options;
    DocumentedDefaults documented;
    documented.expect("distance", options.distance);
    documented.expect("tolerance", options.tolerance);
    documented.expect("method", options.method == Method::SameParameter ? "SameParameter" : "RaviKumar");
    documented.expect("extension", options.extension);
    documented.expect("max_degree", options.max_degree);
    documented.expect("progress", options.progress ? "set" : "none");
    for (const auto &[option, word] : documented.left())
    {
        ADD_FAILURE() << "option " << option << " is not compared with its documented default '" << word << "'";
    }
}

TEST(OffsetOptions, the_defaults_are_accepted) { EXPECT_TRUE(check(OffsetOptions{}).ok()); }

//! Expects a refusal of the options at Stage::Options with the given status and a message that says more than a word.
void expect_refused(const OffsetOptions &options, Status status)
{
    const auto result = check(options);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.failure().status, status);
    EXPECT_EQ(result.failure().stage, Stage::Options);
    EXPECT_GT(result.failure().message.size(), 20U);
}

TEST(OffsetOptions, every_finite_distance_is_accepted_and_no_other)
{
    OffsetOptions options;
    for (const double distance : {0.0, -0.0, 1e-300, -5.0, 227.0, -1e300})
    {
        options.distance = distance;
        EXPECT_TRUE(check(options).ok()) << distance;
    }
    for (const double distance : {infinity, -infinity, not_a_number})
    {
        options.distance = distance;
        expect_refused(options, Status::InvalidDistance);
    }
}

TEST(OffsetOptions, every_positive_finite_tolerance_is_accepted_and_no_other)
{
    OffsetOptions options;
    for (const double tolerance : {1e-6, 1e-3, 1.0, 1e6})
    {
        options.tolerance = tolerance;
        EXPECT_TRUE(check(options).ok()) << tolerance;
    }
    for (const double tolerance : {0.0, -1e-3, infinity, not_a_number})
    {
        options.tolerance = tolerance;
        expect_refused(options, Status::InvalidTolerance);
    }
}

TEST(OffsetOptions, degrees_from_3_to_7_are_accepted_and_no_other)
{
    OffsetOptions options;
    for (int degree = -1; degree <= 30; ++degree)
    {
        options.max_degree = degree;
        if (degree >= 3 && degree <= 7)
        {
            EXPECT_TRUE(check(options).ok()) << degree;
        }
        else
        {
            expect_refused(options, Status::InvalidOption);
        }
    }
}

TEST(OffsetOptions, a_negative_or_infinite_extension_is_refused)
{
    OffsetOptions options;
    for (const double extension : {-1.0, infinity, not_a_number})
    {
        options.extension = extension;
        expect_refused(options, Status::InvalidOption);
    }
}

} // namespace
} // namespace laminate_offset
