// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/normals.h>

#include <cmath>

#include <fovea/base/parallel.h>
#include <fovea/mesh/corners.h>

namespace fovea::field {

vec3 vertex_normal(const Surface& surface, const Neighbors& neighbors, Index vertex) {
    dvec3 sum(0.0);
    for (const Index t : neighbors.triangles[vertex]) {
        const auto [a, b] = sides_from(surface, t, vertex);
        const double weight = glm::dot(a, a) * glm::dot(b, b);
        if (weight > 0.0) sum += glm::cross(a, b) / weight;
    }
    const double length = glm::length(sum);
    return length > 0.0 && length < HUGE_VAL ? vec3(sum / length) : vec3(0.0f);
}

Array<vec3> vertex_normals(const Surface& surface, const Neighbors& neighbors) {
    return parallel_map<vec3>(surface.vertex_count(),
                              [&](std::size_t v) { return vertex_normal(surface, neighbors, Index(v)); });
}

dvec3 corner_areas(const dvec3& p0, const dvec3& p1, const dvec3& p2) {
    const dvec3 e[3] = {p2 - p1, p0 - p2, p1 - p0};
    const double area = 0.5 * glm::length(glm::cross(e[0], e[1]));
    if (!(area > 0.0 && area < HUGE_VAL)) return dvec3(0.0);
    const dvec3 l(glm::dot(e[0], e[0]), glm::dot(e[1], e[1]), glm::dot(e[2], e[2]));
    const dvec3 beta(l[0] * (l[1] + l[2] - l[0]), l[1] * (l[2] + l[0] - l[1]), l[2] * (l[0] + l[1] - l[2]));
    dvec3 corner;
    for (int j = 0; j < 3; ++j) {
        if (beta[j] > 0.0) continue;
        const int k = (j + 1) % 3, m = (j + 2) % 3;
        corner[k] = -0.25 * l[m] * area / glm::dot(e[j], e[m]);
        corner[m] = -0.25 * l[k] * area / glm::dot(e[j], e[k]);
        corner[j] = area - corner[k] - corner[m];
        return corner;
    }
    const double scale = 0.5 * area / (beta[0] + beta[1] + beta[2]);
    for (int j = 0; j < 3; ++j) corner[j] = scale * (beta[(j + 1) % 3] + beta[(j + 2) % 3]);
    return corner;
}

Array<float> vertex_areas(const Surface& surface, const Neighbors& neighbors) {
    // Once per triangle, not once per corner.
    const auto corners = parallel_map<vec3>(surface.triangles.size(), [&](std::size_t t) {
        const Triangle& tri = surface.triangles[t];
        const auto at = [&](Index v) { return dvec3(surface.positions[v]); };
        return vec3(corner_areas(at(tri.x), at(tri.y), at(tri.z)));
    });
    return parallel_map<float>(surface.vertex_count(), [&](std::size_t v) {
        double sum = 0.0;
        for (const Index t : neighbors.triangles[Index(v)])
            sum += corners[t][corner_of(surface.triangles[t], Index(v))];
        return static_cast<float>(sum);
    });
}

}  // namespace fovea::field
