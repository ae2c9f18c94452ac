# SPDX-License-Identifier: LGPL-2.1-or-later
# The workbench's texts in other languages: resources/translations/LaminateOffset_<language>.ts, for Qt Linguist.
# The build compiles them; the target laminate_offset_lupdate reads new texts from the sources into them.

find_package(Qt5LinguistTools QUIET)

# laminate_offset_add_translations(<folder>): compiles every .ts file into the folder; sets
# laminate_offset_translations to the compiled files.
function(laminate_offset_add_translations folder)
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/resources/translations/*.ts)
    set(compiled "")
    foreach(source IN LISTS sources)
        get_filename_component(name ${source} NAME_WE)
        add_custom_command(
            OUTPUT ${folder}/${name}.qm
            COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
            COMMAND Qt5::lrelease -silent ${source} -qm ${folder}/${name}.qm
            DEPENDS ${source}
            VERBATIM
        )
        list(APPEND compiled ${folder}/${name}.qm)
    endforeach()
    # lupdate reads Python as if it were C++ and warns of what it does not know; calls with two texts it finds.
    file(GLOB_RECURSE texts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/Mod/LaminateOffset/laminate_offset/gui/*.py
         ${PROJECT_SOURCE_DIR}/resources/ui/*.ui
    )
    add_custom_target(
        laminate_offset_lupdate
        COMMAND Qt5::lupdate -silent -no-obsolete -locations none -source-language en ${texts} -ts ${sources}
        VERBATIM
    )
    set(laminate_offset_translations ${compiled} PARENT_SCOPE)
endfunction()
