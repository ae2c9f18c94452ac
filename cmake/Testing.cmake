# SPDX-License-Identifier: LGPL-2.1-or-later
# ctest is the one test driver. Labels: core, bindings, workbench, gui, consumer, format, tidiness.

include(GoogleTest)
find_package(GTest REQUIRED)
find_package(Python3 3.8 REQUIRED COMPONENTS Interpreter)

find_path(
    LAMINATE_OFFSET_FREECAD_LIB_DIR
    NAMES FreeCAD.so
    PATHS /usr/lib/freecad-python3 /usr/lib/freecad /usr/lib64/freecad /usr/local /opt/freecad
    PATH_SUFFIXES lib
    NO_DEFAULT_PATH
    DOC "Folder of FreeCAD.so, for tests that import FreeCAD"
)
find_program(LAMINATE_OFFSET_XVFB_RUN xvfb-run)
mark_as_advanced(LAMINATE_OFFSET_XVFB_RUN)

# FreeCAD's settings of the tests, away from the user's own.
set(LAMINATE_OFFSET_TEST_HOME ${PROJECT_BINARY_DIR}/tests/freecad_home)
file(MAKE_DIRECTORY ${LAMINATE_OFFSET_TEST_HOME})

set(laminate_offset_test_environment
    "PYTHONPATH=${LAMINATE_OFFSET_ADDON_DIR}:${LAMINATE_OFFSET_FREECAD_LIB_DIR}"
    "PYTHONDONTWRITEBYTECODE=1"
    "FREECAD_USER_HOME=${LAMINATE_OFFSET_TEST_HOME}"
    "LAMINATE_OFFSET_PROJECT_DIR=${PROJECT_SOURCE_DIR}"
    "LAMINATE_OFFSET_BUILD_DIR=${PROJECT_BINARY_DIR}"
    "LAMINATE_OFFSET_SANITIZERS=${LAMINATE_OFFSET_SANITIZERS}"
)
if(LAMINATE_OFFSET_SANITIZERS MATCHES "address")
    # Python itself is not instrumented: the sanitizer's library must come first, and the C++ library
    # with it, or its interception of exceptions fails. What Python and FreeCAD keep until exit is not ours to report.
    foreach(library asan stdc++)
        execute_process(
            COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=lib${library}.so
            OUTPUT_VARIABLE laminate_offset_library
            OUTPUT_STRIP_TRAILING_WHITESPACE
        )
        list(APPEND laminate_offset_preload ${laminate_offset_library})
    endforeach()
    list(JOIN laminate_offset_preload ":" laminate_offset_preload)
    list(APPEND laminate_offset_test_environment "LD_PRELOAD=${laminate_offset_preload}" "ASAN_OPTIONS=detect_leaks=0")
endif()

# laminate_offset_add_pytest(NAME <name> FILE <file> LABEL <label> [XVFB] [TIMEOUT <seconds>] [DEPENDS <fixture>...])
#
# Registers one pytest file. The tests see the add-on of the build tree and FreeCAD's modules on
# PYTHONPATH, LAMINATE_OFFSET_PROJECT_DIR and LAMINATE_OFFSET_BUILD_DIR, and LAMINATE_OFFSET_SANITIZERS (empty without
# any; with some, times and memory mean nothing, and FreeCAD's own programs hang). With XVFB the whole run has
# an X display of its own, and ctest runs nothing beside it. DEPENDS names ctest fixtures. A file whose tests were all
# skipped is shown as skipped.
function(laminate_offset_add_pytest)
    cmake_parse_arguments(PARSE_ARGV 0 arg "XVFB" "NAME;FILE;LABEL;TIMEOUT" "DEPENDS")
    if(NOT arg_TIMEOUT)
        set(arg_TIMEOUT 300)
    endif()
    get_filename_component(file ${arg_FILE} ABSOLUTE BASE_DIR ${CMAKE_CURRENT_SOURCE_DIR})
    set(launcher)
    if(arg_XVFB)
        if(NOT LAMINATE_OFFSET_XVFB_RUN)
            message(FATAL_ERROR "${arg_NAME} needs xvfb-run: apt-get install xvfb xauth")
        endif()
        set(launcher ${LAMINATE_OFFSET_XVFB_RUN} -a -s "-screen 0 1600x1000x24")
    endif()
    add_test(NAME ${arg_NAME} COMMAND ${launcher} ${Python3_EXECUTABLE} -m pytest -q -rs -p no:cacheprovider ${file}
             WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    )
    set_tests_properties(
        ${arg_NAME}
        PROPERTIES LABELS "${arg_LABEL}"
                   TIMEOUT ${arg_TIMEOUT}
                   ENVIRONMENT "${laminate_offset_test_environment}"
                   SKIP_REGULAR_EXPRESSION "\n[0-9]+ skipped in"
    )
    if(arg_XVFB)
        set_tests_properties(${arg_NAME} PROPERTIES RUN_SERIAL ON)
    endif()
    if(arg_DEPENDS)
        set_tests_properties(${arg_NAME} PROPERTIES FIXTURES_REQUIRED "${arg_DEPENDS}")
    endif()
endfunction()
