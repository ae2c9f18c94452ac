# SPDX-License-Identifier: LGPL-2.1-or-later
# Finds OpenCASCADE 7.6 to 8.x and names its toolkits in one place.
#   LAMINATE_OFFSET_OCCT_MODELING   toolkits the core links
#   LAMINATE_OFFSET_OCCT_EXCHANGE   toolkits that read and write STEP and IGES (tests, generators)
#   LAMINATE_OFFSET_OCCT_ASSEMBLIES toolkits that read and write STEP with names and colours (src/exchange)
# Used by the build and, installed next to it, by LaminateOffsetConfig.cmake.

# The package remembers its first call: components asked for later would not be loaded. DataExchange
# refers to targets of Visualization and ApplicationFramework, so they stand before it.
find_package(
    OpenCASCADE REQUIRED COMPONENTS FoundationClasses ModelingData ModelingAlgorithms Visualization
                                    ApplicationFramework DataExchange
)
if(OpenCASCADE_VERSION VERSION_LESS 7.6)
    message(FATAL_ERROR "OpenCASCADE 7.6 or newer is needed, found ${OpenCASCADE_VERSION}")
endif()

set(LAMINATE_OFFSET_OCCT_MODELING
    TKernel TKMath TKG2d TKG3d TKGeomBase TKBRep TKGeomAlgo TKTopAlgo TKPrim TKShHealing TKBO
)
if(OpenCASCADE_VERSION VERSION_LESS 7.8)
    set(LAMINATE_OFFSET_OCCT_EXCHANGE TKXSBase TKSTEPBase TKSTEPAttr TKSTEP209 TKSTEP TKIGES)
    set(LAMINATE_OFFSET_OCCT_ASSEMBLIES TKXDESTEP TKXCAF TKLCAF TKCDF TKTopAlgo ${LAMINATE_OFFSET_OCCT_EXCHANGE})
else()
    set(LAMINATE_OFFSET_OCCT_EXCHANGE TKXSBase TKDE TKDESTEP TKDEIGES)
    set(LAMINATE_OFFSET_OCCT_ASSEMBLIES TKXCAF TKLCAF TKCDF TKTopAlgo ${LAMINATE_OFFSET_OCCT_EXCHANGE})
endif()
