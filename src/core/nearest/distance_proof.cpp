// SPDX-License-Identifier: LGPL-2.1-or-later
#include "distance_proof.h"

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

constexpr int deepest = 60;
// Coefficients round by about so much of the largest term.
constexpr double rounding = 1e-14;

//! h = |N - w P|^2 - m^2 w^2 on a rectangle of the patch, and w^2 where that is not 1.
struct Part
{
    Bernstein h;
    Bernstein weight;
    UnitBox box;
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

class Prover
{
public:
    Prover(const DistanceProof &proof, const std::function<double()> &reachable,
           const std::function<void(const LeafFoot &)> &offer)
        : m_proof(proof), m_reachable(reachable), m_offer(offer), m_level(reachable() * reachable())
    {
    }

    void run()
    {
        Part whole = whole_part();
        const Bernstein::Range range = whole.h.range();
        m_noise = rounding * (range.size() + m_level);
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
        part.h.add_raised(-m_level, part.weight);
        return part;
    }

    //! The level may have fallen since h was made, which lifts h by its change times w^2.
    [[nodiscard]] bool passed_over(const Part &part) const
    {
        const double reach = m_reachable();
        const double lift = (m_level - reach * reach) * part.weight.range().low;
        return part.h.range().low + lift >= -m_noise;
    }

    [[nodiscard]] bool one_minimum(const Part &part) const
    {
        if (!hessian(part, 0.0).positive())
            return false;
        return !m_proof.leaf.rational || hessian(part, m_level - m_proof.least * m_proof.least).positive();
    }

    void cover(Part part, int depth)
    {
        if (passed_over(part))
            return;
        const UnitBox &box = part.box;
        const bool alone = one_minimum(part);
        if (alone || depth % 4 == 3)
        {
            const LeafFoot foot =
                descend(m_proof.leaf, m_proof.p, box, 0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1), false, 0.0);
            m_offer(foot);
            if (alone || passed_over(part))
                return;
        }
        if (depth >= deepest)
            return;
        Part upper;
        const bool along_u = halves_along_u(part);
        part.h.halve(along_u, upper.h);
        part.weight.halve(along_u, upper.weight);
        upper.box = part.box;
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

    //! Along the direction in which h bends more.
    static bool halves_along_u(const Part &part)
    {
        const Hessian bends = hessian(part, 0.0);
        return bends.uu.size() >= bends.vv.size();
    }

    const DistanceProof &m_proof;
    const std::function<double()> &m_reachable;
    const std::function<void(const LeafFoot &)> &m_offer;
    double m_level;
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
