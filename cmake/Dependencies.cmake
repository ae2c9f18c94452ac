# SPDX-License-Identifier: LGPL-2.1-or-later
# Every package the build needs. scripts/install_deps installs them on Debian.

include(OpenCascade)
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(nlohmann_json 3.9 REQUIRED)
find_package(fmt REQUIRED)

# The module must be built for, and the tests run by, the Python of FreeCAD, whatever else is first in PATH.
set(Python3_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that FreeCAD uses")

if(LAMINATE_OFFSET_BUILD_PYTHON)
    find_package(Python3 3.8 REQUIRED COMPONENTS Interpreter Development.Module)
    # pybind11 must not look for a Python of its own.
    set(PYBIND11_FINDPYTHON OFF)
    set(PYTHON_EXECUTABLE ${Python3_EXECUTABLE} CACHE FILEPATH "The Python that pybind11 uses" FORCE)
    find_package(pybind11 2.9 REQUIRED)
endif()
