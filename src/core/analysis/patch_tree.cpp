// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patch_tree.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace laminate_offset
{
namespace
{

// Derivative boxes are widened by so much of their size for rounding.
constexpr double rounding = 1e-12;
// A leaf that is wider than the rectangle in question is halved down to this depth.
constexpr int deepest_for_bounds = 40;
// Pieces in each direction over which a rational surface is bounded whole, at the first attempt and at the second.
constexpr std::size_t few_parts = 2;
constexpr std::size_t many_parts = 8;

double width_u(const ParameterBox &box) { return box.umax - box.umin; }
double width_v(const ParameterBox &box) { return box.vmax - box.vmin; }

//! Control points of a piece: v runs along the rows.
struct ControlNet
{
    const Eigen::Vector4d *controls;
    int degree_u;
    int degree_v;

    [[nodiscard]] const Eigen::Vector4d &at(int i, int j) const { return controls[i * (degree_v + 1) + j]; }

    //! Poles of the homogeneous derivative with respect to the unit square's u or v.
    template <typename Visit> void visit_derivative(bool along_u, const Visit &visit) const
    {
        const double factor = along_u ? degree_u : degree_v;
        for (int i = 0; i + (along_u ? 1 : 0) <= degree_u; ++i)
            for (int j = 0; j + (along_u ? 0 : 1) <= degree_v; ++j)
                visit((factor * (at(along_u ? i + 1 : i, along_u ? j : j + 1) - at(i, j))).eval());
    }
};

Eigen::AlignedBox3d point_box(const ControlNet &net)
{
    Eigen::AlignedBox3d box;
    for (int k = 0; k < (net.degree_u + 1) * (net.degree_v + 1); ++k)
        box.extend((net.controls[k].head<3>() / net.controls[k].w()).eval());
    return box;
}

Eigen::AlignedBox3d polynomial_derivative_box(const ControlNet &net, bool along_u)
{
    Eigen::AlignedBox3d box;
    net.visit_derivative(along_u, [&](const Eigen::Vector4d &pole) { box.extend(pole.head<3>().eval()); });
    return box;
}

//! With S = N / w and any point c, S' = ((N - c w)' - (S - c) w') / w; S stays in the control points' box, c is its
//! centre.
Eigen::AlignedBox3d rational_derivative_box(const ControlNet &net, bool along_u, const Eigen::AlignedBox3d &points)
{
    const Eigen::Vector3d centre = points.center();
    Eigen::AlignedBox3d box;
    double slope = 0.0;
    net.visit_derivative(along_u, [&](const Eigen::Vector4d &pole) {
        box.extend((pole.head<3>() - pole.w() * centre).eval());
        slope = std::max(slope, std::abs(pole.w()));
    });
    double least = net.controls[0].w();
    double largest = least;
    for (int k = 1; k < (net.degree_u + 1) * (net.degree_v + 1); ++k)
    {
        least = std::min(least, net.controls[k].w());
        largest = std::max(largest, net.controls[k].w());
    }
    const Eigen::Vector3d spread = (0.5 + rounding) * slope * points.sizes();
    for (int e = 0; e < 3; ++e)
    {
        const double low = box.min()[e] - spread[e];
        const double high = box.max()[e] + spread[e];
        box.min()[e] = low / (low < 0.0 ? least : largest);
        box.max()[e] = high / (high < 0.0 ? largest : least);
    }
    return box;
}

PatchBounds bounds_of(const ControlNet &net, bool rational, const ParameterBox &box)
{
    PatchBounds bounds;
    bounds.point = point_box(net);
    const auto derivative = [&](bool along_u, double width) {
        Eigen::AlignedBox3d result =
            rational ? rational_derivative_box(net, along_u, bounds.point) : polynomial_derivative_box(net, along_u);
        result.min() /= width;
        result.max() /= width;
        return result;
    };
    bounds.du = derivative(true, width_u(box));
    bounds.dv = derivative(false, width_v(box));
    return bounds;
}

//! Halves one line of control points by de Casteljau's algorithm: the line becomes its lower half.
void halve_line(Eigen::Vector4d *low, Eigen::Vector4d *high, int degree, int stride)
{
    high[degree * stride] = low[degree * stride];
    for (int r = 1; r <= degree; ++r)
    {
        for (int k = degree; k >= r; --k)
            low[k * stride] = 0.5 * (low[(k - 1) * stride] + low[k * stride]);
        high[(degree - r) * stride] = low[degree * stride];
    }
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

PatchTree::PatchTree(const TensorSpline &spline)
    : PatchTree(spline, SplinePieces(spline, spline.u.breaks(), spline.v.breaks()).near_point(0, 0))
{
}

PatchTree::PatchTree(const TensorSpline &spline, const Eigen::Vector3d &origin)
    : m_us(spline.u.breaks()), m_vs(spline.v.breaks()), m_degree_u(spline.u.degree), m_degree_v(spline.v.degree),
      m_rational(spline.rational)
{
    SplinePieces pieces(spline, m_us, m_vs);
    build(pieces, origin, {0, m_us.size() - 1, 0, m_vs.size() - 1});
}

int PatchTree::build(SplinePieces &pieces, const Eigen::Vector3d &origin, const std::array<std::size_t, 4> &range)
{
    const auto [i0, i1, j0, j1] = range;
    const ParameterBox box{m_us[i0], m_us[i1], m_vs[j0], m_vs[j1]};
    if (i1 - i0 == 1 && j1 - j0 == 1)
    {
        const std::size_t first = m_controls.size();
        pieces.append_controls(i0, j0, origin, m_controls);
        return add_piece(box, 0, first);
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

int PatchTree::add_piece(const ParameterBox &box, int halvings, std::size_t first)
{
    const int index = static_cast<int>(m_nodes.size());
    PatchNode &node = m_nodes.emplace_back();
    node.box = box;
    node.halvings = halvings;
    node.first = first;
    node.bounds = bounds_of({&m_controls[first], m_degree_u, m_degree_v}, m_rational, box);
    return index;
}

void PatchTree::split(int index)
{
    const PatchNode &parent = node(index);
    if (parent.lower >= 0)
        return;
    const PatchBounds &bounds = parent.bounds;
    halve(index, bounds.du.center().norm() * width_u(parent.box) >= bounds.dv.center().norm() * width_v(parent.box));
}

void PatchTree::split_where_it_bends(int index)
{
    if (node(index).lower < 0)
        halve(index, bends_along_u(node(index)));
}

//! Compares second differences of the control points, each over the length of the first derivative that they change.
bool PatchTree::bends_along_u(const PatchNode &piece) const
{
    const double length_u = std::max(piece.bounds.du.center().norm() * width_u(piece.box), 1e-300);
    const double length_v = std::max(piece.bounds.dv.center().norm() * width_v(piece.box), 1e-300);
    double uu = 0.0;
    double vv = 0.0;
    for (int i = 0; i <= m_degree_u; ++i)
        for (int j = 0; j <= m_degree_v; ++j)
        {
            const Eigen::Vector3d here = point(piece, i, j);
            if (i > 1)
                uu = std::max(uu, (point(piece, i - 2, j) - 2.0 * point(piece, i - 1, j) + here).squaredNorm());
            if (j > 1)
                vv = std::max(vv, (point(piece, i, j - 2) - 2.0 * point(piece, i, j - 1) + here).squaredNorm());
        }
    return std::sqrt(uu) * m_degree_u * std::max(0, m_degree_u - 1) / length_u >=
           std::sqrt(vv) * m_degree_v * std::max(0, m_degree_v - 1) / length_v;
}

void PatchTree::halve(int index, bool along_u)
{
    const PatchNode &parent = node(index);
    const std::size_t size = static_cast<std::size_t>((m_degree_u + 1) * (m_degree_v + 1));
    const std::size_t first = m_controls.size();
    m_controls.resize(first + 2 * size);
    Eigen::Vector4d *low = &m_controls[first];
    std::copy_n(&m_controls[parent.first], size, low);
    const int line_step = along_u ? 1 : m_degree_v + 1;
    for (int line = 0; line <= (along_u ? m_degree_v : m_degree_u); ++line)
        halve_line(low + line * line_step, low + size + line * line_step, along_u ? m_degree_u : m_degree_v,
                   along_u ? m_degree_v + 1 : 1);
    ParameterBox low_box = parent.box;
    ParameterBox high_box = parent.box;
    if (along_u)
        low_box.umax = high_box.umin = 0.5 * (parent.box.umin + parent.box.umax);
    else
        low_box.vmax = high_box.vmin = 0.5 * (parent.box.vmin + parent.box.vmax);
    const int halvings = parent.halvings + 1;
    const int lower = add_piece(low_box, halvings, first);
    const int upper = add_piece(high_box, halvings, first + size);
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
    const double long_u = width_u(n.box) / width_u(box);
    const double long_v = width_v(n.box) / width_v(box);
    const bool coarse = std::max(long_u, long_v) > 1.0;
    if (holds(box, n.box) || (n.lower < 0 && (!coarse || n.halvings >= deepest_for_bounds)))
    {
        bounds.extend(n.bounds);
        return;
    }
    if (n.lower < 0)
        halve(index, long_u >= long_v); // nodes stay where they are
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
PatchBounds whole_rational_bounds(const TensorSpline &spline, std::size_t parts, const Eigen::Matrix3d &axes)
{
    const std::vector<double> us = subdivided(spline.u.breaks(), parts);
    const std::vector<double> vs = subdivided(spline.v.breaks(), parts);
    SplinePieces pieces(spline, us, vs);
    const Eigen::Vector3d origin = pieces.near_point(0, 0);
    std::vector<Eigen::Vector4d> controls;
    PatchBounds bounds;
    for (std::size_t i = 0; i + 1 < us.size(); ++i)
        for (std::size_t j = 0; j + 1 < vs.size(); ++j)
        {
            controls.clear();
            pieces.append_controls(i, j, origin, controls);
            for (Eigen::Vector4d &control : controls)
                control.head<3>() = (axes * control.head<3>()).eval();
            bounds.extend(bounds_of({controls.data(), spline.u.degree, spline.v.degree}, true,
                                    {us[i], us[i + 1], vs[j], vs[j + 1]}));
        }
    bounds.point.translate((axes * origin).eval());
    return bounds;
}

//! Rows are an orthonormal frame along the middle derivatives, in which boxes are tight; nothing where these are
//! parallel.
std::optional<Eigen::Matrix3d> frame_along(const PatchBounds &bounds)
{
    const Eigen::Vector3d u = bounds.du.center();
    const Eigen::Vector3d normal = u.cross(bounds.dv.center());
    if (!(normal.norm() > rounding * u.norm() * bounds.dv.center().norm()))
        return std::nullopt;
    Eigen::Matrix3d frame;
    frame.row(0) = u.normalized().transpose();
    frame.row(2) = normal.normalized().transpose();
    frame.row(1) = frame.row(2).cross(frame.row(0));
    return frame;
}

} // namespace

bool one_to_one_whole(const TensorSpline &spline)
{
    const PatchBounds first = whole_bounds(spline, few_parts);
    if (first.one_to_one())
        return true;
    const std::optional<Eigen::Matrix3d> frame = frame_along(first);
    return frame && whole_bounds(spline, many_parts, *frame).one_to_one();
}

PatchBounds whole_bounds(const TensorSpline &spline, std::size_t parts, const Eigen::Matrix3d &axes)
{
    if (spline.rational)
        return whole_rational_bounds(spline, parts, axes);
    const int nu = spline.u.pole_count();
    const int nv = spline.v.pole_count();
    const auto pole = [&spline](int i, int j) -> Eigen::Vector3d { return spline.pole(i, j).head<3>(); };
    PatchBounds bounds;
    for (int i = 0; i < nu; ++i)
        for (int j = 0; j < nv; ++j)
        {
            const Eigen::Vector3d here = pole(i, j);
            bounds.point.extend((axes * here).eval());
            // differences first: they are nearly exact
            if (const double s = i > 0 ? slope(spline.u, i) : 0.0; s > 0.0)
                bounds.du.extend((axes * (s * (here - pole(i - 1, j)))).eval());
            if (const double s = j > 0 ? slope(spline.v, j) : 0.0; s > 0.0)
                bounds.dv.extend((axes * (s * (here - pole(i, j - 1)))).eval());
        }
    return bounds;
}

} // namespace laminate_offset
