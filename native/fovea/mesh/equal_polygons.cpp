// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/mesh/equal_polygons.h>

#include <atomic>

#include <fovea/base/parallel.h>

namespace fovea::mesh {

bool all_polygons_have(int corners, In<glm::ivec2> edge_verts, In<int> corner_verts, In<int> corner_edges) {
    const auto each = std::size_t(corners);
    if (corner_verts.size() != corner_edges.size() || corner_verts.size() % each != 0) return false;
    std::atomic<bool> all{true};
    const auto joins = [&](std::size_t corner, std::size_t next) {
        const auto edge = std::size_t(corner_edges[corner]);  // a negative one is out of range, too
        if (edge >= edge_verts.size()) return false;
        const int from = corner_verts[corner], to = corner_verts[next];
        const glm::ivec2 ends = edge_verts[edge];
        return from != to && ((ends.x == from && ends.y == to) || (ends.x == to && ends.y == from));
    };
    parallel_blocks(corner_verts.size() / each, 4096, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t polygon = begin; polygon < end && all.load(std::memory_order_relaxed); ++polygon)
            for (std::size_t i = 0; i < each; ++i)
                if (!joins(each * polygon + i, each * polygon + (i + 1) % each)) all = false;
    });
    return all;
}

}  // namespace fovea::mesh
