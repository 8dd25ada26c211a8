// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/look_at.h>

#include <cmath>

namespace fovea::line {

SurfaceView look_at(const Surface& surface, Index placement, const Tracer& tracer) {
    const View& view = tracer.view();
    const dmat4 placed = view.world_to_view * tracer.scene().placements[placement].object_to_world;
    const dvec3 eye(glm::inverse(placed) * (view.orthographic ? dvec4(0, 0, 1, 0) : dvec4(0, 0, 0, 1)));
    return {.surface = surface,
            .eye_obj = surface.stretch() * eye,
            .orthographic = view.orthographic,
            .placement = placement,
            .object_to_view = placed * dmat4(glm::inverse(surface.stretch())),
            .tracer = &tracer};
}

/// Evaluated on the original surface, as everywhere else: pre-stretching changes only the last digits.
Array<std::uint8_t> facing_of(const SurfaceView& seen, double edge_on) {
    const Surface& surface = seen.surface.source() ? *seen.surface.source() : seen.surface;
    const dvec3 eye = glm::inverse(seen.surface.stretch()) * seen.eye_obj;
    return parallel_map<std::uint8_t>(surface.facet_count(), [&](std::size_t f) {
        const dvec4 plane(surface.facet_plane[f]);
        const double offset = seen.orthographic ? 0.0 : plane.w;
        return glm::dot(dvec3(plane), eye) - offset >= edge_on * (glm::length(eye) + std::abs(offset));
    });
}

}  // namespace fovea::line
