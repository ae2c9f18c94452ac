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

} // namespace laminate_offset
