// SPDX-License-Identifier: LGPL-2.1-or-later
#include "descent.h"

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

constexpr int most_steps = 60;
constexpr int most_halvings = 12;
// A Newton step below this part of the patch is right even where the distance is too round to tell, and one below the
// second leaves an error of its square.
constexpr double sure_newton_step = 1e-6;
constexpr double last_newton_step = 1e-9;
constexpr double noise = 1e-14;
constexpr double small_step = 1e-15;
constexpr double definite = 1e-12;

//! Half the squared distance from p at a place with its derivatives.
struct Slope
{
    LeafJet jet;
    Eigen::Vector3d r;
    double square = 0.0;
    double f = 0.0; //!< (S - P).S_u, eq. 3.14a
    double g = 0.0; //!< (S - P).S_v, eq. 3.14b
};

Slope slope_at(const PatchLeaf &leaf, const Eigen::Vector3d &p, double x, double y)
{
    Slope slope{leaf.jet(x, y), {}, 0.0, 0.0, 0.0};
    slope.r = slope.jet.s - p;
    slope.square = slope.r.squaredNorm();
    slope.f = slope.r.dot(slope.jet.u);
    slope.g = slope.r.dot(slope.jet.v);
    return slope;
}

struct Step
{
    double x = 0.0;
    double y = 0.0;
    bool newton = true;
};

//! Newton's step in the free directions, Gauss and Newton's where the Hessian is not positive.
Step step_from(const Slope &at, bool free_x, bool free_y)
{
    const double e = at.jet.u.squaredNorm();
    const double m = at.jet.u.dot(at.jet.v);
    const double n = at.jet.v.squaredNorm();
    const double a = e + at.r.dot(at.jet.uu);
    const double b = m + at.r.dot(at.jet.uv);
    const double c = n + at.r.dot(at.jet.vv);
    if (free_x && free_y)
    {
        if (const double det = a * c - b * b; a > 0.0 && det > definite * std::max(e * n, a * c))
            return {(b * at.g - c * at.f) / det, (b * at.f - a * at.g) / det, true};
        if (const double det = e * n - m * m; det > definite * e * n)
            return {(m * at.g - n * at.f) / det, (m * at.f - e * at.g) / det, false};
        return {e > 0.0 ? -0.5 * at.f / e : 0.0, n > 0.0 ? -0.5 * at.g / n : 0.0, false};
    }
    if (free_x)
        return a > definite * e ? Step{-at.f / a, 0.0, true} : Step{e > 0.0 ? -at.f / e : 0.0, 0.0, false};
    return c > definite * n ? Step{0.0, -at.g / c, true} : Step{0.0, n > 0.0 ? -at.g / n : 0.0, false};
}

struct Place
{
    double x;
    double y;
};

//! Takes the longest part of a step that leads downhill, or uphill by less than `admissible`; false where none does.
bool go(const PatchLeaf &leaf, const Eigen::Vector3d &p, const UnitBox &box, const Step &step, int halvings,
        double admissible, Place &at, Slope &here)
{
    double part = 1.0;
    for (int halving = 0; halving < halvings; ++halving, part *= 0.5)
    {
        const double x = std::clamp(at.x + part * step.x, box.x0, box.x1);
        const double y = std::clamp(at.y + part * step.y, box.y0, box.y1);
        if (x == at.x && y == at.y)
            return false;
        const Slope there = slope_at(leaf, p, x, y);
        if (!(there.square < here.square + admissible))
            continue;
        here = there;
        at.x = x;
        at.y = y;
        return true;
    }
    return false;
}

//! What a convex function can be at least over the rectangle, from its tangent plane.
double least_by_tangent(const Slope &at, const UnitBox &box, double x, double y)
{
    const double along_x = at.f * ((at.f > 0.0 ? box.x0 : box.x1) - x);
    const double along_y = at.g * ((at.g > 0.0 ? box.y0 : box.y1) - y);
    return at.square + 2.0 * (along_x + along_y);
}

} // namespace

LeafFoot descend(const PatchLeaf &leaf, const Eigen::Vector3d &p, const UnitBox &box, double x, double y, bool convex,
                 double limit)
{
    Place at{std::clamp(x, box.x0, box.x1), std::clamp(y, box.y0, box.y1)};
    Slope here = slope_at(leaf, p, at.x, at.y);
    for (int count = 0; count < most_steps; ++count)
    {
        if (convex && least_by_tangent(here, box, at.x, at.y) >= limit)
            break;
        const bool free_x = !((at.x <= box.x0 && here.f >= 0.0) || (at.x >= box.x1 && here.f <= 0.0));
        const bool free_y = !((at.y <= box.y0 && here.g >= 0.0) || (at.y >= box.y1 && here.g <= 0.0));
        if (!free_x && !free_y)
            break;
        const Place before = at;
        Step step = step_from(here, free_x, free_y);
        if (const double size = std::max(std::abs(step.x), std::abs(step.y)); step.newton && size < sure_newton_step)
        {
            if (!go(leaf, p, box, step, 1, noise * here.square, at, here) || size < last_newton_step)
                break;
            continue;
        }
        bool lower = go(leaf, p, box, step, most_halvings, 0.0, at, here);
        if (!lower && free_x && free_y) // the border may bend a step uphill: along one side only, then
        {
            step = step_from(here, std::abs(here.f) > std::abs(here.g), std::abs(here.f) <= std::abs(here.g));
            lower = go(leaf, p, box, step, most_halvings, 0.0, at, here);
        }
        const double moved = std::max(std::abs(at.x - before.x), std::abs(at.y - before.y));
        if (!lower || moved < small_step)
            break;
    }
    return {at.x, at.y, here.jet.s, here.square, least_by_tangent(here, box, at.x, at.y)};
}

} // namespace laminate_offset
