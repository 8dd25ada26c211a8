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

namespace {

/// Which facets face the eye, on the original surface, as everywhere else: pre-stretching changes only the last digits.
class Facing {
   public:
    Facing(const SurfaceView& seen, double edge_on)
        : surface_(seen.surface.source() ? *seen.surface.source() : seen.surface),
          eye_(glm::inverse(seen.surface.stretch()) * seen.eye_obj),
          orthographic_(seen.orthographic),
          edge_on_(edge_on) {}

    bool operator()(std::size_t facet) const {
        const dvec4 plane(surface_.facet_plane[facet]);
        const double offset = orthographic_ ? 0.0 : plane.w;
        return glm::dot(dvec3(plane), eye_) - offset >= edge_on_ * (glm::length(eye_) + std::abs(offset));
    }

   private:
    const Surface& surface_;
    const dvec3 eye_;
    const bool orthographic_;
    const double edge_on_;
};

}  // namespace

Array<std::uint8_t> facing_of(const SurfaceView& seen, double edge_on) {
    return parallel_map<std::uint8_t>(seen.surface.facet_count(), Facing(seen, edge_on));
}

bool is_facing(const SurfaceView& seen, Index facet, double edge_on) { return Facing(seen, edge_on)(facet); }

}  // namespace fovea::line
