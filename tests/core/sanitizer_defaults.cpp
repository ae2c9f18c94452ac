// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Settings of the sanitizers, which ask for them by these names at the start of the test program.

#if defined(__SANITIZE_ADDRESS__)

extern "C"
{

const char *__asan_default_options();
const char *__lsan_default_suppressions();
const char *__ubsan_default_options();

//! OpenCASCADE has no frame pointers: only the slow unwinder sees who asked it for memory, so few frames are kept.
const char *__asan_default_options() { return "fast_unwind_on_malloc=0:malloc_context_size=8"; }

//! What OpenCASCADE's readers of STEP and IGES allocate once per process and keep.
const char *__lsan_default_suppressions() { return "leak:libTKXSBase\nleak:libTKSTEP\nleak:libTKIGES\n"; }

const char *__ubsan_default_options() { return "print_stacktrace=1"; }
}

#endif
