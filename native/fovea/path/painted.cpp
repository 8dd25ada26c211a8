// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/painted.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/mesh/corners.h>

namespace fovea::path {
namespace {

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

/// The values of one placement.
template <typename T>
class Sampler {
   public:
    Sampler(const Surface& surface, In<T> values, const T& instead, PaintedOn on)
        : surface_(surface), values_(values), instead_(instead), on_(on) {}

    T at_point(const Paths& paths, Index point) const {
        const Index place = paths.place[point];
        if (surface_.is_edge(place)) {
            const Edge edge = surface_.edges[place];
            return glm::mix(at_end(place, edge.x), at_end(place, edge.y), paths.edge_t[point]);
        }
        const Index triangle = surface_.triangle_at(place);
        const Index polygon = surface_.facet_polygon[surface_.triangle_facet[triangle]];
        const auto corners = triangle_corners(surface_, triangle);
        const vec3 share = shares(surface_, surface_.triangles[triangle], paths.points_obj[point]);
        T value(0.0f);
        for (int k = 0; k < 3; ++k) value += share[k] * of_corner(polygon, corners[k]);
        return value;
    }

   private:
    T value(std::size_t i) const { return i < values_.size() ? painted_value(values_[i], instead_) : instead_; }
    T of_corner(Index polygon, Index corner) const {
        if (on_ == PaintedOn::materials) return value(static_cast<std::size_t>(surface_.polygon_material[polygon]));
        return value(on_ == PaintedOn::surface ? 0 : corner);
    }

    /// Mean, over the polygons at an edge, of their values at one of its vertices.
    T at_end(Index edge, Index vertex) const {
        const In<EdgeSide> sides = surface_.sides(edge);
        if (sides.empty()) {
            if (on_ != PaintedOn::corners) return value(0);
            return surface_.corner_count() == 0 ? value(vertex) : instead_;
        }
        T sum(0.0f);
        for (const EdgeSide side : sides) {
            const Index polygon = surface_.facet_polygon[side.facet()];
            sum += of_corner(polygon, corner_at(surface_, polygon, vertex));
        }
        return sum / static_cast<float>(sides.size());
    }

    const Surface& surface_;
    In<T> values_;
    T instead_;
    PaintedOn on_;
};

template <typename T>
void check_sizes(const std::vector<In<T>>& painted, const Scene& scene, PaintedOn on) {
    check(painted.size() == scene.placements.size(), "painted: one array per placement expected");
    if (on != PaintedOn::corners) return;
    for (std::size_t i = 0; i < painted.size(); ++i) {
        const Surface& surface = *scene.placements[i].surface;
        const std::size_t corners = surface.corner_count(), expected = corners ? corners : surface.vertex_count();
        check(painted[i].empty() || painted[i].size() == expected,
              surface.name() + ": one painted value per " + (corners ? "corner" : "vertex") + " expected");
    }
}

template <typename T>
Array<T> on_paths(const Paths& paths, const Scene& scene, const std::vector<In<T>>& painted, const T& instead,
                  PaintedOn on) {
    check_sizes(painted, scene, on);
    Array<T> values(paths.points_obj.size(), instead);
    parallel_blocks(paths.count(), 64, [&](std::size_t, std::size_t first, std::size_t last) {
        for (std::size_t p = first; p < last; ++p) {
            const Index placement = paths.placement[p];
            if (placement == none || painted[placement].empty()) continue;
            const Sampler<T> sampler(*scene.placements[placement].surface, painted[placement], instead, on);
            for (Index i = paths.rows.begin(Index(p)); i < paths.rows.end(Index(p)); ++i)
                values[i] = sampler.at_point(paths, i);
        }
    });
    return values;
}

}  // namespace

float painted_value(float value, float instead) { return value == value ? std::clamp(value, 0.0f, 1.0f) : instead; }

vec3 painted_value(const vec3& value, const vec3& instead) {
    return glm::any(glm::isnan(value)) ? instead : glm::clamp(value, 0.0f, most_light);
}

void check_painted(const Painted& painted, const Scene& scene) { check_sizes(painted, scene, PaintedOn::corners); }

Array<float> values_on_paths(const Paths& paths, const Scene& scene, const Painted& painted, float instead,
                             PaintedOn on) {
    return on_paths(paths, scene, painted, instead, on);
}

Array<vec3> values_on_paths(const Paths& paths, const Scene& scene, const PaintedColors& painted, const vec3& instead,
                            PaintedOn on) {
    return on_paths(paths, scene, painted, instead, on);
}

}  // namespace fovea::path
