// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Integrals over the strips of a face: Gauss rules of 7 x 7 and 10 x 10 points, quartered until both agree.
#pragma once

#include "face_strips.h"

#include <Eigen/Core>
#include <tbb/parallel_for.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace laminate_offset
{

//! Nodes and weights on [0, 1].
struct GaussRule
{
    std::vector<double> nodes;
    std::vector<double> weights;
};

const GaussRule &coarse_rule(); //!< 7 points
const GaussRule &fine_rule();   //!< 10 points

//! Sums of several kinds, with the sizes that their errors are measured by.
template <int Kinds, int ValuesOfKind> struct StripIntegral
{
    using Sums = Eigen::Array<double, Kinds * ValuesOfKind, 1>;
    using Sizes = Eigen::Array<double, Kinds, 1>;

    Sums sums = Sums::Zero();
    Sizes sizes = Sizes::Zero();      //!< signed like the area
    Sums disagreement = Sums::Zero(); //!< of the two rules

    void add(const StripIntegral &other)
    {
        sums += other.sums;
        sizes += other.sizes;
        disagreement += other.disagreement;
    }
};

//! Adds up an integrand that has
//! - Integral: a StripIntegral,
//! - add_row(us, v, weights, integral): adds the values at places of one row, each with its du dv,
//! - relative(disagreement, sizes): the largest disagreement relative to its size.
template <class Integrand> class StripQuadrature
{
public:
    using Integral = typename Integrand::Integral;

    StripQuadrature(const Integrand &integrand, const std::vector<FaceStrip> &strips)
        : m_integrand(integrand), m_strips(strips)
    {
    }

    //! In parallel; the sum does not depend on the number of threads.
    [[nodiscard]] Integral sum() const
    {
        std::vector<Integral> parts(m_strips.size());
        tbb::parallel_for(std::size_t{0}, m_strips.size(),
                          [&](std::size_t i) { parts[i] = by_both_rules(m_strips[i], Box{}); });
        typename Integral::Sizes allowed = Integral::Sizes::Zero();
        for (const Integral &part : parts)
            allowed += part.sizes.abs() / static_cast<double>(parts.size());
        tbb::parallel_for(std::size_t{0}, m_strips.size(),
                          [&](std::size_t i) { parts[i] = refined(m_strips[i], parts[i], allowed); });
        Integral total;
        for (std::size_t i = 0; i < m_strips.size(); ++i)
        {
            parts[i].sums *= m_strips[i].sign;
            parts[i].sizes *= m_strips[i].sign;
            total.add(parts[i]);
        }
        return total;
    }

private:
    // Both rules have to agree to this part of the integral of the size.
    static constexpr double agreement = 1e-10;
    // A part of the face may also be off by its share of this much of the whole.
    static constexpr double whole_agreement = 1e-11;
    // Halvings of a part; past them its disagreement goes into the estimate.
    static constexpr int deepest = 8;

    //! A rectangle in the unit square of a strip.
    struct Box
    {
        double x0 = 0.0, x1 = 1.0, y0 = 0.0, y1 = 1.0;
        int depth = 0;
    };

    [[nodiscard]] Integral by_rule(const FaceStrip &strip, const Box &box, const GaussRule &rule) const
    {
        Integral result;
        std::vector<double> us(rule.nodes.size());
        std::vector<double> weights(rule.nodes.size());
        for (std::size_t j = 0; j < rule.nodes.size(); ++j)
        {
            const StripRow row = strip.row(box.y0 + (box.y1 - box.y0) * rule.nodes[j]);
            const double width = (row.right - row.left) * (box.x1 - box.x0);
            const double height = row.speed * (box.y1 - box.y0) * rule.weights[j];
            if (width == 0.0 || height == 0.0)
                continue;
            for (std::size_t i = 0; i < us.size(); ++i)
            {
                us[i] = row.left + (row.right - row.left) * (box.x0 + (box.x1 - box.x0) * rule.nodes[i]);
                weights[i] = width * height * rule.weights[i];
            }
            m_integrand.add_row(us, row.v, weights, result);
        }
        return result;
    }

    [[nodiscard]] Integral by_both_rules(const FaceStrip &strip, const Box &box) const
    {
        Integral fine = by_rule(strip, box, fine_rule());
        fine.disagreement = (fine.sums - by_rule(strip, box, coarse_rule()).sums).abs();
        return fine;
    }

    //! The quarters of a box, until both rules agree on each.
    [[nodiscard]] Integral refined(const FaceStrip &strip, const Integral &whole,
                                   const typename Integral::Sizes &allowed) const
    {
        Integral result;
        std::vector<std::pair<Box, Integral>> open{{Box{}, whole}};
        while (!open.empty())
        {
            const auto [box, value] = std::move(open.back());
            open.pop_back();
            if (box.depth >= deepest || m_integrand.relative(value.disagreement, value.sizes) <= agreement ||
                m_integrand.relative(value.disagreement, allowed) <= whole_agreement)
            {
                result.add(value);
                continue;
            }
            const double x = 0.5 * (box.x0 + box.x1);
            const double y = 0.5 * (box.y0 + box.y1);
            for (const Box &quarter : {Box{box.x0, x, box.y0, y, box.depth + 1},
                                       {x, box.x1, box.y0, y, box.depth + 1},
                                       {box.x0, x, y, box.y1, box.depth + 1},
                                       {x, box.x1, y, box.y1, box.depth + 1}})
                open.emplace_back(quarter, by_both_rules(strip, quarter));
        }
        return result;
    }

    const Integrand &m_integrand;
    const std::vector<FaceStrip> &m_strips;
};

template <class Integrand>
typename Integrand::Integral over_strips(const Integrand &integrand, const std::vector<FaceStrip> &strips)
{
    return StripQuadrature<Integrand>(integrand, strips).sum();
}

} // namespace laminate_offset
