// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ply_quadrature.h"

#include "../analysis/base_surface.h"
#include "../spline/geom_values.h"
#include "../spline/scalar_spline.h"
#include "face_quadrature.h"
#include "strip_quadrature.h"

#include <gp_Trsf.hxx>

#include <algorithm>
#include <cmath>
#include <optional>

namespace laminate_offset
{
namespace
{

constexpr int kinds = 2;          // volume, area
constexpr int values_of_kind = 4; // itself, times the position (3)

//! The integrand of one layer.
class LayerIntegrand
{
public:
    using Integral = StripIntegral<kinds, values_of_kind>;

    LayerIntegrand(const InputFace &region, const BaseSurface &base, const PlyLayer &layer)
        : m_region(region), m_base(base), m_bottom(layer.bottom.as_surface()), m_thickness(layer.thickness),
          m_origin(vector(
              region.point({0.5 * (region.box.umin + region.box.umax), 0.5 * (region.box.vmin + region.box.vmax)})
                  .XYZ()))
    {
    }

    [[nodiscard]] const Eigen::Vector3d &origin() const { return m_origin; }

    void add_row(const std::vector<double> &us, double v, const std::vector<double> &weights, Integral &to) const
    {
        const std::vector<SurfaceJet> jets = m_base.jets(us, {v}, 2);
        const std::vector<SurfaceJet> bottoms = m_bottom.jets(us, {v}, 1);
        for (std::size_t i = 0; i < jets.size(); ++i)
            add(jets[i], bottoms[i], weights[i], to);
    }

    //! The largest disagreement, each relative to its size.
    [[nodiscard]] double relative(const Integral::Sums &disagreement, const Integral::Sizes &sizes) const
    {
        double worst = 0.0;
        for (int k = 0; k < kinds; ++k)
        {
            const auto of_kind = disagreement.segment<values_of_kind>(k * values_of_kind).abs();
            const double largest = std::max(of_kind(0), of_kind.segment<3>(1).maxCoeff() / m_region.diagonal);
            if (largest > 0.0)
                worst = std::max(worst, largest / std::abs(sizes(k)));
        }
        return worst;
    }

private:
    //! Adds the values at a place, whose du dv is `weight`; nothing at a singular one.
    void add(const SurfaceJet &jet, const SurfaceJet &bottom, double weight, Integral &to) const
    {
        const Eigen::Vector3d cross = jet.u.cross(jet.v);
        const double stretch = cross.norm();
        if (!(stretch > 0.0))
            return;
        const Eigen::Vector3d normal = cross / stretch;
        const double e = jet.u.squaredNorm(), f = jet.u.dot(jet.v), g = jet.v.squaredNorm();
        const double l = jet.uu.dot(normal), m = jet.uv.dot(normal), n = jet.vv.dot(normal);
        const double square = stretch * stretch;
        const double mean = (e * n - 2.0 * f * m + g * l) / (2.0 * square);
        const double gauss = (l * n - m * m) / square;
        const double low = bottom.s.x();
        const double high = low + m_thickness;
        const auto upright = [&](double x) { return x * (1.0 + x * (-mean + x * gauss / 3.0)); };
        const auto moment = [&](double x) { return x * x * (0.5 + x * (-2.0 * mean / 3.0 + x * gauss / 4.0)); };
        const double turn = m_thickness < 0.0 ? -1.0 : 1.0;
        const double volume = turn * weight * stretch * (upright(high) - upright(low));
        const double lever = turn * weight * stretch * (moment(high) - moment(low));
        const double middle = 0.5 * (low + high);
        // of the normal (Weingarten)
        const Eigen::Vector3d normal_u = ((f * m - g * l) * jet.u + (f * l - e * m) * jet.v) / square;
        const Eigen::Vector3d normal_v = ((f * n - g * m) * jet.u + (f * m - e * n) * jet.v) / square;
        const Eigen::Vector3d along_u = jet.u + middle * normal_u + bottom.u.x() * normal;
        const Eigen::Vector3d along_v = jet.v + middle * normal_v + bottom.v.x() * normal;
        to.sums(0) += volume;
        to.sums.segment<3>(1) += (volume * (jet.s - m_origin) + lever * normal).array();
        to.sums(values_of_kind) += weight * along_u.cross(along_v).norm();
        to.sizes(0) += weight * stretch * std::abs(m_thickness);
        to.sizes(1) += weight * stretch;
    }

    const InputFace &m_region;
    const BaseSurface &m_base;
    TensorSpline m_bottom;
    double m_thickness;
    Eigen::Vector3d m_origin;
};

//! The interval ends of the base with the spline's knots between them.
std::vector<double> merged(const std::vector<double> &ends, const KnotVector &knots)
{
    std::vector<double> between;
    for (const double knot : knots.breaks())
        if (knot > ends.front() && knot < ends.back())
            between.push_back(knot);
    return merged_breaks(ends, between);
}

//! The sums as figures where the region stands.
PlyIntegrals placed(const LayerIntegrand::Integral &total, const LayerIntegrand &integrand, const InputFace &region)
{
    // loops that run clockwise in the parameters enclose the same volume
    const double turn = total.sums(0) < 0.0 ? -1.0 : 1.0;
    const gp_Trsf to_place = region.location.Transformation();
    PlyIntegrals result;
    result.volume = turn * total.sums(0);
    result.area = turn * total.sums(values_of_kind);
    const Eigen::Vector3d moment = turn * total.sums.segment<3>(1).matrix() + result.volume * integrand.origin();
    result.first_moment = gp_XYZ(moment.x(), moment.y(), moment.z()).Multiplied(to_place.VectorialPart()) +
                          result.volume * to_place.TranslationPart();
    result.relative_error = integrand.relative(total.disagreement, total.sizes);
    return result;
}

PlyIntegrals integrate_varying(const InputFace &region, const BaseSurface &base, const PlyLayer &layer)
{
    const std::vector<FaceStrip> strips = face_strips(region, merged(base.interval_ends_u(), layer.bottom.u),
                                                      merged(base.interval_ends_v(), layer.bottom.v));
    const LayerIntegrand integrand(region, base, layer);
    return placed(over_strips(integrand, strips), integrand, region);
}

PlyIntegrals at_constant(const InputFace &region, const FaceIntegrals &face, const PlyLayer &layer)
{
    const double bottom = layer.bottom.poles.front();
    const double first = region.from_face(bottom);
    const double second = region.from_face(bottom + layer.thickness);
    const auto [low, high] = std::minmax(first, second);
    return {face.area_at(0.5 * (low + high)), face.volume(low, high), face.first_moment(low, high),
            face.relative_error};
}

} // namespace

std::vector<PlyIntegrals> integrate_plies(const InputFace &region, const std::vector<PlyLayer> &layers)
{
    const BaseSurface base(region.surface, fit_box(region));
    std::optional<FaceIntegrals> face;
    std::vector<PlyIntegrals> result;
    for (const PlyLayer &layer : layers)
    {
        if (layer.bottom.low() == layer.bottom.high())
        {
            if (!face)
                face = integrate_face(region);
            result.push_back(at_constant(region, *face, layer));
        }
        else
            result.push_back(integrate_varying(region, base, layer));
    }
    return result;
}

} // namespace laminate_offset
