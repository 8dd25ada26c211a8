// What smooth contours and smooth silhouettes share.
#pragma once

#include "line/seen_vertices.h"
#include "line/zero_set.h"

namespace fovea {

/// Zeros of the interpolated n . v, n the normals of the fitted surface; strength(v) at the vertices is interpolated.
template <typename Strength>
Curves find_smooth_contour(const SurfaceView& seen, const Strength& strength) {
    const auto fields = fields_of(seen.surface);
    const Array<float> facing =
        per_vertex(seen, [&](Index v) { return glm::dot(fields->curvature[v].normal, seen.to_viewer(v)); });
    const auto all = [](Index) { return true; };
    return trace_zero_set(seen.surface, all, [&](Index v) { return facing[v]; }, strength, [](float s) { return s; });
}

}  // namespace fovea
