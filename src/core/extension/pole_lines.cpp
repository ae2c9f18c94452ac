// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pole_lines.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

// A cut this near to a knot, as a part of the range, is made at the knot: a shorter span would only carry rounding.
constexpr double knot_snap = 1e-10;
// A last leg below this part of its line's reach has no direction.
constexpr double shortest_leg = 1e-10;
// A line whose neighbours give it to this part of the extent is fixed by them; looser ones are creases.
constexpr double fixed_share = 1e-9;

int multiplicity(const KnotVector &kv, double t)
{
    return static_cast<int>(std::count(kv.knots.begin(), kv.knots.end(), t));
}

double at_knot(const KnotVector &kv, double t)
{
    const double near = knot_snap * (kv.back() - kv.front());
    for (const double knot : kv.knots)
        if (std::abs(knot - t) <= near)
            return knot;
    return t;
}

//! The same lines with t as often in the knots as the degree.
PoleLines with_full_knot(const PoleLines &lines, double t)
{
    const int missing = lines.knots.degree - multiplicity(lines.knots, t);
    if (missing <= 0)
        return lines;
    PoleLines fine = lines;
    auto &knots = fine.knots.knots;
    knots.insert(std::upper_bound(knots.begin(), knots.end(), t), static_cast<std::size_t>(missing), t);
    const BasisRows rows = BasisRows::insertion(lines.knots, fine.knots);
    for (std::size_t k = 0; k < lines.lines.size(); ++k)
    {
        PoleLine &line = fine.lines[k];
        line.assign(static_cast<std::size_t>(rows.rows()), Eigen::Vector4d::Zero());
        for (int r = 0; r < rows.rows(); ++r)
            for (int i = 0; i < rows.width(); ++i)
                if (const double factor = rows.row(r)[i]; factor != 0.0)
                    line[static_cast<std::size_t>(r)] +=
                        factor * lines.lines[k][static_cast<std::size_t>(rows.first(r) + i)];
    }
    return fine;
}

Eigen::Vector3d euclidean(const Eigen::Vector4d &pole) { return pole.head<3>() / pole.w(); }

Eigen::Vector4d homogeneous(const Eigen::Vector3d &point, double weight)
{
    return {weight * point.x(), weight * point.y(), weight * point.z(), weight};
}

//! Mean of w_{n-1} / w_n over the lines, large enough for positive weights.
double leg_ratio(const PoleLines &piece)
{
    double sum = 0.0;
    double largest = 0.0;
    for (const PoleLine &line : piece.lines)
    {
        const double ratio = line[line.size() - 2].w() / line.back().w();
        sum += ratio;
        largest = std::max(largest, ratio);
    }
    // Twice the mean minus any single ratio has to stay well above zero.
    return std::max(sum / static_cast<double>(piece.lines.size()), 0.6 * largest);
}

//! The mirror image of one line of the end piece, without its pole on the mirror plane.
std::optional<PoleLine> mirror_image(const PoleLine &line, double ratio)
{
    const std::size_t last = line.size() - 1;
    const Eigen::Vector3d join = euclidean(line[last]);
    const Eigen::Vector3d leg = join - euclidean(line[last - 1]);
    double reach = 0.0;
    for (const Eigen::Vector4d &pole : line)
        reach = std::max(reach, (euclidean(pole) - join).norm());
    if (!(leg.norm() > shortest_leg * reach) && reach > 0.0)
        return std::nullopt;
    const Eigen::Vector3d axis = leg.normalized(); // zero for a line that is one point, and stays it
    PoleLine image;
    image.emplace_back(2.0 * ratio * line[last] - line[last - 1]);
    for (std::size_t k = 2; k <= last; ++k)
    {
        const Eigen::Vector3d point = euclidean(line[last - k]);
        image.push_back(homogeneous(point - 2.0 * axis.dot(point - join) * axis, line[last - k].w()));
    }
    return image;
}

//! The shares of the two neighbours by least squares over all poles of the lines; nothing where they do not fit.
std::optional<FixedLine> fixed_by(const PoleLines &lines, std::size_t line, std::size_t before, std::size_t after)
{
    const PoleLine &own = lines.lines[line];
    const auto count = static_cast<Eigen::Index>(own.size());
    Eigen::MatrixX2d pair(4 * count, 2);
    Eigen::VectorXd right(4 * count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
        const auto k = static_cast<std::size_t>(i);
        pair.block<4, 2>(4 * i, 0) << lines.lines[before][k], lines.lines[after][k];
        right.segment<4>(4 * i) = own[k];
    }
    const double extent = right.lpNorm<Eigen::Infinity>();
    const Eigen::Vector2d share = pair.colPivHouseholderQr().solve(right);
    for (std::size_t i = 0; i < own.size(); ++i)
    {
        const Eigen::Vector4d miss = share[0] * lines.lines[before][i] + share[1] * lines.lines[after][i] - own[i];
        if (!(miss.norm() <= fixed_share * extent))
            return std::nullopt;
    }
    if (!(share.minCoeff() > 0.0))
        return std::nullopt;
    return FixedLine{line, before, after, share[0], share[1]};
}

void follow_neighbours(PoleLines &lines, std::size_t from, const std::vector<FixedLine> &fixed)
{
    for (const FixedLine &each : fixed)
        for (std::size_t i = from; i < lines.lines[each.line].size(); ++i)
            lines.lines[each.line][i] =
                each.before_share * lines.lines[each.before][i] + each.after_share * lines.lines[each.after][i];
}

std::optional<PoleLines> mirrored_once(const PoleLines &lines, double end, const std::vector<FixedLine> &fixed)
{
    const KnotVector &old = lines.knots;
    const double b = old.back();
    const double from = std::max(at_knot(old, b - (end - b)), old.front()); // eq. 3.2
    const PoleLines piece = cut_at_start(lines, from); // the knots of eq. 3.3 from the inserted one on
    const double ratio = leg_ratio(piece);
    PoleLines result = lines;
    for (std::size_t k = 0; k < lines.lines.size(); ++k)
    {
        const std::optional<PoleLine> image = mirror_image(piece.lines[k], lines.rational ? ratio : 1.0);
        if (!image)
            return std::nullopt;
        result.lines[k].insert(result.lines[k].end(), image->begin(), image->end());
    }
    // The first mirrored poles keep the relation by themselves: their rule is the same for every line.
    follow_neighbours(result, lines.lines.front().size() + 1, fixed);
    // eq. 3.4
    result.knots.knots.pop_back();
    for (std::size_t i = piece.knots.knots.size() - static_cast<std::size_t>(old.degree) - 1; i-- > 0;)
        result.knots.knots.push_back(2.0 * b - piece.knots.knots[i]);
    return result;
}

//! Value of the blossom of the last polynomial piece (de Boor's recursion with one argument for each step).
Eigen::Vector4d last_blossom(const PoleLine &line, const KnotVector &kv, const double *arguments)
{
    const int p = kv.degree;
    const int s = kv.pole_count() - 1; // the last span begins at knot s
    PoleLine d(line.end() - p - 1, line.end());
    for (int r = 1; r <= p; ++r)
        for (int k = p; k >= r; --k)
        {
            const double low = kv.knots[static_cast<std::size_t>(s - p + k)];
            const double high = kv.knots[static_cast<std::size_t>(s + 1 + k - r)];
            const double a = (arguments[r - 1] - low) / (high - low);
            d[static_cast<std::size_t>(k)] =
                (1.0 - a) * d[static_cast<std::size_t>(k - 1)] + a * d[static_cast<std::size_t>(k)];
        }
    return d.back();
}

} // namespace

PoleLines lines_of(const TensorSpline &surface, bool along_u)
{
    PoleLines result{along_u ? surface.u : surface.v, {}, surface.rational};
    const int lines = along_u ? surface.v.pole_count() : surface.u.pole_count();
    for (int k = 0; k < lines; ++k)
    {
        PoleLine line;
        for (int i = 0; i < result.knots.pole_count(); ++i)
            line.push_back(along_u ? surface.pole(i, k) : surface.pole(k, i));
        result.lines.push_back(std::move(line));
    }
    return result;
}

TensorSpline surface_of(const PoleLines &lines, const KnotVector &across, bool along_u)
{
    TensorSpline surface;
    surface.u = along_u ? lines.knots : across;
    surface.v = along_u ? across : lines.knots;
    surface.rational = lines.rational;
    for (std::size_t i = 0; i < static_cast<std::size_t>(surface.u.pole_count()); ++i)
        for (std::size_t j = 0; j < static_cast<std::size_t>(surface.v.pole_count()); ++j)
            surface.poles.push_back(along_u ? lines.lines[j][i] : lines.lines[i][j]);
    return surface;
}

PoleLines turned(const PoleLines &lines)
{
    PoleLines result = lines;
    std::reverse(result.knots.knots.begin(), result.knots.knots.end());
    for (double &knot : result.knots.knots)
        knot = -knot;
    for (PoleLine &line : result.lines)
        std::reverse(line.begin(), line.end());
    return result;
}

PoleLines cut_at_start(const PoleLines &lines, double start)
{
    const double t = at_knot(lines.knots, start);
    if (t <= lines.knots.front())
        return lines;
    PoleLines fine = with_full_knot(lines, t);
    auto &knots = fine.knots.knots;
    const auto first = std::lower_bound(knots.begin(), knots.end(), t);
    const auto dropped = first - knots.begin() - 1; // poles before the one that lies at t
    knots.erase(knots.begin(), first);
    knots.insert(knots.begin(), t);
    for (PoleLine &line : fine.lines)
        line.erase(line.begin(), line.begin() + dropped);
    return fine;
}

PoleLines cut_at_end(const PoleLines &lines, double end) { return turned(cut_at_start(turned(lines), -end)); }

std::vector<FixedLine> fixed_lines(const PoleLines &lines, const KnotVector &across)
{
    std::vector<FixedLine> fixed;
    if (across.degree < 2)
        return fixed;
    std::size_t index = 0; // of the line that lies at the knot
    for (const Knot &knot : across.distinct())
    {
        const bool inside = knot.parameter > across.front() && knot.parameter < across.back();
        if (inside)
            index += static_cast<std::size_t>(knot.multiplicity);
        if (inside && knot.multiplicity == across.degree)
            if (const auto line = fixed_by(lines, index, index - 1, index + 1))
                fixed.push_back(*line);
    }
    const std::size_t last = lines.lines.size() - 1;
    if (last < 3)
        return fixed;
    const auto start = fixed_by(lines, 0, 1, last - 1);
    const auto end = fixed_by(lines, last, 1, last - 1);
    if (start && end)
        fixed.insert(fixed.end(), {*start, *end});
    return fixed;
}

std::optional<PoleLines> mirrored_to(const PoleLines &lines, double end, const std::vector<FixedLine> &fixed)
{
    PoleLines result = lines;
    while (true)
    {
        const double reach = 2.0 * result.knots.back() - result.knots.front();
        const bool enough = reach >= end;
        const std::optional<PoleLines> longer = mirrored_once(result, enough ? end : reach, fixed);
        if (!longer || enough)
            return longer;
        result = *longer;
    }
}

std::optional<PoleLines> continued_to(const PoleLines &lines, double end)
{
    PoleLines result = lines;
    const int p = lines.knots.degree;
    const int n = lines.knots.pole_count() - 1;
    for (int k = 0; k <= p; ++k)
        result.knots.knots[static_cast<std::size_t>(n + 1 + k)] = end;
    for (std::size_t l = 0; l < lines.lines.size(); ++l)
        for (int i = n - p + 1; i <= n; ++i)
        {
            const Eigen::Vector4d pole =
                last_blossom(lines.lines[l], lines.knots, &result.knots.knots[static_cast<std::size_t>(i) + 1]);
            if (!(pole.w() > 0.0))
                return std::nullopt;
            result.lines[l][static_cast<std::size_t>(i)] = pole;
        }
    return result;
}

} // namespace laminate_offset
