// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/line_motion.h>

#include <fovea/draw/frame.h>

namespace fovea::draw {

LineMotion::LineMotion(const Frame& frame) : frame_(frame) {
    const Scene& scene = *frame.job.scene;
    now_ = pose_of(scene, frame.job.view);
    placed_.resize(scene.placements.size());
    before_.pose = frame.job.before;
    after_.pose = frame.job.after;
    for (Index i = 0; i < now_.placed.size(); ++i) {
        const Pose::Placed& placed = now_.placed[i];
        placed_[placed.placement] = i;
        view_to_object_.push_back(glm::inverse(placed.object_to_view));
        for (Beside* beside : {&before_, &after_})
            beside->number.push_back(beside->pose ? beside->pose->find(placed.id) : none);
    }
}

vec4 LineMotion::at(Index piece, double arc) const {
    const ClippedPaths& clipped = *frame_.clipped;
    const Paths& paths = *frame_.paths;
    const Index path = clipped.path[piece], placement = paths.placement[path];
    if (placement == none) return vec4(0.0f);
    const Index number = placed_[placement], segment = clipped.segment_at(piece, arc);
    const Pose::Placed& here = now_.placed[number];
    const dvec3 position = clipped.position_at(segment, clipped.share_at(segment, arc));
    const SurfacePoint point =
        surface_point(*frame_.job.scene->placements[placement].surface, here.at(), paths.place[clipped.source[segment]],
                      dvec3(view_to_object_[number] * dvec4(position, 1.0)));
    const Pose::Seen seen = now_.seen(point, here, number);
    const dvec2 way = dvec2(clipped.px[segment + 1]) - dvec2(clipped.px[segment]);
    const double square = glm::dot(way, way);
    const bool across = paths.of_view[path] && paths.of_view[path] != path::makes_tone && square > 0.0;
    const auto from_here = [&](const Beside& beside) {
        if (!beside.pose) return dvec2(0.0);
        const Pose::Seen there = beside.pose->seen(point, here, beside.number[number]);
        if (!(seen.depth > 0.0 && there.depth > 0.0)) return dvec2(0.0);
        const dvec2 by = there.px - seen.px;
        return across ? by - glm::dot(by, way) / square * way : by;
    };
    return {vec2(from_here(before_)), vec2(-from_here(after_))};
}

}  // namespace fovea::draw
