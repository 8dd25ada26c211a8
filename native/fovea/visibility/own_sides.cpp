// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/own_sides.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/visibility/depth.h>

namespace fovea::visibility {
namespace {

/// The largest triangle of each facet of a surface: slivers say little about where a facet lies.
struct FacetTriangles {
    Array<Index> triangle;
};

/// Data shared by all facets of a placement.
struct PlacedSurface {
    const Surface* surface = nullptr;
    bool occludes = false;
    std::shared_ptr<const FacetTriangles> triangles;
    dvec4 eye_obj;         // homogeneous; for an orthographic view the direction towards the viewer
    dmat4 plane_to_depth;  // object-space planes to planes over (pixels, depth)
};

double area(const Surface& surface, Index triangle) {
    return glm::length(mesh::area_vector(surface.positions, surface.triangles[triangle]));
}

FacetTriangles facet_triangles(const Surface& surface) {
    FacetTriangles result;
    result.triangle.assign(surface.facet_count(), none);
    for (Index t = 0; t < surface.triangles.size(); ++t) {
        Index& largest = result.triangle[surface.triangle_facet[t]];
        if (largest == none || area(surface, t) >= area(surface, largest)) largest = t;
    }
    return result;
}

std::vector<PlacedSurface> place(const Scene& scene, const View& view) {
    const DepthBuffer layout = depth_layout(view, {.scale = 1, .margin = 0.0});
    dmat4 to_pixels(1.0);
    to_pixels[0][0] = 0.5 * view.width;
    to_pixels[1][1] = 0.5 * view.height;
    const dmat4 view_to_depth = to_pixels * view_to_depth_clip(view, layout);
    std::vector<PlacedSurface> placed(scene.placements.size());
    parallel_for(placed.size(), 64, [&](std::size_t i) {
        const Placement& placement = scene.placements[i];
        const dmat4 object_to_view = view.world_to_view * placement.object_to_world;
        placed[i].surface = placement.surface.get();
        placed[i].occludes = placement.usage & usage_occlude;
        placed[i].triangles =
            placement.surface->cache().get<FacetTriangles>(0, [&] { return facet_triangles(*placement.surface); });
        placed[i].eye_obj = glm::inverse(object_to_view) * (view.orthographic ? dvec4(0, 0, 1, 0) : dvec4(0, 0, 0, 1));
        placed[i].plane_to_depth = glm::transpose(glm::inverse(view_to_depth * object_to_view));
    });
    return placed;
}

/// A facet found by its number over the whole scene.
struct Facet {
    const PlacedSurface* placed = nullptr;
    Index number = none;  // facet number in its surface
    dvec4 plane() const {
        const vec4 p = placed->surface->facet_plane[number];
        return dvec4(p.x, p.y, p.z, -p.w);
    }
    Index triangle() const { return placed->triangles->triangle[number]; }
    bool occludes() const {
        return placed->occludes && triangle() < placed->surface->occluding_triangles &&
               !placed->surface->culled(number, placed->eye_obj);
    }
    bool faces_viewer() const { return glm::dot(plane(), placed->eye_obj) >= 0.0; }
    /// Depth slope of a front-facing facet; 0 for others, which do not rise in front of a line.
    float rise() const {
        if (!placed || !faces_viewer()) return 0.0f;
        const dvec4 p = placed->plane_to_depth * plane();
        const double slope = glm::length(dvec2(p.x, p.y)) / std::abs(p.z);
        return static_cast<float>(slope < max_depth_slope ? slope : max_depth_slope);  // also for NaN (0 / 0, edge-on)
    }
};

Facet find_facet(const Scene& scene, const std::vector<PlacedSurface>& placed, Index facet) {
    if (facet == none) return {};
    const auto after = std::upper_bound(scene.facet_base.begin(), scene.facet_base.end(), facet);
    if (after == scene.facet_base.begin()) return {};
    const std::size_t i = after - scene.facet_base.begin() - 1;
    const Index number = facet - scene.facet_base[i];
    return number < placed[i].surface->facet_count() ? Facet{&placed[i], number} : Facet{};
}

/// Whether the edge between facets `a` and `b` is concave: `b` rises in front of `a`. Also true where they intersect,
/// in one placement or two.
bool groove(const Facet& a, const Facet& b) {
    if (a.placed != b.placed) return true;
    const Surface& surface = *b.placed->surface;
    double farthest = 0.0, front = 0.0;
    for (int k = 0; k < 3; ++k) {
        const vec3 corner = surface.positions[surface.triangles[b.triangle()][k]];
        const double away = glm::dot(a.plane(), dvec4(dvec3(corner), 1.0));
        if (std::abs(away) > std::abs(farthest)) farthest = away;
        front = std::max(front, away);
    }
    return front > 1e-3 * std::abs(farthest);
}

}  // namespace

void check_sides(const ClippedPaths& clipped, const OwnSides& sides, const char* what) {
    check(sides.steepness.size() == clipped.px.size() && sides.inner.size() == clipped.px.size(),
          std::string(what) + ": own sides of other paths");
}

OwnSides own_sides(const ClippedPaths& clipped, const Scene& scene, const View& view) {
    const std::vector<PlacedSurface> placed = place(scene, view);
    OwnSides sides;
    sides.steepness.resize(clipped.px.size());
    sides.inner.resize(clipped.px.size());
    parallel_for(clipped.px.size(), [&](std::size_t i) {
        const Facet a = find_facet(scene, placed, clipped.facet0[i]), b = find_facet(scene, placed, clipped.facet1[i]);
        sides.steepness[i] = std::max(a.rise(), b.rise());
        sides.inner[i] = 0;
        if (!a.placed || !b.placed || !a.occludes() || !b.occludes()) return;
        const int facing = int(a.faces_viewer()) + int(b.faces_viewer());
        sides.inner[i] = facing == 0 || (facing == 1 && groove(a, b));
    });
    return sides;
}

}  // namespace fovea::visibility
