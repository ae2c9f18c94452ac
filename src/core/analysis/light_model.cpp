// SPDX-License-Identifier: LGPL-2.1-or-later
#include "light_model.h"

#include "curvature.h"

#include "../spline/data_reduction.h"
#include "../spline/undo_rounding.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

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
// Part of the base's spans that a model without curvatures may have.
constexpr double much_lighter_share = 0.35;
// Blocks of spans in each direction over which bounds are taken; more where the other direction has fewer spans.
constexpr std::size_t even_blocks = 24;
// Angle of the normals (its sine) up to which asin x <= 1.01 x.
constexpr double small_angle = 0.1;
constexpr double small_angle_factor = 1.01;

//! One number for every pole, or for every block.
using Grid = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct IndexRange
{
    Eigen::Index first = 0;
    Eigen::Index last = 0; //!< inclusive
};

//! One direction of a spline: what its derivatives and its blocks need of the knots.
class Direction
{
public:
    Direction(const KnotVector &kv, std::size_t most_blocks) : m_poles(kv.pole_count())
    {
        m_factors.push_back(factors(kv, 0));
        m_factors.push_back(factors(kv, 1));
        const std::vector<double> breaks = kv.breaks();
        const std::size_t spans = breaks.size() - 1;
        const std::size_t blocks = std::min(most_blocks, spans);
        for (std::size_t b = 0; b < blocks; ++b)
        {
            const double high = breaks[(b + 1) * spans / blocks];
            const auto past = std::lower_bound(kv.knots.begin(), kv.knots.end(), high) - kv.knots.begin();
            m_ranges.push_back({kv.span(breaks[b * spans / blocks]) - kv.degree, past - 1});
        }
    }

    [[nodiscard]] Eigen::Index poles() const { return m_poles; }
    [[nodiscard]] Eigen::Index blocks() const { return static_cast<Eigen::Index>(m_ranges.size()); }

    //! The differences of the poles of a derivative of this order times these are the poles of the next one.
    [[nodiscard]] const Eigen::ArrayXd &factors(int order) const { return m_factors[static_cast<std::size_t>(order)]; }

    //! Poles of the derivative of this order whose basis functions do not vanish on a block. Above the degree all are 0,
    //! and any will do.
    [[nodiscard]] IndexRange active(Eigen::Index block, int order) const
    {
        const IndexRange &range = m_ranges[static_cast<std::size_t>(block)];
        const Eigen::Index first = std::min(range.first, m_poles - order - 1);
        return {first, std::max(first, range.last - order)};
    }

private:
    //! degree / (t_{i+p+1} - t_{i+1}) over the derivative's own knots; 0 where a pole has no support.
    static Eigen::ArrayXd factors(const KnotVector &kv, int order)
    {
        const int degree = kv.degree - order;
        Eigen::ArrayXd result(kv.pole_count() - order - 1);
        for (Eigen::Index i = 0; i < result.size(); ++i)
        {
            const auto at = [&](Eigen::Index k) { return kv.knots[static_cast<std::size_t>(k + order)]; };
            const double support = at(i + degree + 1) - at(i + 1);
            result[i] = support > 0.0 ? degree / support : 0.0;
        }
        return result;
    }

    Eigen::Index m_poles;
    std::vector<Eigen::ArrayXd> m_factors;
    std::vector<IndexRange> m_ranges;
};

//! Poles of a spline or one of its derivatives. Each may be wrong by rounding * rise_u * rise_v in each coordinate.
struct Net
{
    std::array<Grid, 3> xyz;
    Eigen::ArrayXd rise_u;
    Eigen::ArrayXd rise_v;
    int order_u = 0;
    int order_v = 0;
};

Eigen::ArrayXd derivative_rise(const Eigen::ArrayXd &factors, const Eigen::ArrayXd &rise)
{
    return factors * (rise.head(factors.size()) + rise.tail(factors.size()));
}

Net derivative_u(const Net &net, const Direction &along)
{
    const Eigen::ArrayXd &factors = along.factors(net.order_u);
    Net result{{}, derivative_rise(factors, net.rise_u), net.rise_v, net.order_u + 1, net.order_v};
    for (std::size_t e = 0; e < 3; ++e)
        result.xyz[e] =
            (net.xyz[e].bottomRows(factors.size()) - net.xyz[e].topRows(factors.size())).colwise() * factors;
    return result;
}

Net derivative_v(const Net &net, const Direction &along)
{
    const Eigen::ArrayXd &factors = along.factors(net.order_v);
    Net result{{}, net.rise_u, derivative_rise(factors, net.rise_v), net.order_u, net.order_v + 1};
    for (std::size_t e = 0; e < 3; ++e)
        result.xyz[e] = (net.xyz[e].rightCols(factors.size()) - net.xyz[e].leftCols(factors.size())).rowwise() *
                        factors.transpose();
    return result;
}

//! The blocks of a spline, over which the poles of its derivatives are joined: largest, least, sum.
class Blocks
{
public:
    explicit Blocks(const TensorSpline &spline)
        : m_u(spline.u, most_blocks_beside(spline.v)), m_v(spline.v, most_blocks_beside(spline.u))
    {
    }

    [[nodiscard]] const Direction &u() const { return m_u; }
    [[nodiscard]] const Direction &v() const { return m_v; }

    //! `join` of a figure of a net's poles over every block, first along one direction, then along the other.
    template <typename Join> [[nodiscard]] Grid joined(const Net &net, const Grid &figures, const Join &join) const
    {
        Grid result(m_u.blocks(), m_v.blocks());
        std::vector<double> row(static_cast<std::size_t>(figures.cols()));
        for (Eigen::Index b = 0; b < m_u.blocks(); ++b)
        {
            const IndexRange us = m_u.active(b, net.order_u);
            std::copy_n(figures.row(us.first).data(), row.size(), row.data());
            for (Eigen::Index i = us.first + 1; i <= us.last; ++i)
                std::transform(row.begin(), row.end(), figures.row(i).data(), row.begin(), join);
            for (Eigen::Index c = 0; c < m_v.blocks(); ++c)
            {
                const IndexRange vs = m_v.active(c, net.order_v);
                result(b, c) = std::accumulate(row.begin() + vs.first + 1, row.begin() + vs.last + 1,
                                               row[static_cast<std::size_t>(vs.first)], join);
            }
        }
        return result;
    }

    [[nodiscard]] Grid largest(const Net &net, const Grid &figures) const
    {
        return joined(net, figures, [](double a, double b) { return a < b ? b : a; });
    }

    //! Mean of the poles, a grid for each coordinate.
    [[nodiscard]] std::array<Grid, 3> means(const Net &net) const
    {
        std::array<Grid, 3> result;
        for (std::size_t e = 0; e < 3; ++e)
            result[e] = joined(net, net.xyz[e], std::plus<>());
        for (Eigen::Index b = 0; b < m_u.blocks(); ++b)
            for (Eigen::Index c = 0; c < m_v.blocks(); ++c)
            {
                const IndexRange us = m_u.active(b, net.order_u);
                const IndexRange vs = m_v.active(c, net.order_v);
                const double count = static_cast<double>((us.last - us.first + 1) * (vs.last - vs.first + 1));
                for (Grid &grid : result)
                    grid(b, c) /= count;
            }
        return result;
    }

    //! Longest values, the rounding of the poles included.
    [[nodiscard]] Grid longest(const Net &net, double rounding) const
    {
        Grid result = largest(net, net.xyz[0].square() + net.xyz[1].square() + net.xyz[2].square()).sqrt();
        for (Eigen::Index b = 0; b < result.rows(); ++b)
            for (Eigen::Index c = 0; c < result.cols() && rounding > 0.0; ++c)
                result(b, c) += std::sqrt(3.0) * rounding * largest(net.rise_u, m_u.active(b, net.order_u)) *
                                largest(net.rise_v, m_v.active(c, net.order_v));
        return result;
    }

private:
    //! As many as leave even_blocks^2 in all.
    static std::size_t most_blocks_beside(const KnotVector &other)
    {
        return even_blocks * even_blocks / std::min(even_blocks, other.breaks().size() - 1);
    }

    static double largest(const Eigen::ArrayXd &values, const IndexRange &range)
    {
        return values.segment(range.first, range.last - range.first + 1).maxCoeff();
    }

    Direction m_u;
    Direction m_v;
};

//! Longest first and second derivatives over every block.
struct Lengths
{
    Grid u, v, uu, uv, vv;
};

//! The values of a first derivative over a block: inside a cone, and longer than the least component along its axis.
//! Convex combinations of the poles as they are, the values keep what the poles keep.
struct Cone
{
    Eigen::Vector3d axis = Eigen::Vector3d::Zero(); //!< mean of the poles
    double angle = 0.0;                             //!< [rad]; a right angle where the cone says nothing
    double shortest = 0.0;                          //!< not positive where the derivative may vanish
};

Cone cone_about(const Eigen::Vector3d &axis, const Net &net, const IndexRange &us, const IndexRange &vs)
{
    Cone cone{axis, 0.0, axis.norm()};
    const Eigen::Vector3d direction = axis.normalized();
    double square = 0.0; // of the largest tangent of the angle
    for (Eigen::Index i = us.first; i <= us.last; ++i)
        for (Eigen::Index j = vs.first; j <= vs.last; ++j)
        {
            const Eigen::Vector3d pole(net.xyz[0](i, j), net.xyz[1](i, j), net.xyz[2](i, j));
            const double along = pole.dot(direction);
            cone.shortest = std::min(cone.shortest, along);
            square = std::max(square, pole.cross(direction).squaredNorm() / (along * along));
        }
    cone.angle = cone.shortest > 0.0 ? std::atan(std::sqrt(square)) : M_PI_2;
    return cone;
}

std::vector<Cone> cones(const Blocks &blocks, const Net &net)
{
    const std::array<Grid, 3> mean = blocks.means(net);
    std::vector<Cone> result;
    for (Eigen::Index b = 0; b < blocks.u().blocks(); ++b)
        for (Eigen::Index c = 0; c < blocks.v().blocks(); ++c)
            result.push_back(cone_about({mean[0](b, c), mean[1](b, c), mean[2](b, c)}, net,
                                        blocks.u().active(b, net.order_u), blocks.v().active(c, net.order_v)));
    return result;
}

//! Least sine of the angle between a vector of one cone and one of the other; 0 where they may be parallel.
double least_sine(const Cone &a, const Cone &b)
{
    const double between = std::atan2(a.axis.cross(b.axis).norm(), a.axis.dot(b.axis));
    const double low = between - a.angle - b.angle;
    const double high = between + a.angle + b.angle;
    return low > 0.0 && high < M_PI ? std::min(std::sin(low), std::sin(high)) : 0.0;
}

//! What every model of one base is held against.
class BaseBounds
{
public:
    explicit BaseBounds(const TensorSpline &base) : m_blocks(base)
    {
        const Net net = net_of(base.poles);
        const Net u = derivative_u(net, m_blocks.u());
        const Net v = derivative_v(net, m_blocks.v());
        const Net uu = derivative_u(u, m_blocks.u());
        const Net uv = derivative_v(u, m_blocks.v());
        const Net vv = derivative_v(v, m_blocks.v());
        m_cones_u = cones(m_blocks, u);
        m_cones_v = cones(m_blocks, v);
        for (std::size_t k = 0; k < m_cones_u.size(); ++k)
        {
            const bool regular = m_cones_u[k].shortest > 0.0 && m_cones_v[k].shortest > 0.0;
            m_sines.push_back(regular ? least_sine(m_cones_u[k], m_cones_v[k]) : 0.0);
        }
        m_second = {{}, {}, m_blocks.longest(uu, 0.0), m_blocks.longest(uv, 0.0), m_blocks.longest(vv, 0.0)};
        note_curvature(uu, uv, vv);
    }

    //! The model's error, of a base that has normals; infinite where the model may turn them by more than a small angle.
    [[nodiscard]] ModelError error(const ReducedSpline &model) const
    {
        const Lengths change = changes(model);
        ModelError error;
        error.point = model.largest;
        for (Eigen::Index k = 0; k < change.u.size() && std::isfinite(error.normal); ++k)
            add_block(k, change, error);
        return error;
    }

    //! Does every block certainly have normals? Else no model of this base can be held against it.
    [[nodiscard]] bool has_normals() const
    {
        return std::all_of(m_sines.begin(), m_sines.end(), [](double sine) { return sine > 0.0; });
    }

    //! The largest curvature at the blocks' centres [1/mm].
    [[nodiscard]] double typical_curvature() const { return m_curvature; }

private:
    template <typename Points> [[nodiscard]] Net net_of(const Points &points) const
    {
        const Eigen::Index nu = m_blocks.u().poles();
        const Eigen::Index nv = m_blocks.v().poles();
        Net net{{Grid(nu, nv), Grid(nu, nv), Grid(nu, nv)}, Eigen::ArrayXd::Ones(nu), Eigen::ArrayXd::Ones(nv), 0, 0};
        for (Eigen::Index k = 0; k < nu * nv; ++k)
            for (std::size_t e = 0; e < 3; ++e)
                net.xyz[e].data()[k] = points[static_cast<std::size_t>(k)][static_cast<Eigen::Index>(e)];
        return net;
    }

    [[nodiscard]] Lengths changes(const ReducedSpline &model) const
    {
        const Net net = net_of(model.change);
        const Net u = derivative_u(net, m_blocks.u());
        const Net v = derivative_v(net, m_blocks.v());
        const auto longest = [&](const Net &derivative) { return m_blocks.longest(derivative, model.rounding); };
        return {longest(u), longest(v), longest(derivative_u(u, m_blocks.u())), longest(derivative_v(u, m_blocks.v())),
                longest(derivative_v(v, m_blocks.v()))};
    }

    void add_block(Eigen::Index k, const Lengths &change, ModelError &error) const
    {
        const auto of = [k](const Grid &grid) { return grid.data()[k]; };
        const Cone &u = m_cones_u[static_cast<std::size_t>(k)];
        const Cone &v = m_cones_v[static_cast<std::size_t>(k)];
        const double sine = m_sines[static_cast<std::size_t>(k)];
        const double du = of(change.u) / u.shortest;
        const double dv = of(change.v) / v.shortest;
        const double turn = (du + dv + du * dv) / sine;
        const double stretch = (du + dv) / sine;
        if (!(turn <= small_angle))
        {
            error.normal = error.curvature = std::numeric_limits<double>::infinity();
            return;
        }
        const double normal = small_angle_factor * turn;
        error.normal = std::max(error.normal, normal);
        const auto over_directions = [&](double xx, double xy, double yy) {
            return (xx / (u.shortest * u.shortest) + 2.0 * xy / (u.shortest * v.shortest) +
                    yy / (v.shortest * v.shortest)) /
                   (sine * sine);
        };
        const double uu = of(m_second.uu);
        const double uv = of(m_second.uv);
        const double vv = of(m_second.vv);
        const double form =
            over_directions(of(change.uu) + uu * normal, of(change.uv) + uv * normal, of(change.vv) + vv * normal);
        const double curvature =
            (form + 2.0 * stretch * over_directions(uu, uv, vv)) / ((1.0 - stretch) * (1.0 - stretch));
        error.curvature = std::max(error.curvature, small_angle_factor * curvature);
    }

    void note_curvature(const Net &uu, const Net &uv, const Net &vv)
    {
        const std::array<std::array<Grid, 3>, 3> second{m_blocks.means(uu), m_blocks.means(uv), m_blocks.means(vv)};
        for (std::size_t k = 0; k < m_cones_u.size(); ++k)
        {
            const auto mean = [&](std::size_t which) -> Eigen::Vector3d {
                return {second[which][0].data()[k], second[which][1].data()[k], second[which][2].data()[k]};
            };
            const SurfaceJet jet{
                Eigen::Vector3d::Zero(), m_cones_u[k].axis, m_cones_v[k].axis, mean(0), mean(1), mean(2)};
            if (const auto curvatures = principal_curvatures(jet))
                m_curvature = std::max({m_curvature, std::abs(curvatures->first), std::abs(curvatures->second)});
        }
    }

    Blocks m_blocks;
    std::vector<Cone> m_cones_u;
    std::vector<Cone> m_cones_v;
    std::vector<double> m_sines; //!< least ones between the two derivatives; 0 where either may vanish
    Lengths m_second;
    double m_curvature = 0.0;
};

double extent(const TensorSpline &spline)
{
    Eigen::AlignedBox3d hull;
    for (const Eigen::Vector4d &pole : spline.poles)
        hull.extend(Eigen::Vector3d(pole.head<3>()));
    return hull.sizes().norm();
}

std::size_t spans(const TensorSpline &spline)
{
    return (spline.u.breaks().size() - 1) * (spline.v.breaks().size() - 1);
}

class ModelSearch
{
public:
    ModelSearch(const TensorSpline &base, double distance, double base_operations)
        : m_reduction(base), m_spans(spans(base)), m_distance(std::abs(distance)), m_bounds(base),
          m_flat(flat_curvature / extent(base)),
          m_base_rounding(base_operations * std::numeric_limits<double>::epsilon() * largest_coordinate(base))
    {
    }

    [[nodiscard]] bool is_hopeless() const { return !m_bounds.has_normals(); }

    //! \param allowance [mm] that the model's point and normal errors may add to the offset's.
    //! \return a model for offsets alone where rounding, on knots that nearly coincide, leaves nothing known of curvatures.
    [[nodiscard]] std::optional<LightModel> within(double allowance)
    {
        const double curvature_allowance = curvature_share * std::max(m_flat, m_bounds.typical_curvature());
        std::optional<bool> with_curvature;
        std::optional<ReducedSpline> model;
        double goal = first_part * allowance;
        for (int round = 0; round < most_rounds; ++round)
        {
            model = m_reduction.within(goal, model ? &*model : nullptr);
            if (!model)
                return std::nullopt;
            model->rounding += m_base_rounding;
            ModelError error = m_bounds.error(*model);
            if (!with_curvature)
                with_curvature =
                    error.curvature <= curvature_allowance || curvature_of_rounding(*model) <= curvature_allowance;
            if (!*with_curvature)
                error.curvature = std::numeric_limits<double>::infinity();
            const double room = std::min(allowance / error.of_offset(m_distance),
                                         *with_curvature ? curvature_allowance / error.curvature : 1.0);
            if (room >= 1.0)
                return *with_curvature || much_lighter(model->spline)
                           ? std::optional(LightModel{std::move(model->spline), error})
                           : std::nullopt;
            if (!std::isfinite(error.normal))
                return std::nullopt;
            goal *= std::clamp(0.8 * room, 1e-3, 0.8);
        }
        return std::nullopt;
    }

private:
    //! What rounding alone leaves of the curvatures' bound, however close the model.
    [[nodiscard]] double curvature_of_rounding(const ReducedSpline &model) const
    {
        const std::vector<Eigen::Vector3d> nothing(model.change.size(), Eigen::Vector3d::Zero());
        return m_bounds.error({{}, nothing, model.rounding, 0.0}).curvature;
    }

    //! So light that it pays though curvature has to be searched on the base, and though its knots are not the offset's best.
    [[nodiscard]] bool much_lighter(const TensorSpline &model) const
    {
        return static_cast<double>(spans(model)) <= much_lighter_share * static_cast<double>(m_spans);
    }

    DataReduction m_reduction;
    std::size_t m_spans;
    double m_distance;
    BaseBounds m_bounds;
    double m_flat;
    double m_base_rounding; //!< of each coordinate of the base's poles
};

//! Fewer facets have sharper kinks between them, which an offset would follow with many poles.
bool smooth(const KnotVector &kv) { return kv.degree > 1 || kv.breaks().size() == 2; }

} // namespace

std::optional<LightModel> light_model(const TensorSpline &base, double distance, double tolerance,
                                      double base_operations)
{
    constexpr int second_derivative = 2;
    const bool too_few = std::min(base.u.pole_count(), base.v.pole_count()) <= second_derivative;
    if (base.rational || spans(base) < least_spans || too_few)
        return std::nullopt;
    ModelSearch search(base, distance, base_operations);
    if (search.is_hopeless())
        return std::nullopt;
    for (const double share : tolerance_shares)
        if (std::optional<LightModel> model = search.within(share * tolerance))
            return smooth(model->spline.u) && smooth(model->spline.v) ? model : std::nullopt;
    return std::nullopt;
}

} // namespace laminate_offset
