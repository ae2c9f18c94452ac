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

} // namespace laminate_offset
