// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/shadow_volume.h>

namespace fovea::scene {

ShadowVolume::ShadowVolume(In<dvec3> corners, const View& view, double margin) {
    const bool orthographic = view.orthographic;
    const dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    // Positive if the normal points away from the eye. Perspective: signed distance of the plane from the eye times the
    // normal's length; orthographic: the normal's component along the view.
    const double facing = orthographic ? -normal.z : glm::dot(normal, corners[0]);
    if (facing == 0.0) return;
    // Without a near plane, as from a light, corners may be all around.
    for (const dvec3& corner : corners)
        if (view.has_near_plane() && -corner.z < view.near_clip) return;
    const dvec3 away = facing > 0.0 ? normal : -normal;
    double farthest = 0.0;
    for (const dvec3& corner : corners) farthest = std::max(farthest, glm::length(corner));
    const double reach = farthest * glm::length(away);
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

Interval ShadowVolume::inside(const dvec3& a, const dvec3& b, int first_plane) const {
    if (!usable_) return {};
    Interval range = whole_segment;
    for (int i = first_plane; i < count_ && !range.is_empty(); ++i) {
        const dvec4& plane = planes_[i];
        const dvec2 at = plane.x * dvec2(a.x, b.x) + plane.y * dvec2(a.y, b.y) + plane.z * dvec2(a.z, b.z) + plane.w;
        clip_plane(at.x, at.y, range);
    }
    return range;
}

Occluding::Occluding(const Tracer& tracer, const Hit& hit, double margin) : placement_(hit.placement) {
    const Outline outline = tracer.outline(hit);
    if (outline.count > 0) volume_ = ShadowVolume({outline.corners, std::size_t(outline.count)}, tracer.view(), margin);
    triangle_ = outline.triangle;
    other_ = outline.other;
}

Interval Occluding::hides(const Tracer& tracer, const dvec3& a, const dvec3& b, const Ignore& ignore) const {
    const Interval hidden = volume_.hides(a, b);
    if (hidden.is_empty() || ignore.leaves_to_rays(placement_)) return {};
    const Surface& surface = *tracer.scene().placements[placement_].surface;
    if (ignore.holds(placement_, surface, triangle_)) return {};
    if (other_ != none && ignore.holds(placement_, surface, other_)) return {};
    return hidden;
}

}  // namespace fovea::scene
