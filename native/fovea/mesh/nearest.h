// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest point of a set of triangles.
#pragma once

#include <unordered_map>

#include <fovea/base/types.h>

namespace fovea {

/// Triangles in the cells of a grid; immutable, safe to ask from any thread.
class NearestPoint {
   public:
    /// `cell`: about the size of a triangle; larger where the box is more than 200 of them long.
    NearestPoint(std::vector<dvec3> positions, std::vector<glm::uvec3> triangles, double cell);

    /// The point itself where there are no triangles.
    dvec3 to(const dvec3& p) const;

   private:
    glm::ivec3 cell_of(const dvec3& p) const;

    std::vector<dvec3> positions_;
    std::vector<glm::uvec3> triangles_;
    dvec3 low_{0.0};
    double cell_ = 1.0;
    glm::ivec3 size_{0};
    std::unordered_map<int, std::vector<Index>> cells_;
};

/// The point of triangle abc nearest to p. Ericson, "Real-Time Collision Detection", 2005, 5.1.5.
dvec3 nearest_in_triangle(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c);

}  // namespace fovea
