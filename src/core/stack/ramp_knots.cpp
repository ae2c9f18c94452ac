// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ramp_knots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace laminate_offset
{
namespace
{

// The first knot stands a little outside of the ply, so that an edge that strays from its parameter line touches no
// further span.
constexpr double clearance = 0.02;
// The last ones stand behind the ramp's end, so that spans wholly past the ramp keep its tail short.
constexpr double behind = 1.0 + 1.0 / 3.0;
// Densities of knots within this factor are made one; parameters within this part of the finest step are one.
constexpr double same_density = 1.5;
constexpr double same_place = 0.05;

//! An interval of one parameter in which knots must stand so densely.
struct Zone
{
    double low = 0.0;
    double high = 0.0;
    double density = 0.0;
};

std::vector<Zone> zones_of(const EdgeWalk &walk, int direction)
{
    std::vector<Zone> zones;
    for (const std::vector<EdgeSample> &run : walk.runs())
        for (std::size_t i = 0; i + 1 < run.size(); ++i)
        {
            Zone zone{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest(), 0.0};
            for (const EdgeSample *sample : {&run[i], &run[i + 1]})
            {
                for (const double part : {clearance, behind})
                {
                    const double place = sample->uv[direction] + part * sample->reach[direction];
                    zone.low = std::min(zone.low, place);
                    zone.high = std::max(zone.high, place);
                }
                zone.density = std::max(zone.density, sample->density[direction]);
            }
            if (zone.density > 0.0 && zone.high > zone.low)
                zones.push_back(zone);
        }
    return zones;
}

//! The largest density wanted between each two neighbours of the zones' ends.
std::vector<Zone> layered(std::vector<Zone> zones, double low, double high)
{
    std::vector<double> ends{low, high};
    double densest = 0.0;
    for (const Zone &zone : zones)
    {
        ends.insert(ends.end(), {std::clamp(zone.low, low, high), std::clamp(zone.high, low, high)});
        densest = std::max(densest, zone.density);
    }
    std::sort(ends.begin(), ends.end());
    std::vector<double> places;
    for (const double end : ends)
        if (places.empty() || (end - places.back()) * densest > same_place)
            places.push_back(end);
    const auto index = [&](double x) {
        const auto next = std::lower_bound(places.begin(), places.end(), x);
        if (next == places.end())
            return places.size() - 1;
        const bool before = next != places.begin() && x - *(next - 1) < *next - x;
        return static_cast<std::size_t>(next - places.begin()) - (before ? 1 : 0);
    };
    std::vector<std::vector<double>> opened(places.size());
    std::vector<std::vector<double>> closed(places.size());
    for (const Zone &zone : zones)
    {
        opened[index(zone.low)].push_back(zone.density);
        closed[index(zone.high)].push_back(zone.density);
    }
    std::multiset<double> active;
    std::vector<Zone> layers;
    for (std::size_t k = 0; k + 1 < places.size(); ++k)
    {
        active.insert(opened[k].begin(), opened[k].end());
        for (const double density : closed[k])
            active.erase(active.find(density));
        layers.push_back({places[k], places[k + 1], active.empty() ? 0.0 : *active.rbegin()});
    }
    return layers;
}

} // namespace

std::vector<double> ramp_knots(const EdgeWalk &walk, int direction, double low, double high)
{
    std::vector<Zone> merged;
    for (const Zone &layer : layered(zones_of(walk, direction), low, high))
        if (!merged.empty() && layer.density <= same_density * merged.back().density &&
            merged.back().density <= same_density * layer.density)
        {
            merged.back().high = layer.high;
            merged.back().density = std::max(merged.back().density, layer.density);
        }
        else
            merged.push_back(layer);
    std::vector<double> knots;
    double missing = 0.0;
    for (const Zone &zone : merged)
    {
        const double wanted = (zone.high - zone.low) * zone.density;
        missing = zone.density > 0.0 ? missing + wanted : 0.0;
        if (missing < 0.5)
            continue;
        missing = 0.0;
        const int spans = std::max(1, static_cast<int>(std::ceil(wanted - 0.2)));
        for (int i = 0; i <= spans; ++i)
            knots.push_back(zone.low + (zone.high - zone.low) * i / spans);
    }
    std::sort(knots.begin(), knots.end());
    const double closest = 1e-6 * (high - low);
    std::vector<double> interior;
    for (const double knot : knots)
        if (knot - (interior.empty() ? low : interior.back()) > closest && high - knot > closest)
            interior.push_back(knot);
    return interior;
}

} // namespace laminate_offset
