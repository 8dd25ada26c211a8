# SPDX-License-Identifier: GPL-3.0-or-later
# Embree 3: triangles and instances, single rays and point queries. Its own build compiles every kind of geometry; the
# files of curves alone take most of its time.
set(folder ${FOVEA_SOURCES}/embree)
set(EMBREE_VERSION_MAJOR 3)
set(EMBREE_VERSION_MINOR 13)
set(EMBREE_VERSION_PATCH 5)
set(EMBREE_VERSION_NUMBER 31305)
set(EMBREE_MAX_INSTANCE_LEVEL_COUNT 1)
set(EMBREE_STATIC_LIB ON)
set(EMBREE_FILTER_FUNCTION ON)
set(EMBREE_GEOMETRY_TRIANGLE ON)
set(EMBREE_GEOMETRY_INSTANCE ON)
set(EMBREE_GEOMETRY_USER ON)
set(EMBREE_CURVE_SELF_INTERSECTION_AVOIDANCE_FACTOR 2.0)
set(EMBREE_HASH 0)
set(headers ${CMAKE_BINARY_DIR}/embree)
configure_file(${folder}/kernels/rtcore_config.h.in ${headers}/include/embree3/rtcore_config.h)
file(GLOB public ${folder}/include/embree3/*.h)
foreach(header ${public})
    configure_file(${header} ${headers}/include/embree3 COPYONLY)
endforeach()
set(EMBREE_COMPACT_POLYS OFF)
configure_file(${folder}/kernels/config.h.in ${headers}/kernels/config.h)
configure_file(${folder}/kernels/hash.h.in ${headers}/kernels/hash.h)
file(MAKE_DIRECTORY ${headers}/kernels/common)

set(common sys/sysinfo sys/alloc sys/filename sys/library sys/thread sys/string sys/regression sys/mutex sys/condition
           sys/barrier math/constants simd/sse lexers/stringstream lexers/tokenstream tasking/taskschedulertbb)
set(kernels common/device common/stat common/acceln common/accelset common/state common/rtcore common/rtcore_builder
            common/scene common/alloc common/geometry common/scene_user_geometry common/scene_instance
            common/scene_triangle_mesh common/motion_derivative geometry/primitive4 geometry/instance_intersector
            builders/primrefgen bvh/bvh bvh/bvh_statistics bvh/bvh4_factory bvh/bvh8_factory bvh/bvh_collider
            bvh/bvh_rotate bvh/bvh_refit bvh/bvh_builder bvh/bvh_builder_morton bvh/bvh_builder_sah
            bvh/bvh_builder_sah_spatial bvh/bvh_builder_sah_mb bvh/bvh_builder_twolevel bvh/bvh_intersector1_bvh4)
list(TRANSFORM common REPLACE "(.+)" "${folder}/common/\\1.cpp")
list(TRANSFORM kernels REPLACE "(.+)" "${folder}/kernels/\\1.cpp")
fovea_static(embree ${common} ${kernels})
# Linked in, as tables of builders name them, and never called (motion blur, high quality, other people's BVHs), or not
# where time is spent (two levels: surfaces that move are refitted elsewhere).
foreach(file bvh/bvh_builder_sah_mb bvh/bvh_builder_sah_spatial bvh/bvh_builder_twolevel common/rtcore_builder
             common/motion_derivative bvh/bvh_statistics)
    set_property(SOURCE ${folder}/kernels/${file}.cpp PROPERTY COMPILE_OPTIONS -Os)
endforeach()
target_include_directories(embree SYSTEM PUBLIC ${headers}/include)
target_include_directories(embree SYSTEM PRIVATE ${headers}/kernels/common ${headers}/include/embree3)
target_compile_definitions(embree PUBLIC EMBREE_STATIC_LIB PRIVATE EMBREE_TARGET_SSE2 EMBREE_LOWEST_ISA TASKING_TBB)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "arm64|aarch64")
    # Its own header carries out SSE2 by NEON.
    target_compile_definitions(embree PRIVATE __SSE__ __SSE2__)
endif()
target_link_libraries(embree PRIVATE tbb)
# Operators that print name members that are not there, of templates that nothing uses: Clang 19 and later look anyway.
set_target_properties(embree PROPERTIES CXX_STANDARD 17)
target_compile_options(embree PRIVATE -fno-strict-aliasing $<$<CXX_COMPILER_ID:Clang,AppleClang>:-fdelayed-template-parsing>)
