// SPDX-License-Identifier: LGPL-2.1-or-later
#include "methods.h"

#include "cases.h"
#include "child_process.h"
#include "median.h"

#include "support/data_files.h"

#include <laminate_offset/offset_limits.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <ostream>
#include <vector>

namespace benchmark
{
namespace
{

using laminate_offset::Method;

// Distances as parts of the diagonal; the first feasible one counts.
constexpr std::array<double, 6> shares{1e-2, -1e-2, 1e-3, -1e-3, 1e-4, -1e-4};
// A face with less curvature than this, times its diagonal, is flat in disguise.
constexpr double flat = 1e-3;
constexpr double limit_s = 120.0;
constexpr std::array<double, 2> tolerances{1e-1, 1e-3};
constexpr std::array<Method, 2> methods{Method::SameParameter, Method::RaviKumar};

constexpr const char *generated[] = {"panel 8x8", "panel 14x14", "wing 20x8"};
constexpr const char *examples[] = {"naca_wing_skin.step", "panel_two_holes.step", "wigley_hull.step",
                                    "table1_fairing.step", "table1_duct.step",     "table1_rib.step"};
constexpr const char *models[] = {"derived_D150_fuselage_2p3m_1hole_6curves.step",
                                  "derived_D150_fuselage_3p4m_2holes_9curves.step",
                                  "bladex_lower.iges",
                                  "dealii_DTMB5415_bulbous_bow.iges",
                                  "dealii_wing.iges",
                                  "iea15_CFD.igs",
                                  "inducer_betterplane_fuselage.brep",
                                  "psas_nose_mold.igs",
                                  "tigl_D150_fuselage_nose_shell.brep",
                                  "tigl_nacelle.stp"};

//! [mm], inside the proven limits; nothing where even the shortest distance folds the face.
std::optional<double> distance_of(const BaseFace &base)
{
    const auto limits = laminate_offset::offset_limits(base.face);
    if (!limits)
        return std::nullopt;
    const auto &[negative, positive, proven] = limits.value();
    for (const double share : shares)
    {
        const auto &limit = share < 0.0 ? negative : positive;
        if (!limit || std::abs(share) * base.diagonal < std::abs(limit->distance))
            return share * base.diagonal;
    }
    return std::nullopt;
}

//! The first curved free-form face of a real model that can be offset; nothing where there is none.
std::vector<BaseFace> first_free_form(const std::string &file)
{
    const auto path = test_support::find_data_file(file);
    if (!path)
        return {};
    int number = 0;
    for (const TopoDS_Face &face : test_support::read_faces(*path))
    {
        BaseFace base = describe(fmt::format("{}#{}", file, ++number), face);
        const double curvature = std::max(base.highest_curvature, -base.lowest_curvature);
        if (base.free_form && base.poles > 0 && curvature * base.diagonal > flat && distance_of(base))
            return {base};
    }
    return {};
}

std::vector<BaseFace> all_faces()
{
    std::vector<BaseFace> faces;
    for (const char *name : generated)
        faces.push_back(generated_face(name));
    for (const char *name : examples)
        faces.push_back(describe(name, test_support::read_faces(test_support::example_file(name)).front()));
    for (const char *name : models)
        for (const BaseFace &base : first_free_form(name))
            faces.push_back(base);
    return faces;
}

std::string poles_of(const Outcome &outcome)
{
    return outcome.poles() > 0 ? fmt::format("{}x{}={}", outcome.poles_u, outcome.poles_v, outcome.poles()) : "exact";
}

std::string cells(const Outcome &o)
{
    if (!o.made)
        return fmt::format("{} | | |", o.status);
    const std::string bound = o.certified ? fmt::format("{:.2g}", o.bound) : "none";
    return fmt::format("{} | {:.1f} | {} | {:.2g}", poles_of(o), o.cpu_ms, bound, o.sampled);
}

void write_line(const BaseFace &base, const Task &task, const Outcome &o, std::ostream &csv)
{
    csv << fmt::format("{},{},{},{},{},{},{},{},{:.3f},{},{}\n", base.name, base.poles, task.distance, task.tolerance,
                       laminate_offset::name(task.method), o.status, o.poles_u, o.poles_v, o.cpu_ms,
                       o.certified ? fmt::format("{}", o.bound) : "", o.sampled);
}

} // namespace

void run_methods(const std::filesystem::path &path, std::ostream &out)
{
    std::ofstream csv(path);
    csv << "face,base_poles,distance_mm,tolerance_mm,method,status,poles_u,poles_v,cpu_ms,certified_mm,sampled_mm\n";
    out << "| face | base poles | d [mm] | tolerance [mm] | default: poles | CPU time [ms] | proven [mm] | true [mm] "
           "| ravi-kumar: poles | CPU time [ms] | proven [mm] | true [mm] "
           "|\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    std::vector<double> pole_ratios;
    std::vector<double> time_ratios;
    for (const BaseFace &base : all_faces())
        for (const double tolerance : tolerances)
        {
            Task task{distance_of(base).value_or(0.0), tolerance, 5, 60};
            std::array<Outcome, 2> outcomes;
            for (std::size_t k = 0; k < methods.size(); ++k)
            {
                task.method = methods[k];
                outcomes[k] = run_in_child([&] { return run_ours(base.face, task); }, limit_s).outcome;
                write_line(base, task, outcomes[k], csv);
            }
            out << fmt::format("| {} | {} | {:.4g} | {:g} | {} | {} |\n", base.name, base.poles, task.distance,
                               tolerance, cells(outcomes[0]), cells(outcomes[1]));
            out.flush();
            if (!outcomes[0].made || !outcomes[1].made || outcomes[0].poles() == 0 || outcomes[1].poles() == 0)
                continue;
            pole_ratios.push_back(static_cast<double>(outcomes[1].poles()) / outcomes[0].poles());
            time_ratios.push_back(outcomes[1].cpu_ms / outcomes[0].cpu_ms);
        }
    out << fmt::format(
        "\nravi-kumar against the default, {} cases with poles: {:.2f} times the poles, {:.2f} times the "
        "time (medians)\n",
        pole_ratios.size(), median(pole_ratios), median(time_ratios));
}

} // namespace benchmark
