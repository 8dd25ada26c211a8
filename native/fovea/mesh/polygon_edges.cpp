// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/mesh/polygon_edges.h>

#include <algorithm>
#include <unordered_map>

#include <fovea/base/check.h>

namespace fovea {

PolygonEdges polygon_edges(In<int> polygon_offsets, In<int> corner_verts) {
    check(polygon_offsets.empty() ||
              (polygon_offsets.front() >= 0 && std::is_sorted(polygon_offsets.begin(), polygon_offsets.end()) &&
               std::size_t(polygon_offsets.back()) <= corner_verts.size()),
          "polygon_offsets must ascend and stay within corner_verts");
    PolygonEdges result;
    result.corner_edges.resize(corner_verts.size());
    std::unordered_map<std::uint64_t, int> known;
    known.reserve(corner_verts.size());
    for (std::size_t f = 0; f + 1 < polygon_offsets.size(); ++f) {
        for (int c = polygon_offsets[f]; c < polygon_offsets[f + 1]; ++c) {
            const int a = corner_verts[c];
            const int b = corner_verts[c + 1 < polygon_offsets[f + 1] ? c + 1 : polygon_offsets[f]];
            const auto key = std::uint64_t(std::min(a, b)) << 32 | std::uint32_t(std::max(a, b));
            const auto [it, inserted] = known.try_emplace(key, static_cast<int>(result.edge_verts.size()));
            if (inserted) result.edge_verts.push_back({a, b});
            result.corner_edges[c] = it->second;
        }
    }
    return result;
}

}  // namespace fovea
