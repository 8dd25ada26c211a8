// SPDX-License-Identifier: GPL-3.0-or-later
// Distance from points to surfaces.
#pragma once

#include <fovea/scene/nearest.h>
#include <fovea/scene/scene.h>

namespace fovea::scene {

/// Unsigned distance to some of a scene's placements. Copies all their triangles, occluding or not, to view space,
/// because distances in object space are not preserved under scale and shear. Const calls are thread-safe.
class SurfaceDistance {
   public:
    /// Throws std::invalid_argument for an invalid placement index, std::runtime_error if Embree fails.
    SurfaceDistance(const Scene& scene, const View& view, In<Index> placements);

    /// Distance from a view-space point to the nearest triangle, also from inside solids. Infinite if it exceeds `far`
    /// (a small `far` makes queries fast), if there are no triangles, and for a non-finite point.
    float operator()(const vec3& position_view, float far) const;

   private:
    std::shared_ptr<const NearestPoint> nearest_;
};

}  // namespace fovea::scene
