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
    vec3 point[2];      ///< object space
    float strength[2];  ///< in [0, 1]
    Index level = 0;    ///< pieces of other levels are other curves, though they cross the same sides
    Index other = none; ///< of a line on two surfaces: the triangle of the second
};

using Curves = Array<CurvePiece>;

/// Curves of the scene that outlive a frame, with what is derived from them.
struct KeptCurves {
    Curves pieces;
    mutable Cache derived;
};

/// Curves of a placement that lie on another one, too (or on itself again). `side` of their pieces numbers what the
/// definition likes, per set of curves; two pieces with the same number go on from each other.
struct SceneCurves {
    Index placement, other;
    std::shared_ptr<const KeptCurves> curves;
};

}  // namespace fovea
