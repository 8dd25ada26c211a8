// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/content.h>

#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <unordered_map>

#include <fovea/base/hash.h>

namespace fovea::draw {
namespace {

/// Hash of arrays and numbers in their order.
class Content {
   public:
    template <typename... Arrays>
    void add(const Arrays&... arrays) {
        ((hash_ =
              hash_bytes(arrays.data(), arrays.size() * sizeof(*arrays.data()), hash_numbers(hash_, arrays.size()))),
         ...);
    }
    template <typename... Numbers>
    void add_numbers(Numbers... numbers) {
        hash_ = hash_numbers(hash_, numbers...);
    }
    template <typename... Numbers>
    void add_reals(Numbers... numbers) {
        add(std::array{double(numbers)...});
    }
    std::uint64_t hash() const { return hash_; }

   private:
    std::uint64_t hash_ = 0;
};

template <typename Matrix>
In<double> numbers_of(const Matrix& matrix) {
    return {glm::value_ptr(matrix), sizeof(Matrix) / sizeof(double)};
}

std::uint64_t content_of(const Surface& s) {
    const mesh::FieldOptions& o = s.field_options();
    Content content;
    content.add(In<vec3>(s.positions.data(), s.vertex_count()), s.rest(), s.jets, s.edges, s.edge_marks,
                s.polygon_material, s.polygon_one_sided, s.triangles, s.triangle_facet, s.facet_polygon);
    if (s.corner_count() > 0) content.add(In<Index>(s.polygon_vertices(0).data(), s.corner_count()));
    content.add_numbers(s.mesh_edges, s.occluding_triangles, s.two_sided_triangles, s.shape(), o.estimator, o.degree,
                        o.rings);
    content.add_reals(o.smoothing, o.hard_angle);
    return content.hash();
}

void add_filter(const path::MaterialFilter& filter, Content& content) {
    content.add(filter.row);
    for (const auto& mask : filter.masks) content.add(mask);
}

void add_overrides(const Overrides& overrides, Content& content) {
    content.add(overrides.importance, overrides.lines.kinds);
    for (const auto& [paint, painted] : overrides.painted) {
        std::unordered_map<const float*, std::uint64_t> known;  // instances share their arrays
        content.add_numbers(paint.source);
        content.add(paint.name);
        for (const In<float> values : painted) {
            const auto [at, fresh] = known.try_emplace(values.data());
            if (fresh) at->second = base::hash_of(values);
            content.add_numbers(at->second);
        }
    }
    for (const auto& own : overrides.lines.parameters) {
        content.add_numbers(own.definition, own.parameter);
        content.add(own.values);
    }
    add_filter(overrides.lines.materials, content);
    for (const Overrides::Filter& filter : overrides.line_sets) {
        content.add(filter.placements);
        add_filter(filter.materials, content);
    }
    if (overrides.density_map) content.add_numbers(overrides.density_map->content());
}

}  // namespace

std::uint64_t content_of(const Scene& scene, const View& view, const Overrides& overrides) {
    Content content;
    std::unordered_map<const Surface*, std::uint64_t> known;
    for (const scene::Placement& placement : scene.placements) {
        const auto [at, fresh] = known.try_emplace(placement.surface.get());
        if (fresh) at->second = content_of(*placement.surface);
        content.add_numbers(at->second, placement.id, placement.usage, placement.group);
        content.add(numbers_of(placement.object_to_world));
    }
    if (scene.section) content.add(numbers_of(*scene.section));
    for (const scene::Light& light : scene.lights) {
        content.add_numbers(light.kind, light.casts, light.id);
        content.add_reals(light.cos_outer, light.cos_inner, light.color.x, light.color.y, light.color.z);
        for (const dvec3& place : {light.position, light.direction, light.half_side[0], light.half_side[1]})
            content.add(numbers_of(place));
    }
    content.add(numbers_of(view.world_to_view), numbers_of(view.view_to_clip), numbers_of(view.frame));
    content.add_numbers(view.width, view.height, view.orthographic);
    content.add_reals(view.near_clip, view.far_clip, view.reference_scale);
    add_overrides(overrides, content);
    return content.hash();
}

}  // namespace fovea::draw
