// SPDX-License-Identifier: LGPL-2.1-or-later
// Cases with figures of their own to be held against: the prototype's pole counts, memory at 128x128 poles.
#include "comparison.h"

#include <fmt/format.h>

#include <ostream>

namespace benchmark
{
namespace
{

constexpr double limit_s = 120.0;

struct PrototypeCase
{
    const char *name;
    double distance; // mm
    double tolerance;
    int poles; // least squares, best degree; 0: not known
    int occt;
};

// The shapes of the wing and of the noise are ours: where OpenCASCADE needs other poles than noted, the base is another
// one and the prototype's figure is only a hint.
constexpr PrototypeCase prototype_cases[] = {
    {"panel 8x8", 10.0, 1e-3, 144, 289},     {"panel 8x8", 10.0, 1e-5, 289, 484},
    {"panel 14x14", 10.0, 1e-4, 576, 7396},  {"wing 20x8", 5.0, 1e-3, 84, 465},
    {"wing 20x8", 5.0, 1e-5, 265, 1358},     {"wavy 16x12", 5.0, 1e-3, 588, 2052},
    {"wavy 16x12", 5.0, 1e-5, 2014, 3752},   {"noisy 12x12", 10.0, 1e-3, 600, 4225},
    {"biquintic 8x8", 10.0, 1e-5, 130, 728}, {"biquintic 6x6", 10.0, 1e-5, 70, 99},
    {"panel 60x60", 5.0, 1e-3, 156, 2916},   {"wavy 60x60", 5.0, 1e-5, 12768, 100350},
};

double peak(const std::function<Outcome()> &work) { return run_in_child(work, limit_s).peak_mib; }

} // namespace

void print_prototype_cases(std::ostream &out)
{
    out << fmt::format("\n{:<16} {:>5} {:>6} | {:>10} {:>6} | {:>6} {:>6} | {:>7} {:>7} | {:>9} {:>9} {}\n", "case",
                       "d mm", "tol", "ours", "LSQ", "ratio", "OCCT", "noted", "ms", "certified", "sampled", "status");
    for (const PrototypeCase &known : prototype_cases)
    {
        const Comparison row =
            compare_one(generated_face(known.name), {known.distance, known.tolerance, 1, 100}, limit_s);
        out << fmt::format("{:<16} {:>5} {:>6.0e} | {:>10} {:>6} | {:>6.2f} {:>6} | {:>7} {:>7.1f} | {:>9.2e} {:>9.2e} "
                           "{}{}\n",
                           known.name, known.distance, known.tolerance,
                           fmt::format("{}x{}={}", row.ours.poles_u, row.ours.poles_v, row.ours.poles()), known.poles,
                           static_cast<double>(row.ours.poles()) / known.poles, row.occt.poles(), known.occt,
                           row.ours.ms, row.ours.bound, row.ours.sampled, row.ours.status,
                           row.occt.made && row.occt.poles() != known.occt ? ", another base" : "");
        out.flush();
    }
}

void print_memory(std::ostream &out)
{
    const BaseFace base = generated_face("panel 128x128");
    out << fmt::format("\nPeak memory at 128x128 poles [MiB, above the process that only holds the face]\n");
    const double idle = peak([] { return Outcome(); });
    for (const double share : {0.001, 0.01})
        for (const double tolerance : {1e-1, 1e-3, 1e-5})
        {
            const Task task{share * base.diagonal, tolerance, 1, 1};
            const double ours = peak([&] { return run_ours(base.face, task); });
            const double occt = peak([&] { return run_occt(base.face, task); });
            out << fmt::format("  d {:.4g} tol {:.0e}: ours {:.1f} (+{:.1f}), OCCT {:.1f} (+{:.1f}), ratio of peaks "
                               "{:.2f}, of increases {:.2f}\n",
                               task.distance, tolerance, ours, ours - idle, occt, occt - idle, ours / occt,
                               (ours - idle) / std::max(occt - idle, 0.1));
            out.flush();
        }
}

} // namespace benchmark
