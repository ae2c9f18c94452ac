// SPDX-License-Identifier: LGPL-2.1-or-later
#include "vector_kernels.h"

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
