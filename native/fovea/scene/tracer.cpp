// SPDX-License-Identifier: GPL-3.0-or-later
// Queries of the tracer; the intersection of rays and triangles is in bvh.cpp.
#include <fovea/scene/tracer.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/scene/bvh.h>
#include <fovea/scene/section.h>

namespace fovea::scene {
namespace {

/// Whether the quadrilateral is convex, and planar within a tenth of ray_margin, so that it hides no more than its two
/// triangles do.
bool is_flat_and_convex(const Outline& quad) {
    const dvec3* c = quad.corners;
    const dvec3 normal = glm::cross(c[1] - c[0], c[3] - c[0]);
    if (std::abs(glm::dot(normal, c[2] - c[0])) > 0.1 * ray_margin * glm::length(normal) * glm::length(c[2]))
        return false;
    for (int i = 0; i < 4; ++i)
        if (glm::dot(glm::cross(c[(i + 1) % 4] - c[i], c[(i + 2) % 4] - c[i]), normal) <= 0.0) return false;
    return true;
}

}  // namespace

Tracer::Tracer(const Scene& scene, const View& view)
    : scene_(scene),
      view_(view),
      clip_to_view_(glm::inverse(view.view_to_clip)),
      section_(section_in_view(scene, view)),
      bvh_(std::make_unique<Bvh>(scene, !view.has_near_plane())) {
    bvh_->object_to_view.resize(scene.placements.size());
    bvh_->build(
        parallel_collect<Index>(scene.placements.size(), 4096, [&](std::size_t begin, std::size_t end, auto& hiding) {
            for (auto i = static_cast<Index>(begin); i < end; ++i) {
                const Placement& placement = scene.placements[i];
                bvh_->object_to_view[i] = view.world_to_view * placement.object_to_world;
                const bool hides = placement.usage & (usage_occlude | usage_holdout);
                if (hides && placement.surface->occluding_triangles > 0 && in_frame(placement, view, 0.1) &&
                    cut_of(scene, placement).kept != Cut::nothing)
                    hiding.push_back(i);
            }
        }));
}

Tracer::~Tracer() = default;

void prepare_rays(const Surface& surface) { bvh_of(surface); }

Ray Tracer::ray_to(const vec3& point) const {
    if (view_.orthographic) {
        const float near_z = static_cast<float>(-view_.near_clip), length = near_z - point.z;
        const float margin = static_cast<float>(ray_margin) * std::max(std::abs(point.z), glm::length(vec2(point)));
        return behind_section({vec3(point.x, point.y, near_z), vec3(0, 0, -length), 0.0f,
                               length > margin ? 1.0f - margin / length : -1.0f});
    }
    // Without a near plane, as from a light, there are points all around.
    const float near_t = view_.has_near_plane() ? static_cast<float>(view_.near_clip) / -point.z : 0.0f;
    return behind_section({vec3(0.0f), point, near_t, static_cast<float>(1.0 - ray_margin)});
}

std::optional<Hit> Tracer::occluder(const vec3& point, const Ignore& ignore) const {
    return nearest(ray_to(point), ignore);
}

std::optional<Hit> Tracer::along(const dvec3& point, const Ignore& ignore, double near_t) const {
    const dvec3 eye = view_.orthographic ? dvec3(point.x, point.y, 0.0) : dvec3(0.0);
    return nearest(behind_section({eye, point - eye, near_t, infinity}), ignore);
}

bool Tracer::is_blocked(const dvec3& origin, const dvec3& point, double before, const Ignore& ignore,
                        Blocker& last) const {
    return bvh_->is_blocked(behind_section({origin, point - origin, 0.0, before}), ignore, last);
}

Ray Tracer::ray_beyond(const vec3& point) const {
    if (view_.orthographic) {
        const float reach = std::max(std::abs(point.z), 1e-6f);
        return behind_section({point, vec3(0, 0, -reach), static_cast<float>(ray_margin), infinity});
    }
    return behind_section({vec3(0.0f), point, static_cast<float>(1.0 + ray_margin), infinity});
}

bool Tracer::cuts_away(const dvec3& point) const {
    return section_ && glm::dot(*section_, dvec4(point, 1.0)) > ray_margin * glm::length(point);
}

Ray Tracer::behind_section(Ray ray) const {
    if (!section_) return ray;
    const double before = glm::dot(*section_, dvec4(ray.origin, 1.0));
    const double rise = glm::dot(dvec3(*section_), ray.direction);
    // Half the margin, so that nothing hides a line in the plane.
    const double t = -before / rise, margin = 0.5 * ray_margin * std::abs(t);
    if (rise < 0.0)
        ray.near_t = std::max(ray.near_t, double(static_cast<float>(t - margin)));
    else if (rise > 0.0)
        ray.far_t = std::min(ray.far_t, double(static_cast<float>(t + margin)));
    else if (before > 0.0)
        ray.far_t = ray.near_t;
    return ray;
}

std::optional<Hit> Tracer::nearest(const Ray& ray, const Ignore& ignore) const {
    if (ray.far_t <= ray.near_t) return {};
    return bvh_->trace(ray, ignore);
}

/// Sutherland & Hodgman, "Reentrant Polygon Clipping", CACM 1974, for one plane.
Outline Tracer::behind_section(const Outline& whole) const {
    if (!section_) return whole;
    const auto before = [&](const dvec3& point) {
        return glm::dot(*section_, dvec4(point, 1.0)) - ray_margin * glm::length(point);
    };
    Outline kept = whole;
    kept.count = 0;
    for (int i = 0; i < whole.count; ++i) {
        const dvec3 &a = whole.corners[i], &b = whole.corners[(i + 1) % whole.count];
        const double of_a = before(a), of_b = before(b);
        if (of_a <= 0.0) kept.corners[kept.count++] = a;
        if ((of_a <= 0.0) != (of_b <= 0.0)) kept.corners[kept.count++] = glm::mix(a, b, of_a / (of_a - of_b));
    }
    if (kept.count < 3) kept.count = 0;
    return kept;
}

std::optional<Hit> Tracer::behind(const vec3& point, const Ignore& ignore) const {
    return nearest(ray_beyond(point), ignore);
}

bool Tracer::continues_behind(const vec3& point, const Ignore& ignore, Index placement) const {
    constexpr Index few = 256;  // triangles that are asked in less time than other placements take to pass
    const Placement& own = scene_.placements[placement];
    const bool asked_first = own.group == 0 && own.surface->occluding_triangles <= few;
    const Ray ray = ray_beyond(point);
    if (ray.far_t <= ray.near_t) return false;
    const auto hit = asked_first ? bvh_->trace_if_of(placement, ray, ignore) : bvh_->trace(ray, ignore);
    return hit && scene_.share_outline(hit->placement, placement);
}

std::optional<Hit> Tracer::seen(const dvec2& px) const {
    const dvec3 point = on_near_plane(view_, clip_to_view_, px);
    const auto near_distance = static_cast<float>(view_.near_clip);
    if (view_.orthographic)
        return nearest(behind_section({vec3(point.x, point.y, 0.0), vec3(0, 0, -1), near_distance, infinity}), {});
    // Direction scaled so that t is the distance along -z.
    return nearest(behind_section({vec3(0.0f), vec3(point / -point.z), near_distance, infinity}), {});
}

void Tracer::check_current() const {
    for (const Bvh::Version& made : bvh_->surfaces)
        if (made.surface->version() != made.version)
            check(false, made.surface->name() + ": moved after its tracer was made; make a new one");
}

/// Offset of lines across triangles from their surface, at most [px].
constexpr double most_offset_px = 2.0;

Ignore Tracer::ignore_at(Index placement, Index place, Index other_facet, bool contour) const {
    const Surface& surface = *scene_.placements[placement].surface;
    if (surface.is_edge(place)) {
        const EdgeSide* sides = surface.edge_sides.data();
        return {placement, sides + surface.edge_rows.begin(place), sides + surface.edge_rows.end(place)};
    }
    const Index triangle = surface.triangle_at(place);
    if (other_facet != none) {
        const auto& base = scene_.facet_base;
        const auto other =
            static_cast<Index>(std::upper_bound(base.begin(), base.end(), other_facet) - base.begin() - 1);
        return {.placement = placement,
                .facet = surface.triangle_facet[triangle],
                .other_placement = other,
                .other_facet = other_facet - base[other]};
    }
    const auto c = corners(placement, triangle);
    const double longest = std::max({glm::distance(c[0], c[1]), glm::distance(c[1], c[2]), glm::distance(c[2], c[0])});
    Ignore ignore{.placement = placement, .around = surface.triangles[triangle]};
    const dvec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
    const double size = glm::length(normal);
    const bool mirrored = glm::determinant(dmat3(bvh_->object_to_view[placement])) < 0.0;
    const bool away = glm::dot(normal, view_.orthographic ? dvec3(0, 0, 1) : -c[0]) < 0.0;
    // An open shell may be seen from either side; a contour is offset to the outside of its surface.
    const double sign = contour ? (mirrored ? -1.0 : 1.0) : (away ? -1.0 : 1.0);
    const double height = size > 0.0 ? size / longest : 0.0;
    // Roughness is that of triangles; larger ones are flat, with things right before them.
    const double offset = contour ? 0.28 * height : std::min(0.1 * height, most_offset_px * px_at(c));
    if (height > 0.0) ignore.above = vec3(sign * offset / size * normal);
    if (contour) {
        ignore.reach = static_cast<float>(2.0 * longest);
        ignore.bodies = bodies_of(surface).get();  // kept by the surface, which stays as it is as long as the tracer
        ignore.body = ignore.bodies->of_facet[surface.triangle_facet[triangle]];
    }
    return ignore;
}

double Tracer::px_at(const std::array<dvec3, 3>& corners) const {
    const double side = 2.0 / (std::abs(view_.view_to_clip[0][0]) * view_.width);
    if (view_.orthographic) return side;
    return side * std::max(view_.near_clip, -std::max({corners[0].z, corners[1].z, corners[2].z}));
}

std::array<dvec3, 3> Tracer::corners(Index placement, Index triangle) const {
    const Surface& surface = *scene_.placements[placement].surface;
    const glm::dmat4x3 to_view(bvh_->object_to_view[placement]);
    const auto in_view = [&](Index vertex) {
        const dvec3 p(surface.positions[vertex]);
        // As glm's product of a matrix and a vector rounds, which compilers do not inline.
        return (to_view[0] * p.x + to_view[1] * p.y) + (to_view[2] * p.z + to_view[3]);
    };
    const Triangle& t = surface.triangles[triangle];
    return {in_view(t.x), in_view(t.y), in_view(t.z)};
}

Outline Tracer::outline(const Hit& hit) const {
    const auto c = corners(hit.placement, hit.triangle);
    const Surface& surface = *scene_.placements[hit.placement].surface;
    const Triangle& here = surface.triangles[hit.triangle];
    // hit.triangle - 1 wraps around for the first one, and is then out of range
    for (const Index next : {hit.triangle + 1, hit.triangle - 1}) {
        if (next >= surface.occluding_triangles || surface.triangle_facet[next] != surface.triangle_facet[hit.triangle])
            continue;
        const Triangle& there = surface.triangles[next];
        const auto in = [](Index vertex, const Triangle& other) {
            return vertex == other[0] || vertex == other[1] || vertex == other[2];
        };
        int alone = -1, beyond = -1, shared = 0;
        for (int i = 0; i < 3; ++i) {
            if (!in(here[i], there)) alone = i;
            if (in(there[i], here))
                ++shared;
            else
                beyond = i;
        }
        if (shared != 2 || alone < 0) continue;
        const dvec3 opposite = corners(hit.placement, next)[beyond];
        const Outline quad{{c[alone], c[(alone + 1) % 3], opposite, c[(alone + 2) % 3]}, 4, hit.triangle, next};
        if (is_flat_and_convex(quad)) return behind_section(quad);
    }
    return behind_section(Outline{{c[0], c[1], c[2]}, 3, hit.triangle});
}

}  // namespace fovea::scene
