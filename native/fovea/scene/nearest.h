// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest point of a set of triangles.
#pragma once

#include <limits>
#include <optional>

#include <fovea/mesh/surface.h>

namespace fovea::scene {

/// A BVH over triangles of its own, in whatever space their vertices are; may be asked from many threads.
class NearestPoint {
   public:
    /// Throws std::runtime_error where Embree fails.
    NearestPoint(Array<vec3> positions, Array<Triangle> triangles);
    ~NearestPoint();
    NearestPoint(const NearestPoint&) = delete;
    NearestPoint& operator=(const NearestPoint&) = delete;

    /// Of several that are equally near, that of the triangle with the least number. None where all are farther than
    /// `far`, which is what makes it cheap, where there are no triangles, and for a position that is not finite.
    std::optional<dvec3> operator()(const vec3& p, float far = std::numeric_limits<float>::infinity()) const;

   private:
    struct Bvh;
    std::unique_ptr<Bvh> bvh_;
};

}  // namespace fovea::scene
