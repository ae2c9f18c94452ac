// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept_model.h"

#include "profile_bounds.h"

#include "../spline/geom_values.h"

#include <Eigen/Dense>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace laminate_offset
{
namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();
// Part of the tolerance that a model aims at, and that it may take at most.
constexpr double aimed_share = 4e-3;
constexpr double largest_share = 0.1;
// Relative error of curvatures that a model aims at: far below the gap at which their search ends.
constexpr double curvature_share = 1e-4;
constexpr double largest_curvature_share = 1e-2;
// Roundings of a pole, those of OpenCASCADE's own evaluation included.
constexpr double pole_roundings = 32.0;
// A profile this near to a plane through the axis, or to the axis, lies in it: roundings of its coordinates.
constexpr double in_plane = 256.0 * epsilon;
// Radii below this part of the size are rounding, as in the search for curvatures.
constexpr double least_length = 1e-5;
// Half width [rad] of the strip whose curvature is searched: bounds over it exceed those of its middle line by
// less than this part, rounding of second derivatives stays below 1e-6.
constexpr double half_strip = 2e-4;
// The normals of a model lie this near to the base's whatever the tolerance.
constexpr double largest_slope_error = 1e-3;
constexpr double infinity = std::numeric_limits<double>::infinity();

//! From a bound x of |a - b| / |b| to one of the difference of the directions (Dunkl & Williams 1964).
double turn(double x) { return x < 1.0 ? 2.0 * x / (2.0 - x) : infinity; }

//! e_j + e_k + e_j e_k: of the product of two factors with relative errors.
double product(double a, double b) { return a + b + a * b; }

//! As an error of the model: a factor 1 + z on the base's curvature, |z| <= relative.
double inverse(double relative) { return relative < 1.0 ? relative / (1.0 - relative) : infinity; }

//! First by one model, then by another one of that.
ModelError chained(const ModelError &a, const ModelError &b)
{
    return {a.point + b.point, a.normal + b.normal, a.curvature + (1.0 + a.curvature_ratio) * b.curvature,
            product(a.curvature_ratio, b.curvature_ratio)};
}

//! A conic's size: the singular values of its linear part, and cosh at the far end of the range.
struct ConicSize
{
    double large = 0.0;
    double small = 0.0;
    double growth = 1.0;
};

ConicSize conic_size(const ConicFrame &conic, double low, double high)
{
    Eigen::Matrix<double, 3, 2> axes;
    axes << conic.x, conic.y;
    const Eigen::Vector2d s = axes.jacobiSvd().singularValues();
    const bool circle = conic.kind == ConicKind::Circle;
    return {s[0], s[1], circle ? 1.0 : std::cosh(std::max(std::abs(low), std::abs(high)))};
}

//! What the splines of a conic's functions should keep to.
ConicErrors conic_demand(const ConicSize &size, const ModelDemand &demand)
{
    const double room = aimed_share * demand.tolerance;
    const double roundness = size.small / size.large;
    return {0.25 * room / (size.large * size.growth),
            roundness * std::min(0.1 * curvature_share, 0.125 * room / std::max(1e-300, std::abs(demand.distance))),
            0.5 * curvature_share / (size.growth * size.growth)};
}

//! The error of a conic as a curve: its point, the turn of its tangent, the ratio of its curvature.
ModelError curve_error(const ConicSize &size, const ConicErrors &e, ConicKind kind)
{
    const double x = size.large / size.small * e.slope;
    const double bend = kind == ConicKind::Circle ? product(e.slope, e.bend)
                                                  : 2.0 * size.growth * size.growth * product(e.slope, e.bend);
    const double ratio = x < 1.0 ? (1.0 + bend) / std::pow(1.0 - x, 3) - 1.0 : infinity;
    return {size.large * size.growth * e.value, turn(x), 0.0, inverse(ratio)};
}

//! Widths of the shortest spans, for what a rounded pole does to derivatives.
double shortest_span(const KnotVector &kv)
{
    const std::vector<double> breaks = kv.breaks();
    double least = infinity;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        least = std::min(least, breaks[i + 1] - breaks[i]);
    return least;
}

//! Error of rounded poles: `rounding` [mm] each; slopes |S_u|, |S_v| at least `length_u`, `length_v`.
ModelError pole_rounding(const TensorSpline &spline, double rounding, double length_u, double length_v, double sine,
                         double size)
{
    const double u = 2.0 * spline.u.degree / shortest_span(spline.u);
    const double v = 2.0 * spline.v.degree / shortest_span(spline.v);
    const double tilt = rounding * (u / length_u + v / length_v) / sine;
    const double floor_u = std::max(length_u, least_length * size);
    const double bend = rounding * (std::pow(u / floor_u, 2) + std::pow(v / length_v, 2)) / (sine * sine);
    return {rounding, turn(tilt), 4.0 * bend, 0.0};
}

double weight_ratio(const ProfileSpline &profile)
{
    double low = infinity;
    double high = 0.0;
    for (const Eigen::Vector4d &p : profile.poles)
    {
        low = std::min(low, p.w());
        high = std::max(high, p.w());
    }
    return low > 0.0 ? high / low : infinity;
}

std::vector<SmoothnessBreak> profile_breaks(const ProfileSpline &profile)
{
    if (profile.conic)
        return {};
    return spline_breaks(profile.knots);
}

bool within(const ModelError &error, double curvature_scale, const ModelDemand &demand)
{
    return error.of_offset(demand.distance) <= largest_share * demand.tolerance &&
           error.curvature_ratio + error.curvature / curvature_scale <= largest_curvature_share;
}

//! A surface of revolution in the coordinates of its axis.
class Revolution
{
public:
    Revolution(const Geom_SurfaceOfRevolution &surface, const ParameterBox &box, const ModelDemand &demand)
        : m_box(box), m_demand(demand), m_origin(vector(surface.Axis().Location().XYZ())),
          m_z(vector(surface.Axis().Direction().XYZ())), m_curve(surface.BasisCurve())
    {
    }

    std::optional<SweptModel> model()
    {
        const auto wanted = [&](const ConicFrame &conic) {
            return conic_demand(conic_size(conic, m_box.vmin, m_box.vmax), m_demand);
        };
        std::optional<ProfileSpline> profile = profile_spline(m_curve, m_box.vmin, m_box.vmax, wanted);
        if (!profile || !to_axis(*profile))
            return std::nullopt;
        const std::optional<ProfileBounds> bounds = profile_bounds(*profile, m_planar);
        const std::optional<ModelError> of_profile = bounds ? profile_error(*profile, *bounds) : std::nullopt;
        if (!of_profile)
            return std::nullopt;
        const std::optional<ConicSpline> circle =
            conic_spline(ConicKind::Circle, m_box.umin, m_box.umax, circle_demand(*bounds));
        if (!circle)
            return std::nullopt;
        SweptModel result{product_spline(*circle, *profile), narrow_strip(*profile), {}, {}, profile_breaks(*profile)};
        const ModelError of_poles = pole_rounding(result.spline, pole_rounding_length(*profile), bounds->least_radius,
                                                  bounds->slowest, bounds->least_sine, bounds->largest_radius);
        result.error = chained(chained(*of_profile, turning_error(circle->errors, *bounds)),
                               chained(of_poles, strip_rounding(*bounds)));
        if (!within(result.error, 1.0 / bounds->largest_radius, m_demand))
            return std::nullopt;
        return result;
    }

private:
    //! Poles relative to the axis, x towards the farthest one. What lies in the plane or on the axis to
    //! rounding is put there exactly.
    bool to_axis(ProfileSpline &profile)
    {
        double farthest = 0.0;
        for (Eigen::Vector4d &pole : profile.poles)
        {
            pole.head<3>() -= pole.w() * m_origin;
            const Eigen::Vector3d p = pole.head<3>() / pole.w();
            const Eigen::Vector3d radial = p - p.dot(m_z) * m_z;
            m_size = std::max(m_size, p.norm());
            if (radial.norm() <= farthest)
                continue;
            farthest = radial.norm();
            m_x = radial.normalized();
        }
        m_size += m_origin.norm();
        if (!(farthest > in_plane * m_size))
            return false;
        m_y = m_z.cross(m_x);
        const Eigen::Matrix3d rows = (Eigen::Matrix3d() << m_x, m_y, m_z).finished().transpose();
        m_planar = true;
        for (Eigen::Vector4d &pole : profile.poles)
        {
            pole.head<3>() = (rows * pole.head<3>()).eval();
            m_planar = m_planar && std::abs(pole.y()) <= in_plane * m_size * pole.w();
        }
        for (Eigen::Vector4d &pole : profile.poles)
        {
            if (m_planar)
                put_to_zero(pole.y(), pole.w());
            if (m_planar && std::abs(pole.x()) <= in_plane * m_size * pole.w())
                put_to_zero(pole.x(), pole.w());
        }
        return true;
    }

    void put_to_zero(double &coordinate, double weight)
    {
        m_moved = std::max(m_moved, std::abs(coordinate) / weight);
        coordinate = 0.0;
    }

    [[nodiscard]] double pole_rounding_length(const ProfileSpline &profile) const
    {
        return (pole_roundings * epsilon * m_size + 2.0 * m_moved) * weight_ratio(profile);
    }

    [[nodiscard]] ConicErrors circle_demand(const ProfileBounds &bounds) const
    {
        const double room = aimed_share * m_demand.tolerance;
        const double slope = 0.2 * bounds.least_sine * room / std::max(1e-300, std::abs(m_demand.distance));
        return {std::min(slope, 0.25 * room / bounds.largest_radius), std::min(slope, largest_slope_error), infinity};
    }

    //! Of e0 and e1 (swept_model.h).
    [[nodiscard]] static ModelError turning_error(const ConicErrors &e, const ProfileBounds &bounds)
    {
        return {e.value * bounds.largest_radius, turn(product(e.value, e.slope) / bounds.least_sine), 0.0, 0.0};
    }

    //! e^(iu) about u = 0 by 1 + i u - u u / 2, which has the same derivatives there up to the second.
    [[nodiscard]] static CurvatureStrip narrow_strip(const ProfileSpline &profile)
    {
        CurvatureStrip strip;
        strip.width = strip.fineness = 2.0 * half_strip;
        strip.spline.u = clamped_knots(2, -half_strip, half_strip, {});
        strip.spline.v = profile.knots;
        strip.spline.rational = profile.rational;
        const double square = 0.5 * half_strip * half_strip;
        for (const std::complex<double> e :
             {std::complex<double>(1.0 - square, -half_strip), std::complex<double>(1.0 + square, 0.0),
              std::complex<double>(1.0 - square, half_strip)})
            for (const Eigen::Vector4d &p : profile.poles)
            {
                const std::complex<double> q = e * std::complex<double>(p.x(), p.y());
                strip.spline.poles.emplace_back(q.real(), q.imag(), p.z(), p.w());
            }
        return strip;
    }

    //! Rounding of the strip's poles in second derivatives along u.
    [[nodiscard]] ModelError strip_rounding(const ProfileBounds &bounds) const
    {
        const double relative = 64.0 * epsilon / (half_strip * half_strip);
        if (m_planar)
            return {0.0, 0.0, 0.0, relative};
        return {0.0, 0.0, relative / (bounds.least_radius * bounds.least_sine * bounds.least_sine), 0.0};
    }

    //! Of the true profile against its spline, both turned exactly.
    [[nodiscard]] std::optional<ModelError> profile_error(const ProfileSpline &profile,
                                                          const ProfileBounds &bounds) const
    {
        if (!profile.conic)
            return ModelError{};
        if (!m_planar)
            return std::nullopt;
        const ConicFrame &conic = *profile.conic;
        const ConicSize size = conic_size(conic, m_box.vmin, m_box.vmax);
        ModelError error = curve_error(size, profile.errors, conic.kind);
        const std::optional<double> parallel = ratio_at_pole(conic, profile.errors, size);
        if (parallel)
            error.curvature_ratio = std::max(error.curvature_ratio, *parallel);
        else if (bounds.touches_axis || !(bounds.least_radius > error.point))
            return std::nullopt;
        else
        {
            const double radius = bounds.least_radius - error.point;
            error.curvature = (error.normal + error.point / radius) / radius;
        }
        return error;
    }

    //! The relative error of N_r / r where r = a E_k and the axis is an axis of the conic, which ends at r = 0 or
    //! before: splines and functions agree there in value and slope.
    [[nodiscard]] std::optional<double> ratio_at_pole(const ConicFrame &conic, const ConicErrors &e,
                                                      const ConicSize &size) const
    {
        const Eigen::Vector3d centre = conic.centre - m_origin;
        const bool x_along = conic.x.cross(m_z).norm() <= in_plane * conic.x.norm();
        const bool y_along = conic.y.cross(m_z).norm() <= in_plane * conic.y.norm();
        const bool circle = conic.kind == ConicKind::Circle;
        if (centre.cross(m_z).norm() > in_plane * m_size || !(x_along || (y_along && circle)))
            return std::nullopt;
        const double first_zero = x_along ? 0.0 : 0.5 * M_PI; // of sin and sinh, or of cos
        const double slack = 8.0 * epsilon * std::max({1.0, std::abs(m_box.vmin), std::abs(m_box.vmax)});
        const double k = circle ? std::ceil((m_box.vmin + slack - first_zero) / M_PI) : 0.0;
        const double zero = first_zero + k * M_PI;
        if (zero > m_box.vmin + slack && zero < m_box.vmax - slack)
            return std::nullopt;
        // |sin t| >= 2 t / pi up to a quarter turn, |sinh t| >= t
        const double steepness = circle ? 0.5 * M_PI : size.growth;
        const double x = size.large / size.small * e.slope;
        if (!(steepness * e.slope < 1.0 && x < 1.0))
            return std::nullopt;
        return inverse((1.0 + steepness * e.bend) / ((1.0 - steepness * e.slope) * (1.0 - x)) - 1.0);
    }

    [[nodiscard]] TensorSpline product_spline(const ConicSpline &circle, const ProfileSpline &profile) const
    {
        TensorSpline spline;
        spline.u = circle.knots;
        spline.v = profile.knots;
        spline.rational = profile.rational;
        for (const Eigen::Vector2d &e : circle.poles)
            for (const Eigen::Vector4d &p : profile.poles)
            {
                const std::complex<double> q = std::complex<double>(e.x(), e.y()) * std::complex<double>(p.x(), p.y());
                const Eigen::Vector3d turned = p.w() * m_origin + q.real() * m_x + q.imag() * m_y + p.z() * m_z;
                spline.poles.emplace_back(turned.x(), turned.y(), turned.z(), p.w());
            }
        return spline;
    }

    ParameterBox m_box;
    ModelDemand m_demand;
    Eigen::Vector3d m_origin, m_x, m_y, m_z;
    Handle(Geom_Curve) m_curve;
    bool m_planar = true;
    double m_size = 0.0;  //!< largest coordinate that is rounded [mm]
    double m_moved = 0.0; //!< farthest that a pole was moved into the plane or onto the axis [mm]
};

//! Curvature and normal of an extrusion are those of its profile as seen along the direction.
class Extrusion
{
public:
    Extrusion(const Geom_SurfaceOfLinearExtrusion &surface, const ParameterBox &box, const ModelDemand &demand)
        : m_box(box), m_demand(demand), m_direction(vector(surface.Direction().XYZ())), m_curve(surface.BasisCurve())
    {
    }

    std::optional<SweptModel> model()
    {
        const auto wanted = [&](const ConicFrame &conic) {
            ConicSize size = seen_size(conic);
            size.large = std::max(size.large, conic_size(conic, m_box.umin, m_box.umax).large);
            return conic_demand(size, m_demand);
        };
        const std::optional<ProfileSpline> profile = profile_spline(m_curve, m_box.umin, m_box.umax, wanted);
        // splines are read as they are (base_surface.h)
        if (!profile || (!profile->conic && profile->knots.breaks().size() > 2))
            return std::nullopt;
        SweptModel result;
        const double size = extrude(*profile, result.spline);
        const double slowest = least_speed(*profile);
        if (!(slowest > 0.0))
            return std::nullopt;
        result.error = chained(profile_error(*profile),
                               pole_rounding(result.spline, pole_roundings * epsilon * size, slowest, 1.0, 1.0, size));
        if (!within(result.error, 1.0 / size, m_demand))
            return std::nullopt;
        result.strip = {result.spline, true, 0.5 * (m_box.vmin + m_box.vmax), m_box.vmax - m_box.vmin};
        return result;
    }

private:
    [[nodiscard]] Eigen::Vector3d across(const Eigen::Vector3d &a) const
    {
        return a - a.dot(m_direction) * m_direction;
    }

    [[nodiscard]] ConicSize seen_size(const ConicFrame &conic) const
    {
        return conic_size({conic.kind, conic.centre, across(conic.x), across(conic.y)}, m_box.umin, m_box.umax);
    }

    //! \return the largest coordinate that is rounded [mm].
    double extrude(const ProfileSpline &profile, TensorSpline &spline) const
    {
        spline.u = profile.knots;
        spline.v = clamped_knots(1, m_box.vmin, m_box.vmax, {});
        double size = 0.0;
        for (const Eigen::Vector4d &p : profile.poles)
            for (const double v : {m_box.vmin, m_box.vmax})
            {
                const Eigen::Vector3d point = p.head<3>() + v * m_direction;
                size = std::max({size, point.norm(), std::abs(v)});
                spline.poles.emplace_back(point.x(), point.y(), point.z(), 1.0);
            }
        return size;
    }

    //! Lower bound of |C'| as seen along the direction: |L E'|, or |a + t b| of a line or parabola.
    [[nodiscard]] double least_speed(const ProfileSpline &profile) const
    {
        if (profile.conic)
            return 0.5 * seen_size(*profile.conic).small; // the spline of a conic is this near to it
        const Eigen::Vector3d a = across(vector(m_curve->DN(m_box.umin, 1).XYZ()));
        const Eigen::Vector3d b = across(vector(m_curve->DN(m_box.umin, 2).XYZ()));
        const double t =
            b.squaredNorm() > 0.0 ? std::clamp(-a.dot(b) / b.squaredNorm(), 0.0, m_box.umax - m_box.umin) : 0.0;
        return (a + t * b).norm();
    }

    [[nodiscard]] ModelError profile_error(const ProfileSpline &profile) const
    {
        if (!profile.conic)
            return {};
        ModelError error = curve_error(seen_size(*profile.conic), profile.errors, profile.conic->kind);
        const ConicSize whole = conic_size(*profile.conic, m_box.umin, m_box.umax);
        error.point = whole.large * whole.growth * profile.errors.value;
        return error;
    }

    ParameterBox m_box;
    ModelDemand m_demand;
    Eigen::Vector3d m_direction;
    Handle(Geom_Curve) m_curve;
};

} // namespace

std::optional<SweptModel> swept_model(const Handle(Geom_Surface) & surface, const ParameterBox &box,
                                      const ModelDemand &demand)
{
    if (!(box.umin < box.umax && box.vmin < box.vmax))
        return std::nullopt;
    if (const auto revolution = Handle(Geom_SurfaceOfRevolution)::DownCast(surface))
        return Revolution(*revolution, box, demand).model();
    if (const auto extrusion = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface))
        return Extrusion(*extrusion, box, demand).model();
    return std::nullopt;
}

} // namespace laminate_offset
