// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/light_eye.h>

#include <algorithm>

#include <fovea/base/parallel.h>
#include <fovea/line/look_at.h>
#include <fovea/scene/bodies.h>

namespace fovea::line {

LightEye::LightEye(const Scene& scene, const Light& of)
    : light(of), tracer(scene, view_from(of, scene)), radius(radius_of(scene)), step(step_of(scene)) {}

bool LightEye::shines_at(const dvec3& point) const {
    if (tracer.cuts_away(point)) return false;
    const double cone = cone_of(light);
    return cone <= -1.0 || glm::dot(point, light.direction) >= cone * glm::length(point);
}

dvec3 LightEye::on_ray(const dvec3& point, double t) const {
    return tracer.view().orthographic ? dvec3(point.x, point.y, t * point.z) : t * point;
}

bool LightEye::is_one_body(const Hit& hit, const Ignore& ignore) const {
    if (hit.placement != ignore.placement) return false;
    const Surface& surface = *tracer.scene().placements[hit.placement].surface;
    const auto bodies = bodies_of(surface);
    const Index own = ignore.begin == ignore.end ? ignore.facet : ignore.begin->facet();
    return bodies->of_facet[surface.triangle_facet[hit.triangle]] == bodies->of_facet[own];
}

LightEye::Passing LightEye::pass(const dvec3& point, const Ignore& ignore) const {
    if (!shines_at(point)) return {};
    const std::optional<Hit> hit = tracer.along(point, ignore);
    if (!hit) return {.lit = true};
    const bool of_sun = tracer.view().orthographic;
    const double distance = of_sun ? -point.z : glm::length(point);
    const double margin = 2.0 * scene::ray_margin * std::min(distance, radius) / distance;
    if (hit->t > 1.0 + margin) return {.lit = true, .hit = hit};
    // Where a body stands on another, its edges are the outline of what it hides; it casts nothing there.
    if (hit->t < 1.0 - margin || !is_one_body(*hit, ignore)) return {.lit = false, .hit = hit};
    return {.lit = true, .hit = tracer.along(point, ignore, 1.0 + margin)};
}

Array<Index> outline_edges(const SurfaceView& seen) {
    const Surface& surface = *seen.tracer->scene().placements[seen.placement].surface;
    const dvec3 eye = glm::inverse(seen.surface.stretch()) * seen.eye_obj;
    const dvec4 homogeneous(eye, seen.orthographic ? 0.0 : 1.0);
    const auto bodies = bodies_of(surface);
    const Array<std::uint8_t> facing = facing_of(seen, 0.0);
    const auto is_outline = [&](Index e) {
        bool any = false, first = false;
        for (const EdgeSide side : surface.sides(e)) {
            const Index facet = side.facet();
            if (bodies->of_facet[facet] == none || surface.culled(facet, homogeneous)) continue;
            // A front-facing facet that winds along the edge is to its left in the image.
            const bool left = bool(facing[facet]) == side.forward();
            if (any && left != first) return false;
            first = left;
            any = true;
        }
        return any;
    };
    return parallel_where(surface.edges.size(), is_outline);
}

}  // namespace fovea::line
