// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Bivariate polynomials in Bernstein form over the unit square: products, derivatives, bounds, halving.
//!
//! Coefficients are kept scaled by their binomials, c_ij C(m,i) C(n,j), so that a product is a plain
//! convolution (Farouki & Rajan 1988). The convex hull property then bounds a polynomial by its
//! coefficients. All operations are sums of products with positive weights, so their rounding stays
//! near one unit in the last place per operation of the largest coefficient.
#pragma once

#include "tensor_spline.h"

#include <array>
#include <vector>

namespace laminate_offset
{

inline constexpr int largest_bernstein_degree = 127;

//! Row n holds the binomial coefficients of n, or their inverses.
using BinomialTable = std::array<std::array<double, largest_bernstein_degree + 1>, largest_bernstein_degree + 1>;
extern const BinomialTable binomial_table;
extern const BinomialTable inverse_binomial_table;

//! Binomial coefficient; n up to largest_bernstein_degree.
inline double binomial(int n, int k)
{
    return binomial_table[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
}
inline double inverse_binomial(int n, int k)
{
    return inverse_binomial_table[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
}

//! A scalar polynomial of degree (m, n). Reassigning keeps the storage, so a workspace does not allocate.
class Bernstein
{
public:
    Bernstein() = default;
    Bernstein(int m, int n) { reset(m, n); }

    //! Becomes the zero polynomial of the given degree.
    void reset(int m, int n);

    [[nodiscard]] int degree_u() const { return m_m; }
    [[nodiscard]] int degree_v() const { return m_n; }
    [[nodiscard]] double &scaled(int i, int j) { return m_c[static_cast<std::size_t>(i * (m_n + 1) + j)]; }
    [[nodiscard]] double scaled(int i, int j) const { return m_c[static_cast<std::size_t>(i * (m_n + 1) + j)]; }
    //! The Bernstein coefficient itself.
    [[nodiscard]] double coefficient(int i, int j) const
    {
        return scaled(i, j) * (inverse_binomial(m_m, i) * inverse_binomial(m_n, j));
    }
    void set_coefficient(int i, int j, double value) { scaled(i, j) = value * binomial(m_m, i) * binomial(m_n, j); }

    //! this += factor * a * b; the degrees must add up.
    void add_product(double factor, const Bernstein &a, const Bernstein &b);
    //! this += factor * a, with a raised to this degree.
    void add_raised(double factor, const Bernstein &a);
    void scale(double factor);

    //! Derivatives with respect to the unit square's coordinates.
    void assign_derivative_u(const Bernstein &a);
    void assign_derivative_v(const Bernstein &a);

    //! Halves along u (or v): this becomes the half with the lower parameters, `upper` the other.
    void halve(bool along_u, Bernstein &upper);

    //! Divides by u, 1 - u, v or 1 - v. Precondition: the border row in question is zero.
    enum class Border
    {
        LowU,
        HighU,
        LowV,
        HighV
    };
    void divide(Border border);
    //! Largest absolute coefficient on a border row.
    [[nodiscard]] double border_size(Border border) const;

    struct Range
    {
        double low = 0.0;
        double high = 0.0;
        [[nodiscard]] double size() const;
    };
    //! Least and largest coefficient: an enclosure of the values.
    [[nodiscard]] Range range() const;
    //! Value at the centre of the square.
    [[nodiscard]] double centre() const;

private:
    int m_m = 0;
    int m_n = 0;
    std::vector<double> m_c;
};

//! A vector polynomial.
using Bernstein3 = std::array<Bernstein, 3>;

//! Longest coefficient vector: a bound of the length of the values.
double longest(const Bernstein3 &a);

//! The vector of the values at the centre of the square.
Eigen::Vector3d centre(const Bernstein3 &a);

//! out = a.b
void assign_dot(const Bernstein3 &a, const Bernstein3 &b, Bernstein &out);

//! out = a x b
void assign_cross(const Bernstein3 &a, const Bernstein3 &b, Bernstein3 &out);

//! out = a b
void assign_product(const Bernstein &a, const Bernstein &b, Bernstein &out);

//! Takes the p + 1 poles of one span, in place, to their Bernstein coefficients on [a, b] inside that span. De Boor's
//! algorithm at a leaves the blossoms with a repeated p - i times and the i knots after the span; the same at b on those
//! leaves the ones with a repeated p - i and b repeated i times.
//! \param t points to the start of the span inside a knot vector.
//! \param mix (s, i, j, k): pole k becomes (1 - s) times pole i plus s times pole j.
template <class Mix> void to_bernstein(const double *t, int p, double a, double b, const Mix &mix)
{
    for (int r = 1; r <= p; ++r)
        for (int k = 0; k <= p - r; ++k)
            mix((a - t[k + r - p]) / (t[k + 1] - t[k + r - p]), k, k + 1, k);
    for (int r = 1; r <= p; ++r)
        for (int k = p; k >= r; --k)
            mix((b - a) / (t[k + 1 - r] - a), k - 1, k, k);
}

//! The matrix that takes the degree + 1 poles of a span to Bernstein coefficients on [a, b] inside that
//! span: coefficient i is row i (blossom with a repeated degree - i and b repeated i times).
struct SpanExtraction
{
    double a = 0.0;
    double b = 1.0;
    int first = 0; //!< index of the first pole
    std::vector<double> matrix;
};

//! Extractions of every interval between consecutive breaks; each must lie in one span of the knots.
std::vector<SpanExtraction> extractions(const KnotVector &kv, const std::vector<double> &breaks);

} // namespace laminate_offset
