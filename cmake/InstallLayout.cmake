# SPDX-License-Identifier: LGPL-2.1-or-later
# Where things go on installation, relative to the prefix.

include(GNUInstallDirs)

# Debian's FreeCAD reads <prefix>/share/freecad/Mod: /usr/lib/freecad/Mod is a link to it.
set(LAMINATE_OFFSET_INSTALL_ADDON_DIR
    ${CMAKE_INSTALL_DATADIR}/freecad/Mod/LaminateOffset
    CACHE STRING "Folder of the add-on, relative to the prefix"
)
set(LAMINATE_OFFSET_INSTALL_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/LaminateOffset)

# A shared core is found from the installed module wherever the prefix is.
if(BUILD_SHARED_LIBS)
    file(RELATIVE_PATH laminate_offset_library_path /${LAMINATE_OFFSET_INSTALL_ADDON_DIR}/laminate_offset
         /${CMAKE_INSTALL_LIBDIR}
    )
    set(CMAKE_INSTALL_RPATH $ORIGIN/${laminate_offset_library_path})
endif()
