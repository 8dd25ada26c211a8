// SPDX-License-Identifier: GPL-3.0-or-later
// Nearest point on a set of triangles.
#pragma once

#include <limits>
#include <optional>

#include <fovea/mesh/surface.h>

namespace fovea::scene {

/// BVH over its own copy of the triangles, in any space. Const calls are thread-safe.
class NearestPoint {
   public:
    /// Throws std::runtime_error if Embree fails.
    NearestPoint(Array<vec3> positions, Array<Triangle> triangles);
    ~NearestPoint();
    NearestPoint(const NearestPoint&) = delete;
    NearestPoint& operator=(const NearestPoint&) = delete;

    /// Nearest point; among equally near triangles, that of the lowest index. No value if it is farther than `far` (a
    /// small `far` makes queries fast), if there are no triangles, and for a non-finite p.
    std::optional<dvec3> operator()(const vec3& p, float far = std::numeric_limits<float>::infinity()) const;

   private:
    struct Bvh;
    std::unique_ptr<Bvh> bvh_;
};

}  // namespace fovea::scene
