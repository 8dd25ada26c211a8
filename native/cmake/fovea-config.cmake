# SPDX-License-Identifier: GPL-3.0-or-later
# find_package(fovea) gives fovea::core: headers <fovea/...> and a static library.
include(${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/fovea-targets.cmake)
