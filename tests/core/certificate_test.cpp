// SPDX-License-Identifier: LGPL-2.1-or-later
// The certificate against judges that share nothing with it: OpenCASCADE's evaluation at many points, and interval
// arithmetic. A bound must never lie below the truth, a bad fit must never pass, a good one must.
#include "support/deviation.h"
#include "support/interval_oracle.h"
#include "support/random_cases.h"

#include <laminate_offset/spline/knot_choice.h>
#include <laminate_offset/spline/least_squares.h>
#include <laminate_offset/surface/certificate.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace laminate_offset;
using namespace test_support;

namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Eigen::Vector3d exact_offset(const SurfaceJet &jet, double distance)
{
    return jet.s + distance * jet.u.cross(jet.v).normalized();
}

//! Knots that hold the base's at multiplicity `degree` and `parts` equal parts of each of its spans.
KnotVector finer(const KnotVector &base, int degree, int parts)
{
    const std::vector<double> breaks = base.breaks();
    std::vector<double> interior;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    {
        if (i > 0)
            interior.insert(interior.end(), static_cast<std::size_t>(degree), breaks[i]);
        for (int k = 1; k < parts; ++k)
            interior.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * k / parts);
    }
    return clamped_knots(degree, base.front(), base.back(), interior);
}

RowMatrix solve(const KnotVector &kv, const std::vector<double> &parameters, const RowMatrix &rows)
{
    const auto fit = LeastSquaresFit::make(kv, parameters);
    EXPECT_TRUE(fit.has_value());
    return fit->solve(rows);
}

//! A polynomial tensor-product fit of the exact offset on the given knots.
TensorSpline fitted(const TensorSpline &base, double distance, const KnotVector &u, const KnotVector &v)
{
    const std::vector<double> us = chebyshev_parameters(u.breaks(), u.degree + 3);
    const std::vector<double> vs = chebyshev_parameters(v.breaks(), v.degree + 3);
    const std::vector<SurfaceJet> jets = base.jets(us, vs, 1);
    const Eigen::Vector3d origin = jets.front().s;
    const auto nu = static_cast<Eigen::Index>(us.size()), nv = static_cast<Eigen::Index>(vs.size());
    RowMatrix rows(nu, 3 * nv);
    for (Eigen::Index k = 0; k < nu; ++k)
        for (Eigen::Index l = 0; l < nv; ++l)
            rows.row(k).segment<3>(3 * l) =
                (exact_offset(jets[static_cast<std::size_t>(k * nv + l)], distance) - origin).transpose();
    const RowMatrix by_u = solve(u, us, rows);
    RowMatrix turned(nv, 3 * by_u.rows());
    for (Eigen::Index i = 0; i < by_u.rows(); ++i)
        for (Eigen::Index l = 0; l < nv; ++l)
            turned.row(l).segment<3>(3 * i) = by_u.row(i).segment<3>(3 * l);
    const RowMatrix net = solve(v, vs, turned);
    TensorSpline spline{u, v, {}, false};
    for (Eigen::Index i = 0; i < by_u.rows(); ++i)
        for (Eigen::Index j = 0; j < net.rows(); ++j)
        {
            const Eigen::Vector3d point = net.row(j).segment<3>(3 * i).transpose() + origin;
            spline.poles.emplace_back(point.x(), point.y(), point.z(), 1.0);
        }
    return spline;
}

TensorSpline fitted(const TensorSpline &base, double distance, int degree, int parts)
{
    return fitted(base, distance, finer(base.u, degree, parts), finer(base.v, degree, parts));
}

//! The base moved along its normals at the poles' parameters, over the base's own weight function: a coarse offset.
TensorSpline moved_poles(const TensorSpline &base, double distance)
{
    TensorSpline result = base;
    const auto greville = [](const KnotVector &kv) {
        std::vector<double> parameters;
        for (int i = 0; i < kv.pole_count(); ++i)
        {
            double sum = 0.0;
            for (int k = 1; k <= kv.degree; ++k)
                sum += kv.knots[static_cast<std::size_t>(i + k)];
            parameters.push_back(sum / kv.degree);
        }
        return parameters;
    };
    const std::vector<SurfaceJet> jets = base.jets(greville(base.u), greville(base.v), 1);
    for (std::size_t i = 0; i < jets.size(); ++i)
        result.poles[i].head<3>() += result.poles[i].w() * distance * jets[i].u.cross(jets[i].v).normalized();
    return result;
}

double largest_coordinate(const TensorSpline &spline)
{
    double largest = 0.0;
    for (const Eigen::Vector4d &pole : spline.poles)
        largest = std::max(largest, (pole.head<3>() / pole.w()).cwiseAbs().maxCoeff());
    return largest;
}

//! The largest deviation that OpenCASCADE sees, less what its own rounding may have made of it.
double seen(const TensorSpline &base, const TensorSpline &offset, double distance, int count = 61)
{
    const Rectangle box{base.u.front(), base.u.back(), base.v.front(), base.v.back()};
    const Deviation found = deviation(to_geom(base), to_geom(offset), box, distance, count);
    EXPECT_GT(found.points, count * count / 2);
    return std::max(0.0, found.largest - 256.0 * epsilon * (largest_coordinate(base) + std::abs(distance)));
}

//! A parameter inside a random merged span.
double inside_a_span(RandomCases &random, const std::vector<double> &breaks, double &width)
{
    const auto i = static_cast<std::size_t>(random.integer(0, static_cast<int>(breaks.size()) - 2));
    width = breaks[i + 1] - breaks[i];
    return breaks[i] + width * random.uniform(0.01, 0.98);
}

//! The largest lower end of the enclosures at random points: the true error is at least that.
double surely_reached(RandomCases &random, const TensorSpline &base, const TensorSpline &offset, double distance,
                      int points, int &decided)
{
    const auto us = merged_breaks(base.u.breaks(), offset.u.breaks());
    const auto vs = merged_breaks(base.v.breaks(), offset.v.breaks());
    double reached = 0.0;
    for (int i = 0; i < points; ++i)
    {
        double width_u = 0.0, width_v = 0.0;
        const double u = inside_a_span(random, us, width_u), v = inside_a_span(random, vs, width_v);
        const double size = i % 3 == 0 ? 1e-9 : 0.0;
        const Enclosure e = enclose_deviation(base, offset, distance, {u, u + size * width_u}, {v, v + size * width_v});
        if (std::isfinite(e.high))
            ++decided;
        reached = std::max(reached, e.low);
    }
    return reached;
}

struct RandomBase
{
    TensorSpline spline;
    double size = 1.0; //!< side [mm]
};

RandomBase random_base(RandomCases &random, bool rational, double least_size = 1.0, double largest_size = 1e3)
{
    SurfaceKind kind;
    kind.degree_u = random.integer(1, 7);
    kind.degree_v = random.integer(1, 7);
    kind.spans_u = random.integer(1, 3);
    kind.spans_v = random.integer(1, 3);
    kind.size = random.magnitude(least_size, largest_size);
    kind.height = kind.size * random.magnitude(1e-3, 0.1);
    kind.jitter = random.uniform(0.0, 0.25);
    kind.rational = rational;
    return {from_geom(random_surface(random, kind)), kind.size};
}

void shift(TensorSpline &spline, const Eigen::Vector3d &by)
{
    for (Eigen::Vector4d &pole : spline.poles)
        pole.head<3>() += pole.w() * by;
}

//! A distance of any kind: zero, tiny, ordinary, huge; both signs.
double random_distance(RandomCases &random, double size)
{
    switch (random.integer(0, 4))
    {
    case 0: return 0.0;
    case 1: return random.sign() * size * random.magnitude(1e-9, 1e-5);
    case 2: return random.sign() * size * random.magnitude(1.0, 1e3);
    default: return random.sign() * size * random.magnitude(1e-4, 0.2);
    }
}

//! One of several more or less good offsets.
TensorSpline some_offset(RandomCases &random, const TensorSpline &base, double distance)
{
    if (base.rational && random.integer(0, 1) == 0)
        return moved_poles(base, distance);
    const int degree = random.integer(2, 6);
    return fitted(base, distance, degree, random.integer(1, 2));
}

//! The bound holds at every point that either judge looks at.
void expect_bound_holds(RandomCases &random, const TensorSpline &base, const TensorSpline &offset, double distance,
                        double target, int &judged)
{
    const Certificate certificate = certify({base, offset, distance, target, {}});
    const double sampled = seen(base, offset, distance, 31);
    int decided = 0;
    const double reached = surely_reached(random, base, offset, distance, 60, decided);
    EXPECT_LE(sampled, certificate.bound) << "distance " << distance << " target " << target;
    EXPECT_LE(reached, certificate.bound) << "distance " << distance << " target " << target;
    EXPECT_EQ(certificate.proven, certificate.bound <= target);
    EXPECT_FALSE(certificate.proven && std::max(sampled, reached) > target);
    if (std::isfinite(certificate.bound) && decided > 30)
        ++judged;
}

void sweep(bool rational, int cases, int needed)
{
    RandomCases random;
    int judged = 0;
    for (int i = 0; i < cases; ++i)
    {
        SCOPED_TRACE(testing::Message() << "case " << i);
        const RandomBase base = random_base(random, rational);
        const double distance = random_distance(random, base.size);
        const TensorSpline offset = some_offset(random, base.spline, distance);
        const double about = std::max(seen(base.spline, offset, distance, 17), 1e-12 * base.size);
        for (const double share : {0.3, 1.01, 3.0})
            expect_bound_holds(random, base.spline, offset, distance, share * about, judged);
    }
    EXPECT_GE(judged, needed) << "hardly any bound was finite: nothing was tested";
}

//! A smooth bicubic panel of 400 x 300 mm.
TensorSpline panel()
{
    const KnotVector u = clamped_knots(3, 0.0, 1.0, {0.25, 0.5, 0.75}), v = clamped_knots(3, 0.0, 1.0, {0.4, 0.7});
    TensorSpline spline{u, v, {}, false};
    for (int i = 0; i < u.pole_count(); ++i)
        for (int j = 0; j < v.pole_count(); ++j)
        {
            const double x = static_cast<double>(i) / (u.pole_count() - 1),
                         y = static_cast<double>(j) / (v.pole_count() - 1);
            spline.poles.emplace_back(400.0 * x, 300.0 * y, 40.0 * std::sin(2.5 * x + 0.4) * std::cos(2.0 * y), 1.0);
        }
    return spline;
}

constexpr double panel_distance = 8.0;

//! +1 where S_u x S_v points upwards in the middle, else -1.
double normal_sign(const TensorSpline &base)
{
    const SurfaceJet jet = base.jets({0.5 * (base.u.front() + base.u.back())}, {0.5}, 1).front();
    return jet.u.cross(jet.v).z() > 0.0 ? 1.0 : -1.0;
}

//! The bad fit is refused at a target below its error, and its bound is no less than that error.
void expect_refused(const TensorSpline &base, const TensorSpline &offset, double distance, double target)
{
    const double error = seen(base, offset, distance, 151);
    ASSERT_GT(error, target) << "not a bad fit";
    const Certificate certificate = certify({base, offset, distance, target, {}});
    EXPECT_FALSE(certificate.proven);
    EXPECT_GE(certificate.bound, error);
}

} // namespace

TEST(IntervalOracle, RoundsOutwards)
{
    const Enclosure third = enclose_square_plus(1.0 / 3.0, -1.0 / 9.0);
    EXPECT_LT(third.low, third.high);
    EXPECT_LT(third.high - third.low, 1e-16);
    const Enclosure tiny = enclose_square_plus(1e-9, 1.0);
    EXPECT_LT(tiny.low, 1.0 + 1e-18);
    EXPECT_GT(tiny.high, 1.0);
}

TEST(IntervalOracle, EnclosesAKnownDeviation)
{
    TensorSpline flat{clamped_knots(1, 0.0, 1.0, {}), clamped_knots(1, 0.0, 1.0, {}), {}, false};
    flat.poles = {{0, 0, 0, 1}, {0, 10, 0, 1}, {10, 0, 0, 1}, {10, 10, 0, 1}};
    TensorSpline above = flat;
    shift(above, {0.3, 0.0, 2.4});
    const Enclosure e = enclose_deviation(flat, above, 2.0, {0.2, 0.2}, {0.7, 0.7}); // 0.3 sideways, 0.4 too high
    EXPECT_LE(e.low, 0.5);
    EXPECT_GE(e.high, 0.5);
    EXPECT_LT(e.high - e.low, 1e-13);
}

TEST(Certificate, HoldsOnRandomPolynomialSurfaces) { sweep(false, 40, 60); }

TEST(Certificate, HoldsOnRandomRationalSurfaces) { sweep(true, 30, 45); }

TEST(Certificate, HoldsFarFromTheOriginAndAtEveryScale)
{
    RandomCases random;
    int judged = 0;
    for (int i = 0; i < 30; ++i)
    {
        SCOPED_TRACE(testing::Message() << "case " << i);
        const bool rational = i % 3 == 0;
        const double size = i % 2 == 0 ? 1e-3 : 1e6;
        RandomBase base = random_base(random, rational, size, size);
        if (i % 5 == 0)
            shift(base.spline, {1e6, -1e6, 1e6});
        const double distance = random.sign() * base.size * random.magnitude(1e-3, 0.1);
        const TensorSpline offset = some_offset(random, base.spline, distance);
        const double about = std::max(seen(base.spline, offset, distance, 17), 1e-12 * base.size);
        expect_bound_holds(random, base.spline, offset, distance, 2.0 * about, judged);
    }
    EXPECT_GE(judged, 18);
}

TEST(Certificate, HoldsForTinyDistancesWithLargeErrors)
{
    // The deviation changes its side of the surface within one piece: its sign at one place tells nothing elsewhere.
    RandomCases random;
    const TensorSpline base = panel();
    int judged = 0;
    for (int i = 0; i < 25; ++i)
    {
        const double distance = random.sign() * random.magnitude(1e-4, 1.0);
        TensorSpline offset = moved_poles(base, distance);
        for (Eigen::Vector4d &pole : offset.poles)
            pole.z() += std::abs(distance) * random.uniform(-20.0, 20.0);
        const double error = seen(base, offset, distance, 61);
        for (const double share : {0.5, 0.7, 0.8, 0.9, 0.95, 0.99, 1.2})
        {
            SCOPED_TRACE(testing::Message() << "case " << i << " share " << share);
            expect_bound_holds(random, base, offset, distance, share * error, judged);
        }
    }
    EXPECT_GE(judged, 80);
}

TEST(Certificate, ProvesGoodFitsWithoutWaste)
{
    RandomCases random;
    int proven = 0, tried = 0;
    for (int i = 0; i < 30; ++i)
    {
        const RandomBase base = random_base(random, i % 3 == 0);
        const double distance = random.sign() * base.size * random.magnitude(1e-4, 1e-2);
        const TensorSpline offset = fitted(base.spline, distance, 5, 3);
        const double rounding = 1e-11 * (base.size + std::abs(distance));
        const double error = seen(base.spline, offset, distance, 101);
        if (error > 0.3 * std::abs(distance)) // the base folds or kinks: no good fit
            continue;
        ++tried;
        const Certificate certificate = certify({base.spline, offset, distance, 2.0 * error + rounding, {}});
        EXPECT_LE(certificate.bound, 3.0 * error + rounding) << "case " << i;
        proven += certificate.proven ? 1 : 0;
    }
    EXPECT_GE(tried, 15);
    EXPECT_GE(proven, tried - 1);
}

//! Straight rulings, 60 long, that turn while their middles run 30 far along an arc; across them in u, or in v.
TensorSpline twisted_ribbon(double turn, bool ruled_in_v)
{
    const KnotVector along = clamped_knots(3, 0.0, 1.0, {});
    const KnotVector across = clamped_knots(1, 0.0, 1.0, {});
    const auto pole = [&](int i, int j) {
        const double angle = turn * i / 3.0, side = j == 0 ? -30.0 : 30.0;
        return Eigen::Vector4d(10.0 * i, side * std::cos(angle), side * std::sin(angle) + 1.0 * i * i, 1.0);
    };
    TensorSpline ribbon{ruled_in_v ? along : across, ruled_in_v ? across : along, {}, false};
    for (int a = 0; a < (ruled_in_v ? 4 : 2); ++a)
        for (int b = 0; b < (ruled_in_v ? 2 : 4); ++b)
            ribbon.poles.push_back(ruled_in_v ? pole(a, b) : pole(b, a));
    return ribbon;
}

TEST(Certificate, ProvesFitsOfTwistedRibbonsWithStraightRulings)
{
    int tried = 0;
    for (const double turn : {0.2, 0.6, 1.2})
        for (const bool ruled_in_v : {true, false})
            for (const double distance : {14.0, -14.0, 0.5})
            {
                SCOPED_TRACE(testing::Message()
                             << "turn " << turn << " ruled in v " << ruled_in_v << " distance " << distance);
                const TensorSpline base = twisted_ribbon(turn, ruled_in_v);
                const TensorSpline offset = fitted(base, distance, 6, 1);
                const double error = seen(base, offset, distance, 201);
                ASSERT_LT(error, 0.1 * std::abs(distance));
                const Certificate certificate = certify({base, offset, distance, 1.1 * error, {}});
                EXPECT_TRUE(certificate.proven) << certificate.bound << " against " << error;
                ++tried;
            }
    EXPECT_EQ(tried, 18);
}

TEST(Certificate, RefusesAMovedPole)
{
    const TensorSpline base = panel();
    const TensorSpline good = fitted(base, panel_distance, 5, 2);
    ASSERT_TRUE(certify({base, good, panel_distance, 1e-3, {}}).proven);
    RandomCases random;
    int refused = 0;
    for (int i = 0; i < 15; ++i)
    {
        TensorSpline bad = good;
        const auto pole = static_cast<std::size_t>(random.integer(0, static_cast<int>(bad.poles.size()) - 1));
        bad.poles[pole].head<3>() += 0.02 * Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), 1.0);
        expect_refused(base, bad, panel_distance, 1e-3);
        ++refused;
    }
    EXPECT_EQ(refused, 15);
}

TEST(Certificate, RefusesAWaveBetweenTheSamples)
{
    // Right at 12 equal parts of every span, wrong between them: what a grid of samples cannot see.
    const TensorSpline base = panel();
    const KnotVector u = finer(base.u, 5, 24), v = finer(base.v, 5, 2);
    const TensorSpline good = fitted(base, panel_distance, u, v);
    ASSERT_TRUE(certify({base, good, panel_distance, 1e-3, {}}).proven);
    for (const int spoiled : {7, 30, 61})
    {
        TensorSpline bad = good;
        bad.poles[static_cast<std::size_t>(spoiled * v.pole_count() + 6)].z() += 0.05;
        expect_refused(base, bad, panel_distance, 1e-3);
    }
}

TEST(Certificate, RefusesTheWrongSideAndTheWrongDistance)
{
    const TensorSpline base = panel();
    const TensorSpline good = fitted(base, panel_distance, 5, 2);
    expect_refused(base, good, -panel_distance, 1e-3);
    expect_refused(base, good, -panel_distance, 15.9);
    expect_refused(base, good, panel_distance + 2e-3, 1e-3);
    expect_refused(base, good, panel_distance - 2e-3, 1e-3);
    expect_refused(base, good, 0.0, 7.9);
}

TEST(Certificate, RefusesATangentialSlip)
{
    // On a plane a slip along the surface leaves the surface as a set of points where it was.
    const TensorSpline base = panel();
    for (const Eigen::Vector3d &slip : {Eigen::Vector3d(2e-3, 0, 0), Eigen::Vector3d(0, 2e-3, 0)})
    {
        TensorSpline flat = base;
        for (Eigen::Vector4d &pole : flat.poles)
            pole.z() = 0.0;
        TensorSpline bad = moved_poles(flat, panel_distance);
        ASSERT_TRUE(certify({flat, bad, panel_distance, 1e-3, {}}).proven);
        shift(bad, slip);
        expect_refused(flat, bad, panel_distance, 1e-3);
        TensorSpline curved = fitted(base, panel_distance, 5, 2);
        shift(curved, slip);
        expect_refused(base, curved, panel_distance, 1e-3);
    }
}

TEST(Certificate, HoldsAtCollapsedSides)
{
    RandomCases random;
    int proven = 0, judged = 0;
    for (int i = 0; i < 12; ++i)
    {
        SCOPED_TRACE(testing::Message() << "case " << i);
        // One side of a paraboloid-like cap drawn together into its top.
        const KnotVector u = clamped_knots(4, 0.0, 1.0, {}), v = clamped_knots(3, 0.0, 1.0, {0.6});
        TensorSpline base{u, v, {}, false};
        const double bulge = random.uniform(-10.0, 10.0), opening = random.uniform(0.8, 2.5);
        const double rise[] = {0.0, 0.0, 0.04, 0.3, 1.0}, radius[] = {0.0, 0.2, 0.5, 0.8, 1.0};
        for (int k = 0; k < u.pole_count(); ++k)
            for (int l = 0; l < v.pole_count(); ++l)
            {
                const double angle = opening * k / (u.pole_count() - 1);
                base.poles.emplace_back(50.0 * radius[l] * std::cos(angle), 50.0 * radius[l] * std::sin(angle),
                                        bulge * rise[l], 1.0);
            }
        const double distance = random.sign() * random.magnitude(0.05, 2.0);
        TensorSpline offset = moved_poles(base, distance);
        for (int k = 0; k < u.pole_count(); ++k) // the normal of the collapsed side is the axis
            offset.poles[static_cast<std::size_t>(k * v.pole_count())] = {0.0, 0.0, distance * normal_sign(base), 1.0};
        const double error = seen(base, offset, distance, 101);
        const Certificate certificate = certify({base, offset, distance, 1.5 * error, {}});
        proven += certificate.proven ? 1 : 0;
        expect_bound_holds(random, base, offset, distance, 1.5 * error, judged);
        expect_bound_holds(random, base, offset, distance, 0.9 * error, judged);
    }
    EXPECT_GE(proven, 10);
    EXPECT_GE(judged, 12);
}

TEST(Certificate, HoldsOnSliversBetweenNearlyEqualKnots)
{
    // Knots of the fit a hair's breadth from those of the base leave pieces in which S_u is mostly rounding.
    RandomCases random;
    const TensorSpline base = panel();
    int judged = 0;
    for (const double gap : {1e-11, 1e-10, 1e-9, 1e-8, 1e-6})
    {
        const KnotVector u = clamped_knots(5, 0.0, 1.0, {0.25 + gap, 0.25 + gap, 0.5 - gap, 0.75 + gap});
        const TensorSpline offset = fitted(base, panel_distance, u, finer(base.v, 5, 1));
        const double error = seen(base, offset, panel_distance, 101);
        expect_bound_holds(random, base, offset, panel_distance, 1.2 * error, judged);
        expect_bound_holds(random, base, offset, panel_distance, 0.95 * error, judged);
    }
    EXPECT_GE(judged, 8);
}

TEST(Certificate, IsConvexInTheDistanceOfAFamily)
{
    const TensorSpline base = panel();
    const TensorSpline low = fitted(base, -10.0, 5, 2), high = fitted(base, 20.0, 5, 2);
    double ends = 0.0;
    for (const auto &[distance, offset] : {std::pair(-10.0, low), std::pair(20.0, high)})
    {
        const double error = seen(base, offset, distance, 101);
        const Certificate certificate = certify({base, offset, distance, 1.3 * error, {}});
        ASSERT_TRUE(certificate.proven);
        ends = std::max(ends, certificate.bound);
    }
    for (const double share : {0.1, 0.3, 0.5, 0.8})
    {
        TensorSpline between = low;
        for (std::size_t i = 0; i < low.poles.size(); ++i)
            between.poles[i] = (1.0 - share) * low.poles[i] + share * high.poles[i];
        const double distance = -10.0 + 30.0 * share;
        const Certificate certificate = certify({base, between, distance, ends, {}});
        EXPECT_LE(seen(base, between, distance, 101), ends);
        EXPECT_TRUE(certificate.proven) << certificate.bound << " above " << ends;
    }
}

TEST(Certificate, LooksOnlyWhereItIsNeeded)
{
    const TensorSpline base = panel();
    TensorSpline offset = fitted(base, panel_distance, 5, 2);
    offset.poles.back().z() += 5.0; // spoils the far corner
    const auto low_half = [](const ParameterBox &box) { return box.umin < 0.5 && box.vmin < 0.4; };
    EXPECT_TRUE(certify({base, offset, panel_distance, 1e-3, low_half}).proven);
    const Certificate everywhere = certify({base, offset, panel_distance, 1e-3, {}});
    EXPECT_FALSE(everywhere.proven);
    EXPECT_GE(everywhere.worst.umax, 1.0);
    EXPECT_GE(everywhere.worst.vmax, 1.0);
}

TEST(Certificate, ThatOnlyHasToSettleGivesTheSameAnswer)
{
    RandomCases random;
    int proven = 0, refused = 0;
    for (int i = 0; i < 30; ++i)
    {
        const RandomBase base = random_base(random, i % 3 == 0);
        const double distance = random.sign() * base.size * random.magnitude(1e-4, 1e-2);
        const TensorSpline offset = fitted(base.spline, distance, 5, 3);
        const double error = seen(base.spline, offset, distance, 51);
        const double target = error * random.magnitude(0.3, 3.0) + 1e-11 * base.size;
        const Certificate whole = certify({base.spline, offset, distance, target, {}});
        const Certificate settled = certify({base.spline, offset, distance, target, {}, 0.0, true});
        ASSERT_EQ(settled.proven, whole.proven) << "case " << i;
        if (whole.proven)
            EXPECT_EQ(settled.bound, whole.bound);
        else
            EXPECT_TRUE(std::isinf(settled.bound)) << "a proof that was ended bounds nothing";
        ++(whole.proven ? proven : refused);
    }
    EXPECT_GE(proven, 5);
    EXPECT_GE(refused, 5);
}
