// SPDX-License-Identifier: GPL-3.0-or-later
// Quick rejection of pairs of triangles, four at a time.
#pragma once

#include <fovea/scene/triangle_tree.h>

namespace fovea::scene {

/// Four vectors; coordinates.
struct Vectors {
    Four x[3];
};

/// The planes of four triangles, in single precision.
class FourPlanes {
   public:
    /// `error`: bound of the errors of coordinates, of these triangles and of others. `within`: the others are of the
    /// same surface, and a corner at the same position is no crossing.
    FourPlanes(const FourTriangles& triangles, float error, bool within);

    /// Of the triangles whose bits are set in `lanes`, those that may cross triangle `lane` of `others`. The rest does
    /// not, wherever in the bounds of the errors the corners are: all corners of one that are not the other's, too, are
    /// on one side of the other's plane, or what the two cut from the line in which their planes meet is apart (Möller,
    /// "A Fast Triangle-Triangle Intersection Test", 1997). With `within`, nor do those with a side in common, or whose
    /// cuts go apart from a common corner.
    unsigned may_cross(unsigned lanes, const FourTriangles& others, int lane) const;

   private:
    const FourTriangles& triangles_;
    Vectors normal_;       ///< length is twice the area
    Four longest_, area_;  ///< bounds: of the sides from the first corner, and of the product of their lengths
    const float error_;
    const bool within_;
};

}  // namespace fovea::scene
