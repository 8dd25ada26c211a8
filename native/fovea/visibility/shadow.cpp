// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/shadow.h>

#include <fovea/project/clip.h>

namespace fovea::visibility {

Shadow::Shadow(In<dvec3> corners, bool orthographic, double near_clip, double margin) {
    const dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    // Positive if the normal points away from the eye. Perspective: signed distance of the plane from the eye times the
    // normal's length; orthographic: the normal's component along the view.
    const double facing = orthographic ? -normal.z : glm::dot(normal, corners[0]);
    if (facing == 0.0) return;
    for (const dvec3& corner : corners)
        if (-corner.z < near_clip) return;
    const dvec3 away = facing > 0.0 ? normal : -normal;
    const double reach = glm::length(corners[0]) * glm::length(away);
    planes_[0] = dvec4(away, -glm::dot(away, corners[0]) - margin * (orthographic ? reach : std::abs(facing)));
    const std::size_t sides = corners.size();
    for (std::size_t i = 0; i < sides; ++i) {
        const dvec3 &a = corners[i], &b = corners[(i + 1) % sides], &c = corners[(i + 2) % sides];
        dvec3 side = orthographic ? glm::cross(b - a, dvec3(0, 0, 1)) : glm::cross(a, b);
        double offset = orthographic ? -glm::dot(side, a) : 0.0;
        const double inside = glm::dot(side, c) + offset;
        if (inside == 0.0) return;
        const double sign = inside > 0.0 ? 1.0 : -1.0;
        planes_[i + 1] = sign * dvec4(side, offset);
    }
    count_ = static_cast<int>(sides) + 1;
    usable_ = true;
}

Interval Shadow::hides(const dvec3& a, const dvec3& b) const {
    if (!usable_) return {};
    ClipRange range;
    for (int i = 0; i < count_ && range.begin <= range.end; ++i) {
        const dvec3 normal(planes_[i]);
        clip_plane(glm::dot(normal, a) + planes_[i].w, glm::dot(normal, b) + planes_[i].w, range);
    }
    return {range.begin, range.end};
}

Occluding::Occluding(const Tracer& tracer, const Hit& hit) : placement_(hit.placement) {
    const Outline outline = tracer.outline(hit);
    const View& view = tracer.view();
    if (outline.count > 0)
        shadow_ = Shadow({outline.corners, std::size_t(outline.count)}, view.orthographic, view.near_clip, ray_margin);
    triangle_ = outline.triangle;
    other_ = outline.other;
}

Interval Occluding::hides(const Tracer& tracer, const Segment& segment) const {
    if (!shadow_.usable()) return {};
    const Ignore& ignore = segment.ignore;
    const Surface& surface = *tracer.scene().placements[placement_].surface;
    // The distance to a curve's own surface is handled by rays only.
    if (placement_ == ignore.placement && ignore.across_triangles()) return {};
    if (ignore.holds(placement_, surface, triangle_)) return {};
    if (other_ != none && ignore.holds(placement_, surface, other_)) return {};
    const Interval interval = shadow_.hides(segment.a, segment.b);
    if (interval.begin > interval.end) return {};
    return {segment.to_screen(interval.begin), segment.to_screen(interval.end)};
}

}  // namespace fovea::visibility
