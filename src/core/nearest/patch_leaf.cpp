// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patch_leaf.h"

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

// Second derivatives stay below this part of the first ones over the unit square of a leaf.
constexpr double bend = 0.35;
// The mixed one has to stay below it beside the shorter side too, which counts as no shorter than this part of the longer
// one: at a pole it vanishes.
constexpr double shorter_side = 0.1;
// A patch more slender than that is cut across at first: many slivers side by side are as far away as one of them.
constexpr double slender = 0.02;
// Enclosures are widened by so much of their size for rounding.
constexpr double rounding = 1e-12;

struct Basis
{
    double value[3][max_spline_degree + 1];
};

//! Bernstein polynomials of degree n at t with two derivatives.
void fill(Basis &basis, int n, double t)
{
    double *const b = basis.value[0];
    double *const d = basis.value[1];
    double *const dd = basis.value[2];
    const double s = 1.0 - t;
    // degrees are raised one by one; the last two lower ones give the derivatives
    b[0] = 1.0;
    double lower[max_spline_degree + 1] = {};  // degree n - 1
    double lowest[max_spline_degree + 1] = {}; // degree n - 2
    for (int k = 1; k <= n; ++k)
    {
        if (k == n - 1)
            std::copy(b, b + k, lowest);
        if (k == n)
            std::copy(b, b + k, lower);
        double carried = 0.0;
        for (int i = 0; i < k; ++i)
        {
            const double old = b[i];
            b[i] = s * old + carried;
            carried = t * old;
        }
        b[k] = carried;
    }
    for (int i = 0; i <= n; ++i)
    {
        d[i] = n * ((i > 0 ? lower[i - 1] : 0.0) - (i < n ? lower[i] : 0.0));
        dd[i] = n < 2 ? 0.0
                      : n * (n - 1) *
                            ((i > 1 ? lowest[i - 2] : 0.0) - 2.0 * (i > 0 && i < n ? lowest[i - 1] : 0.0) +
                             (i < n - 1 ? lowest[i] : 0.0));
    }
}

//! Numerator of a derivative: a' w - k a w', which stands over w^(k + 1) when a stands over w^k.
Bernstein3 derivative_numerator(const Bernstein3 &a, const Bernstein &omega, int power, bool along_u)
{
    const auto derivative = [along_u](const Bernstein &of) {
        Bernstein result;
        along_u ? result.assign_derivative_u(of) : result.assign_derivative_v(of);
        return result;
    };
    const Bernstein slope = derivative(omega);
    Bernstein3 result;
    for (std::size_t e = 0; e < 3; ++e)
    {
        result[e].reset(a[e].degree_u() + omega.degree_u(), a[e].degree_v() + omega.degree_v());
        Bernstein product;
        assign_product(derivative(a[e]), omega, product);
        result[e].add_raised(1.0, product);
        assign_product(a[e], slope, product);
        result[e].add_raised(-power, product);
    }
    return result;
}

Bernstein3 polynomial_derivative(const Bernstein3 &a, bool along_u)
{
    Bernstein3 result;
    for (std::size_t e = 0; e < 3; ++e)
        along_u ? result[e].assign_derivative_u(a[e]) : result[e].assign_derivative_v(a[e]);
    return result;
}

Bernstein3 derivative(const Bernstein3 &a, const RationalPiece &piece, int power, bool along_u)
{
    return piece.rational() ? derivative_numerator(a, piece.omega, power, along_u) : polynomial_derivative(a, along_u);
}

//! Enclosure of a vector polynomial over w^power.
Eigen::AlignedBox3d enclosure(const Bernstein3 &numerator, const Bernstein::Range &weight, int power)
{
    Eigen::AlignedBox3d box(Eigen::Vector3d::Zero().eval());
    const double small = std::pow(weight.low, power);
    const double large = std::pow(weight.high, power);
    for (int e = 0; e < 3; ++e)
    {
        const Bernstein::Range range = numerator[static_cast<std::size_t>(e)].range();
        const double slack = rounding * range.size();
        box.min()[e] = range.low / (range.low < 0.0 ? small : large) - slack / small;
        box.max()[e] = range.high / (range.high < 0.0 ? large : small) + slack / small;
    }
    return box;
}

double longest(const Eigen::AlignedBox3d &box) { return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).norm(); }

//! Least value of a . b for vectors in two boxes.
double least_product(const Eigen::AlignedBox3d &a, const Eigen::AlignedBox3d &b)
{
    double sum = 0.0;
    for (int e = 0; e < 3; ++e)
        sum += std::min(std::min(a.min()[e] * b.min()[e], a.min()[e] * b.max()[e]),
                        std::min(a.max()[e] * b.min()[e], a.max()[e] * b.max()[e]));
    return sum;
}

Eigen::AlignedBox3d opposite(const Eigen::AlignedBox3d &box) { return {-box.max(), -box.min()}; }

//! Rows: along a, across it in the plane of a and b, normal to both.
Eigen::Matrix3d frame_of(const Eigen::Vector3d &a, const Eigen::Vector3d &b)
{
    Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
    const Eigen::Vector3d normal = a.cross(b);
    if (!(normal.norm() > rounding * a.norm() * b.norm()))
        return frame;
    frame.row(0) = a.normalized();
    frame.row(2) = normal.normalized();
    frame.row(1) = frame.row(2).cross(frame.row(0));
    return frame;
}

//! The piece's numerator about `centre` in a frame.
Bernstein3 turned(const RationalPiece &piece, const Eigen::Matrix3d &frame, const Eigen::Vector3d &centre)
{
    Bernstein3 result;
    for (int e = 0; e < 3; ++e)
    {
        Bernstein &row = result[static_cast<std::size_t>(e)];
        row.reset(piece.numerator[0].degree_u(), piece.numerator[0].degree_v());
        for (int k = 0; k < 3; ++k)
            row.add_raised(frame(e, k), piece.numerator[static_cast<std::size_t>(k)]);
        row.add_raised(-frame.row(e).dot(centre), piece.omega);
    }
    return result;
}

void fill_poles(PatchLeaf &leaf)
{
    for (int i = 0; i <= leaf.degree_u; ++i)
        for (int j = 0; j <= leaf.degree_v; ++j)
        {
            const double weight = leaf.rational ? leaf.piece.omega.coefficient(i, j) : 1.0;
            Eigen::Vector3d point;
            for (int e = 0; e < 3; ++e)
            {
                point[e] = leaf.piece.numerator[static_cast<std::size_t>(e)].coefficient(i, j);
                leaf.poles.push_back(point[e]);
            }
            leaf.poles.push_back(weight);
            leaf.hull.extend((point / weight).eval());
        }
}

} // namespace

LeafJet PatchLeaf::jet(double x, double y) const
{
    Basis bu;
    Basis bv;
    fill(bu, degree_u, x);
    fill(bv, degree_v, y);
    Eigen::Vector4d h[6];
    for (Eigen::Vector4d &part : h)
        part.setZero();
    const double *pole = poles.data();
    for (int i = 0; i <= degree_u; ++i)
    {
        Eigen::Vector4d row[3] = {Eigen::Vector4d::Zero(), Eigen::Vector4d::Zero(), Eigen::Vector4d::Zero()};
        for (int j = 0; j <= degree_v; ++j, pole += 4)
        {
            const Eigen::Map<const Eigen::Vector4d> at(pole);
            row[0] += bv.value[0][j] * at;
            row[1] += bv.value[1][j] * at;
            row[2] += bv.value[2][j] * at;
        }
        h[0] += bu.value[0][i] * row[0];
        h[1] += bu.value[1][i] * row[0];
        h[2] += bu.value[0][i] * row[1];
        h[3] += bu.value[2][i] * row[0];
        h[4] += bu.value[1][i] * row[1];
        h[5] += bu.value[0][i] * row[2];
    }
    LeafJet jet;
    if (!rational)
    {
        jet.s = h[0].head<3>();
        jet.u = h[1].head<3>();
        jet.v = h[2].head<3>();
        jet.uu = h[3].head<3>();
        jet.uv = h[4].head<3>();
        jet.vv = h[5].head<3>();
        return jet;
    }
    const double w = 1.0 / h[0].w(); // NURBS Book A4.4
    jet.s = h[0].head<3>() * w;
    jet.u = (h[1].head<3>() - h[1].w() * jet.s) * w;
    jet.v = (h[2].head<3>() - h[2].w() * jet.s) * w;
    jet.uu = (h[3].head<3>() - 2.0 * h[1].w() * jet.u - h[3].w() * jet.s) * w;
    jet.uv = (h[4].head<3>() - h[1].w() * jet.v - h[2].w() * jet.u - h[4].w() * jet.s) * w;
    jet.vv = (h[5].head<3>() - 2.0 * h[2].w() * jet.v - h[5].w() * jet.s) * w;
    return jet;
}

PatchLeaf::Focus PatchLeaf::focus(const Eigen::Vector3d &p) const
{
    // half of |S - p|^2 has the slopes (S - p).S_a and the Hessian S_a.S_b + (S - p).S_ab
    const Eigen::AlignedBox3d from_p = Eigen::AlignedBox3d(around).translate(frame * (centre - p));
    Focus result;
    const bool rises_u = least_product(from_p, u) > 0.0;
    const bool falls_u = !rises_u && least_product(from_p, opposite(u)) > 0.0;
    const bool rises_v = least_product(from_p, v) > 0.0;
    const bool falls_v = !rises_v && least_product(from_p, opposite(v)) > 0.0;
    if (rises_u || falls_u)
        result.box.x0 = result.box.x1 = falls_u ? 1.0 : 0.0;
    if (rises_v || falls_v)
        result.box.y0 = result.box.y1 = falls_v ? 1.0 : 0.0;
    const bool free_u = result.box.x0 < result.box.x1;
    const bool free_v = result.box.y0 < result.box.y1;
    const double stray_u = 0.5 * (size_uu + size_uv); // of S_u from its value in the middle
    const double stray_v = 0.5 * (size_uv + size_vv);
    const double length_u = du.norm();
    const double length_v = dv.norm();
    const double least_u = std::max(0.0, length_u - stray_u);
    const double least_v = std::max(0.0, length_v - stray_v);
    const double a = free_u ? least_u * least_u + least_product(from_p, uu) : 1.0;
    const double c = free_v ? least_v * least_v + least_product(from_p, vv) : 1.0;
    result.convex = a > 0.0 && c > 0.0;
    if (!result.convex || !free_u || !free_v)
        return result;
    const double mixed = du.dot(dv);
    const double stray = length_u * stray_v + length_v * stray_u + stray_u * stray_v;
    const double low = mixed - stray + least_product(from_p, uv);
    const double high = mixed + stray - least_product(from_p, opposite(uv));
    const double b = std::max(std::abs(low), std::abs(high));
    result.convex = a * c > (1.0 + rounding) * b * b;
    return result;
}

PatchLeaf::Plane PatchLeaf::nearest_on_plane(const Eigen::Vector3d &p) const
{
    const Eigen::Vector3d d = p - centre;
    const double e = du.squaredNorm();
    const double f = du.dot(dv);
    const double g = dv.squaredNorm();
    const double along_u = du.dot(d);
    const double along_v = dv.dot(d);
    const double area = e * g - f * f;
    Plane plane;
    if (!(area > rounding * e * g))
    {
        plane.distance = d.norm();
        plane.least = std::max(0.0, plane.distance - radius);
        plane.most = plane.distance; // the middle
        return plane;
    }
    const auto square = [&](double x, double y) { return (d - x * du - y * dv).squaredNorm(); };
    const auto clamped = [](double x) { return std::clamp(x, -0.5, 0.5); };
    const double x = (g * along_u - f * along_v) / area;
    const double y = (e * along_v - f * along_u) / area;
    // the least of a convex function over a square lies on a side that its least over the plane has passed
    double bx = x;
    double by = y;
    double best = x == clamped(x) && y == clamped(y) ? square(x, y) : std::numeric_limits<double>::infinity();
    if (x != clamped(x))
    {
        bx = clamped(x);
        by = clamped((along_v - f * bx) / g);
        best = square(bx, by);
    }
    if (y != clamped(y))
    {
        const double sy = clamped(y);
        const double sx = clamped((along_u - f * sy) / e);
        if (const double there = square(sx, sy); there < best)
        {
            best = there;
            bx = sx;
            by = sy;
        }
    }
    plane.distance = std::sqrt(best);
    plane.least = std::max(0.0, plane.distance - bulge);
    plane.most = plane.distance + bulge;
    plane.x = bx + 0.5;
    plane.y = by + 0.5;
    return plane;
}

PatchLeaf make_leaf(const ParameterBox &box, RationalPiece piece)
{
    PatchLeaf leaf;
    leaf.box = box;
    leaf.piece = std::move(piece);
    leaf.degree_u = leaf.piece.numerator[0].degree_u();
    leaf.degree_v = leaf.piece.numerator[0].degree_v();
    leaf.rational = leaf.piece.rational();
    fill_poles(leaf);
    const LeafJet middle = leaf.jet(0.5, 0.5);
    leaf.centre = middle.s;
    leaf.du = middle.u;
    leaf.dv = middle.v;
    leaf.frame = frame_of(leaf.du, leaf.dv);
    const Bernstein::Range weight = leaf.rational ? leaf.piece.omega.range() : Bernstein::Range{1.0, 1.0};
    const Bernstein3 local = turned(leaf.piece, leaf.frame, leaf.centre);
    const Bernstein3 along_u = derivative(local, leaf.piece, 1, true);
    const Bernstein3 along_v = derivative(local, leaf.piece, 1, false);
    leaf.around = enclosure(local, weight, 1);
    leaf.u = enclosure(along_u, weight, 2);
    leaf.v = enclosure(along_v, weight, 2);
    leaf.uu = enclosure(derivative(along_u, leaf.piece, 2, true), weight, 3);
    leaf.uv = enclosure(derivative(along_u, leaf.piece, 2, false), weight, 3);
    leaf.vv = enclosure(derivative(along_v, leaf.piece, 2, false), weight, 3);
    leaf.size_uu = longest(leaf.uu);
    leaf.size_uv = longest(leaf.uv);
    leaf.size_vv = longest(leaf.vv);
    // Taylor's remainder with |x - 1/2|, |y - 1/2| <= 1/2
    leaf.bulge = (1.0 + rounding) * (leaf.size_uu + 2.0 * leaf.size_uv + leaf.size_vv) / 8.0;
    const double reach = 0.5 * std::max((leaf.du + leaf.dv).norm(), (leaf.du - leaf.dv).norm()) + leaf.bulge;
    leaf.radius = std::min(reach, longest(Eigen::AlignedBox3d(leaf.hull).translate(-leaf.centre)));
    return leaf;
}

Bend bend_of(const PatchLeaf &leaf)
{
    const double lu = leaf.du.norm();
    const double lv = leaf.dv.norm();
    const bool u_bends = leaf.size_uu > bend * lu;
    const bool v_bends = leaf.size_vv > bend * lv;
    const double shorter = std::min(lu, lv);
    const double longer = std::max(lu, lv);
    if (!u_bends && !v_bends && leaf.size_uv <= bend * std::max(shorter, shorter_side * longer))
        return Bend::None;
    const bool along_u = u_bends != v_bends && shorter >= slender * longer ? u_bends : lu >= lv;
    return along_u ? Bend::AlongU : Bend::AlongV;
}

std::pair<PatchLeaf, PatchLeaf> halves(const PatchLeaf &leaf, bool along_u)
{
    RationalPiece low = leaf.piece;
    RationalPiece high = leaf.piece;
    low.halve(along_u, high);
    ParameterBox low_box = leaf.box;
    ParameterBox high_box = leaf.box;
    if (along_u)
        low_box.umax = high_box.umin = 0.5 * (leaf.box.umin + leaf.box.umax);
    else
        low_box.vmax = high_box.vmin = 0.5 * (leaf.box.vmin + leaf.box.vmax);
    return {make_leaf(low_box, std::move(low)), make_leaf(high_box, std::move(high))};
}

} // namespace laminate_offset
