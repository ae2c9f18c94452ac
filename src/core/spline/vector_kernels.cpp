// SPDX-License-Identifier: LGPL-2.1-or-later
#include "vector_kernels.h"

#include <algorithm>

// Compiled for wide registers too; the loader picks what the machine has. Fused multiply-add is left out, so that
// all machines round alike. Sanitizers come too late for functions that are picked by the loader.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) &&                           \
    !defined(__SANITIZE_ADDRESS__)
    #define LAMINATE_OFFSET_VECTORISED __attribute__((target_clones("avx2", "default")))
#else
    #define LAMINATE_OFFSET_VECTORISED
#endif

namespace laminate_offset
{

LAMINATE_OFFSET_VECTORISED
void add_multiple(double factor, const double *__restrict from, double *__restrict to, int count)
{
    for (int k = 0; k < count; ++k)
        to[k] += factor * from[k];
}

// Spelled out, since compilers would turn the loops of add_convolution round.
using Four = double __attribute__((vector_size(4 * sizeof(double)), aligned(sizeof(double)), may_alias));

// A block of sums stays in registers until it is complete.
LAMINATE_OFFSET_VECTORISED
void add_convolution(const double *__restrict factors, int rows, int columns, int width, const double *__restrict from,
                     int run, double *__restrict to, int count)
{
    constexpr int block = convolution_margin + 1;
    static_assert(block == 4 * sizeof(Four) / sizeof(double));
    for (int t = 0; t < count; t += block)
    {
        Four a{}, b{}, c{}, d{};
        for (int i = 0; i < rows; ++i)
        {
            const int start = t - i * width;
            const int last = std::min(columns - 1, start + block - 1);
            for (int j = std::max(0, start - run + 1); j <= last; ++j)
            {
                const double factor = factors[i * columns + j];
                const auto *x = reinterpret_cast<const Four *>(from + (start - j));
                a += factor * x[0];
                b += factor * x[1];
                c += factor * x[2];
                d += factor * x[3];
            }
        }
        const Four sums[4] = {a, b, c, d};
        const auto *plain = reinterpret_cast<const double *>(sums);
        for (int k = 0; k < std::min(block, count - t); ++k)
            to[t + k] += plain[k];
    }
}

LAMINATE_OFFSET_VECTORISED
void add_outer_product(const double *__restrict factors, int rows, const double *__restrict from, double *__restrict to,
                       int count)
{
    for (int i = 0; i < rows; ++i, to += count)
        for (int k = 0; k < count; ++k)
            to[k] += factors[i] * from[k];
}

LAMINATE_OFFSET_VECTORISED
void subtract_combination(const double *__restrict factors, int rows, const double *__restrict from,
                          double *__restrict to, int count)
{
    for (int i = 0; i < rows; ++i, from += count)
        for (int k = 0; k < count; ++k)
            to[k] -= factors[i] * from[k];
}

static_assert(lanes == 2 * sizeof(Four) / sizeof(double));

LAMINATE_OFFSET_VECTORISED
void span_basis(const double *t, const double *inverses, int q, const double *__restrict u, double *__restrict rows)
{
    const Four low = *reinterpret_cast<const Four *>(u);
    const Four high = *reinterpret_cast<const Four *>(u + 4);
    auto *row = reinterpret_cast<Four *>(rows);
    row[0] = row[1] = Four{1.0, 1.0, 1.0, 1.0};
    for (int j = 1; j <= q; ++j)
    {
        Four saved_low{}, saved_high{};
        for (int r = 0; r < j; ++r)
        {
            const double inverse = *inverses++;
            const Four part_low = row[2 * r] * inverse;
            const Four part_high = row[2 * r + 1] * inverse;
            row[2 * r] = saved_low + (t[r + 1] - low) * part_low;
            row[2 * r + 1] = saved_high + (t[r + 1] - high) * part_high;
            saved_low = (low - t[1 - j + r]) * part_low;
            saved_high = (high - t[1 - j + r]) * part_high;
        }
        row[2 * j] = saved_low;
        row[2 * j + 1] = saved_high;
    }
}

// Horner's scheme in s with the powers of 1 - s collected on the way.
LAMINATE_OFFSET_VECTORISED
void bernstein_sum(const double *coefficients, int degree, const double *__restrict s, double *__restrict rows)
{
    for (int half = 0; half < lanes; half += 4)
    {
        const Four t = *reinterpret_cast<const Four *>(s + half);
        const Four rest = 1.0 - t;
        Four power{1.0, 1.0, 1.0, 1.0};
        const double *last = coefficients + 4 * degree;
        Four x = last[0] * power, y = last[1] * power, z = last[2] * power, w = last[3] * power;
        for (int i = degree - 1; i >= 0; --i)
        {
            const double *c = coefficients + 4 * i;
            power *= rest;
            x = x * t + c[0] * power;
            y = y * t + c[1] * power;
            z = z * t + c[2] * power;
            w = w * t + c[3] * power;
        }
        *reinterpret_cast<Four *>(rows + half) = x;
        *reinterpret_cast<Four *>(rows + lanes + half) = y;
        *reinterpret_cast<Four *>(rows + 2 * lanes + half) = z;
        *reinterpret_cast<Four *>(rows + 3 * lanes + half) = w;
    }
}

LAMINATE_OFFSET_VECTORISED
void tensor_sum(const double *poles, int step, int p, int q, const double *__restrict basis_u,
                const double *__restrict basis_v, double *__restrict rows)
{
    for (int half = 0; half < lanes; half += 4)
    {
        Four x{}, y{}, z{}, w{};
        for (int i = 0; i <= p; ++i)
        {
            Four along_x{}, along_y{}, along_z{}, along_w{};
            const double *pole = poles + i * step;
            for (int j = 0; j <= q; ++j, pole += 4)
            {
                const Four b = *reinterpret_cast<const Four *>(basis_v + j * lanes + half);
                along_x += pole[0] * b;
                along_y += pole[1] * b;
                along_z += pole[2] * b;
                along_w += pole[3] * b;
            }
            const Four b = *reinterpret_cast<const Four *>(basis_u + i * lanes + half);
            x += along_x * b;
            y += along_y * b;
            z += along_z * b;
            w += along_w * b;
        }
        *reinterpret_cast<Four *>(rows + half) = x;
        *reinterpret_cast<Four *>(rows + lanes + half) = y;
        *reinterpret_cast<Four *>(rows + 2 * lanes + half) = z;
        *reinterpret_cast<Four *>(rows + 3 * lanes + half) = w;
    }
}

LAMINATE_OFFSET_VECTORISED
void without_weights(const double *__restrict sums, bool rational, double *__restrict rows)
{
    const double *weights = sums + 3 * lanes;
    for (int e = 0; e < 3; ++e)
        for (int k = 0; k < lanes; ++k)
            rows[e * lanes + k] = rational ? sums[e * lanes + k] / weights[k] : sums[e * lanes + k];
}

} // namespace laminate_offset
