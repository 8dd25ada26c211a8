// SPDX-License-Identifier: GPL-3.0-or-later
// What the polygons of a surface stand for, which decides the lines that suit it.
#pragma once

#include <cstdint>

namespace fovea::mesh {

enum class Shape : std::uint8_t {
    automatic,  ///< decided by field/shape.h
    hard,       ///< its faces are meant as they are: creases at all sharp angles
    rounded,    ///< its faces approximate a rounded shape, but coarsely: creases only where sharp among their like
    smooth,     ///< its faces approximate a smooth shape well enough for lines of curvature
};

}  // namespace fovea::mesh
