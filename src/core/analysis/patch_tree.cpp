// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patch_tree.h"

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

// Derivative boxes are widened by so much of their size for rounding.
constexpr double rounding = 1e-12;
// A leaf that is wider than the rectangle in question is halved down to this depth.
constexpr int deepest_for_bounds = 40;
// Pieces in each direction over which a rational surface is bounded whole.
constexpr std::size_t least_rational_pieces = 8;

double width_u(const ParameterBox &box) { return box.umax - box.umin; }
double width_v(const ParameterBox &box) { return box.vmax - box.vmin; }

//! The quotient of an enclosure of the numerator and the square of the weights.
Eigen::AlignedBox3d quotient(const Bernstein3 &numerator, const Bernstein::Range &weights)
{
    const double small = weights.low * weights.low;
    const double large = weights.high * weights.high;
    Eigen::AlignedBox3d box(Eigen::Vector3d::Zero().eval());
    for (int e = 0; e < 3; ++e)
    {
        const Bernstein::Range range = numerator[static_cast<std::size_t>(e)].range();
        box.min()[e] = range.low / (range.low < 0.0 ? small : large);
        box.max()[e] = range.high / (range.high < 0.0 ? large : small);
    }
    return box;
}

//! N' w - N w', whose quotient by w^2 is the derivative.
Bernstein3 derivative_numerator(const RationalPiece &piece, bool along_u)
{
    const auto derivative = [along_u](const Bernstein &a) {
        Bernstein result;
        along_u ? result.assign_derivative_u(a) : result.assign_derivative_v(a);
        return result;
    };
    Bernstein3 result;
    for (std::size_t e = 0; e < 3; ++e)
        result[e] = derivative(piece.numerator[e]);
    if (!piece.rational())
        return result;
    const Bernstein weight = derivative(piece.omega);
    for (std::size_t e = 0; e < 3; ++e)
    {
        Bernstein sum(2 * piece.omega.degree_u(), 2 * piece.omega.degree_v());
        Bernstein product;
        assign_product(result[e], piece.omega, product);
        sum.add_raised(1.0, product);
        assign_product(piece.numerator[e], weight, product);
        sum.add_raised(-1.0, product);
        result[e] = sum;
    }
    return result;
}

Eigen::AlignedBox3d derivative_box(const RationalPiece &piece, bool along_u, double width)
{
    const Bernstein::Range weights = piece.rational() ? piece.omega.range() : Bernstein::Range{1.0, 1.0};
    Eigen::AlignedBox3d box = quotient(derivative_numerator(piece, along_u), weights);
    box.min() /= width;
    box.max() /= width;
    return box;
}

std::vector<Eigen::Vector3d> control_points(const RationalPiece &piece)
{
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i <= piece.numerator[0].degree_u(); ++i)
        for (int j = 0; j <= piece.numerator[0].degree_v(); ++j)
        {
            const double weight = piece.rational() ? piece.omega.coefficient(i, j) : 1.0;
            points.emplace_back(piece.numerator[0].coefficient(i, j) / weight,
                                piece.numerator[1].coefficient(i, j) / weight,
                                piece.numerator[2].coefficient(i, j) / weight);
        }
    return points;
}

bool overlap_inside(const ParameterBox &a, const ParameterBox &b)
{
    return a.umin < b.umax && b.umin < a.umax && a.vmin < b.vmax && b.vmin < a.vmax;
}

bool holds(const ParameterBox &outer, const ParameterBox &inner)
{
    return outer.umin <= inner.umin && outer.umax >= inner.umax && outer.vmin <= inner.vmin && outer.vmax >= inner.vmax;
}

} // namespace

void PatchBounds::extend(const PatchBounds &other)
{
    point.extend(other.point);
    du.extend(other.du);
    dv.extend(other.dv);
}

bool PatchBounds::one_to_one() const
{
    if (du.isEmpty() || dv.isEmpty())
        return false;
    const Eigen::Vector3d cu = du.center();
    const Eigen::Vector3d cv = dv.center();
    const double e = cu.squaredNorm();
    const double f = cu.dot(cv);
    const double g = cv.squaredNorm();
    const double area = e * g - f * f;
    if (!(area > rounding * e * g))
        return false;
    // the rows that take cu to (1, 0) and cv to (0, 1)
    const Eigen::Vector3d row_u = ((g * cu - f * cv) / area).cwiseAbs();
    const Eigen::Vector3d row_v = ((e * cv - f * cu) / area).cwiseAbs();
    const Eigen::Vector3d hu = (0.5 + rounding) * du.sizes();
    const Eigen::Vector3d hv = (0.5 + rounding) * dv.sizes();
    const double uu = 1.0 - row_u.dot(hu);
    const double vv = 1.0 - row_v.dot(hv);
    return uu > 0.0 && vv > 0.0 && uu * vv > (1.0 + rounding) * row_u.dot(hv) * row_v.dot(hu);
}

PatchTree::PatchTree(const TensorSpline &spline) : m_us(spline.u.breaks()), m_vs(spline.v.breaks())
{
    SplinePieces pieces(spline, m_us, m_vs);
    build(pieces, pieces.near_point(0, 0), {0, m_us.size() - 1, 0, m_vs.size() - 1});
}

int PatchTree::build(SplinePieces &pieces, const Eigen::Vector3d &origin, const std::array<std::size_t, 4> &range)
{
    const auto [i0, i1, j0, j1] = range;
    const ParameterBox box{m_us[i0], m_us[i1], m_vs[j0], m_vs[j1]};
    if (i1 - i0 == 1 && j1 - j0 == 1)
    {
        RationalPiece piece;
        pieces.cut(i0, j0, origin, piece);
        return add_piece(box, 0, std::move(piece));
    }
    const int index = static_cast<int>(m_nodes.size());
    m_nodes.emplace_back().box = box;
    const bool along_u = i1 - i0 >= j1 - j0;
    const std::size_t middle = along_u ? (i0 + i1) / 2 : (j0 + j1) / 2;
    const int lower =
        along_u ? build(pieces, origin, {i0, middle, j0, j1}) : build(pieces, origin, {i0, i1, j0, middle});
    const int upper =
        along_u ? build(pieces, origin, {middle, i1, j0, j1}) : build(pieces, origin, {i0, i1, middle, j1});
    PatchNode &parent = m_nodes[static_cast<std::size_t>(index)];
    parent.lower = lower;
    parent.upper = upper;
    parent.bounds = node(lower).bounds;
    parent.bounds.extend(node(upper).bounds);
    return index;
}

int PatchTree::add_piece(const ParameterBox &box, int halvings, RationalPiece piece)
{
    const int index = static_cast<int>(m_nodes.size());
    PatchNode &node = m_nodes.emplace_back();
    node.box = box;
    node.halvings = halvings;
    node.points = control_points(piece);
    for (const Eigen::Vector3d &point : node.points)
        node.bounds.point.extend(point);
    node.bounds.du = derivative_box(piece, true, width_u(box));
    node.bounds.dv = derivative_box(piece, false, width_v(box));
    node.piece = std::move(piece);
    return index;
}

void PatchTree::split(int index)
{
    const PatchNode &parent = node(index);
    if (parent.lower >= 0)
        return;
    const PatchBounds &bounds = parent.bounds;
    const bool along_u =
        bounds.du.center().norm() * width_u(parent.box) >= bounds.dv.center().norm() * width_v(parent.box);
    RationalPiece low = parent.piece;
    RationalPiece high = parent.piece;
    low.halve(along_u, high);
    ParameterBox low_box = parent.box;
    ParameterBox high_box = parent.box;
    if (along_u)
        low_box.umax = high_box.umin = 0.5 * (parent.box.umin + parent.box.umax);
    else
        low_box.vmax = high_box.vmin = 0.5 * (parent.box.vmin + parent.box.vmax);
    const int halvings = parent.halvings + 1;
    const int lower = add_piece(low_box, halvings, std::move(low));
    const int upper = add_piece(high_box, halvings, std::move(high));
    m_nodes[static_cast<std::size_t>(index)].lower = lower;
    m_nodes[static_cast<std::size_t>(index)].upper = upper;
}

PatchBounds PatchTree::bounds_over(const ParameterBox &box)
{
    PatchBounds bounds;
    gather(root(), box, bounds);
    return bounds;
}

void PatchTree::gather(int index, const ParameterBox &box, PatchBounds &bounds)
{
    const PatchNode &n = node(index);
    if (!overlap_inside(n.box, box))
        return;
    const bool coarse = width_u(n.box) > width_u(box) || width_v(n.box) > width_v(box);
    if (holds(box, n.box) || (n.lower < 0 && (!coarse || n.halvings >= deepest_for_bounds)))
    {
        bounds.extend(n.bounds);
        return;
    }
    split(index); // keeps what is there; nodes stay where they are
    gather(n.lower, box, bounds);
    gather(n.upper, box, bounds);
}

namespace
{

//! Factor of the difference of poles i - 1 and i in the derivative; 0 where that difference has no support.
double slope(const KnotVector &kv, int i)
{
    const double length = kv.knots[static_cast<std::size_t>(i + kv.degree)] - kv.knots[static_cast<std::size_t>(i)];
    return length > 0.0 ? kv.degree / length : 0.0;
}

//! At least `least` intervals, every one between two breaks.
std::vector<double> subdivided(const std::vector<double> &breaks, std::size_t least)
{
    const std::size_t spans = breaks.size() - 1;
    const std::size_t parts = (least + spans - 1) / spans;
    std::vector<double> result;
    for (std::size_t i = 0; i < spans; ++i)
        for (std::size_t k = 0; k < parts; ++k)
            result.push_back(breaks[i] +
                             (breaks[i + 1] - breaks[i]) * static_cast<double>(k) / static_cast<double>(parts));
    result.push_back(breaks.back());
    return result;
}

//! Over short pieces, on which the weight hardly varies.
PatchBounds whole_rational_bounds(const TensorSpline &spline)
{
    const std::vector<double> us = subdivided(spline.u.breaks(), least_rational_pieces);
    const std::vector<double> vs = subdivided(spline.v.breaks(), least_rational_pieces);
    SplinePieces pieces(spline, us, vs);
    const Eigen::Vector3d origin = pieces.near_point(0, 0);
    RationalPiece piece;
    PatchBounds bounds;
    for (std::size_t i = 0; i + 1 < us.size(); ++i)
        for (std::size_t j = 0; j + 1 < vs.size(); ++j)
        {
            pieces.cut(i, j, origin, piece);
            for (const Eigen::Vector3d &point : control_points(piece))
                bounds.point.extend((point + origin).eval());
            bounds.du.extend(derivative_box(piece, true, us[i + 1] - us[i]));
            bounds.dv.extend(derivative_box(piece, false, vs[j + 1] - vs[j]));
        }
    return bounds;
}

} // namespace

PatchBounds whole_bounds(const TensorSpline &spline)
{
    if (spline.rational)
        return whole_rational_bounds(spline);
    const int nu = spline.u.pole_count();
    const int nv = spline.v.pole_count();
    const auto pole = [&spline](int i, int j) -> Eigen::Vector3d { return spline.pole(i, j).head<3>(); };
    PatchBounds bounds;
    for (int i = 0; i < nu; ++i)
        for (int j = 0; j < nv; ++j)
        {
            const Eigen::Vector3d here = pole(i, j);
            bounds.point.extend(here);
            if (const double s = i > 0 ? slope(spline.u, i) : 0.0; s > 0.0)
                bounds.du.extend(((here - pole(i - 1, j)) * s).eval());
            if (const double s = j > 0 ? slope(spline.v, j) : 0.0; s > 0.0)
                bounds.dv.extend(((here - pole(i, j - 1)) * s).eval());
        }
    return bounds;
}

} // namespace laminate_offset
