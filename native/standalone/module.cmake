# SPDX-License-Identifier: GPL-3.0-or-later
# The Python module from the headers in FOVEA_SOURCES, or else FOVEA_PYTHON_HEADERS, for each Python of FOVEA_PYTHONS
# ("3.11;3.13"), none of which need be there: cp311/_native.so and so on. Sets `modules`, their targets.
if(FOVEA_LINKER AND NOT APPLE)
    # In place of the compiler (linker.py says why), with the same words.
    string(REPLACE "<CMAKE_CXX_COMPILER>" "${FOVEA_LINKER}" CMAKE_CXX_CREATE_SHARED_MODULE
                   "${CMAKE_CXX_CREATE_SHARED_MODULE}")
elseif(FOVEA_LINKER)
    set(CMAKE_CXX_CREATE_SHARED_MODULE "${FOVEA_LINKER} -bundle -exported_symbol _PyInit__native \
-undefined dynamic_lookup -dead_strip -S -x -o <TARGET> <OBJECTS> <LINK_LIBRARIES>")
endif()

foreach(python ${FOVEA_PYTHONS})
    string(REPLACE "." "" tag cp${python})
    set(folder ${FOVEA_SOURCES}/python${python})
    if(NOT IS_DIRECTORY ${folder})
        set(folder ${FOVEA_PYTHON_HEADERS}/python${python})
    endif()
    set(configured ${CMAKE_BINARY_DIR}/${tag}/include)
    if(WIN32)
        # Since 3.13 a file that is a header but for one line.
        file(GLOB windows ${folder}/PC/pyconfig.h*)
        configure_file(${windows} ${configured}/pyconfig.h COPYONLY)
    else()
        configure_file(${CMAKE_CURRENT_LIST_DIR}/pyconfig.h.in ${configured}/pyconfig.h COPYONLY)
    endif()
    add_library(_native_${tag} MODULE ${bindings})
    target_include_directories(_native_${tag} SYSTEM PRIVATE ${FOVEA_SOURCES}/pybind11 ${configured} ${folder}/Include)
    if(WIN32)
        # Headers of 3.11 know by this alone that pointers have 64 bits; the library is made of them (build.py).
        target_compile_definitions(_native_${tag} PRIVATE MS_WIN64=)
        string(REPLACE cp "" number ${tag})
        target_link_libraries(_native_${tag} PRIVATE ${CMAKE_BINARY_DIR}/${tag}/libpython${number}.a)
    endif()
    set_target_properties(_native_${tag} PROPERTIES PREFIX "" OUTPUT_NAME _native
                          LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/${tag} LINK_DEPENDS "${FOVEA_LINKER}")
    list(APPEND modules _native_${tag})
endforeach()
