// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/painted.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/mesh/corners.h>

namespace fovea::path {
namespace {

/// Mean, over the polygons at an edge, of their painted values at one of its vertices.
float at_end(const Surface& surface, In<float> values, Index edge, Index vertex) {
    float sum = 0.0f;
    const In<EdgeSide> sides = surface.sides(edge);
    for (const EdgeSide side : sides)
        sum += painted_value(values[corner_at(surface, surface.facet_polygon[side.facet()], vertex)]);
    return sides.empty() ? unpainted : sum / static_cast<float>(sides.size());
}

/// Barycentric coordinates of a point in a triangle's plane, clamped to the triangle; 1/3 each if it has no area.
vec3 shares(const Surface& surface, const Triangle& t, const vec3& point) {
    const dvec3 a(surface.positions[t[0]]);
    const dvec3 ab = dvec3(surface.positions[t[1]]) - a, ac = dvec3(surface.positions[t[2]]) - a, ap = dvec3(point) - a;
    const double bb = glm::dot(ab, ab), bc = glm::dot(ab, ac), cc = glm::dot(ac, ac);
    const double pb = glm::dot(ap, ab), pc = glm::dot(ap, ac), area = bb * cc - bc * bc;
    if (!(area > 0.0)) return vec3(1.0f / 3.0f);
    const double v = (cc * pb - bc * pc) / area, w = (bb * pc - bc * pb) / area;
    const dvec3 inside = glm::max(dvec3(1.0 - v - w, v, w), dvec3(0.0));
    return vec3(inside / (inside.x + inside.y + inside.z));
}

float at_point(const Surface& surface, In<float> values, const Paths& paths, Index point) {
    const Index place = paths.place[point];
    if (surface.is_edge(place)) {
        const Edge edge = surface.edges[place];
        const float first = at_end(surface, values, place, edge.x), second = at_end(surface, values, place, edge.y);
        return glm::mix(first, second, paths.edge_t[point]);
    }
    const Index triangle = surface.triangle_at(place);
    const auto corners = triangle_corners(surface, triangle);
    const vec3 share = shares(surface, surface.triangles[triangle], paths.points_obj[point]);
    float value = 0.0f;
    for (int k = 0; k < 3; ++k) value += share[k] * painted_value(values[corners[k]]);
    return value;
}

}  // namespace

float painted_value(float value) { return value == value ? std::clamp(value, 0.0f, 1.0f) : unpainted; }

void check_painted(const Painted& painted, const Scene& scene) {
    check(painted.size() == scene.placements.size(), "painted: one array per placement expected");
    for (std::size_t i = 0; i < painted.size(); ++i) {
        const Surface& surface = *scene.placements[i].surface;
        check(painted[i].empty() || painted[i].size() == surface.corner_count(),
              surface.name() + ": one painted value per corner expected");
    }
}

Array<float> values_on_paths(const Paths& paths, const Scene& scene, const Painted& painted) {
    check_painted(painted, scene);
    Array<float> values(paths.points_obj.size(), unpainted);
    parallel_blocks(paths.count(), 64, [&](std::size_t, std::size_t first, std::size_t last) {
        for (std::size_t p = first; p < last; ++p) {
            const Index placement = paths.placement[p];
            if (placement == none || painted[placement].empty()) continue;
            const Surface& surface = *scene.placements[placement].surface;
            for (Index i = paths.rows.begin(Index(p)); i < paths.rows.end(Index(p)); ++i)
                values[i] = at_point(surface, painted[placement], paths, i);
        }
    });
    return values;
}

}  // namespace fovea::path
