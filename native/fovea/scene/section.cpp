// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/section.h>

#include <fovea/scene/bodies.h>

namespace fovea::scene {
namespace {

/// Share of coordinates that exceeds their rounding in single precision.
constexpr double rounding = 1e-6;

/// Makes image-space sides of segments in the section plane.
class Sides {
   public:
    Sides(const View& view, const dvec4& plane) : view_(view), near_z_(-view.near_clip) {
        const dvec3 normal(plane);
        back_ = dvec3(0, 0, 1) - normal * normal.z;
    }

    /// Appends a segment. What is before the near plane is moved, in the section plane, to where both planes meet.
    void append(dvec3 from, dvec3 to, Array<SectionSide>& out) const {
        const bool from_in = from.z <= near_z_, to_in = to.z <= near_z_;
        if (!from_in && !to_in && back_.z < 1e-12) return;
        if (from_in != to_in) {
            const dvec3 at = glm::mix(from, to, (near_z_ - from.z) / (to.z - from.z));
            put(from_in ? from : moved(from), at, out);
            put(at, to_in ? to : moved(to), out);
        } else {
            put(from_in ? from : moved(from), to_in ? to : moved(to), out);
        }
    }

   private:
    dvec3 moved(const dvec3& point) const { return point + back_ * ((near_z_ - point.z) / back_.z); }
    void put(const dvec3& from, const dvec3& to, Array<SectionSide>& out) const {
        const auto px = [&](const dvec3& p) { return to_pixels(view_, view_.view_to_clip * dvec4(p, 1.0)); };
        const SectionSide side{px(from), px(to)};
        const dvec2 sum = side.from + side.to;
        if (std::isfinite(sum.x + sum.y)) out.push_back(side);
    }

    const View& view_;
    double near_z_;
    dvec3 back_;  // the view's z axis, projected into the plane
};

void append_sides(const Placement& placement, const Cut& cut, const View& view, const Sides& sides,
                  Array<SectionSide>& out) {
    const Surface& surface = *placement.surface;
    const auto bodies = bodies_of(surface);
    const dmat4 object_to_view = view.world_to_view * placement.object_to_world;
    const bool mirrored = glm::determinant(dmat3(placement.object_to_world)) < 0.0;
    for (Index t = 0; t < surface.occluding_triangles; ++t) {
        const Triangle& triangle = surface.triangles[t];
        double before[3];
        int cut_away = 0;
        for (int k = 0; k < 3; ++k) cut_away += (before[k] = cut.before(surface.positions[triangle[k]])) > 0.0;
        if (cut_away == 0 || cut_away == 3) continue;
        const Index body = bodies->of_facet[surface.triangle_facet[t]];
        if (body == none || !bodies->solid[body]) continue;
        // Counterclockwise around the triangle seen from outside, the side where it goes down comes first.
        dvec3 down(0.0), up(0.0);
        for (int k = 0; k < 3; ++k) {
            const int next = (k + 1) % 3;
            if ((before[k] > 0.0) == (before[next] > 0.0)) continue;
            // Of a side, the same point from both of its triangles.
            const bool ahead = triangle[k] < triangle[next];
            const int a = ahead ? k : next, b = ahead ? next : k;
            const dvec3 at = glm::mix(dvec3(surface.positions[triangle[a]]), dvec3(surface.positions[triangle[b]]),
                                      before[a] / (before[a] - before[b]));
            (before[k] > 0.0 ? down : up) = dvec3(object_to_view * dvec4(at, 1.0));
        }
        if (mirrored) std::swap(down, up);
        sides.append(down, up, out);
    }
}

}  // namespace

Cut cut_of(const Scene& scene, const Placement& placement) {
    Cut cut;
    if (!scene.section) return cut;
    const Surface& surface = *placement.surface;
    cut.plane = glm::transpose(placement.object_to_world) * *scene.section;
    const double turn = glm::length(dvec3(cut.plane)), radius = surface.radius;
    cut.slack = rounding * (turn * (glm::length(dvec3(surface.center)) + radius) + std::abs(cut.plane.w));
    cut.plane.w -= cut.slack;
    const double middle = cut.before(surface.center), reach = turn * radius;
    cut.kept = middle + reach <= 0.0 ? Cut::all : middle - reach > 0.0 ? Cut::nothing : Cut::part;
    return cut;
}

std::optional<dvec4> section_in_view(const Scene& scene, const View& view) {
    if (!scene.section) return {};
    const dvec4 plane = glm::transpose(glm::inverse(view.world_to_view)) * *scene.section;
    return plane / glm::length(dvec3(plane));
}

bool faces_section(const dvec4& plane_view, const View& view) {
    return view.orthographic ? plane_view.z > 0.0 : plane_view.w > 0.0;
}

Array<SectionSide> section_sides(const Scene& scene, const View& view) {
    const auto plane = section_in_view(scene, view);
    if (!plane || !faces_section(*plane, view)) return {};
    const Sides sides(view, *plane);
    return parallel_collect<SectionSide>(scene.placements.size(), 1,
                                         [&](std::size_t begin, std::size_t end, auto& out) {
                                             for (std::size_t i = begin; i < end; ++i) {
                                                 const Placement& placement = scene.placements[i];
                                                 if (!(placement.usage & usage_draw) || !in_frame(placement, view, 0.1))
                                                     continue;
                                                 const Cut cut = cut_of(scene, placement);
                                                 if (cut.kept == Cut::part)
                                                     append_sides(placement, cut, view, sides, out);
                                             }
                                         });
}

}  // namespace fovea::scene
