// SPDX-License-Identifier: LGPL-2.1-or-later
#include "comparison.h"

#include "median.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <ostream>

namespace benchmark
{
namespace
{

constexpr int few_poles = 64; // of OpenCASCADE: up to here we may need a quarter more
constexpr double ratio_when_few = 1.25;
constexpr double largest_time_ratio = 3.0;

// Other programs can only slow a run down. A ratio above this one is measured anew, both sides, so many times, and of each
// side the quickest median counts.
constexpr double doubtful_ratio = 2.0;
constexpr int repeats = 2;

void take_quicker(Outcome &outcome, const Outcome &again)
{
    if (again.made && again.ms < outcome.ms)
        outcome = again;
}

double largest(const std::vector<double> &values)
{
    return values.empty() ? std::nan("") : *std::max_element(values.begin(), values.end());
}

std::vector<double> collect(const std::vector<Comparison> &rows, const std::function<bool(const Comparison &)> &which,
                            const std::function<double(const Comparison &)> &figure)
{
    std::vector<double> values;
    for (const Comparison &row : rows)
        if (row.both() && which(row))
            values.push_back(figure(row));
    return values;
}

std::string label(const Comparison &row)
{
    return fmt::format("{} d {:+.4g} tol {:.0e}", row.name, row.task.distance, row.task.tolerance);
}

bool needs_many(const Comparison &row) { return row.occt.poles() > few_poles; }

bool violates_poles(const Comparison &row) { return row.pole_ratio() > (needs_many(row) ? 1.0 : ratio_when_few); }

std::string pole_note(const Comparison &row)
{
    return fmt::format("  {}: ours {}x{} (degree {},{}), OCCT {}{}, ratio {:.2f}\n", label(row), row.ours.poles_u,
                       row.ours.poles_v, row.ours.degree_u, row.ours.degree_v, row.occt.poles(),
                       row.occt_in_tolerance() ? "" : fmt::format(" (misses its tolerance: {:.1e})", row.occt.sampled),
                       row.pole_ratio());
}

std::string time_note(const Comparison &row)
{
    return fmt::format("  {}: ours {:.2f} ms, OCCT {:.2f} ms, ratio {:.2f}, poles {} / {}; stages {}\n", label(row),
                       row.ours.ms, row.occt.ms, row.time_ratio(), row.ours.poles(), row.occt.poles(),
                       fmt::format("analysis {:.2f} surface {:.2f} trimming {:.2f} topology {:.2f}", row.ours.stages[2],
                                   row.ours.stages[3], row.ours.stages[5], row.ours.stages[6]));
}

void print_ratios(const char *title, const std::vector<Comparison> &rows,
                  const std::function<bool(const Comparison &)> &which, std::ostream &out)
{
    const auto poles = collect(rows, which, &Comparison::pole_ratio);
    const auto many = [&](const Comparison &row) { return which(row) && needs_many(row); };
    const auto few = [&](const Comparison &row) { return which(row) && !needs_many(row); };
    const auto times = collect(rows, which, &Comparison::time_ratio);
    out << fmt::format("{}: {} cases\n  poles ratio median {:.3f}, largest where OCCT > {} poles {:.3f}, elsewhere "
                       "{:.3f}\n  time ratio median {:.3f}, largest {:.3f}\n",
                       title, poles.size(), median(poles), few_poles,
                       largest(collect(rows, many, &Comparison::pole_ratio)),
                       largest(collect(rows, few, &Comparison::pole_ratio)), median(times), largest(times));
}

void print_if(const char *title, const std::vector<Comparison> &rows,
              const std::function<bool(const Comparison &)> &which,
              const std::function<std::string(const Comparison &)> &note, std::ostream &out)
{
    out << fmt::format("{}: {}\n", title, std::count_if(rows.begin(), rows.end(), which));
    for (const Comparison &row : rows)
        if (which(row))
            out << note(row);
}

} // namespace

Comparison compare_one(const BaseFace &base, const Task &task, double limit_s)
{
    Comparison row{base.name, base.poles, task, {}, {}};
    row.ours = run_in_child([&] { return run_ours(base.face, task); }, limit_s).outcome;
    row.occt = run_in_child([&] { return run_occt(base.face, task); }, limit_s).outcome;
    for (int i = 0; i < repeats && row.both() && row.time_ratio() > doubtful_ratio; ++i)
    {
        row.anew = true;
        take_quicker(row.ours, run_in_child([&] { return run_ours(base.face, task); }, limit_s).outcome);
        take_quicker(row.occt, run_in_child([&] { return run_occt(base.face, task); }, limit_s).outcome);
    }
    return row;
}

void print_heading(std::ostream &out)
{
    out << fmt::format(
        "{:<44} {:>6} {:>9} {:>6} | {:>8} {:>5} {:>7} {:>6} | {:>8} {:>8} {:>6} | {:>9} {:>9} {:>9} {}\n", "case",
        "base", "d mm", "tol", "ours", "deg", "OCCT", "ratio", "ours ms", "OCCT ms", "ratio", "certified", "ours err",
        "OCCT err", "status ours / OCCT");
}

void print_line(const Comparison &row, std::ostream &out)
{
    out << fmt::format(
        "{:<44} {:>6} {:>9.4g} {:>6.0e} | {:>8} {:>5} {:>7} {:>6.2f} | {:>8.2f} {:>8.2f} {:>6.2f} | {:>9} {:>9.2e} "
        "{:>9.2e} {} / {}{}{}{}\n",
        row.name, row.base_poles, row.task.distance, row.task.tolerance,
        fmt::format("{}x{}", row.ours.poles_u, row.ours.poles_v),
        fmt::format("{},{}", row.ours.degree_u, row.ours.degree_v), row.occt.poles(),
        row.both() ? row.pole_ratio() : 0.0, row.ours.ms, row.occt.ms, row.both() ? row.time_ratio() : 0.0,
        row.ours.certified ? fmt::format("{:.2e}", row.ours.bound) : "none", row.ours.sampled, row.occt.sampled,
        row.ours.status, row.occt.status, row.bound_exceeded() ? " BOUND EXCEEDED" : "",
        row.ours.made && !row.ours.valid ? " INVALID" : "", row.anew ? " *" : "");
    out.flush();
}

std::vector<Comparison> compare(const std::vector<BaseFace> &faces, const ComparisonPlan &plan, std::ostream &out)
{
    std::vector<Comparison> rows;
    print_heading(out);
    for (const BaseFace &base : faces)
        for (const double share : plan.shares)
            for (const double sign : plan.both_signs ? std::vector<double>{1.0, -1.0} : std::vector<double>{1.0})
                for (const double tolerance : plan.tolerances)
                {
                    const double distance = sign * share * base.diagonal;
                    if (!base.feasible(distance))
                        continue;
                    rows.push_back(compare_one(base, {distance, tolerance, plan.runs, plan.grid}, plan.limit_s));
                    print_line(rows.back(), out);
                }
    return rows;
}

void print_summary(const std::vector<Comparison> &rows, std::ostream &out)
{
    out << fmt::format("\n{} feasible cases; ours made {}, OCCT made {}\n", rows.size(),
                       std::count_if(rows.begin(), rows.end(), [](const Comparison &row) { return row.ours.made; }),
                       std::count_if(rows.begin(), rows.end(), [](const Comparison &row) { return row.occt.made; }));
    out << fmt::format(
        "{} of them (*) showed a time ratio above {} and were measured up to {} more times, both sides; of each side "
        "the quickest median counts\n",
        std::count_if(rows.begin(), rows.end(), [](const Comparison &row) { return row.anew; }), doubtful_ratio,
        repeats);
    print_ratios(
        "Where both have a result", rows, [](const Comparison &) { return true; }, out);
    print_ratios("Where OCCT also meets its tolerance", rows, &Comparison::occt_in_tolerance, out);
    print_if(
        "Pole counts above the limit", rows, [](const Comparison &r) { return r.both() && violates_poles(r); },
        pole_note, out);
    print_if(
        "Times above the limit", rows,
        [](const Comparison &r) { return r.both() && r.time_ratio() > largest_time_ratio; }, time_note, out);
    print_if(
        "Sampled errors beyond the certificate", rows, &Comparison::bound_exceeded,
        [](const Comparison &r) {
            return fmt::format("  {}: {:.3e} > {:.3e}\n", label(r), r.ours.sampled, r.ours.bound);
        },
        out);
    print_if(
        "Sampled errors beyond the tolerance", rows,
        [](const Comparison &r) { return r.ours.made && r.ours.sampled > r.task.tolerance; },
        [](const Comparison &r) { return fmt::format("  {}: {:.3e}\n", label(r), r.ours.sampled); }, out);
    print_if(
        "Results without a certificate", rows, [](const Comparison &r) { return r.ours.made && !r.ours.certified; },
        [](const Comparison &r) { return fmt::format("  {}\n", label(r)); }, out);
    print_if(
        "Feasible cases that we refuse", rows,
        [](const Comparison &r) { return !r.ours.made && !r.ours.fold_confirmed; },
        [](const Comparison &r) { return fmt::format("  {}: {}: {}\n", label(r), r.ours.status, r.ours.message); },
        out);
    print_if(
        "OCCT surfaces out of tolerance", rows,
        [](const Comparison &r) { return r.occt.made && !r.occt_in_tolerance(); },
        [](const Comparison &r) { return fmt::format("  {}: {:.2e}\n", label(r), r.occt.sampled); }, out);
}

void print_worst(const std::vector<Comparison> &rows, std::size_t count, std::ostream &out)
{
    std::vector<Comparison> sorted;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(sorted),
                 [](const Comparison &row) { return row.both(); });
    const auto print = [&](const char *title, auto figure, auto note) {
        std::sort(sorted.begin(), sorted.end(),
                  [&](const Comparison &a, const Comparison &b) { return figure(a) > figure(b); });
        out << title << '\n';
        for (std::size_t i = 0; i < std::min(count, sorted.size()); ++i)
            out << note(sorted[i]);
    };
    print(
        "Worst pole ratios", [](const Comparison &row) { return row.pole_ratio(); }, pole_note);
    print(
        "Worst time ratios", [](const Comparison &row) { return row.time_ratio(); }, time_note);
    print(
        "Longest times of ours", [](const Comparison &row) { return row.ours.ms; }, time_note);
}

void write_csv(const std::vector<Comparison> &rows, const std::filesystem::path &path)
{
    std::ofstream out(path);
    out << "case,base_poles,distance_mm,tolerance_mm,ours_poles_u,ours_poles_v,ours_degree_u,ours_degree_v,occt_poles,"
           "ours_ms,occt_ms,certified_mm,ours_sampled_mm,occt_sampled_mm,ours_status,occt_status,analysis_ms,"
           "surface_ms,trimming_ms,topology_ms\n";
    for (const Comparison &row : rows)
        out << fmt::format("{},{},{},{},{},{},{},{},{},{:.4f},{:.4f},{},{},{},{},{},{:.4f},{:.4f},{:.4f},{:.4f}\n",
                           row.name, row.base_poles, row.task.distance, row.task.tolerance, row.ours.poles_u,
                           row.ours.poles_v, row.ours.degree_u, row.ours.degree_v, row.occt.poles(), row.ours.ms,
                           row.occt.ms, row.ours.certified ? fmt::format("{}", row.ours.bound) : "", row.ours.sampled,
                           row.occt.sampled, row.ours.status, row.occt.status, row.ours.stages[2], row.ours.stages[3],
                           row.ours.stages[5], row.ours.stages[6]);
}

} // namespace benchmark
