// Lines that cross triangles: the pieces that field definitions find, one triangle at a time.
#pragma once

#include "mesh/surface.h"

namespace fovea {

/// A straight piece of a curve in one triangle. An end on a side of the triangle carries the side's number
/// (mesh/triangle_sides.h), which the piece beyond the side shares; an end inside has `none`: there the curve ends.
/// A definition leaves at most one piece of a level in a triangle.
struct CurvePiece {
    Index triangle;
    Index side[2];
    vec3 point[2];      ///< in the surface's space
    float strength[2];  ///< in [0, 1]
    Index level = 0;    ///< pieces of other levels are other curves, though they cross the same sides
};

using Curves = Array<CurvePiece>;

}  // namespace fovea
