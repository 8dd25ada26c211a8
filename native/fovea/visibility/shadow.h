// SPDX-License-Identifier: GPL-3.0-or-later
// The shadow volume of a polygon: what it hides from the eye.
#pragma once

#include <fovea/base/types.h>

namespace fovea {

/// Interval of a segment's parameter; empty when begin > end.
struct Interval {
    double begin = 1.0, end = 0.0;
    bool holds(double t) const { return begin <= t && t <= end; }
};

/// Bounded by the planes through the eye (view-space origin; along z for an orthographic camera) and the sides of a
/// flat convex polygon of three or four corners, and by the polygon's own plane. Convex, so it cuts an interval out of
/// a segment.
class Shadow {
   public:
    Shadow() = default;
    /// Corners in view space. `margin`: share of the distance by which a point must lie behind to be hidden.
    Shadow(In<dvec3> corners, bool orthographic, double near_clip, double margin);

    /// False when the polygon is seen edge-on or reaches in front of the near plane: it then hides nothing for sure.
    bool usable() const { return usable_; }

    /// Part of the segment from a to b that is hidden, as fractions of its length in space.
    Interval hides(const dvec3& a, const dvec3& b) const;

   private:
    dvec4 planes_[5];  // inside where positive; its own first
    int count_ = 0;
    bool usable_ = false;
};

}  // namespace fovea
