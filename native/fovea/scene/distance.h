// SPDX-License-Identifier: GPL-3.0-or-later
// How far places are from surfaces.
#pragma once

#include <fovea/scene/nearest.h>
#include <fovea/scene/scene.h>

namespace fovea::scene {

/// Distance from some of a scene's placements. Keeps a copy of their triangles, those that hide nothing, too, in one
/// piece and in view space: distances do not survive placements that stretch. May be asked from many threads.
class SurfaceDistance {
   public:
    /// Throws std::invalid_argument for a placement that does not exist, std::runtime_error where Embree fails.
    SurfaceDistance(const Scene& scene, const View& view, In<Index> placements);

    /// From a place in view space to the nearest of the triangles, inside bodies, too; infinite where all are farther
    /// than `far`, which is what makes it cheap, where there are none, and for what is no place.
    float operator()(const vec3& position_view, float far) const;

   private:
    std::shared_ptr<const NearestPoint> nearest_;
};

}  // namespace fovea::scene
