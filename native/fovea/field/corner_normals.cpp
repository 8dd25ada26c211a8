// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/corner_normals.h>

#include <cmath>

#include <fovea/base/elementary.h>
#include <fovea/base/parallel.h>
#include <fovea/field/fields.h>
#include <fovea/mesh/corners.h>

namespace fovea::field {
namespace {

/// Mean normal, weighted by angle, of the triangles around a vertex whose normals are within default_hard_angle of
/// `own`.
vec3 smooth_side(const Surface& surface, const Neighbors& all, Index vertex, const vec3& own) {
    const double least_cosine = cosine(glm::radians(default_hard_angle));
    dvec3 sum(0.0);
    for (const Index t : all.triangles[vertex]) {
        const vec3 normal(surface.facet_plane[surface.triangle_facet[t]]);
        const double cosine = glm::dot(dvec3(normal), dvec3(own));
        // Adjacent facets may have opposite orientation: compare lines, not directions.
        if (std::abs(cosine) < least_cosine) continue;
        sum += (cosine < 0.0 ? -1.0 : 1.0) * corner_angle(surface, t, vertex) * dvec3(normal);
    }
    const double length = glm::length(sum);
    return length > 0.0 && length < HUGE_VAL ? vec3(sum / length) : own;
}

CornerNormals find_normals(const Surface& surface) {
    const auto fields = fields_of(surface);
    const auto smooth = neighbors_of(surface), all = neighbors_of(surface, no_hard_edges);
    CornerNormals normals;
    const auto fitted = [&](std::size_t v) { return fields->curvature[v].normal; };
    normals.vertex = parallel_map<vec3>(surface.vertex_count(), fitted);
    const auto own = [&](std::size_t t) { return vec3(surface.facet_plane[surface.triangle_facet[t]]); };
    const auto fits = [&](Index v, const vec3& facet) {
        return !smooth->hard[v] && glm::dot(normals.vertex[v], facet) > 0.0f;
    };

    normals.first = parallel_map<Index>(surface.triangles.size(), [&](std::size_t t) {
        const Triangle& c = surface.triangles[t];
        const vec3 facet = own(t);
        return fits(c.x, facet) && fits(c.y, facet) && fits(c.z, facet) ? 0 : 3;
    });
    Index total = 0;
    for (Index& first : normals.first) {
        const Index count = first;
        first = count ? total : none;
        total += count;
    }
    normals.corner.resize(total);
    parallel_for(normals.first.size(), [&](std::size_t t) {
        if (normals.first[t] == none) return;
        const vec3 facet = own(t);
        for (int k = 0; k < 3; ++k) {
            const Index v = surface.triangles[t][k];
            vec3& normal = normals.corner[normals.first[t] + k];
            normal = smooth->hard[v] ? smooth_side(surface, *all, v, facet) : normals.vertex[v];
            const float side = glm::dot(normal, facet);
            if (side < 0.0f) normal = -normal;
            if (!(std::abs(side) > 0.0f)) normal = facet;
        }
    });
    return normals;
}

}  // namespace

std::shared_ptr<const CornerNormals> corner_normals(const Surface& surface) {
    return surface.cache().get<CornerNormals>(0, [&] { return find_normals(surface); });
}

}  // namespace fovea::field
