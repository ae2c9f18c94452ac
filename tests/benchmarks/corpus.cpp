// SPDX-License-Identifier: LGPL-2.1-or-later
#include "corpus.h"

#include "child_process.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <ostream>

namespace benchmark
{
namespace
{

constexpr double tolerance = 1e-3;
constexpr double limit_s = 20.0;
constexpr int grid = 60;
constexpr std::array<double, 4> shares{0.001, -0.001, 0.01, -0.01};

struct Entry
{
    std::string face;
    bool free_form = false;
    bool feasible = false;
    double distance = 0.0;
    Outcome outcome;
    double wall_ms = 0.0;
};

bool wrong(const Entry &entry)
{
    const Outcome &o = entry.outcome;
    return o.made && (!o.valid || (entry.free_form && (o.sampled > tolerance || (o.certified && o.sampled > o.bound))));
}

std::string describe(const Entry &e)
{
    return fmt::format("  {} d {:+.4g}: {}{} {:.1f} ms, poles {}, sampled {:.2e}, bound {:.2e} {}\n", e.face,
                       e.distance, e.outcome.status, e.outcome.made && !e.outcome.valid ? " INVALID" : "", e.outcome.ms,
                       e.outcome.poles(), e.outcome.sampled, e.outcome.bound, e.outcome.message);
}

void list(const char *title, const std::vector<Entry> &entries, const std::function<bool(const Entry &)> &which,
          std::ostream &out)
{
    out << fmt::format("{}: {}\n", title, std::count_if(entries.begin(), entries.end(), which));
    for (const Entry &entry : entries)
        if (which(entry))
            out << describe(entry);
}

void summarise(std::vector<Entry> entries, std::ostream &out)
{
    std::map<std::string, int> statuses;
    for (const Entry &entry : entries)
        ++statuses[entry.outcome.status];
    out << fmt::format("{} offsets of real faces at {} mm\n", entries.size(), tolerance);
    for (const auto &[status, count] : statuses)
        out << fmt::format("  {:<24} {}\n", status, count);
    const auto feasible = [](const Entry &e) { return e.feasible; };
    const auto made = [](const Entry &e) { return e.feasible && e.outcome.made; };
    const auto count = std::count_if(entries.begin(), entries.end(), feasible);
    const auto good = std::count_if(entries.begin(), entries.end(), made);
    out << fmt::format("feasible by the dense grid {}, made {} ({:.2f} %)\n", count, good,
                       100.0 * static_cast<double>(good) / static_cast<double>(std::max<std::ptrdiff_t>(count, 1)));
    list("Wrong results", entries, wrong, out);
    list(
        "Folded by the dense grid and yet made", entries, [](const Entry &e) { return !e.feasible && e.outcome.made; },
        out);
    list(
        "Feasible and not made", entries, [](const Entry &e) { return e.feasible && !e.outcome.made; }, out);
    list(
        "Refused without a place", entries, [](const Entry &e) { return !e.outcome.made && !e.outcome.has_where; },
        out);
    list(
        "Free-form results without a certificate", entries,
        [](const Entry &e) { return e.free_form && e.outcome.made && !e.outcome.certified; }, out);
    std::sort(entries.begin(), entries.end(), [](const Entry &a, const Entry &b) { return a.wall_ms > b.wall_ms; });
    out << "Slowest\n";
    for (std::size_t i = 0; i < std::min<std::size_t>(15, entries.size()); ++i)
        out << describe(entries[i]);
}

void write(const std::vector<Entry> &entries, const std::filesystem::path &path)
{
    std::ofstream out(path);
    out << "face,free_form,feasible,distance_mm,status,valid,certified_mm,sampled_mm,poles,ms,wall_ms\n";
    for (const Entry &e : entries)
        out << fmt::format("{},{:d},{:d},{},{},{:d},{},{},{},{:.3f},{:.3f}\n", e.face, e.free_form, e.feasible,
                           e.distance, e.outcome.status, e.outcome.valid,
                           e.outcome.certified ? fmt::format("{}", e.outcome.bound) : "", e.outcome.sampled,
                           e.outcome.poles(), e.outcome.ms, e.wall_ms);
}

} // namespace

void run_corpus(const std::vector<BaseFace> &faces, const std::filesystem::path &csv, std::ostream &out)
{
    std::vector<Entry> entries;
    for (const BaseFace &base : faces)
        for (const double share : shares)
        {
            const double distance = share * base.diagonal;
            const ChildResult result = run_in_child(
                [&] {
                    return run_ours(base.face, {distance, tolerance, 1, grid});
                },
                limit_s);
            entries.push_back({base.name, base.free_form, base.feasible(distance) && !result.outcome.fold_confirmed,
                               distance, result.outcome, result.wall_ms});
        }
    summarise(entries, out);
    write(entries, csv);
}

} // namespace benchmark
