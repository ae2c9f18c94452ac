# SPDX-License-Identifier: LGPL-2.1-or-later
# Compiler settings that every C++ target of the project shares; see laminate_offset_set_build_options().

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

get_property(laminate_offset_multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
if(NOT CMAKE_BUILD_TYPE AND NOT laminate_offset_multi_config)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(LAMINATE_OFFSET_CCACHE ccache)
mark_as_advanced(LAMINATE_OFFSET_CCACHE)
if(LAMINATE_OFFSET_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    # The sloppiness is what ccache asks for before it caches anything next to a precompiled header.
    set(CMAKE_CXX_COMPILER_LAUNCHER
        ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${LAMINATE_OFFSET_CCACHE}
    )
endif()

find_program(LAMINATE_OFFSET_CLANG_TIDY NAMES clang-tidy clang-tidy-14)
mark_as_advanced(LAMINATE_OFFSET_CLANG_TIDY)
if(LAMINATE_OFFSET_TIDY AND NOT LAMINATE_OFFSET_CLANG_TIDY)
    message(FATAL_ERROR "LAMINATE_OFFSET_TIDY is ON but clang-tidy was not found: apt-get install clang-tidy")
endif()

# Applies warnings, floating-point rules, assertions, sanitizers and clang-tidy to one target. Error
# bounds rely on IEEE arithmetic: no fused multiply-add behind our back, no fast-math.
function(laminate_offset_set_build_options target)
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_compile_options(
        ${target}
        PRIVATE -Wall
                -Wextra
                -Wpedantic
                -Wshadow
                -Wnon-virtual-dtor
                -Woverloaded-virtual
                -ffp-contract=off
                $<$<CONFIG:Release>:-O3>
                # GCC keeps macro state for ccache next to a precompiled header only with this.
                $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
                $<$<BOOL:${LAMINATE_OFFSET_WERROR}>:-Werror>
    )
    if(LAMINATE_OFFSET_ASSERTIONS)
        target_compile_options(${target} PRIVATE -UNDEBUG)
        target_compile_definitions(${target} PRIVATE _GLIBCXX_ASSERTIONS)
    endif()
    if(LAMINATE_OFFSET_SANITIZERS)
        target_compile_options(
            ${target} PRIVATE -fsanitize=${LAMINATE_OFFSET_SANITIZERS} -fno-sanitize-recover=undefined
                              -fno-omit-frame-pointer
        )
        target_link_options(${target} PUBLIC $<BUILD_INTERFACE:-fsanitize=${LAMINATE_OFFSET_SANITIZERS}>)
    endif()
    if(LAMINATE_OFFSET_TIDY)
        set_target_properties(
            ${target} PROPERTIES CXX_CLANG_TIDY "${LAMINATE_OFFSET_CLANG_TIDY};--quiet" DISABLE_PRECOMPILE_HEADERS ON
        )
    endif()
endfunction()
