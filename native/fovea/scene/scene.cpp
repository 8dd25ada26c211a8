// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/scene.h>

#include <fovea/scene/flattened.h>

namespace fovea::scene {

Scene::Scene(std::vector<Placement> placed) : placements(std::move(placed)) {
    Index base = 0;
    for (Placement& placement : placements) {
        const Surface& surface = *placement.surface;
        placement.object_to_world =
            with_thickness(placement.object_to_world, dvec3(surface.center), dvec3(surface.half));
        facet_base.push_back(base);
        base += surface.facet_count();
    }
}

Sphere bounding_sphere(const Placement& placement, const View& view) {
    const Surface& surface = *placement.surface;
    const dmat4 object_to_view = view.world_to_view * placement.object_to_world;
    // Upper bound of the scale factor: the Frobenius norm of the linear part.
    const double scale =
        std::sqrt(glm::dot(object_to_view[0], object_to_view[0]) + glm::dot(object_to_view[1], object_to_view[1]) +
                  glm::dot(object_to_view[2], object_to_view[2]));
    return {dvec3(object_to_view * dvec4(dvec3(surface.center), 1.0)), surface.radius * scale};
}

bool in_frame(const Placement& placement, const View& view, double margin) {
    if (view.view_to_clip == dmat4(0.0)) return true;
    const Sphere sphere = bounding_sphere(placement, view);
    const dvec4 center(sphere.center, 1.0);
    // Frustum planes in view space: rows of the projection, w + x >= 0 and so on, widened; and the near plane.
    const dmat4 rows = glm::transpose(view.view_to_clip);
    const dvec4 planes[] = {rows[3] * (1.0 + margin) + rows[0], rows[3] * (1.0 + margin) - rows[0],
                            rows[3] * (1.0 + margin) + rows[1], rows[3] * (1.0 + margin) - rows[1],
                            dvec4(0.0, 0.0, -1.0, -view.near_clip)};
    for (const dvec4& plane : planes)
        if (glm::dot(plane, center) < -sphere.radius * glm::length(dvec3(plane))) return false;
    return true;
}

}  // namespace fovea::scene
