// SPDX-License-Identifier: LGPL-2.1-or-later
#include "face_quadrature.h"

#include "../analysis/base_surface.h"
#include "../spline/geom_values.h"
#include "../trimming/curve_breaks.h"
#include "face_strips.h"

#include <gp_Trsf.hxx>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace laminate_offset
{
namespace
{

// Both rules have to agree to this part of the integral of the size.
constexpr double agreement = 1e-10;
// A part of the face may also be off by its share of this much of the whole.
constexpr double whole_agreement = 1e-11;
// Halvings of a part; past them its disagreement goes into the estimate.
constexpr int deepest = 8;
constexpr int coarse_points = 7;
constexpr int fine_points = 10;

constexpr int kinds = 3;          // 1, H, K
constexpr int values_of_kind = 7; // itself, times S (3), times N (3)
using Sums = Eigen::Array<double, kinds * values_of_kind, 1>;
using Sizes = Eigen::Array<double, kinds, 1>;

struct Rule
{
    std::vector<double> nodes; //!< in [0, 1]
    std::vector<double> weights;
};

//! The Gauss-Legendre rule on [0, 1], by Newton's iteration on the Legendre polynomial.
Rule gauss_rule(int count)
{
    Rule rule;
    for (int i = 0; i < count; ++i)
    {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
        double slope = 1.0;
        for (int step = 0; step < 20; ++step)
        {
            double before = 1.0;
            double here = x;
            for (int k = 2; k <= count; ++k)
                before = std::exchange(here, ((2.0 * k - 1.0) * x * here - (k - 1.0) * before) / k);
            slope = count * (x * here - before) / (x * x - 1.0);
            x -= here / slope;
        }
        rule.nodes.push_back(0.5 * (1.0 - x));
        rule.weights.push_back(1.0 / ((1.0 - x * x) * slope * slope));
    }
    return rule;
}

const Rule &coarse_rule()
{
    static const Rule rule = gauss_rule(coarse_points);
    return rule;
}

const Rule &fine_rule()
{
    static const Rule rule = gauss_rule(fine_points);
    return rule;
}

//! Sums with the sizes that their errors are measured by.
struct Integral
{
    Sums sums = Sums::Zero();
    Sizes sizes = Sizes::Zero();      //!< signed like the area
    Sums disagreement = Sums::Zero(); //!< of the two rules

    void add(const Integral &other)
    {
        sums += other.sums;
        sizes += other.sizes;
        disagreement += other.disagreement;
    }
};

//! The integrand on the face.
class Integrand
{
public:
    Integrand(const InputFace &input, const BaseSurface &base)
        : m_input(input), m_base(base), m_origin(vector(input.point(middle(input.box)).XYZ()))
    {
    }

    [[nodiscard]] const BaseSurface &base() const { return m_base; }
    [[nodiscard]] const Eigen::Vector3d &origin() const { return m_origin; }

    //! Adds the values at a jet, whose du dv is `weight`; nothing at a singular place.
    void add(const SurfaceJet &jet, double weight, Integral &to) const
    {
        const Eigen::Vector3d cross = jet.u.cross(jet.v);
        const double stretch = cross.norm();
        if (!(stretch > 0.0))
            return;
        Eigen::Vector3d normal = cross / stretch;
        const double e = jet.u.squaredNorm();
        const double f = jet.u.dot(jet.v);
        const double g = jet.v.squaredNorm();
        const double l = jet.uu.dot(normal);
        const double m = jet.uv.dot(normal);
        const double n = jet.vv.dot(normal);
        const double square = stretch * stretch;
        double mean = (e * n - 2.0 * f * m + g * l) / (2.0 * square);
        double gauss = (l * n - m * m) / square;
        // from the surface to the face, which may stand off it, and to its outward normal
        const double b = m_input.base_distance;
        const double growth = 1.0 - 2.0 * mean * b + gauss * b * b;
        const Eigen::Vector3d arm = jet.s + b * normal - m_origin;
        mean = m_input.normal_sign * (mean - gauss * b) / growth;
        gauss /= growth;
        normal *= m_input.normal_sign;
        add_values(weight * stretch * growth, mean, gauss, arm, normal, to);
    }

    //! Whether the disagreement is within a part of the sizes.
    [[nodiscard]] bool within(const Sums &disagreement, const Sizes &sizes, double part) const
    {
        return relative(disagreement, sizes) <= part;
    }

    //! The largest disagreement, each relative to its size.
    [[nodiscard]] double relative(const Sums &disagreement, const Sizes &sizes) const
    {
        double worst = 0.0;
        for (int k = 0; k < kinds; ++k)
        {
            const auto of_kind = disagreement.segment<values_of_kind>(k * values_of_kind).abs();
            const double largest = std::max(
                {of_kind(0), of_kind.segment<3>(1).maxCoeff() / m_input.diagonal, of_kind.segment<3>(4).maxCoeff()});
            if (largest > 0.0)
                worst = std::max(worst, largest / std::abs(sizes(k)));
        }
        return worst;
    }

private:
    static gp_Pnt2d middle(const ParameterBox &box)
    {
        return {0.5 * (box.umin + box.umax), 0.5 * (box.vmin + box.vmax)};
    }

    void add_values(double area, double mean, double gauss, const Eigen::Vector3d &arm, const Eigen::Vector3d &normal,
                    Integral &to) const
    {
        // flat places count as if they were bent to the face's own size: that is far below what any thickness shows
        const double bend = std::sqrt(std::max(0.0, 4.0 * mean * mean - 2.0 * gauss)) + 1.0 / m_input.diagonal;
        const double factors[kinds] = {area, area * mean, area * gauss};
        const double sizes[kinds] = {area, area * bend, area * bend * bend};
        for (int k = 0; k < kinds; ++k)
        {
            auto values = to.sums.segment<values_of_kind>(k * values_of_kind);
            values(0) += factors[k];
            values.segment<3>(1) += factors[k] * arm.array();
            values.segment<3>(4) += factors[k] * normal.array();
            to.sizes(k) += sizes[k];
        }
    }

    const InputFace &m_input;
    const BaseSurface &m_base;
    Eigen::Vector3d m_origin;
};

//! A rectangle in the unit square of a strip.
struct UnitBox
{
    double x0 = 0.0, x1 = 1.0, y0 = 0.0, y1 = 1.0;
    int depth = 0;
};

Integral by_rule(const Integrand &integrand, const FaceStrip &strip, const UnitBox &box, const Rule &rule)
{
    Integral result;
    std::vector<double> us(rule.nodes.size());
    for (std::size_t j = 0; j < rule.nodes.size(); ++j)
    {
        const StripRow row = strip.row(box.y0 + (box.y1 - box.y0) * rule.nodes[j]);
        for (std::size_t i = 0; i < us.size(); ++i)
            us[i] = row.left + (row.right - row.left) * (box.x0 + (box.x1 - box.x0) * rule.nodes[i]);
        const double width = (row.right - row.left) * (box.x1 - box.x0);
        const double height = row.speed * (box.y1 - box.y0) * rule.weights[j];
        if (width == 0.0 || height == 0.0)
            continue;
        const std::vector<SurfaceJet> jets = integrand.base().jets(us, {row.v}, 2);
        for (std::size_t i = 0; i < jets.size(); ++i)
            integrand.add(jets[i], width * height * rule.weights[i], result);
    }
    return result;
}

Integral by_both_rules(const Integrand &integrand, const FaceStrip &strip, const UnitBox &box)
{
    Integral fine = by_rule(integrand, strip, box, fine_rule());
    fine.disagreement = (fine.sums - by_rule(integrand, strip, box, coarse_rule()).sums).abs();
    return fine;
}

//! The quarters of a box, until both rules agree on each.
Integral refined(const Integrand &integrand, const FaceStrip &strip, const Integral &whole, const Sizes &allowed)
{
    Integral result;
    std::vector<std::pair<UnitBox, Integral>> open{{UnitBox{}, whole}};
    while (!open.empty())
    {
        const auto [box, value] = std::move(open.back());
        open.pop_back();
        if (box.depth >= deepest || integrand.within(value.disagreement, value.sizes, agreement) ||
            integrand.within(value.disagreement, allowed, whole_agreement))
        {
            result.add(value);
            continue;
        }
        const double x = 0.5 * (box.x0 + box.x1);
        const double y = 0.5 * (box.y0 + box.y1);
        for (const UnitBox &quarter : {UnitBox{box.x0, x, box.y0, y, box.depth + 1},
                                       {x, box.x1, box.y0, y, box.depth + 1},
                                       {box.x0, x, y, box.y1, box.depth + 1},
                                       {x, box.x1, y, box.y1, box.depth + 1}})
            open.emplace_back(quarter, by_both_rules(integrand, strip, quarter));
    }
    return result;
}

Integral over_strips(const Integrand &integrand, const std::vector<FaceStrip> &strips)
{
    std::vector<Integral> parts(strips.size());
    tbb::parallel_for(std::size_t{0}, strips.size(),
                      [&](std::size_t i) { parts[i] = by_both_rules(integrand, strips[i], UnitBox{}); });
    Sizes allowed = Sizes::Zero();
    for (const Integral &part : parts)
        allowed += part.sizes.abs() / static_cast<double>(parts.size());
    tbb::parallel_for(std::size_t{0}, strips.size(),
                      [&](std::size_t i) { parts[i] = refined(integrand, strips[i], parts[i], allowed); });
    Integral total;
    for (std::size_t i = 0; i < strips.size(); ++i)
    {
        parts[i].sums *= strips[i].sign;
        parts[i].sizes *= strips[i].sign;
        total.add(parts[i]);
    }
    return total;
}

gp_XYZ xyz(const Eigen::Vector3d &v) { return {v.x(), v.y(), v.z()}; }

//! The sums as integrals where the face stands.
FaceIntegrals placed(const Integral &total, const Integrand &integrand, const InputFace &input)
{
    // loops that run clockwise in the parameters enclose the same area
    const double turn = total.sums(0) < 0.0 ? -1.0 : 1.0;
    const gp_Trsf to_place = input.location.Transformation();
    const gp_Mat turning = to_place.VectorialPart();
    FaceIntegrals result;
    double *const scalars[kinds] = {&result.area, &result.mean_curvature, &result.gaussian_curvature};
    for (int k = 0; k < kinds; ++k)
    {
        const Eigen::Matrix<double, values_of_kind, 1> values =
            turn * total.sums.segment<values_of_kind>(k * values_of_kind).matrix();
        *scalars[k] = values(0);
        const gp_XYZ local = xyz(values.segment<3>(1) + values(0) * integrand.origin());
        result.position[static_cast<std::size_t>(k)] =
            local.Multiplied(turning) + values(0) * to_place.TranslationPart();
        result.normal[static_cast<std::size_t>(k)] = xyz(values.segment<3>(4)).Multiplied(turning);
    }
    result.relative_error = integrand.relative(total.disagreement, total.sizes);
    return result;
}

} // namespace

double FaceIntegrals::area_at(double distance) const
{
    return area - 2.0 * distance * mean_curvature + distance * distance * gaussian_curvature;
}

double FaceIntegrals::volume(double low, double high) const
{
    const double first = 0.5 * (low + high);
    const double second = (low * low + low * high + high * high) / 3.0;
    return (high - low) * (area - 2.0 * first * mean_curvature + second * gaussian_curvature);
}

gp_XYZ FaceIntegrals::first_moment(double low, double high) const
{
    const double first = 0.5 * (low + high);
    const double second = (low * low + low * high + high * high) / 3.0;
    const double third = 0.25 * (low + high) * (low * low + high * high);
    const gp_XYZ of_position = position[0] - 2.0 * first * position[1] + second * position[2];
    const gp_XYZ of_normal = first * normal[0] - 2.0 * second * normal[1] + third * normal[2];
    return (high - low) * (of_position + of_normal);
}

Result<FaceIntegrals> integrate_face(const InputFace &input)
{
    const BaseSurface base(input.surface, fit_box(input));
    const Result<std::vector<FaceStrip>> strips = face_strips(input, base);
    if (!strips)
        return strips.failure();
    const Integrand integrand(input, base);
    return placed(over_strips(integrand, strips.value()), integrand, input);
}

} // namespace laminate_offset
