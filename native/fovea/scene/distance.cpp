// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/distance.h>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>

namespace fovea::scene {

SurfaceDistance::SurfaceDistance(const Scene& scene, const View& view, In<Index> placements) {
    Array<vec3> positions;
    Array<Triangle> triangles;
    for (const Index placement : placements) {
        check(placement < scene.placements.size(), "distance: there is no such placement");
        const Surface& surface = *scene.placements[placement].surface;
        const dmat4 object_to_view = view.world_to_view * scene.placements[placement].object_to_world;
        const std::size_t vertex = positions.size(), triangle = triangles.size();
        positions.resize(vertex + surface.vertex_count());
        parallel_for(surface.vertex_count(), [&](std::size_t i) {
            positions[vertex + i] = vec3(object_to_view * dvec4(dvec3(surface.positions[i]), 1.0));
        });
        triangles.resize(triangle + surface.triangles.size());
        parallel_for(surface.triangles.size(), [&](std::size_t i) {
            triangles[triangle + i] = surface.triangles[i] + static_cast<Index>(vertex);
        });
    }
    nearest_ = std::make_shared<NearestPoint>(std::move(positions), std::move(triangles));
}

float SurfaceDistance::operator()(const vec3& position_view, float far) const {
    const std::optional<dvec3> nearest = (*nearest_)(position_view, far);
    if (!nearest) return std::numeric_limits<float>::infinity();
    return static_cast<float>(glm::distance(dvec3(position_view), *nearest));
}

}  // namespace fovea::scene
