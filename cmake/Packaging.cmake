# SPDX-License-Identifier: LGPL-2.1-or-later
# `cpack` in the build folder makes one .deb: add-on, command line, library and headers.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME laminate-offset)
set(CPACK_PACKAGE_VENDOR "LaminateOffset")
set(CPACK_PACKAGE_CONTACT "LaminateOffset maintainers <maintainers@laminate-offset.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# The shared libraries are found by dpkg-shlibdeps; the rest is what the add-on runs in. The compiled
# module fits one minor version of Python only.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(laminate_offset_depends "freecad (>= 0.20)" "python3-numpy" "python3-yaml")
if(LAMINATE_OFFSET_BUILD_PYTHON)
    math(EXPR laminate_offset_next_minor "${Python3_VERSION_MINOR} + 1")
    list(APPEND laminate_offset_depends "python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR})"
         "python3 (<< ${Python3_VERSION_MAJOR}.${laminate_offset_next_minor})"
    )
endif()
list(JOIN laminate_offset_depends ", " CPACK_DEBIAN_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-h5py, python3-matplotlib, python3-pivy, python3-tqdm") # HDF5 files, ply books, the direction arrow, the progress bar
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libocct-data-exchange-dev, libeigen3-dev, libtbb-dev, nlohmann-json3-dev, libfmt-dev")

include(CPack)
