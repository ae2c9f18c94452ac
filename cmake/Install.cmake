# SPDX-License-Identifier: LGPL-2.1-or-later
# Installs the library with its CMake package. The add-on installs itself in src/bindings and Mod.

include(CMakePackageConfigHelpers)

install(
    TARGETS laminate_offset_core
    EXPORT LaminateOffsetTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT application NAMELINK_COMPONENT development
)
install(
    DIRECTORY ${PROJECT_SOURCE_DIR}/src/core/
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/laminate_offset
    COMPONENT development
    FILES_MATCHING
    PATTERN "*.h"
)

install(
    FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/laminate-offset
    COMPONENT application
)
install(
    FILES ${PROJECT_SOURCE_DIR}/LICENSE
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/laminate-offset
    RENAME copyright
    COMPONENT application
)

# package.xml names the licence file beside it.
if(LAMINATE_OFFSET_BUILD_PYTHON)
    install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${LAMINATE_OFFSET_INSTALL_ADDON_DIR})
endif()

configure_package_config_file(
    ${PROJECT_SOURCE_DIR}/cmake/LaminateOffsetConfig.cmake.in ${PROJECT_BINARY_DIR}/LaminateOffsetConfig.cmake
    INSTALL_DESTINATION ${LAMINATE_OFFSET_INSTALL_CMAKE_DIR}
)
write_basic_package_version_file(
    ${PROJECT_BINARY_DIR}/LaminateOffsetConfigVersion.cmake COMPATIBILITY SameMinorVersion
)
install(
    FILES ${PROJECT_BINARY_DIR}/LaminateOffsetConfig.cmake ${PROJECT_BINARY_DIR}/LaminateOffsetConfigVersion.cmake
          ${PROJECT_SOURCE_DIR}/cmake/OpenCascade.cmake
    DESTINATION ${LAMINATE_OFFSET_INSTALL_CMAKE_DIR}
    COMPONENT development
)
install(
    EXPORT LaminateOffsetTargets
    NAMESPACE LaminateOffset::
    DESTINATION ${LAMINATE_OFFSET_INSTALL_CMAKE_DIR}
    COMPONENT development
)
