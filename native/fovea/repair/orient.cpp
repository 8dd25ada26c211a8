// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/repair/orient.h>

#include <algorithm>

#include <fovea/base/disjoint_sets.h>

namespace fovea::repair {
namespace {

/// Polygons along an edge: their number, and the first and last with their direction.
struct Sides {
    Index count = 0;
    EdgeSide first, last;
    bool pair() const { return count == 2 && first.facet() != last.facet(); }
};

std::vector<Sides> sides_of(const RepairedMesh& mesh) {
    std::vector<Sides> sides(mesh.edge_verts.size());
    for (std::size_t f = 0; f + 1 < mesh.polygon_offsets.size(); ++f)
        for (int c = mesh.polygon_offsets[f]; c < mesh.polygon_offsets[f + 1]; ++c) {
            Sides& edge = sides[mesh.corner_edges[c]];
            edge.last = {Index(f), mesh.corner_verts[c] == mesh.edge_verts[mesh.corner_edges[c]].x};
            if (edge.count++ == 0) edge.first = edge.last;
        }
    return sides;
}

/// Six times the signed volume between a polygon and `origin`.
double volume(const RepairedMesh& mesh, Index polygon, const dvec3& origin) {
    double sum = 0.0;
    const int begin = mesh.polygon_offsets[polygon], end = mesh.polygon_offsets[polygon + 1];
    const auto at = [&](int c) { return dvec3(mesh.positions[mesh.corner_verts[c]]) - origin; };
    for (int c = begin + 1; c + 1 < end; ++c) sum += glm::dot(at(begin), glm::cross(at(c), at(c + 1)));
    return sum;
}

/// Reverses a polygon's winding; its first corner stays first.
void turn(RepairedMesh& mesh, Index polygon) {
    const int begin = mesh.polygon_offsets[polygon], end = mesh.polygon_offsets[polygon + 1];
    if (begin == end) return;
    std::reverse(mesh.corner_verts.begin() + begin + 1, mesh.corner_verts.begin() + end);
    std::reverse(mesh.corner_edges.begin() + begin, mesh.corner_edges.begin() + end);
}

/// Union-find over 2 * count nodes: polygon f as it is (f), and flipped (count + f). Nodes that imply each other are
/// joined.
DisjointSets together(const std::vector<Sides>& sides, Index count) {
    DisjointSets sets(2 * std::size_t(count));
    for (const Sides& edge : sides) {
        if (!edge.pair()) continue;
        const Index f = edge.first.facet(), g = edge.last.facet();
        const bool agree = edge.first.forward() != edge.last.forward();
        const Index with = agree ? g : g + count, against = agree ? g + count : g;
        if (sets.name(f) == sets.name(against)) continue;  // not orientable: the cycle cannot agree
        sets.join(f, with);
        sets.join(f + count, against);
    }
    return sets;
}

/// A connected component.
struct Part {
    bool closed = true;
    double volume = 0.0;
    Index polygons = 0, turned = 0;
};

}  // namespace

Index orient(RepairedMesh& mesh) {
    const auto count = static_cast<Index>(mesh.polygon_offsets.size() - 1);
    const std::vector<Sides> sides = sides_of(mesh);
    DisjointSets sets = together(sides, count);
    // A component is named by its lowest polygon; is_turned: whether a polygon must be flipped relative to that one.
    const auto part_of = [&](Index f) { return std::min(sets.name(f), sets.name(f + count)); };
    const auto is_turned = [&](Index f) { return sets.name(f) != part_of(f); };
    std::vector<Part> parts(count);
    for (Index f = 0; f < count; ++f) {
        if (mesh.polygon_offsets[f] == mesh.polygon_offsets[f + 1]) continue;  // no corners: no orientation
        const Index name = part_of(f);
        const dvec3 origin(mesh.positions[mesh.corner_verts[mesh.polygon_offsets[name]]]);
        Part& part = parts[name];
        for (int c = mesh.polygon_offsets[f]; c < mesh.polygon_offsets[f + 1]; ++c)
            part.closed = part.closed && sides[mesh.corner_edges[c]].pair();
        part.volume += (is_turned(f) ? -1.0 : 1.0) * volume(mesh, f, origin);
        part.turned += is_turned(f);
        ++part.polygons;
    }
    Array<std::uint8_t> turned(count, 0);
    for (Index f = 0; f < count; ++f) {
        // Closed: outwards. Open: as the majority is already.
        const Part& part = parts[part_of(f)];
        const bool all_over = part.closed ? part.volume < 0.0 : 2 * part.turned > part.polygons;
        turned[f] = is_turned(f) != all_over;
    }
    for (Index f = 0; f < count; ++f)
        if (turned[f]) turn(mesh, f);
    for (std::size_t t = 0; t < mesh.ngon_triangles.size(); ++t)
        if (turned[mesh.ngon_polygon[t]]) std::swap(mesh.ngon_triangles[t].y, mesh.ngon_triangles[t].z);
    return static_cast<Index>(std::count(turned.begin(), turned.end(), 1));
}

}  // namespace fovea::repair
