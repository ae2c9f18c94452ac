// SPDX-License-Identifier: LGPL-2.1-or-later
#include "distance_proof.h"

#include "valley_bound.h"

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

constexpr int deepest = 60;
// Coefficients round by about so much of the largest term.
constexpr double rounding = 1e-14;
// Fewer halvings settle most parts; a bound along a valley costs more than such a halving.
constexpr int valley_depth = 5;
// A second derivative above so many times the coefficients' rounding is positive.
constexpr double sure_curvature = 1e3;

//! h = |N - w P|^2 - m^2 w^2 on a rectangle of the patch, and w^2 where that is not 1.
struct Part
{
    Bernstein h;
    Bernstein weight;
    UnitBox box;
    double level = 0.0; //!< m^2
};

//! Second differences of the coefficients: bounds of the second derivatives up to a common factor.
struct Hessian
{
    Bernstein::Range uu{0.0, 0.0};
    Bernstein::Range uv{0.0, 0.0};
    Bernstein::Range vv{0.0, 0.0};

    [[nodiscard]] bool positive() const
    {
        const double mixed = uv.size();
        return uu.low > 0.0 && vv.low > 0.0 && uu.low * vv.low > mixed * mixed;
    }
};

void widen(Bernstein::Range &range, double value, bool first)
{
    range.low = first ? value : std::min(range.low, value);
    range.high = first ? value : std::max(range.high, value);
}

//! Of h + factor * weight.
Hessian hessian(const Part &part, double factor)
{
    const int m = part.h.degree_u();
    const int n = part.h.degree_v();
    static thread_local std::vector<double> c;
    c.resize(static_cast<std::size_t>((m + 1) * (n + 1)));
    const auto at = [&](int i, int j) -> double & { return c[static_cast<std::size_t>(i * (n + 1) + j)]; };
    for (int i = 0; i <= m; ++i)
        for (int j = 0; j <= n; ++j)
            at(i, j) = part.h.coefficient(i, j) + (factor != 0.0 ? factor * part.weight.coefficient(i, j) : 0.0);
    Hessian result;
    const double fu = m * (m - 1.0);
    const double fv = n * (n - 1.0);
    const double fm = static_cast<double>(m) * n;
    for (int i = 0; i <= m; ++i)
        for (int j = 0; j <= n; ++j)
        {
            if (i + 2 <= m)
                widen(result.uu, fu * (at(i + 2, j) - 2.0 * at(i + 1, j) + at(i, j)), i + j == 0);
            if (j + 2 <= n)
                widen(result.vv, fv * (at(i, j + 2) - 2.0 * at(i, j + 1) + at(i, j)), i + j == 0);
            if (i < m && j < n)
                widen(result.uv, fm * (at(i + 1, j + 1) - at(i + 1, j) - at(i, j + 1) + at(i, j)), i + j == 0);
        }
    return result;
}

//! A polynomial on a side of the square, constant in the other direction.
Bernstein side_of(const Bernstein &h, bool along_u, bool high)
{
    const int m = h.degree_u();
    const int n = h.degree_v();
    Bernstein side(along_u ? 0 : m, along_u ? n : 0);
    for (int i = 0; i <= side.degree_u(); ++i)
        for (int j = 0; j <= side.degree_v(); ++j)
            side.set_coefficient(i, j, h.coefficient(along_u ? (high ? m : 0) : i, along_u ? j : (high ? n : 0)));
    return side;
}

class Prover
{
public:
    Prover(const DistanceProof &proof, const std::function<double()> &reachable,
           const std::function<void(const LeafFoot &)> &offer)
        : m_proof(proof), m_reachable(reachable), m_offer(offer)
    {
    }

    void run()
    {
        Part whole = whole_part();
        const Bernstein::Range range = whole.h.range();
        const int degree = std::max(whole.h.degree_u(), whole.h.degree_v());
        m_noise = std::max(rounding, valley_rounding(degree)) * (range.size() + whole.level);
        cover(std::move(whole), 0);
    }

private:
    [[nodiscard]] Part whole_part() const
    {
        const PatchLeaf &leaf = m_proof.leaf;
        Part part;
        part.h.reset(2 * leaf.degree_u, 2 * leaf.degree_v);
        Bernstein shifted;
        for (int e = 0; e < 3; ++e)
        {
            shifted = leaf.piece.numerator[static_cast<std::size_t>(e)];
            shifted.add_raised(-m_proof.p[e], leaf.piece.omega);
            part.h.add_product(1.0, shifted, shifted);
        }
        part.weight.reset(leaf.rational ? 2 * leaf.degree_u : 0, leaf.rational ? 2 * leaf.degree_v : 0);
        part.weight.add_product(1.0, leaf.piece.omega, leaf.piece.omega);
        part.level = m_reachable() * m_reachable();
        part.h.add_raised(-part.level, part.weight);
        return part;
    }

    //! The best distance may have fallen since h was made.
    void bring_up_to_date(Part &part) const
    {
        const double reach = m_reachable();
        const double level = reach * reach;
        if (level < part.level)
            part.h.add_raised(part.level - level, part.weight);
        part.level = level;
    }

    [[nodiscard]] bool passed_over(const Part &part) const { return part.h.range().low >= -m_noise; }

    [[nodiscard]] bool out_of_region(const Part &part) const { return m_proof.touches && !m_proof.touches(part.box); }

    [[nodiscard]] bool one_minimum(const Part &part, const Hessian &bends) const
    {
        if (!bends.positive())
            return false;
        return !m_proof.leaf.rational || hessian(part, part.level - m_proof.least * m_proof.least).positive();
    }

    //! 1 where the distance grows along u (v) all over the part, -1 where it falls, 0 where neither is known. It has the slope
    //! of |N - w P|^2 - c^2 w^2 wherever it is c.
    [[nodiscard]] int trend(const Part &part, bool along_u) const
    {
        const double sure = sure_curvature * m_noise;
        const auto sign = [&](const Bernstein &h) {
            Bernstein slope;
            along_u ? slope.assign_derivative_u(h) : slope.assign_derivative_v(h);
            const Bernstein::Range range = slope.range();
            return range.low > sure ? 1 : range.high < -sure ? -1 : 0;
        };
        const int way = sign(part.h);
        if (way == 0 || !m_proof.leaf.rational)
            return way;
        Bernstein lowest = part.h;
        lowest.add_raised(part.level - m_proof.least * m_proof.least, part.weight);
        return sign(lowest) == way ? way : 0;
    }

    //! Takes the part to the side or corner of the patch where alone it can have a minimum. False where it has none: the
    //! distance falls towards a neighbour inside of the patch.
    [[nodiscard]] bool narrowed(Part &part) const
    {
        for (const bool along_u : {true, false})
        {
            const int way = trend(part, along_u);
            if (way == 0)
                continue;
            UnitBox &box = part.box;
            const double side = along_u ? (way > 0 ? box.x0 : box.x1) : (way > 0 ? box.y0 : box.y1);
            if (side > 0.0 && side < 1.0)
                return false;
            part.h = side_of(part.h, along_u, way < 0);
            part.weight = side_of(part.weight, along_u, way < 0);
            (along_u ? box.x0 : box.y0) = (along_u ? box.x1 : box.y1) = side;
        }
        return true;
    }

    void cover(Part part, int depth)
    {
        bring_up_to_date(part);
        if (passed_over(part) || out_of_region(part) || (m_proof.touches && !narrowed(part)))
            return;
        const UnitBox &box = part.box;
        const Hessian bends = hessian(part, 0.0);
        const bool corner = box.x0 == box.x1 && box.y0 == box.y1;
        const bool alone = corner || one_minimum(part, bends);
        if (alone || depth % 4 == 3)
        {
            const LeafFoot foot =
                descend(m_proof.leaf, m_proof.p, box, 0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1), false, 0.0);
            m_offer(foot);
            bring_up_to_date(part);
            if (alone || passed_over(part))
                return;
        }
        const bool across_v = bends.vv.low * bends.uu.size() >= bends.uu.low * bends.vv.size();
        const double curvature = across_v ? bends.vv.low : bends.uu.low;
        const bool valley = depth >= valley_depth && curvature > sure_curvature * m_noise;
        if (depth >= deepest || (valley && valley_is_above(part.h, m_noise, across_v, curvature)))
            return;
        Part upper;
        const bool along_valley = valley && !(m_proof.touches && depth % 2 == 1); // a region may lie beside it
        const bool wanted = along_valley ? across_v : bends.uu.size() >= bends.vv.size();
        const bool along_u = box.y0 == box.y1 || (wanted && box.x0 < box.x1);
        part.h.halve(along_u, upper.h);
        part.weight.halve(along_u, upper.weight);
        upper.box = part.box;
        upper.level = part.level;
        if (along_u)
            part.box.x1 = upper.box.x0 = 0.5 * (box.x0 + box.x1);
        else
            part.box.y1 = upper.box.y0 = 0.5 * (box.y0 + box.y1);
        const bool lower_first = part.h.range().low <= upper.h.range().low;
        if (!lower_first)
            std::swap(part, upper);
        cover(std::move(part), depth + 1);
        cover(std::move(upper), depth + 1);
    }

    const DistanceProof &m_proof;
    const std::function<double()> &m_reachable;
    const std::function<void(const LeafFoot &)> &m_offer;
    double m_noise = 0.0;
};

} // namespace

void prove_distance(const DistanceProof &proof, const std::function<double()> &reachable,
                    const std::function<void(const LeafFoot &)> &offer)
{
    if (proof.leaf.degree_u > 0 && proof.leaf.degree_v > 0)
        Prover(proof, reachable, offer).run();
}

} // namespace laminate_offset
