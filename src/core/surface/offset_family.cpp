// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_family.h"

#include "one_space_fit.h"

#include "../spline/geom_values.h"

#include <Geom_SphericalSurface.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// A pole of at(d) is off the line through the fitted ends' poles by at most 10.1 u D |N^| + 2.1 u |S^|, with u the unit
// roundoff, half of epsilon, and D the larger |distance|: 3 u |N^| for the quotient, times at most 2 D, and one rounding
// each for the two products and the two sums. The bound below takes a multiple of it.
constexpr double rounding_operations = 16.0;
// A pole of a sphere's offset is computed with fewer roundings than that, each of the size of pole and centre.
constexpr double sphere_operations = 8.0;

//! N^ = (O_high - O_low) / (high - low), S^ = O_low - low N^, in numerators.
OffsetFamily through(const TensorSpline &at_low, const TensorSpline &at_high, double low, double high)
{
    OffsetFamily family{at_low, at_low, low, high, std::nullopt, 0.0};
    for (std::size_t i = 0; i < at_low.poles.size(); ++i)
    {
        const Eigen::Vector3d difference = at_high.poles[i].head<3>() - at_low.poles[i].head<3>();
        family.direction.poles[i].head<3>() = difference / (high - low);
        family.position.poles[i].head<3>() -= low * family.direction.poles[i].head<3>();
    }
    return family;
}

//! Bound of the rounding of at(d) against the line through the fitted ends [mm], for every d of the interval.
double rounding(const OffsetFamily &family)
{
    const double farther = std::max(std::abs(family.low), std::abs(family.high));
    double largest = 0.0;
    for (std::size_t i = 0; i < family.position.poles.size(); ++i)
    {
        const Eigen::Vector4d &s = family.position.poles[i];
        const Eigen::Vector4d &n = family.direction.poles[i];
        const double size = (s.head<3>().norm() + farther * n.head<3>().norm()) / s.w();
        if (!(s.w() > 0.0) || !std::isfinite(size))
            return std::numeric_limits<double>::infinity();
        largest = std::max(largest, size);
    }
    return rounding_operations * epsilon * largest;
}

//! Largest distance seen on a grid over the loops' box between the ends of a sphere's family and the exact offset [mm].
double seen_on_sphere(const OffsetFamily &family, const Geom_SphericalSurface &sphere, double radius,
                      const ParameterBox &box)
{
    constexpr int grid = 24;
    const Eigen::Vector3d centre = vector(sphere.Location().XYZ());
    std::vector<double> us, vs;
    for (int i = 0; i <= grid; ++i)
    {
        us.push_back(box.umin + (box.umax - box.umin) * i / grid);
        vs.push_back(box.vmin + (box.vmax - box.vmin) * i / grid);
    }
    double largest = 0.0;
    for (const double distance : {family.low, family.high})
    {
        const std::vector<SurfaceJet> jets = family.at(distance).jets(us, vs, 0);
        for (std::size_t k = 0; k < jets.size(); ++k)
        {
            const Eigen::Vector3d on_base = vector(sphere.Value(us[k / vs.size()], vs[k % vs.size()]).XYZ());
            const Eigen::Vector3d exact = centre + (1.0 + distance / radius) * (on_base - centre);
            largest = std::max(largest, (jets[k].s - exact).norm());
        }
    }
    return largest;
}

//! Of a sphere, S + d N = C + (1 + d / r) (S - C), with r the radius, below zero where S_u x S_v points inwards. So the
//! family of the spline that stands for S is known, and its error is the spline's, (1 + d / r) times as large: also at
//! poles, where a fit of normals has no proof.
std::optional<OffsetFamily> sphere_family(const SurfaceAnalysis &analysis, const InputFace &input, double low,
                                          double high, double tolerance)
{
    const auto sphere = Handle(Geom_SphericalSurface)::DownCast(input.surface);
    const std::optional<TensorSpline> &spline = analysis.base.spline();
    if (sphere.IsNull() || !spline)
        return std::nullopt;
    const gp_Ax3 &frame = sphere->Position();
    const Eigen::Vector3d centre = vector(frame.Location().XYZ());
    const double radius = frame.Direct() ? sphere->Radius() : -sphere->Radius();
    const auto at = [&](double distance) {
        TensorSpline offset = *spline;
        for (Eigen::Vector4d &pole : offset.poles)
            pole.head<3>() = pole.w() * centre + (1.0 + distance / radius) * (pole.head<3>() - pole.w() * centre);
        return offset;
    };
    OffsetFamily family = through(at(low), at(high), low, high);
    double size = 0.0;
    for (const Eigen::Vector4d &pole : spline->poles)
        size = std::max(size, pole.head<3>().norm() / pole.w() + 2.0 * centre.norm());
    const double factor = 1.0 + std::max(std::abs(low), std::abs(high)) / sphere->Radius();
    const double bound =
        factor * (analysis.base.model_error().point + sphere_operations * epsilon * size) + rounding(family);
    if (!(bound <= tolerance))
        return std::nullopt;
    family.certified_error = bound;
    family.sampled_error = seen_on_sphere(family, *sphere, radius, input.box);
    return family;
}

//! What is wrong with the interval?
std::optional<Failure> refusal_of(double low, double high)
{
    if (!std::isfinite(low) || !std::isfinite(high) || !std::isfinite(high - low))
        return Failure{Status::InvalidDistance, Stage::Options,
                       "The ends of the interval of distances are not finite numbers; give them in millimetres.",
                       std::nullopt, std::nullopt};
    if (low >= high)
        return Failure{Status::InvalidOption, Stage::Options,
                       fmt::format("The interval of distances from {} to {} mm is empty or a single distance; give the "
                                   "lesser end first, and fit a single distance on its own.",
                                   low, high),
                       std::nullopt, std::nullopt};
    return std::nullopt;
}

} // namespace

TensorSpline OffsetFamily::at(double distance) const
{
    TensorSpline spline = position;
    for (std::size_t i = 0; i < spline.poles.size(); ++i)
        spline.poles[i].head<3>() += distance * direction.poles[i].head<3>();
    return spline;
}

Result<OffsetFamily> fit_offset_family(const SurfaceAnalysis &analysis, const InputFace &input, double low, double high,
                                       double tolerance, const OffsetOptions &options)
{
    if (std::optional<Failure> refusal = refusal_of(low, high))
        return *std::move(refusal);
    if (std::optional<OffsetFamily> known = sphere_family(analysis, input, low, high, tolerance))
        return *std::move(known);
    const auto rounding_between = [&](const std::vector<TensorSpline> &ends) {
        return rounding(through(ends[0], ends[1], low, high));
    };
    const Result<OneSpaceFit> fitted =
        fit_in_one_space({analysis, input, {low, high}, tolerance, options, rounding_between});
    if (!fitted)
        return fitted.failure();
    const OneSpaceFit &fit = fitted.value();
    OffsetFamily family = through(fit.splines[0], fit.splines[1], low, high);
    family.certified_error = fit.certified_error;
    family.sampled_error = fit.sampled_error;
    return family;
}

} // namespace laminate_offset
