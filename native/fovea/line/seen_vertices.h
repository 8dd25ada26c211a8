// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices of a surface as a view sees them.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/field/fields.h>
#include <fovea/field/view_curvature.h>
#include <fovea/line/definition.h>

namespace fovea {

inline SeenOf<float> see_vertex(const SurfaceView& seen, const Curvature& c, Index vertex) {
    const vec3 towards = seen.to_viewer(vertex);
    const float distance = glm::length(towards);
    if (!(distance > 0.0f)) return {0.0f, 0.0f, 0.0f, 0.0f};
    return see(c, towards / distance, seen.orthographic ? 0.0f : 1.0f / distance);
}

/// One number per vertex.
template <typename Value>
Array<float> per_vertex(const SurfaceView& seen, const Value& value) {
    Array<float> values(seen.surface.vertex_count());
    parallel_for(values.size(), [&](std::size_t v) { values[v] = value(static_cast<Index>(v)); });
    return values;
}

/// Triangles at all of whose corners n . v is above a limit.
inline auto facing_above(const Surface& surface, const Array<float>& facing, float limit) {
    return [&surface, &facing, limit](Index t) {
        const Triangle& c = surface.triangles[t];
        return facing[c.x] > limit && facing[c.y] > limit && facing[c.z] > limit;
    };
}

/// Triangles that have a corner with n . v > 0.
inline auto facing_anywhere(const Surface& surface, const Array<float>& facing) {
    return [&surface, &facing](Index t) {
        const Triangle& c = surface.triangles[t];
        return facing[c.x] > 0.0f || facing[c.y] > 0.0f || facing[c.z] > 0.0f;
    };
}

}  // namespace fovea
