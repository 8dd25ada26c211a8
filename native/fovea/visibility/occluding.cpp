// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/occluding.h>

namespace fovea {

Occluding::Occluding(const Tracer& tracer, const Hit& hit) : placement_(hit.placement) {
    const Outline outline = tracer.outline(hit);
    const View& view = tracer.view();
    shadow_ = Shadow({outline.corners, std::size_t(outline.count)}, view.orthographic, view.near_clip, ray_margin);
    triangle_ = outline.triangle;
    other_ = outline.other;
}

Interval Occluding::hides(const Tracer& tracer, const Segment& segment) const {
    if (!shadow_.usable()) return {};
    const Ignore& ignore = segment.ignore;
    const Surface& surface = *tracer.scene().placements[placement_].surface;
    // How near a curve's own surface may be, only rays know.
    if (placement_ == ignore.placement && ignore.across_triangles()) return {};
    if (ignore.holds(placement_, surface, triangle_)) return {};
    if (other_ != none && ignore.holds(placement_, surface, other_)) return {};
    const Interval interval = shadow_.hides(segment.a, segment.b);
    if (interval.begin > interval.end) return {};
    return {segment.to_screen(interval.begin), segment.to_screen(interval.end)};
}

}  // namespace fovea
