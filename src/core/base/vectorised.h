// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! LAMINATE_OFFSET_VECTORISED compiles a function for wide registers too, and the loader picks what the machine
//! has. Fused multiply-add is left out, so that all machines round alike.
#pragma once

#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) &&                           \
    !defined(__SANITIZE_ADDRESS__)
    #define LAMINATE_OFFSET_VECTORISED __attribute__((target_clones("avx2", "default")))
#else
    #define LAMINATE_OFFSET_VECTORISED
#endif
