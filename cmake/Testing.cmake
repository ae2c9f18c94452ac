# SPDX-License-Identifier: LGPL-2.1-or-later
# ctest is the one test driver. Labels: core, bindings, workbench, gui, consumer, format.

include(GoogleTest)
find_package(GTest REQUIRED)
