// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Clamped knot vectors and their basis functions (Piegl & Tiller, The NURBS Book, ch. 2).
#pragma once

#include <array>
#include <vector>

namespace laminate_offset
{

//! Highest degree that the numerics carry: OpenCASCADE's own limit.
inline constexpr int max_spline_degree = 25;

//! One distinct knot and how often it stands in the vector.
struct Knot
{
    double parameter = 0.0;
    int multiplicity = 1;
};

//! A clamped knot vector: first and last knot have multiplicity degree + 1.
struct KnotVector
{
    int degree = 3;
    std::vector<double> knots; //!< non-decreasing

    [[nodiscard]] int pole_count() const { return static_cast<int>(knots.size()) - degree - 1; }
    [[nodiscard]] double front() const { return knots.front(); }
    [[nodiscard]] double back() const { return knots.back(); }

    //! Index s with knots[s] <= u < knots[s+1]; u at or past the end belongs to the last span.
    [[nodiscard]] int span(double u) const;

    //! The distinct knots with their multiplicities.
    [[nodiscard]] std::vector<Knot> distinct() const;

    //! The distinct parameters only.
    [[nodiscard]] std::vector<double> breaks() const;

    //! The parameter to which each pole belongs: the mean of the degree knots inside its support (Greville).
    [[nodiscard]] std::vector<double> pole_parameters() const;
};

//! Clamped vector on [a, b] with the given interior knots (sorted, repeated as wanted).
KnotVector clamped_knots(int degree, double a, double b, const std::vector<double> &interior);

//! Two sorted lists of breaks as one; parameters closer than 1e-12 of the range count as equal.
std::vector<double> merged_breaks(const std::vector<double> &a, const std::vector<double> &b);

//! Values of the degree + 1 basis functions that do not vanish on span s, at u (NURBS Book A2.2).
void basis_values(const KnotVector &kv, int span, double u, double *values);

//! Derivatives 0..order of the same functions: out[k * (degree + 1) + i] (NURBS Book A2.3).
void basis_derivatives(const KnotVector &kv, int span, double u, int order, double *out);

//! The basis functions on one span, for many parameters: the divisors belong to the span, and dividing takes longer than
//! all the rest.
class SpanBasis
{
public:
    //! \param t points to the start of the span inside a knot vector, which has to stay.
    //! \param p the highest degree that is asked for.
    void reset(const double *t, int p);

    //! The q + 1 functions of degree q <= p that do not vanish on the span, at u.
    void values_of_degree(int q, double u, double *values) const;

    //! The same at `lanes` parameters at once (vector_kernels.h), a row of them each.
    void lane_values(int q, const double *u, double *rows) const;

    [[nodiscard]] const double *t() const { return m_t; }

private:
    const double *m_t = nullptr;
    std::array<double, max_spline_degree *(max_spline_degree + 1) / 2> m_inverses;
};

//! Basis functions tabulated at many parameters, as the rows of a banded matrix.
class BasisRows
{
public:
    //! \param order derivatives 0..order are tabulated.
    BasisRows(const KnotVector &kv, const std::vector<double> &parameters, int order = 0);

    //! The matrix of knot insertion: row r gives pole r over the `fine` knots from the poles over the `coarse`
    //! ones (Oslo algorithm, Cohen, Lyche & Riesenfeld 1980). Both of one degree and range; every knot of
    //! `coarse` stands in `fine` at least as often.
    static BasisRows insertion(const KnotVector &coarse, const KnotVector &fine);

    [[nodiscard]] int rows() const { return static_cast<int>(m_first.size()); }
    [[nodiscard]] int width() const { return m_width; }
    //! Index of the first pole that row r touches.
    [[nodiscard]] int first(int r) const { return m_first[static_cast<std::size_t>(r)]; }
    //! The width() coefficients of row r for one derivative order.
    [[nodiscard]] const double *row(int r, int derivative = 0) const
    {
        return m_values.data() + (static_cast<std::size_t>(r) * m_orders + derivative) * m_width;
    }

private:
    BasisRows() = default;

    int m_width = 0;
    int m_orders = 1;
    std::vector<int> m_first;
    std::vector<double> m_values;
};

} // namespace laminate_offset
