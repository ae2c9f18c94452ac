// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The loops in which products of polynomials and banded least squares spend their time, compiled for wide
//! registers. Rows lie one after the other, `count` numbers each; inputs and outputs do not overlap.
#pragma once

namespace laminate_offset
{

//! to += factor * from
void add_multiple(double factor, const double *from, double *to, int count);

//! Zeros that have to stand on both sides of `from` in add_convolution.
inline constexpr int convolution_margin = 15;

//! to[t] += the sum of factors(i, j) * from[t - i * width - j] over a matrix of factors, row by row, for t below `count`;
//! `from` has `run` numbers.
void add_convolution(const double *factors, int rows, int columns, int width, const double *from, int run, double *to,
                     int count);

//! Row i of `to` += factors[i] * from, for each of `rows` rows.
void add_outer_product(const double *factors, int rows, const double *from, double *to, int count);

//! to -= the sum of factors[i] * (row i of `from`) over `rows` rows.
void subtract_combination(const double *factors, int rows, const double *from, double *to, int count);

//! Parameters that the functions below take at once. What belongs to them lies in rows of `lanes` numbers.
inline constexpr int lanes = 8;

//! Rows 0 to q: the basis functions on one span of knots (SpanBasis) at the parameters u.
void span_basis(const double *t, const double *inverses, int q, const double *u, double *rows);

//! Rows x, y, z, w: the sum of s^i (1 - s)^(degree - i) times coefficient i of four numbers.
void bernstein_sum(const double *coefficients, int degree, const double *s, double *rows);

//! Rows x, y, z, w: the sum of basis_u[i] basis_v[j] times pole (i, j) of four numbers, i up to p and j up to q; poles of
//! one i follow each other, the next i is `step` numbers away.
void tensor_sum(const double *poles, int step, int p, int q, const double *basis_u, const double *basis_v,
                double *rows);

//! Rows x, y, z of points from the rows x, y, z, w of their numerators and weights; w counts where `rational`.
void without_weights(const double *sums, bool rational, double *rows);

} // namespace laminate_offset
