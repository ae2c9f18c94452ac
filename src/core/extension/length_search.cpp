// SPDX-License-Identifier: LGPL-2.1-or-later
#include "length_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace laminate_offset
{
namespace
{

constexpr double wanted_accuracy = 1e-9;
constexpr int most_steps = 60;
// Parts of each interval between two breaks, so that a bend inside it does no harm.
constexpr int parts = 4;

// Nodes and weights of Gauss' rule with eight points on [-1, 1], one half of them.
constexpr std::array<std::array<double, 2>, 4> gauss{{{0.18343464249564980494, 0.36268378337836198297},
                                                      {0.52553240991632898582, 0.31370664587788728734},
                                                      {0.79666647741362673959, 0.22238103445337447054},
                                                      {0.96028985649753623168, 0.10122853629037625915}}};

} // namespace

double arc_length(const std::function<double(double)> &speed, const std::vector<double> &breaks)
{
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        for (int part = 0; part < parts; ++part)
        {
            const double half = 0.5 * (breaks[i + 1] - breaks[i]) / parts;
            const double middle = breaks[i] + (2 * part + 1) * half;
            for (const auto &[node, weight] : gauss)
                length += half * weight * (speed(middle - half * node) + speed(middle + half * node));
        }
    return length;
}

std::optional<double> increment_for(const std::function<std::optional<double>(double)> &length_of, double length,
                                    double start, double largest)
{
    double low = 0.0;
    double high = largest;
    double x = std::min(start, largest);
    std::optional<std::pair<double, double>> before; // logarithms of increment and length
    for (int step = 0; step < most_steps; ++step)
    {
        const std::optional<double> reached = length_of(x);
        if (!reached || !(*reached > 0.0))
            return std::nullopt;
        if (std::abs(*reached / length - 1.0) <= wanted_accuracy)
            return x;
        (*reached < length ? low : high) = x;
        if (low >= largest)
            return std::nullopt;
        const std::pair<double, double> here{std::log(x), std::log(*reached)};
        double slope = before ? (here.second - before->second) / (here.first - before->first) : 1.0;
        slope = std::isfinite(slope) ? std::clamp(slope, 0.2, 5.0) : 1.0;
        before = here;
        x = std::exp(here.first + (std::log(length) - here.second) / slope);
        if (!(x > low) || (x >= high && high < largest))
            x = 0.5 * (low + high);
        x = std::min(x, largest);
    }
    return x;
}

} // namespace laminate_offset
