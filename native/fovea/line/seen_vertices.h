// SPDX-License-Identifier: GPL-3.0-or-later
// View direction at a vertex, in its principal frame.
#pragma once

#include <fovea/field/fields.h>
#include <fovea/field/view_curvature.h>
#include <fovea/line/definition.h>

namespace fovea::line {

inline SeenOf<float> see_vertex(const SurfaceView& seen, const Curvature& c, Index vertex) {
    const vec3 towards = seen.to_viewer(vertex);
    const float distance = glm::length(towards);
    if (!(distance > 0.0f)) return {0.0f, 0.0f, 0.0f, 0.0f};
    return see(c, towards / distance, seen.orthographic ? 0.0f : 1.0f / distance);
}

}  // namespace fovea::line
