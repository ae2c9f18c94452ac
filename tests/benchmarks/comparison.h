// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Our offsets beside OpenCASCADE's route to NURBS, case by case, and what follows from all cases together.
#pragma once

#include "cases.h"
#include "child_process.h"

#include <filesystem>
#include <iosfwd>
#include <vector>

namespace benchmark
{

struct Comparison
{
    std::string name;
    int base_poles = 0;
    Task task;
    Outcome ours;
    Outcome occt;
    bool anew = false; //!< measured more than once, because the ratio of times looked doubtful

    [[nodiscard]] bool both() const { return ours.made && occt.made && occt.poles() > 0 && ours.poles() > 0; }
    [[nodiscard]] double pole_ratio() const { return static_cast<double>(ours.poles()) / occt.poles(); }
    [[nodiscard]] double time_ratio() const { return ours.ms / occt.ms; }
    [[nodiscard]] bool occt_in_tolerance() const { return occt.sampled <= task.tolerance; }
    //! An error seen that the certificate denies; a share of 1e-9 is left to the rounding of the samples.
    [[nodiscard]] bool bound_exceeded() const
    {
        return ours.made && ours.certified && ours.sampled > ours.bound + 1e-9 * std::abs(task.distance) + 1e-12;
    }
};

struct ComparisonPlan
{
    std::vector<double> tolerances{1e-1, 1e-3, 1e-5};
    std::vector<double> shares{0.001, 0.01}; //!< distances as parts of the diagonal
    bool both_signs = false;
    int runs = 3;
    int grid = 100;
    double limit_s = 60.0; //!< for one route on one case
};

//! Runs every feasible case and prints a line for each.
std::vector<Comparison> compare(const std::vector<BaseFace> &faces, const ComparisonPlan &plan, std::ostream &out);

//! One case with both routes.
Comparison compare_one(const BaseFace &base, const Task &task, double limit_s);

void print_heading(std::ostream &out);
void print_line(const Comparison &row, std::ostream &out);

//! Medians, extremes, violations by name, results beyond their certificate, refusals.
void print_summary(const std::vector<Comparison> &rows, std::ostream &out);

//! The worst `count` ratios of poles and of time.
void print_worst(const std::vector<Comparison> &rows, std::size_t count, std::ostream &out);

void write_csv(const std::vector<Comparison> &rows, const std::filesystem::path &path);

//! Our poles beside the least-squares column of the prototype, which they must not exceed.
void print_prototype_cases(std::ostream &out);

//! Peak memory of each route at 128x128 poles, each in a process of its own.
void print_memory(std::ostream &out);

} // namespace benchmark
