// SPDX-License-Identifier: LGPL-2.1-or-later
#include "light_model.h"

#include "curvature.h"

#include "../spline/data_reduction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace laminate_offset
{
namespace
{

// With fewer spans the base itself is as cheap.
constexpr std::size_t least_spans = 100;
// Parts of the tolerance that point and normal of the model may use up: a few percent cost no poles; where that
// leaves too many knots, a quarter still pays, because the base has many more poles than its offset will need.
constexpr double tolerance_shares[] = {0.04, 0.25};
// The search for a model starts with this part of its share for the points.
constexpr double first_part = 0.5;
// The model's principal curvatures agree with the base's largest to this, or to this part of a flat face's.
constexpr double curvature_share = 5e-3;
constexpr double flat_curvature = 1e-2;
constexpr int most_rounds = 4;
// Blocks of spans in each direction over which bounds are taken.
constexpr std::size_t most_blocks = 24;
// Angle of the normals (its sine) up to which asin x <= 1.01 x.
constexpr double small_angle = 0.1;
constexpr double small_angle_factor = 1.01;

//! Poles of a spline or one of its derivatives. Each may be wrong by rounding * rise_u * rise_v in each coordinate.
struct Net
{
    KnotVector u;
    KnotVector v;
    std::vector<Eigen::Vector3d> poles;
    std::vector<double> rise_u;
    std::vector<double> rise_v;

    [[nodiscard]] const Eigen::Vector3d &pole(std::size_t i, std::size_t j) const
    {
        return poles[i * rise_v.size() + j];
    }
};

Net net_of(const KnotVector &u, const KnotVector &v, std::vector<Eigen::Vector3d> poles)
{
    return {u, v, std::move(poles), std::vector<double>(static_cast<std::size_t>(u.pole_count()), 1.0),
            std::vector<double>(static_cast<std::size_t>(v.pole_count()), 1.0)};
}

//! Factors degree / (t_{i+p+1} - t_{i+1}) of the derivative's poles; 0 where a pole has no support.
std::vector<double> derivative_factors(const KnotVector &kv)
{
    std::vector<double> factors;
    for (int i = 0; i + 1 < kv.pole_count(); ++i)
    {
        const double support =
            kv.knots[static_cast<std::size_t>(i + kv.degree + 1)] - kv.knots[static_cast<std::size_t>(i) + 1];
        factors.push_back(support > 0.0 ? kv.degree / support : 0.0);
    }
    return factors;
}

KnotVector derivative_knots(const KnotVector &kv)
{
    return {kv.degree - 1, {kv.knots.begin() + 1, kv.knots.end() - 1}};
}

std::vector<double> derivative_rise(const std::vector<double> &factors, const std::vector<double> &rise)
{
    std::vector<double> result;
    for (std::size_t i = 0; i < factors.size(); ++i)
        result.push_back(factors[i] * (rise[i] + rise[i + 1]));
    return result;
}

Net derivative_u(const Net &net)
{
    const std::vector<double> factors = derivative_factors(net.u);
    Net result{derivative_knots(net.u), net.v, {}, derivative_rise(factors, net.rise_u), net.rise_v};
    result.poles.reserve(factors.size() * net.rise_v.size());
    for (std::size_t i = 0; i < factors.size(); ++i)
        for (std::size_t j = 0; j < net.rise_v.size(); ++j)
            result.poles.emplace_back(factors[i] * (net.pole(i + 1, j) - net.pole(i, j)));
    return result;
}

Net derivative_v(const Net &net)
{
    const std::vector<double> factors = derivative_factors(net.v);
    Net result{net.u, derivative_knots(net.v), {}, net.rise_u, derivative_rise(factors, net.rise_v)};
    result.poles.reserve(factors.size() * net.rise_u.size());
    for (std::size_t i = 0; i < net.rise_u.size(); ++i)
        for (std::size_t j = 0; j < factors.size(); ++j)
            result.poles.emplace_back(factors[j] * (net.pole(i, j + 1) - net.pole(i, j)));
    return result;
}

//! First and second derivatives.
struct Derivatives
{
    explicit Derivatives(const Net &net)
        : u(derivative_u(net)), v(derivative_v(net)), uu(derivative_u(u)), uv(derivative_v(u)), vv(derivative_v(v))
    {
    }

    Net u, v, uu, uv, vv;
};

struct IndexRange
{
    std::size_t first = 0;
    std::size_t last = 0; //!< inclusive
};

//! Poles whose basis functions do not vanish between two breaks.
IndexRange active(const KnotVector &kv, double low, double high)
{
    const auto past = std::lower_bound(kv.knots.begin(), kv.knots.end(), high) - kv.knots.begin();
    return {static_cast<std::size_t>(kv.span(low) - kv.degree), static_cast<std::size_t>(past - 1)};
}

template <typename Visit> void visit_active(const Net &net, const ParameterBox &box, const Visit &visit)
{
    const IndexRange us = active(net.u, box.umin, box.umax);
    const IndexRange vs = active(net.v, box.vmin, box.vmax);
    for (std::size_t i = us.first; i <= us.last; ++i)
        for (std::size_t j = vs.first; j <= vs.last; ++j)
            visit(i, j);
}

//! The values of a first derivative over a block: inside a cone, and between two lengths. Convex combinations of
//! the poles as they are, the values keep what the poles keep.
struct Cone
{
    Eigen::Vector3d axis = Eigen::Vector3d::Zero(); //!< mean of the poles
    double angle = 0.0;                             //!< [rad]; above a right angle the cone says nothing
    double shortest = 0.0;
    double longest = 0.0;
};

Cone cone_over(const Net &net, const ParameterBox &box)
{
    Cone cone;
    double count = 0.0;
    visit_active(net, box, [&](std::size_t i, std::size_t j) {
        cone.axis += net.pole(i, j);
        count += 1.0;
    });
    cone.axis /= count;
    const Eigen::Vector3d direction = cone.axis.normalized();
    cone.shortest = cone.axis.norm();
    visit_active(net, box, [&](std::size_t i, std::size_t j) {
        const Eigen::Vector3d &pole = net.pole(i, j);
        cone.angle = std::max(cone.angle, std::atan2(pole.cross(direction).norm(), pole.dot(direction)));
        cone.shortest = std::min(cone.shortest, pole.dot(direction));
        cone.longest = std::max(cone.longest, pole.norm());
    });
    return cone;
}

//! Least sine of the angle between a vector of one cone and one of the other; 0 where they may be parallel.
double least_sine(const Cone &a, const Cone &b)
{
    const double between = std::atan2(a.axis.cross(b.axis).norm(), a.axis.dot(b.axis));
    const double low = between - a.angle - b.angle;
    const double high = between + a.angle + b.angle;
    return low > 0.0 && high < M_PI ? std::min(std::sin(low), std::sin(high)) : 0.0;
}

Eigen::Vector3d mean_over(const Net &net, const ParameterBox &box)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double count = 0.0;
    visit_active(net, box, [&](std::size_t i, std::size_t j) {
        sum += net.pole(i, j);
        count += 1.0;
    });
    return sum / count;
}

//! Longest value over a block, the rounding of the poles included.
double longest_over(const Net &net, double rounding, const ParameterBox &box)
{
    double square = 0.0;
    double rise = 0.0;
    visit_active(net, box, [&](std::size_t i, std::size_t j) {
        square = std::max(square, net.pole(i, j).squaredNorm());
        rise = std::max(rise, net.rise_u[i] * net.rise_v[j]);
    });
    return std::sqrt(square) + std::sqrt(3.0) * rounding * rise;
}

std::vector<double> block_ends(const std::vector<double> &breaks)
{
    const std::size_t spans = breaks.size() - 1;
    const std::size_t blocks = std::min(most_blocks, spans);
    std::vector<double> ends;
    for (std::size_t b = 0; b <= blocks; ++b)
        ends.push_back(breaks[b * spans / blocks]);
    return ends;
}

//! The model's error over blocks of the base; infinite where a block may hold a place without a normal.
class ErrorBound
{
public:
    ErrorBound(const TensorSpline &base, const Derivatives &derivatives, const ReducedSpline &model)
        : m_derivatives(derivatives), m_change(net_of(base.u, base.v, model.change)), m_rounding(model.rounding)
    {
        m_error.point = model.largest;
        const std::vector<double> us = block_ends(base.u.breaks());
        const std::vector<double> vs = block_ends(base.v.breaks());
        for (std::size_t i = 0; i + 1 < us.size(); ++i)
            for (std::size_t j = 0; j + 1 < vs.size(); ++j)
                add_block({us[i], us[i + 1], vs[j], vs[j + 1]});
    }

    [[nodiscard]] const ModelError &error() const { return m_error; }
    //! The largest curvature at the blocks' centres [1/mm].
    [[nodiscard]] double typical_curvature() const { return m_curvature; }

private:
    void add_block(const ParameterBox &box)
    {
        const Cone u = cone_over(m_derivatives.u, box);
        const Cone v = cone_over(m_derivatives.v, box);
        const double sine = least_sine(u, v);
        const double du = change(m_change.u, box) / u.shortest;
        const double dv = change(m_change.v, box) / v.shortest;
        const double turn = (du + dv + du * dv) / sine;
        const double stretch = (du + dv) / sine;
        if (!(sine > 0.0 && u.shortest > 0.0 && v.shortest > 0.0) || !(turn <= small_angle))
        {
            m_error.normal = m_error.curvature = std::numeric_limits<double>::infinity();
            return;
        }
        const double normal = small_angle_factor * turn;
        m_error.normal = std::max(m_error.normal, normal);
        const double uu = longest_over(m_derivatives.uu, 0.0, box);
        const double uv = longest_over(m_derivatives.uv, 0.0, box);
        const double vv = longest_over(m_derivatives.vv, 0.0, box);
        const auto over_directions = [&](double xx, double xy, double yy) {
            return (xx / (u.shortest * u.shortest) + 2.0 * xy / (u.shortest * v.shortest) +
                    yy / (v.shortest * v.shortest)) /
                   (sine * sine);
        };
        const double form =
            over_directions(change(m_change.uu, box) + uu * normal, change(m_change.uv, box) + uv * normal,
                            change(m_change.vv, box) + vv * normal);
        const double curvature =
            (form + 2.0 * stretch * over_directions(uu, uv, vv)) / ((1.0 - stretch) * (1.0 - stretch));
        m_error.curvature = std::max(m_error.curvature, small_angle_factor * curvature);
        note_curvature(u, v, box);
    }

    [[nodiscard]] double change(const Net &net, const ParameterBox &box) const
    {
        return longest_over(net, m_rounding, box);
    }

    void note_curvature(const Cone &u, const Cone &v, const ParameterBox &box)
    {
        const SurfaceJet jet{Eigen::Vector3d::Zero(),
                             u.axis,
                             v.axis,
                             mean_over(m_derivatives.uu, box),
                             mean_over(m_derivatives.uv, box),
                             mean_over(m_derivatives.vv, box)};
        if (const auto k = principal_curvatures(jet))
            m_curvature = std::max({m_curvature, std::abs(k->first), std::abs(k->second)});
    }

    const Derivatives &m_derivatives;
    Derivatives m_change;
    double m_rounding;
    ModelError m_error;
    double m_curvature = 0.0;
};

std::vector<Eigen::Vector3d> points_of(const TensorSpline &spline)
{
    std::vector<Eigen::Vector3d> points;
    points.reserve(spline.poles.size());
    for (const Eigen::Vector4d &pole : spline.poles)
        points.emplace_back(pole.head<3>());
    return points;
}

double extent(const TensorSpline &spline)
{
    Eigen::AlignedBox3d hull;
    for (const Eigen::Vector4d &pole : spline.poles)
        hull.extend(Eigen::Vector3d(pole.head<3>()));
    return hull.sizes().norm();
}

class ModelSearch
{
public:
    ModelSearch(const TensorSpline &base, double distance)
        : m_base(base), m_distance(std::abs(distance)), m_derivatives(net_of(base.u, base.v, points_of(base))),
          m_flat(flat_curvature / extent(base))
    {
    }

    //! \param allowance [mm] that the model's point and normal errors may add to the offset's.
    [[nodiscard]] std::optional<LightModel> within(double allowance) const
    {
        double goal = first_part * allowance;
        for (int round = 0; round < most_rounds; ++round)
        {
            std::optional<ReducedSpline> model = reduced(m_base, goal);
            if (!model)
                return std::nullopt;
            const ErrorBound bound(m_base, m_derivatives, *model);
            const ModelError &error = bound.error();
            const double room =
                std::min(allowance / error.of_offset(m_distance),
                         curvature_share * std::max(m_flat, bound.typical_curvature()) / error.curvature);
            if (room >= 1.0)
                return LightModel{std::move(model->spline), error};
            if (!std::isfinite(error.normal))
                return std::nullopt;
            goal *= std::clamp(0.8 * room, 1e-3, 0.8);
        }
        return std::nullopt;
    }

private:
    const TensorSpline &m_base;
    double m_distance;
    Derivatives m_derivatives;
    double m_flat;
};

} // namespace

std::optional<LightModel> light_model(const TensorSpline &base, double distance, double tolerance)
{
    const std::size_t spans = (base.u.breaks().size() - 1) * (base.v.breaks().size() - 1);
    if (base.rational || spans < least_spans || base.u.degree < 2 || base.v.degree < 2)
        return std::nullopt;
    const ModelSearch search(base, distance);
    for (const double share : tolerance_shares)
        if (std::optional<LightModel> model = search.within(share * tolerance))
            return model;
    return std::nullopt;
}

} // namespace laminate_offset
