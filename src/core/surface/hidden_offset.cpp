// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_surface.h"

#include "certificate.h"
#include "hidden_shape.h"

#include "../spline/knot_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

// Samples in each direction: enough to tell the five kinds from a free form; the proof settles the rest.
constexpr int samples_per_direction = 12;
// A knot that moves the surface by this part of its size is redundant: rounding of a knot insertion.
constexpr double redundant_knot = 1e-12;

std::vector<double> sample_parameters(const std::vector<double> &ends)
{
    const int intervals = static_cast<int>(ends.size()) - 1;
    return chebyshev_parameters(ends, std::max(1, samples_per_direction / intervals));
}

std::optional<ShapeSamples> sampled(const BaseSurface &base)
{
    const std::vector<double> us = sample_parameters(base.interval_ends_u());
    const std::vector<double> vs = sample_parameters(base.interval_ends_v());
    const std::vector<SurfaceJet> jets = base.jets(us, vs, 1);
    ShapeSamples samples;
    const auto count = static_cast<Eigen::Index>(jets.size());
    samples.points.resize(count, 3);
    samples.normals.resize(count, 3);
    for (std::size_t i = 0; i < jets.size(); ++i)
    {
        const auto normal = base.unit_normal(jets[i], us[i / vs.size()], vs[i % vs.size()]);
        if (!normal)
            return std::nullopt;
        samples.points.row(static_cast<Eigen::Index>(i)) = jets[i].s.transpose();
        samples.normals.row(static_cast<Eigen::Index>(i)) = normal->transpose();
    }
    return samples;
}

//! A surface of revolution with the parameters of one has the poles origin + z_j axis + r_j e_i in one of its
//! two directions. The poles e_i of the unit circle are read off the widest circle.
class RevolvedPoles
{
public:
    RevolvedPoles(const TensorSpline &spline, const HiddenShape &shape, bool along_u)
        : m_spline(spline), m_shape(shape), m_along_u(along_u)
    {
        for (int k = 0; k < other_count(); ++k)
            if (radial(0, k).norm() > radial(0, m_widest).norm())
                m_widest = k;
        const double widest = radial(0, m_widest).norm();
        for (int i = 0; i < count(); ++i)
            m_unit.push_back(radial(i, m_widest) / widest);
    }

    //! Are the poles so, within a tolerance?
    [[nodiscard]] bool fits(double tolerance) const
    {
        for (int k = 0; k < other_count(); ++k)
        {
            const double radius = radial(0, k).dot(m_unit.front());
            for (int i = 0; i < count(); ++i)
                if (!((radial(i, k) - radius * m_unit[static_cast<std::size_t>(i)]).norm() <= tolerance))
                    return false;
        }
        return true;
    }

    //! The pole of the unit circle that belongs to pole (i, j) of the surface.
    [[nodiscard]] const Eigen::Vector3d &unit(int i, int j) const
    {
        return m_unit[static_cast<std::size_t>(m_along_u ? i : j)];
    }

private:
    [[nodiscard]] int count() const { return (m_along_u ? m_spline.u : m_spline.v).pole_count(); }
    [[nodiscard]] int other_count() const { return (m_along_u ? m_spline.v : m_spline.u).pole_count(); }
    [[nodiscard]] Eigen::Vector3d radial(int i, int k) const
    {
        const Eigen::Vector4d &pole = m_along_u ? m_spline.pole(i, k) : m_spline.pole(k, i);
        const Eigen::Vector3d p = pole.head<3>() / pole.w() - m_shape.origin;
        return p - p.dot(m_shape.axis) * m_shape.axis;
    }

    const TensorSpline &m_spline;
    const HiddenShape &m_shape;
    bool m_along_u;
    int m_widest = 0;
    std::vector<Eigen::Vector3d> m_unit;
};

//! Every pole (w p, w) moved by w times what `move` says for the point p.
template <typename Move> TensorSpline moved(TensorSpline spline, const Move &move)
{
    for (int i = 0; i < spline.u.pole_count(); ++i)
        for (int j = 0; j < spline.v.pole_count(); ++j)
        {
            Eigen::Vector4d &pole = spline.poles[static_cast<std::size_t>(i) * spline.v.pole_count() + j];
            const Eigen::Vector3d p = pole.head<3>() / pole.w();
            pole.head<3>() += pole.w() * move(p, i, j);
        }
    return spline;
}

//! The offset of a cone or torus, whose normal is no affine function of the point but one of the unit circle too.
std::optional<TensorSpline> offset_of_revolved(const TensorSpline &base, const HiddenShape &shape, double distance,
                                               double tolerance)
{
    for (const bool along_u : {true, false})
    {
        const RevolvedPoles poles(base, shape, along_u);
        if (!poles.fits(tolerance))
            continue;
        if (shape.kind == HiddenShape::Kind::Cone)
            return moved(base, [&](const Eigen::Vector3d &, int i, int j) -> Eigen::Vector3d {
                return distance * (shape.outward * poles.unit(i, j) + shape.axial * shape.axis);
            });
        return moved(base, [&](const Eigen::Vector3d &p, int i, int j) -> Eigen::Vector3d {
            return distance / shape.radius * (p - shape.origin - shape.major * poles.unit(i, j));
        });
    }
    return std::nullopt;
}

//! S + d N as a spline on the base's own knots and weights, if the base is this shape.
std::optional<TensorSpline> offset_of_shape(const TensorSpline &base, const HiddenShape &shape, double distance,
                                            double tolerance)
{
    const double scale = distance / shape.radius;
    switch (shape.kind)
    {
    case HiddenShape::Kind::Plane:
        return moved(base, [&](const Eigen::Vector3d &, int, int) -> Eigen::Vector3d { return distance * shape.axis; });
    case HiddenShape::Kind::Sphere:
        return moved(base,
                     [&](const Eigen::Vector3d &p, int, int) -> Eigen::Vector3d { return scale * (p - shape.origin); });
    case HiddenShape::Kind::Cylinder:
        return moved(base, [&](const Eigen::Vector3d &p, int, int) -> Eigen::Vector3d {
            const Eigen::Vector3d from = p - shape.origin;
            return scale * (from - from.dot(shape.axis) * shape.axis);
        });
    default: return offset_of_revolved(base, shape, distance, tolerance);
    }
}

double largest_coordinate(const TensorSpline &spline)
{
    double largest = 0.0;
    for (const Eigen::Vector4d &pole : spline.poles)
        largest = std::max(largest, pole.head<3>().cwiseAbs().maxCoeff());
    return largest;
}

//! The same surface without the knots that it does not need.
TensorSpline without_redundant_knots(const TensorSpline &spline)
{
    const Handle(Geom_BSplineSurface) surface = to_geom(spline);
    const double tolerance = redundant_knot * largest_coordinate(spline);
    for (int k = surface->NbUKnots() - 1; k > 1; --k)
        while (k < surface->NbUKnots() && surface->RemoveUKnot(k, surface->UMultiplicity(k) - 1, tolerance))
        {
        }
    for (int k = surface->NbVKnots() - 1; k > 1; --k)
        while (k < surface->NbVKnots() && surface->RemoveVKnot(k, surface->VMultiplicity(k) - 1, tolerance))
        {
        }
    return from_geom(surface);
}

//! Is the guess right at the samples? What fails here need not be proven wrong.
bool holds_at(const ShapeSamples &samples, const TensorSpline &offset, const BaseSurface &base, double distance,
              double tolerance)
{
    const std::vector<SurfaceJet> jets =
        offset.jets(sample_parameters(base.interval_ends_u()), sample_parameters(base.interval_ends_v()), 0);
    for (std::size_t i = 0; i < jets.size(); ++i)
    {
        const auto row = static_cast<Eigen::Index>(i);
        const Eigen::Vector3d exact = (samples.points.row(row) + distance * samples.normals.row(row)).transpose();
        if (!((jets[i].s - exact).norm() <= tolerance))
            return false;
    }
    return true;
}

} // namespace

std::optional<OffsetSurface> hidden_offset(const SurfaceAnalysis &analysis, double distance, double tolerance)
{
    const std::optional<TensorSpline> &base = analysis.base.spline();
    const std::optional<ShapeSamples> samples = base ? sampled(analysis.base) : std::nullopt;
    if (!samples)
        return std::nullopt;
    const double of_model = analysis.base.model_error().of_offset(distance);
    const double left = tolerance - of_model;
    const auto needed = [&](const ParameterBox &box) { return analysis.region.may_touch(box); };
    for (const HiddenShape &shape : recognise(*samples, left))
    {
        const std::optional<TensorSpline> full = offset_of_shape(*base, shape, distance, left);
        if (!full || !holds_at(*samples, *full, analysis.base, distance, left))
            continue;
        for (const TensorSpline &offset : {without_redundant_knots(*full), *full})
            if (const Certificate proof = certify({*base, offset, distance, left, needed, analysis.base.rounding()});
                proof.proven)
                return OffsetSurface{to_geom(offset), {0.0, 0.0}, proof.bound + of_model, std::nullopt};
    }
    return std::nullopt;
}

} // namespace laminate_offset
