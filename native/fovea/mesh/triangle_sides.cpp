// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/mesh/triangle_sides.h>

#include <algorithm>

#include <fovea/base/parallel.h>

namespace fovea::mesh {
namespace {

/// Numbers sides by lower vertex, then by higher vertex.
TriangleSides number_sides(const Surface& surface) {
    const std::size_t count = surface.triangles.size();
    const auto ends = [&](std::size_t corner) {
        const Triangle& t = surface.triangles[corner / 3];
        const Index a = t[int(corner % 3)], b = t[int((corner + 1) % 3)];
        return Edge(std::min(a, b), std::max(a, b));
    };
    struct Corner {
        Index other, corner;  // 3 t + i
        auto operator<=>(const Corner&) const = default;
    };
    Lists<Corner> sides_at = lists_of_ranges<Corner>(surface.vertex_count(), [&](const auto& give) {
        for (std::size_t corner = 0; corner < 3 * count; ++corner) {
            const Edge e = ends(corner);
            give(e.x, Corner{e.y, static_cast<Index>(corner)});
        }
    });
    parallel_for(sides_at.count(), [&](std::size_t v) { std::ranges::sort(sides_at[Index(v)]); });
    // number of sides of each vertex, then (prefix sum) the number of its first side
    Array<Index> first = parallel_map<Index>(surface.vertex_count(), [&](std::size_t v) {
        const In<Corner> corners = sides_at[Index(v)];
        Index sides = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) sides += i == 0 || corners[i].other != corners[i - 1].other;
        return sides;
    });
    counts_to_offsets(first);
    TriangleSides sides;
    sides.of_triangle.resize(count);
    sides.vertices.resize(first.back());
    parallel_for(surface.vertex_count(), [&](std::size_t v) {
        Index number = first[v] - 1;
        const In<Corner> corners = sides_at[Index(v)];
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if (i == 0 || corners[i].other != corners[i - 1].other)
                sides.vertices[++number] = Edge(static_cast<Index>(v), corners[i].other);
            sides.of_triangle[corners[i].corner / 3][int(corners[i].corner % 3)] = number;
        }
    });
    return sides;
}

}  // namespace

std::shared_ptr<const TriangleSides> triangle_sides(const Surface& surface) {
    if (surface.source()) return triangle_sides(*surface.source());
    return surface.cache().get<TriangleSides>(0, [&] { return number_sides(surface); });
}

std::shared_ptr<const Lists<Index>> triangles_at_sides(const Surface& surface) {
    struct AtSides : Lists<Index> {};
    return surface.cache().get<AtSides>(0, [&] {
        const auto sides = triangle_sides(surface);
        return AtSides{lists_of_ranges<Index>(sides->vertices.size(), [&](const auto& give) {
            for (Index t = 0; t < sides->of_triangle.size(); ++t)
                for (int i = 0; i < 3; ++i) give(sides->of_triangle[t][i], t);
        })};
    });
}

}  // namespace fovea::mesh
