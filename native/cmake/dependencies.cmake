# SPDX-License-Identifier: GPL-3.0-or-later
# What the core links. The build reads this, and find_package(fovea) where it is installed: a static library is of no
# use without them, so all are required.
find_package(glm REQUIRED)
find_package(TBB REQUIRED)
find_package(embree 4 REQUIRED)
find_package(PNG REQUIRED)
find_package(nlohmann_json REQUIRED)

# Libraries that Debian packages without a CMake config that can be used; that of OpenSubdiv names a static library that
# is not packaged.
function(fovea_find name library header)
    if(TARGET fovea::${name})
        return()
    endif()
    string(TOUPPER ${name} upper)
    find_library(${upper}_LIBRARY ${library} REQUIRED)
    find_path(${upper}_INCLUDE ${header} REQUIRED)
    mark_as_advanced(${upper}_LIBRARY ${upper}_INCLUDE)
    add_library(fovea::${name} UNKNOWN IMPORTED)
    set_target_properties(fovea::${name} PROPERTIES IMPORTED_LOCATION ${${upper}_LIBRARY}
                          INTERFACE_INCLUDE_DIRECTORIES ${${upper}_INCLUDE})
endfunction()

fovea_find(xxhash xxhash xxhash.h)
fovea_find(opensubdiv osdCPU opensubdiv/far/patchTable.h)
fovea_find(openmesh OpenMeshCore OpenMesh/Core/System/config.hh)
fovea_find(openmesh_tools OpenMeshTools OpenMesh/Tools/Decimater/DecimaterT.hh)
