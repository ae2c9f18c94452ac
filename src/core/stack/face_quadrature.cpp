// SPDX-License-Identifier: LGPL-2.1-or-later
#include "face_quadrature.h"

#include "../analysis/base_surface.h"
#include "../spline/geom_values.h"
#include "strip_quadrature.h"

#include <gp_Trsf.hxx>

#include <algorithm>
#include <cmath>
#include <vector>

namespace laminate_offset
{
namespace
{

constexpr int kinds = 3;          // 1, H, K
constexpr int values_of_kind = 7; // itself, times S (3), times N (3)

//! The integrand on the face.
class Integrand
{
public:
    using Integral = StripIntegral<kinds, values_of_kind>;

    Integrand(const InputFace &input, const BaseSurface &base)
        : m_input(input), m_base(base), m_origin(vector(input.point(middle(input.box)).XYZ()))
    {
    }

    [[nodiscard]] const Eigen::Vector3d &origin() const { return m_origin; }

    void add_row(const std::vector<double> &us, double v, const std::vector<double> &weights, Integral &to) const
    {
        const std::vector<SurfaceJet> jets = m_base.jets(us, {v}, 2);
        for (std::size_t i = 0; i < jets.size(); ++i)
            add(jets[i], weights[i], to);
    }

    //! The largest disagreement, each relative to its size.
    [[nodiscard]] double relative(const Integral::Sums &disagreement, const Integral::Sizes &sizes) const
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

gp_XYZ xyz(const Eigen::Vector3d &v) { return {v.x(), v.y(), v.z()}; }

//! The sums as integrals where the face stands.
FaceIntegrals placed(const Integrand::Integral &total, const Integrand &integrand, const InputFace &input)
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

FaceIntegrals integrate_face(const InputFace &input)
{
    const BaseSurface base(input.surface, fit_box(input));
    const std::vector<FaceStrip> strips = face_strips(input, base.interval_ends_u(), base.interval_ends_v());
    const Integrand integrand(input, base);
    return placed(over_strips(integrand, strips), integrand, input);
}

} // namespace laminate_offset
