# SPDX-License-Identifier: GPL-3.0-or-later
# The libraries that the core links, static, from the sources in FOVEA_SOURCES (sources.json says which): only the files
# that Fovea needs, so that one list serves every system. Included in place of dependencies.cmake.
enable_language(C)
find_package(Threads REQUIRED)

if(WIN32)
    # Windows 10 and later; constants of math.h and functions that are not part of C++, which the libraries use.
    add_compile_definitions(_WIN32_WINNT=0x0A00 _USE_MATH_DEFINES NOMINMAX)
    add_compile_options(-U__STRICT_ANSI__)
endif()

# Functions that nobody calls are left out, also where others of their file are called.
if(NOT APPLE)
    add_compile_options(-ffunction-sections -fdata-sections)
endif()
if(UNIX AND NOT APPLE)
    # Nor are there tables for functions that no exception leaves: a twentieth of a module.
    add_compile_options(-fno-asynchronous-unwind-tables -fno-unwind-tables)
    add_link_options(-Wl,--gc-sections) # the linker for Windows does so by itself
    # Nothing else is taken of the compiler's own library (the file says why, toolchain.py how).
    add_library(fovea_wide_integers STATIC ${CMAKE_CURRENT_LIST_DIR}/wide_integers.cpp)
    link_libraries(fovea_wide_integers)
endif()

# Warnings of others are not ours, and nothing of theirs is exported.
add_library(fovea_foreign INTERFACE)
target_compile_options(fovea_foreign INTERFACE -w -ffp-contract=off)

function(fovea_static name)
    add_library(${name} STATIC ${ARGN})
    target_link_libraries(${name} PRIVATE fovea_foreign)
    set_target_properties(${name} PROPERTIES C_VISIBILITY_PRESET hidden)
endfunction()

# oneTBB
set(folder ${FOVEA_SOURCES}/onetbb)
file(GLOB files ${folder}/src/tbb/*.cpp)
fovea_static(tbb ${files})
target_include_directories(tbb SYSTEM PUBLIC ${folder}/include)
target_compile_definitions(tbb PUBLIC __TBB_NO_IMPLICIT_LINKAGE PRIVATE __TBB_BUILD
                           # Else only a library of its own starts it on Windows; as a part of others it starts itself.
                           __TBB_SOURCE_DIRECTLY_INCLUDED=1
                           # Its weak references would be bound to the allocator of the host program's own oneTBB.
                           __TBB_WEAK_SYMBOLS_PRESENT=0 __TBB_DYNAMIC_LOAD_ENABLED=0)
target_link_libraries(tbb PUBLIC Threads::Threads PRIVATE ${CMAKE_DL_LIBS})
if(WIN32)
    # In place of its header of this guard, which hands out every function where it is built.
    target_compile_definitions(tbb PRIVATE __TBB_detail__export_H TBB_EXPORT=)
endif()
if(APPLE)
    target_compile_definitions(tbb PRIVATE _XOPEN_SOURCE) # for contexts, which are deprecated there
endif()
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    target_compile_options(tbb PRIVATE -mrtm -mwaitpkg)
endif()
add_library(fovea_tbb INTERFACE)
target_link_libraries(fovea_tbb INTERFACE tbb)
if(WIN32)
    configure_file(${CMAKE_CURRENT_LIST_DIR}/windows.h.in ${CMAKE_BINARY_DIR}/windows/windows.h COPYONLY)
    target_include_directories(fovea_tbb INTERFACE ${CMAKE_BINARY_DIR}/windows)
endif()
add_library(TBB::tbb ALIAS fovea_tbb)

# Embree
include(${CMAKE_CURRENT_LIST_DIR}/embree.cmake)

# OpenSubdiv: refinement of topology and evaluation of limits, nothing that draws
set(folder ${FOVEA_SOURCES}/opensubdiv)
file(GLOB files ${folder}/opensubdiv/far/*.cpp ${folder}/opensubdiv/sdc/*.cpp ${folder}/opensubdiv/vtr/*.cpp)
list(FILTER files EXCLUDE REGEX "test|regression")
fovea_static(opensubdiv ${files})
target_include_directories(opensubdiv SYSTEM PUBLIC ${folder})
# Topology is refined once for a mesh; what is evaluated for each frame is Fovea's own. A fiftieth of a module.
target_compile_options(opensubdiv PRIVATE $<$<CONFIG:Release>:-Os>)
add_library(fovea::opensubdiv ALIAS opensubdiv)

# OpenMesh
set(folder ${FOVEA_SOURCES}/openmesh/src)
file(GLOB files ${folder}/OpenMesh/Core/*/*.cc)
list(FILTER files EXCLUDE REGEX "/IO/")
fovea_static(openmesh ${files} ${folder}/OpenMesh/Tools/Decimater/Observer.cc)
target_include_directories(openmesh SYSTEM PUBLIC ${folder})
target_compile_definitions(openmesh PUBLIC OM_STATIC_BUILD)
add_library(fovea::openmesh ALIAS openmesh)
add_library(fovea_openmesh_tools INTERFACE)
add_library(fovea::openmesh_tools ALIAS fovea_openmesh_tools)

# libpng and zlib
set(folder ${FOVEA_SOURCES}/zlib)
foreach(file adler32 compress crc32 deflate infback inffast inflate inftrees trees uncompr zutil)
    list(APPEND zlib_files ${folder}/${file}.c)
endforeach()
fovea_static(z ${zlib_files})
target_include_directories(z SYSTEM PUBLIC ${folder})
set(folder ${FOVEA_SOURCES}/libpng)
foreach(file png pngerror pngget pngmem pngpread pngread pngrio pngrtran pngrutil pngset pngtrans pngwio pngwrite
             pngwtran pngwutil)
    list(APPEND png_files ${folder}/${file}.c)
endforeach()
fovea_static(png ${png_files})
configure_file(${folder}/scripts/pnglibconf.h.prebuilt ${CMAKE_BINARY_DIR}/libpng/pnglibconf.h COPYONLY)
target_include_directories(png SYSTEM PUBLIC ${folder} ${CMAKE_BINARY_DIR}/libpng)
target_compile_definitions(png PRIVATE PNG_INTEL_SSE_OPT=0 PNG_ARM_NEON_OPT=0)
target_link_libraries(png PUBLIC z)
add_library(PNG::PNG ALIAS png)

# Those of headers alone
function(fovea_headers name folder)
    add_library(fovea_${name} INTERFACE)
    target_include_directories(fovea_${name} SYSTEM INTERFACE ${FOVEA_SOURCES}/${folder})
    target_compile_definitions(fovea_${name} INTERFACE ${ARGN})
endfunction()
fovea_headers(xxhash xxhash XXH_INLINE_ALL)
add_library(fovea::xxhash ALIAS fovea_xxhash)
fovea_headers(glm glm)
add_library(glm::glm ALIAS fovea_glm)
fovea_headers(json nlohmann_json)
add_library(nlohmann_json::nlohmann_json ALIAS fovea_json)
fovea_headers(cli11 cli11/include)
if(WIN32)
    # Before the parts of it that CLI11 includes: the one that libraries above are given.
    target_compile_options(fovea_cli11 INTERFACE "SHELL:-include windows.h")
endif()
add_library(CLI11::CLI11 ALIAS fovea_cli11)

if(FOVEA_TESTS)
    set(folder ${FOVEA_SOURCES}/googletest/googletest)
    fovea_static(gtest ${folder}/src/gtest-all.cc)
    target_include_directories(gtest SYSTEM PUBLIC ${folder}/include PRIVATE ${folder})
    fovea_static(gtest_main ${folder}/src/gtest_main.cc)
    target_link_libraries(gtest_main PUBLIC gtest)
    add_library(GTest::gtest_main ALIAS gtest_main)
endif()
