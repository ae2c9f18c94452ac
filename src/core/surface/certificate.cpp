// SPDX-License-Identifier: LGPL-2.1-or-later
#include "certificate.h"

#include "../spline/piece_tangents.h"
#include "../spline/undo_rounding.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>

namespace laminate_offset
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unbounded = std::numeric_limits<double>::max(); // nothing known, though halving may help
constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Halvings of the scalar polynomials before the whole rectangle is halved and its frame renewed.
constexpr int scalar_depth = 6;
constexpr int geometric_depth = 24;
// Rectangles that one piece may be cut into. One that needs more waves about its target, or about a distance that is smaller
// still: a closer fit is proven sooner (34 s of proofs became 2 s).
constexpr int most_steps = 400;
// A border row of S_u x S_v this small against its largest coefficient is zero where the side vanishes by its poles.
constexpr double collapsed = 1e-11;
// Rounding: coefficients of a piece are sums of some 10 products each in extraction and subtraction, halved
// up to geometric_depth times with two roundings a degree; products of pieces are sums of some 100. The oracle
// tests compare with interval arithmetic. Matrices of an extraction take six roundings a degree, in both directions:
// the degrees that are usual leave room for that.
constexpr double extraction_operations = 160.0;
constexpr double roundings_per_degree = 8.0; // of a matrix and of the sums over it
constexpr int usual_degree = 8;
constexpr double operations_per_degree = 12.0;
constexpr double product_operations = 512.0;
constexpr double usual_terms = 64.0; // pieces of higher degrees than 7 have more

//! Something of the four sides of a rectangle, in the order of Bernstein::Border.
using Sides = std::array<bool, 4>;

constexpr Bernstein::Border borders[] = {Bernstein::Border::LowU, Bernstein::Border::HighU, Bernstein::Border::LowV,
                                         Bernstein::Border::HighV};

//! The pieces of base and offset on one rectangle, in coordinates relative to a near point.
struct Piece
{
    RationalPiece base;
    RationalPiece offset;      //!< its weight function is the base's, or 1
    bool shared_weight = true; //!< numerators stand over the same weight function
    double extent = 0.0;       //!< largest absolute coordinate before the shift, for the rounding bound
    double local = 0.0;        //!< longest coefficient of the base's numerator after it
    PieceReach reach;          //!< of the base's poles
    double poles = 0.0;        //!< largest coordinate of them all
    Sides vanishing{};         //!< where S_u x S_v is zero by the poles of a side of the base
    double weight_gap = 0.0;   //!< bound of the offset's own weight function minus the base's

    [[nodiscard]] const Bernstein &omega() const { return base.omega; }
};

struct Scalars
{
    Bernstein a; //!< W.W - d^2 omega^2
    Bernstein b; //!< W.T1, or the components of W x M in the general form
    Bernstein c;
    Bernstein third;  //!< general form only
    Bernstein square; //!< general form only: M.M
    Bernstein omega;

    void halve(bool along_u, Scalars &upper, bool general)
    {
        a.halve(along_u, upper.a);
        b.halve(along_u, upper.b);
        c.halve(along_u, upper.c);
        omega.halve(along_u, upper.omega);
        if (!general)
            return;
        third.halve(along_u, upper.third);
        square.halve(along_u, upper.square);
    }
};

using Corners = Eigen::Array22d; //!< u down, v across

//! The values at the corners of the rectangle.
Corners corners_of(const Bernstein &b)
{
    const int m = b.degree_u();
    const int n = b.degree_v();
    Corners result;
    result << b.coefficient(0, 0), b.coefficient(0, n), b.coefficient(m, 0), b.coefficient(m, n);
    return result;
}

//! Length of everything on one rectangle that does not change while its scalars are halved.
struct Frame
{
    double gram = 1.0;      //!< 1 / lambda_min of the Gram matrix of T1, T2
    double a_error = 0.0;   //!< rounding of a / omega^2 [mm^2]
    double b_error = 0.0;   //!< rounding of the tangential part [mm]
    int b_weight_power = 1; //!< power of omega that divides b and c
    double slope_u = 0.0;   //!< turn of T1, T2 or M for an error of 1 mm in the derivative by u [1/mm]
    double slope_v = 0.0;   //!< by v
    bool general = false;
};

//! What one part of a frame tells.
struct Leaf
{
    double bound = 0.0;     //!< of |O - (S + dN)|, if O lies on the same side of the surface as at the centre
    double any_side = 0.0;  //!< the same without knowing the side
    bool may_cross = false; //!< O may lie on the surface somewhere in this part
};

class PieceProver
{
public:
    explicit PieceProver(const CertificateRequest &request)
        : m_d(request.distance), m_target(request.target), m_operations(extraction_operations),
          m_base_operations(request.base_operations)
    {
        for (const TensorSpline *spline : {&request.base, &request.offset})
            for (const int degree : {spline->u.degree, spline->v.degree})
                m_operations += operations_per_degree * std::max(0, degree - usual_degree);
    }

    //! A bound over the piece: at most the target if that can be shown.
    double prove(Piece &piece)
    {
        m_steps = 0;
        return prove(piece, 0);
    }

private:
    double prove(Piece &piece, int depth)
    {
        m_depth = depth;
        double bound = try_frame(piece, false);
        if (bound > m_target)
            bound = std::min(bound, try_frame(piece, true));
        if (bound <= m_target || depth >= geometric_depth || ++m_steps > most_steps)
            return bound;
        const Corners corners = deviations();
        if (corners.maxCoeff() > m_target) // no proof can get below what is attained
            return bound;
        Piece upper = piece;
        const bool along_u = changes_more_along_u(piece.base.numerator);
        piece.base.halve(along_u, upper.base);
        piece.offset.halve(along_u, upper.offset);
        piece.vanishing[along_u ? 1 : 3] = upper.vanishing[along_u ? 0 : 2] = false; // where they meet
        // the worse half first: where the piece fails, that shows soonest
        if ((along_u ? corners.row(1).maxCoeff() > corners.row(0).maxCoeff()
                     : corners.col(1).maxCoeff() > corners.col(0).maxCoeff()))
            std::swap(piece, upper);
        const double first = prove(piece, depth + 1);
        if (first > m_target) // this half settles it; the bound of the whole still holds
            return bound;
        const double second = prove(upper, depth + 1);
        return second > m_target ? bound : std::max(first, second);
    }

    //! Does S_u x S_v change more along u than along v? Halving pays most across the sharper change: that of a twisted ribbon
    //! with straight rulings is along these, and no bend of its poles shows it.
    static bool changes_more_along_u(const Bernstein3 &p)
    {
        const double m = p[0].degree_u();
        const double n = p[0].degree_v();
        const double lu = m * longest_difference(p, 1, 0, 0, 0);
        const double lv = n * longest_difference(p, 0, 1, 0, 0);
        const double uv = m * n * longest_difference(p, 1, 0, 0, 1);
        const double along_u = m * (m - 1.0) * longest_difference(p, 1, 0, 1, 0) * lv + uv * lu;
        const double along_v = n * (n - 1.0) * longest_difference(p, 0, 1, 0, 1) * lu + uv * lv;
        return along_u != along_v ? along_u > along_v : lu >= lv;
    }

    //! The longest difference of coefficients by (ui, uj), of differences by (vi, vj) where that is a step.
    static double longest_difference(const Bernstein3 &p, int ui, int uj, int vi, int vj)
    {
        const bool second = vi + vj > 0;
        double longest = 0.0;
        for (int i = 0; i + ui + vi <= p[0].degree_u(); ++i)
            for (int j = 0; j + uj + vj <= p[0].degree_v(); ++j)
            {
                double square = 0.0;
                for (const Bernstein &c : p)
                {
                    double step = c.coefficient(i + ui, j + uj) - c.coefficient(i, j);
                    if (second)
                        step = c.coefficient(i + ui + vi, j + uj + vj) - c.coefficient(i + vi, j + vj) - step;
                    square += step * step;
                }
                longest = std::max(longest, square);
            }
        return std::sqrt(longest);
    }

    double try_frame(const Piece &piece, bool general)
    {
        difference(piece);
        m_tangents.assign(piece.base);
        const Bernstein::Range weights = piece.omega().range();
        if (weights.low <= 0.0)
            return infinity;
        Frame frame;
        frame.general = general;
        Scalars &scalars = m_scalars[0];
        const bool usable =
            general ? general_form(piece.vanishing, frame, scalars) : simple_form(piece, weights, frame, scalars);
        if (!usable)
            return infinity;
        square_of_difference(piece, scalars);
        scalars.omega = piece.omega();
        m_corner_weights = corners_of(piece.omega());
        rounding(piece, weights, frame);
        m_sign_holds = m_d == 0.0 || centre(m_w).dot(centre(m_tangents.normal())) * m_d > 0.0;
        return frame_bound(frame);
    }

    //! The deviation at the corners of the last frame's piece, u down and v across; 0 where there is no normal.
    [[nodiscard]] Corners deviations() const
    {
        const Bernstein3 &normals = m_tangents.normal();
        Corners w[3];
        Corners n[3];
        for (std::size_t e = 0; e < 3; ++e)
        {
            w[e] = corners_of(m_w[e]) / m_corner_weights;
            n[e] = corners_of(normals[e]);
        }
        const Corners length = (n[0].square() + n[1].square() + n[2].square()).sqrt();
        Corners square = Corners::Zero();
        for (std::size_t e = 0; e < 3; ++e)
            square += (w[e] - m_d * n[e] / length).square();
        return (length > 0.0).select(square.sqrt(), 0.0);
    }

    //! W = omega (O - S)
    void difference(const Piece &piece)
    {
        const bool product = !piece.shared_weight;
        for (int e = 0; e < 3; ++e)
        {
            const int m = std::max(piece.base.numerator[e].degree_u(),
                                   piece.offset.numerator[e].degree_u() + (product ? piece.omega().degree_u() : 0));
            const int n = std::max(piece.base.numerator[e].degree_v(),
                                   piece.offset.numerator[e].degree_v() + (product ? piece.omega().degree_v() : 0));
            m_w[e].reset(m, n);
            if (product)
            {
                assign_product(piece.offset.numerator[e], piece.omega(), m_temporary);
                m_w[e].add_raised(1.0, m_temporary);
            }
            else
                m_w[e].add_raised(1.0, piece.offset.numerator[e]);
            m_w[e].add_raised(-1.0, piece.base.numerator[e]);
        }
    }

    //! T1, T2 orthonormal at the centre, their Gram bound, and b = W.T1, c = W.T2.
    bool simple_form(const Piece &piece, const Bernstein::Range &weights, Frame &frame, Scalars &scalars)
    {
        const bool rational = piece.base.rational();
        m_tangents.find_tangents(piece.base);
        const Bernstein3 &qu = m_tangents.tangent_u();
        const Bernstein3 &qv = m_tangents.tangent_v();
        frame.b_weight_power = rational ? 3 : 1;
        const double at_centre = rational ? std::pow(piece.omega().centre(), 2) : 1.0;
        const Eigen::Vector3d cu = centre(qu) / at_centre;
        const Eigen::Vector3d cv = centre(qv) / at_centre;
        const double e = cu.squaredNorm();
        const double f = cu.dot(cv);
        const double g = cv.squaredNorm() - f * f / e;
        if (!(e > 0.0) || !(g > 1e-18 * cv.squaredNorm()))
            return false;
        combine(qu, qv, 1.0 / std::sqrt(e), 0.0, m_t1);
        combine(qu, qv, -f / e / std::sqrt(g), 1.0 / std::sqrt(g), m_t2);
        const double smallest_weight = rational ? weights.low * weights.low : 1.0;
        const double h1 = longest(m_t1) / smallest_weight;
        const double h2 = longest(m_t2) / smallest_weight;
        // |T1 x T2| >= (S_u x S_v) . n0 / sqrt(e g)
        m_tangents.assign_height(m_temporary);
        const double area = m_temporary.range().low / (rational ? std::pow(weights.high, 3) : 1.0) / std::sqrt(e * g);
        if (!(area > 1e-6))
            return false;
        const double trace = h1 * h1 + h2 * h2;
        const double largest = 0.5 * (trace + std::sqrt(std::max(0.0, trace * trace - 4.0 * area * area)));
        frame.gram = (1.0 + 1e-9) * largest / (area * area);
        frame.slope_u = (1.0 + std::abs(f) / std::sqrt(e * g)) / std::sqrt(e);
        frame.slope_v = 1.0 / std::sqrt(g);
        assign_dot(m_w, m_t1, scalars.b);
        assign_dot(m_w, m_t2, scalars.c);
        return true;
    }

    static void combine(const Bernstein3 &qu, const Bernstein3 &qv, double x, double y, Bernstein3 &out)
    {
        for (int e = 0; e < 3; ++e)
        {
            out[e].reset(std::max(qu[e].degree_u(), qv[e].degree_u()), std::max(qu[e].degree_v(), qv[e].degree_v()));
            if (x != 0.0)
                out[e].add_raised(x, qu[e]);
            if (y != 0.0)
                out[e].add_raised(y, qv[e]);
        }
    }

    //! W x M and M.M, where M is the normal with its zeros on borders divided out.
    bool general_form(const Sides &vanishing, Frame &frame, Scalars &scalars)
    {
        m_divided = m_tangents.normal();
        const double size = longest(m_divided);
        if (!(size > 0.0))
            return false;
        double growth = 1.0; // of an error: a coefficient is divided by (i + 1) / degree
        for (std::size_t side = 0; side < vanishing.size(); ++side)
            while (vanishing[side] && collapses(borders[side], size))
            {
                growth *= side < 2 ? m_divided[0].degree_u() : m_divided[0].degree_v();
                for (Bernstein &component : m_divided)
                    component.divide(borders[side]);
            }
        const double unit = 1.0 / longest(m_divided);
        frame.slope_u = growth * longest(m_tangents.derivative_v().numerator) * unit;
        frame.slope_v = growth * longest(m_tangents.derivative_u().numerator) * unit;
        for (Bernstein &component : m_divided)
            component.scale(unit);
        for (Bernstein *component : {&scalars.b, &scalars.c, &scalars.third})
            component->reset(m_w[0].degree_u() + m_divided[0].degree_u(), m_w[0].degree_v() + m_divided[0].degree_v());
        Bernstein *const out[3] = {&scalars.b, &scalars.c, &scalars.third};
        for (int e = 0; e < 3; ++e)
        {
            out[e]->add_product(1.0, m_w[(e + 1) % 3], m_divided[(e + 2) % 3]);
            out[e]->add_product(-1.0, m_w[(e + 2) % 3], m_divided[(e + 1) % 3]);
        }
        assign_dot(m_divided, m_divided, scalars.square);
        frame.b_weight_power = 1;
        frame.gram = 1.0;
        return true;
    }

    [[nodiscard]] bool collapses(Bernstein::Border border, double size) const
    {
        const bool along_u = border == Bernstein::Border::LowU || border == Bernstein::Border::HighU;
        if ((along_u ? m_divided[0].degree_u() : m_divided[0].degree_v()) == 0)
            return false;
        return std::all_of(m_divided.begin(), m_divided.end(),
                           [&](const Bernstein &b) { return b.border_size(border) <= collapsed * size; });
    }

    void square_of_difference(const Piece &piece, Scalars &scalars)
    {
        assign_dot(m_w, m_w, scalars.a);
        assign_product(piece.omega(), piece.omega(), m_temporary);
        scalars.a.add_raised(-m_d * m_d, m_temporary);
    }

    //! A-priori rounding of a and of the tangential part, and the weight functions' difference.
    void rounding(const Piece &piece, const Bernstein::Range &weights, Frame &frame) const
    {
        const double w = longest(m_w) / weights.low;
        const double size =
            std::max({longest(piece.base.numerator), longest(piece.offset.numerator), piece.extent}) / weights.low;
        const double w_error = (m_operations + m_base_operations) * epsilon * size * (weights.high / weights.low) +
                               piece.weight_gap * size / weights.low;
        const double ratio = weights.high / weights.low;
        const double products = product_operations * epsilon * std::max(1.0, terms(m_w[0]) / usual_terms);
        frame.a_error = 2.0 * w * w_error + w_error * w_error + products * (w * w + std::pow(m_d * ratio, 2));
        frame.b_error = w_error + w * (products + turn_of_rounding(piece, weights, frame));
    }

    //! Poles that nearly agree, on short pieces or under skewed parameters, leave little of their difference.
    [[nodiscard]] double turn_of_rounding(const Piece &piece, const Bernstein::Range &weights, const Frame &frame) const
    {
        const double p = piece.base.numerator[0].degree_u();
        const double q = piece.base.numerator[0].degree_v();
        if (piece.base.rational())
        {
            const double ratio = weights.high / weights.low;
            const double local = longest(piece.base.numerator) / weights.low + piece.extent;
            return (frame.slope_u + frame.slope_v) * 2.0 * std::max(p, q) * (m_operations + m_base_operations) *
                   epsilon * local * ratio * ratio;
        }
        // what a row has in common is added last and rounded once, and again in every halving
        const double last = (2.0 + 2.0 * std::max(p, q) * m_depth) * piece.local;
        const PieceReach &reach = piece.reach;
        const double extraction = roundings_per_degree * (p + q + 1.0);
        const double of_poles = std::sqrt(3.0) * m_base_operations * piece.poles;
        const double in_u = p * (2.0 * (last + extraction * reach.across_u) + reach.change_u * of_poles);
        const double in_v =
            q * (2.0 * (last + extraction * (reach.along_v + reach.across_u)) + reach.change_v * of_poles);
        return epsilon * (frame.slope_u * in_u + frame.slope_v * in_v);
    }

    //! Products of two coefficients that may add up in one of a product's.
    [[nodiscard]] static double terms(const Bernstein &b) { return (b.degree_u() + 1.0) * (b.degree_v() + 1.0); }

    //! Bound over a whole frame. The side of the surface on which O lies is known at the centre only: it holds
    //! elsewhere if no leaf lets O pass through the surface.
    double frame_bound(const Frame &frame)
    {
        const Leaf whole = bound(frame, 0);
        return m_sign_holds && whole.may_cross ? whole.any_side : whole.bound;
    }

    //! Bound over the current scalars, halving them while that helps.
    Leaf bound(const Frame &frame, int depth)
    {
        const Leaf here = leaf(frame, m_scalars[static_cast<std::size_t>(depth)]);
        if (here.bound <= m_target || depth >= scalar_depth || here.bound == infinity)
            return here;
        Scalars &lower = m_scalars[static_cast<std::size_t>(depth) + 1];
        lower = m_scalars[static_cast<std::size_t>(depth)];
        Scalars &upper = m_scalars[static_cast<std::size_t>(depth)];
        Scalars &spare = m_spare;
        lower.halve(depth % 2 == 0, spare, frame.general);
        std::swap(upper, spare);
        const Leaf first = bound(frame, depth + 1);
        if (first.bound > m_target)
            return either(first, here);
        lower = m_scalars[static_cast<std::size_t>(depth)];
        return either(first, bound(frame, depth + 1));
    }

    static Leaf either(const Leaf &a, const Leaf &b)
    {
        return {std::max(a.bound, b.bound), std::max(a.any_side, b.any_side), a.may_cross || b.may_cross};
    }

    [[nodiscard]] Leaf leaf(const Frame &frame, const Scalars &s) const
    {
        const Bernstein::Range omega = s.omega.range();
        if (omega.low <= 0.0)
            return {infinity, infinity, true};
        const Bernstein::Range a = s.a.range();
        const double low = a.low / std::pow(a.low < 0.0 ? omega.low : omega.high, 2) - frame.a_error;
        const double high = a.high / std::pow(a.high < 0.0 ? omega.high : omega.low, 2) + frame.a_error;
        const double weight = std::pow(omega.low, frame.b_weight_power);
        double tangential = 0.0;
        if (frame.general)
        {
            const double square = s.square.range().low;
            if (!(square > 1e-8))
                return {unbounded, unbounded, true}; // halving may still help
            tangential = std::sqrt(squares(s.b, s.c, s.third) / square) / weight + frame.b_error / std::sqrt(square);
        }
        else
            tangential =
                std::sqrt(frame.gram * (std::pow(s.b.range().size(), 2) + std::pow(s.c.range().size(), 2))) / weight +
                frame.b_error * std::sqrt(frame.gram);
        return combined(tangential, low, high);
    }

    //! Tangential and normal part together; low <= |w|^2 - d^2 <= high.
    [[nodiscard]] Leaf combined(double tangential, double low, double high) const
    {
        const double d = std::abs(m_d);
        const double least = low - tangential * tangential;
        const double most = std::sqrt(std::max(0.0, d * d + high));
        double normal = d + most;
        const bool keeps_side = d * d + least > 0.0;
        const double any_side = std::hypot(tangential, normal) * (1.0 + 8.0 * epsilon);
        if (m_sign_holds && keeps_side)
        {
            const double above = std::max(0.0, high) / (d + most);
            const double below = std::max(0.0, -least) / (d + std::sqrt(d * d + least));
            normal = std::max(above, below);
        }
        return {std::hypot(tangential, normal) * (1.0 + 8.0 * epsilon), any_side, !keeps_side};
    }

    static double squares(const Bernstein &x, const Bernstein &y, const Bernstein &z)
    {
        double largest = 0.0;
        for (int i = 0; i <= x.degree_u(); ++i)
            for (int j = 0; j <= x.degree_v(); ++j)
                largest = std::max(largest, std::pow(x.coefficient(i, j), 2) + std::pow(y.coefficient(i, j), 2) +
                                                std::pow(z.coefficient(i, j), 2));
        return largest;
    }

    double m_d;
    double m_target;
    double m_operations;
    double m_base_operations;
    bool m_sign_holds = true;
    int m_steps = 0;
    int m_depth = 0; //!< halvings of the rectangle that is being proven
    Corners m_corner_weights = Corners::Ones();
    PieceTangents m_tangents;
    Bernstein3 m_w, m_t1, m_t2, m_divided;
    Bernstein m_temporary;
    std::array<Scalars, scalar_depth + 2> m_scalars;
    Scalars m_spare;
};

//! Is a side of the spline a point, or does its derivative across vanish all along it? So the poles say themselves: what is
//! nearly so leaves normals that turn, and has to be proven like any other.
//! \param same [mm] coordinates that differ by no more are equal.
bool vanishes(const TensorSpline &spline, bool along_u, bool at_end, double same)
{
    const int rows = (along_u ? spline.v : spline.u).pole_count();
    const int count = (along_u ? spline.u : spline.v).pole_count();
    const auto point = [&](int row, int k) -> Eigen::Vector3d {
        const int at = at_end ? rows - 1 - row : row;
        const Eigen::Vector4d &pole = along_u ? spline.pole(k, at) : spline.pole(at, k);
        return pole.head<3>() / pole.w();
    };
    bool one_point = true;
    bool still = true;
    for (int k = 0; k < count && (one_point || still); ++k)
    {
        one_point = one_point && (point(0, k) - point(0, 0)).cwiseAbs().maxCoeff() <= same;
        still = still && (point(0, k) - point(1, k)).cwiseAbs().maxCoeff() <= same;
    }
    return one_point || still;
}

//! \param largest coordinate of the base.
Sides vanishing_sides(const TensorSpline &base, double largest)
{
    const double same = base.rational ? 8.0 * epsilon * largest : 0.0; // roundings of a quotient
    return {vanishes(base, false, false, same), vanishes(base, false, true, same), vanishes(base, true, false, same),
            vanishes(base, true, true, same)};
}

//! Cuts both splines along their merged knots.
class PairCutter
{
public:
    explicit PairCutter(const CertificateRequest &request)
        : m_rational_base(request.base.rational), m_rational_offset(request.offset.rational),
          m_poles(largest_coordinate(request.base)), m_vanishing(vanishing_sides(request.base, m_poles)),
          m_us(merged_breaks(request.base.u.breaks(), request.offset.u.breaks())),
          m_vs(merged_breaks(request.base.v.breaks(), request.offset.v.breaks())), m_base(request.base, m_us, m_vs),
          m_offset(request.offset, m_us, m_vs)
    {
    }

    [[nodiscard]] std::size_t count_u() const { return m_us.size() - 1; }
    [[nodiscard]] std::size_t count_v() const { return m_vs.size() - 1; }

    [[nodiscard]] ParameterBox box(std::size_t i, std::size_t j) const
    {
        return {m_us[i], m_us[i + 1], m_vs[j], m_vs[j + 1]};
    }

    void cut(std::size_t i, std::size_t j, Piece &piece)
    {
        const Eigen::Vector3d origin = m_base.near_point(i, j);
        piece.extent = origin.cwiseAbs().maxCoeff();
        piece.shared_weight = m_rational_offset || !m_rational_base;
        m_base.cut(i, j, origin, piece.base);
        piece.local = longest(piece.base.numerator);
        piece.reach = m_base.reach();
        piece.poles = m_poles;
        piece.vanishing = {m_vanishing[0] && i == 0, m_vanishing[1] && i + 1 == count_u(), m_vanishing[2] && j == 0,
                           m_vanishing[3] && j + 1 == count_v()};
        m_offset.cut(i, j, origin, piece.offset);
        piece.weight_gap = m_rational_offset ? gap(piece) : 0.0;
    }

private:
    [[nodiscard]] static double gap(const Piece &piece)
    {
        const Bernstein &base = piece.base.omega;
        const Bernstein &offset = piece.offset.omega;
        Bernstein difference(std::max(base.degree_u(), offset.degree_u()),
                             std::max(base.degree_v(), offset.degree_v()));
        difference.add_raised(1.0, offset);
        difference.add_raised(-1.0, base);
        return difference.range().size();
    }

    bool m_rational_base;
    bool m_rational_offset;
    double m_poles;
    Sides m_vanishing;
    std::vector<double> m_us;
    std::vector<double> m_vs;
    SplinePieces m_base;
    SplinePieces m_offset;
};

bool finite(const TensorSpline &spline)
{
    return std::all_of(spline.poles.begin(), spline.poles.end(),
                       [](const Eigen::Vector4d &pole) { return pole.allFinite(); });
}

} // namespace

Certificate certify(const CertificateRequest &request)
{
    if (!finite(request.base) || !finite(request.offset)) // comparisons would pass over what is no number
        return {infinity, false, {}};
    const PairCutter pattern(request);
    Certificate certificate;
    std::mutex guard;
    std::atomic<bool> ended = false;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pattern.count_u()), [&](const auto &range) {
        PairCutter cutter = pattern;
        PieceProver prover(request);
        Piece piece;
        double worst = 0.0;
        ParameterBox place;
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            for (std::size_t j = 0; j < cutter.count_v() && !ended; ++j)
            {
                if (request.needed && !request.needed(cutter.box(i, j)))
                    continue;
                cutter.cut(i, j, piece);
                const double bound = prover.prove(piece);
                if (bound > worst)
                {
                    worst = bound;
                    place = cutter.box(i, j);
                    ended = ended || (request.settle && bound > request.target);
                }
            }
        const std::lock_guard lock(guard);
        if (worst > certificate.bound)
        {
            certificate.bound = worst;
            certificate.worst = place;
        }
    });
    certificate.proven = certificate.bound <= request.target;
    if (ended || certificate.bound >= std::numeric_limits<double>::max())
        certificate.bound = infinity;
    return certificate;
}

} // namespace laminate_offset
