// SPDX-License-Identifier: LGPL-2.1-or-later
#include "extension.h"

#include <laminate_offset/extend_face.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <map>
#include <ostream>

namespace benchmark
{
namespace
{

using namespace laminate_offset;

constexpr double length_share = 0.05;

struct Figures
{
    double worst_mean = 0.0; //!< largest |mean length / length - 1| of the sides
    double shortest = 1e300; //!< of all iso-curves, by the length
    double longest = 0.0;    //!< the same
    double join_angle = 0.0; //!< [rad]
    int moved = 0;           //!< sides with edges that moved
};

Figures figures_of(const ExtensionReport &report)
{
    Figures figures;
    for (const ExtendedSide &side : report.sides)
    {
        figures.worst_mean = std::max(figures.worst_mean, std::abs(side.mean_length / report.length - 1.0));
        figures.shortest = std::min(figures.shortest, side.shortest / report.length);
        figures.longest = std::max(figures.longest, side.longest / report.length);
        figures.join_angle = std::max(figures.join_angle, side.join_angle);
        figures.moved += side.moved_edges > 0 ? 1 : 0;
    }
    return figures;
}

struct Mode
{
    Continuity continuity;
    LengthRule rule;
};

void run_mode(const std::vector<BaseFace> &faces, const Mode &mode, std::ostream &csv, std::ostream &out)
{
    out << fmt::format("Extension by {} of the diagonal on all sides, {}, {}\n", length_share, name(mode.continuity),
                       name(mode.rule));
    std::map<std::string, int> statuses;
    Figures worst;
    double slowest_ms = 0.0;
    for (const BaseFace &base : faces)
    {
        ExtensionOptions options;
        options.length = length_share * base.diagonal;
        options.continuity = mode.continuity;
        options.rule = mode.rule;
        const auto started = std::chrono::steady_clock::now();
        const Result<ExtensionResult> result = extend_face(base.face, options);
        const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - started).count();
        slowest_ms = std::max(slowest_ms, ms);
        ++statuses[std::string(name(result ? Status::Ok : result.failure().status))];
        csv << fmt::format("{},{},{},{},", base.name, name(mode.continuity), name(mode.rule), options.length);
        if (!result)
        {
            const Failure &failure = result.failure();
            out << fmt::format("  {} {} mm: {} at {}{}: {}\n", base.name, options.length, name(failure.status),
                               name(failure.stage), failure.where ? "" : " WITHOUT A PLACE", failure.message);
            csv << fmt::format("{},,,,,{:.2f}\n", name(failure.status), ms);
            continue;
        }
        const Figures own = figures_of(result.value().report);
        out << fmt::format("  {} {:.4g} mm: mean off by {:.1e}, spread {:.4f} to {:.4f}, join {:.1e} rad, {} of {} "
                           "sides moved, {:.1f} ms\n",
                           base.name, options.length, own.worst_mean, own.shortest, own.longest, own.join_angle,
                           own.moved, result.value().report.sides.size(), ms);
        csv << fmt::format("ok,{},{},{},{},{:.2f}\n", own.worst_mean, own.shortest, own.longest, own.join_angle, ms);
        worst.worst_mean = std::max(worst.worst_mean, own.worst_mean);
        worst.shortest = std::min(worst.shortest, own.shortest);
        worst.longest = std::max(worst.longest, own.longest);
        worst.join_angle = std::max(worst.join_angle, own.join_angle);
    }
    for (const auto &[status, count] : statuses)
        out << fmt::format("{:<24} {}\n", status, count);
    out << fmt::format("worst: mean off by {:.1e}, spread {:.4f} to {:.4f}, join {:.1e} rad; slowest {:.0f} ms\n",
                       worst.worst_mean, worst.shortest, worst.longest, worst.join_angle, slowest_ms);
}

} // namespace

void run_extension(const std::vector<BaseFace> &faces, const std::filesystem::path &path, std::ostream &out)
{
    std::ofstream csv(path);
    csv << "face,continuity,rule,length_mm,status,worst_mean,shortest,longest,join_angle_rad,ms\n";
    for (const Continuity continuity : {Continuity::G1, Continuity::Natural})
        for (const LengthRule rule : {LengthRule::Mean, LengthRule::AtLeast})
            run_mode(faces, {continuity, rule}, csv, out);
}

} // namespace benchmark
