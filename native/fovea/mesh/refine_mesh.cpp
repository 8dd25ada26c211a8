// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/mesh/refine_mesh.h>

#include <opensubdiv/far/ptexIndices.h>

#include <fovea/base/parallel.h>

namespace fovea::mesh {
namespace {

/// Pairs of an edge (finally of the finest level) and the cage edge that it descends from.
using Descent = std::vector<std::pair<int, int>>;

Descent descendants(const Far::TopologyRefiner& uniform, Descent edges) {
    for (int l = 0; l < uniform.GetMaxLevel(); ++l) {
        Descent finer;
        for (const auto& [edge, origin] : edges)
            for (int child : uniform.GetLevel(l).GetEdgeChildEdges(edge)) finer.emplace_back(child, origin);
        edges = std::move(finer);
    }
    return edges;
}

void take_topology(const Far::TopologyLevel& fine, OwnedMesh& out) {
    const int quads = fine.GetNumFaces();
    out.corner_verts.resize(4 * std::size_t(quads));
    out.corner_edges.resize(4 * std::size_t(quads));
    out.polygon_offsets.resize(std::size_t(quads) + 1);
    parallel_for(quads + 1, [&](std::size_t f) { out.polygon_offsets[f] = static_cast<int>(4 * f); });
    parallel_for(quads, [&](std::size_t f) {
        const auto verts = fine.GetFaceVertices(int(f)), edges = fine.GetFaceEdges(int(f));
        for (int i = 0; i < 4; ++i) {
            out.corner_verts[4 * f + i] = verts[i];
            out.corner_edges[4 * f + i] = edges[i];
        }
    });
    out.edge_verts.resize(fine.GetNumEdges());
    parallel_for(out.edge_verts.size(), [&](std::size_t e) {
        const auto verts = fine.GetEdgeVertices(int(e));
        out.edge_verts[e] = {verts[0], verts[1]};
    });
}

void take_edge_marks(const Far::TopologyRefiner& uniform, const Cage& cage, const MeshArrays& mesh, OwnedMesh& out) {
    Descent marked;
    const auto has = [](In<std::uint8_t> flags, std::size_t e) { return !flags.empty() && flags[e]; };
    for (std::size_t e = 0; e < mesh.edge_verts.size(); ++e) {
        if (!has(mesh.sharp, e) && !has(mesh.seam, e) && !has(mesh.edge_mark, e)) continue;
        const Index a = cage.number[mesh.edge_verts[e].x], b = cage.number[mesh.edge_verts[e].y];
        const int edge = a == none || b == none ? -1 : uniform.GetLevel(0).FindEdge(int(a), int(b));
        if (edge >= 0) marked.emplace_back(edge, int(e));
    }
    marked = descendants(uniform, std::move(marked));
    const auto per_edge = [&](In<std::uint8_t> given, std::vector<std::uint8_t>& flags) {
        if (given.empty()) return;
        flags.assign(out.edge_verts.size(), 0);
        for (const auto& [edge, origin] : marked) flags[edge] = given[origin];
    };
    per_edge(mesh.sharp, out.sharp);
    per_edge(mesh.seam, out.seam);
    per_edge(mesh.edge_mark, out.edge_mark);
    out.smooth.assign(out.edge_verts.size(), 1);  // the limit surface is, whatever the shading of the cage
    for (std::size_t e = 0; e < out.sharp.size(); ++e)
        if (out.sharp[e]) out.smooth[e] = 0;
}

}  // namespace

Cell Cell::child(int i, int corners) const {
    if (corners != 4) return {.polygon = polygon, .face = face + i};
    const double half = 0.5 * size;
    return {polygon, face, u + (i == 1 || i == 2 ? half : 0.0), v + (i >= 2 ? half : 0.0), half};
}

std::vector<Cell> cells_of(const Far::TopologyRefiner& uniform) {
    const Far::PtexIndices faces(uniform);
    std::vector<Cell> cells(uniform.GetLevel(0).GetNumFaces());
    for (std::size_t f = 0; f < cells.size(); ++f) cells[f] = {.polygon = int(f), .face = faces.GetFaceId(int(f))};
    for (int l = 0; l < uniform.GetMaxLevel(); ++l) {
        const Far::TopologyLevel& level = uniform.GetLevel(l);
        std::vector<Cell> finer(uniform.GetLevel(l + 1).GetNumFaces());
        parallel_for(cells.size(), [&](std::size_t f) {
            const auto children = level.GetFaceChildFaces(int(f));
            for (int i = 0; i < children.size(); ++i) finer[children[i]] = cells[f].child(i, children.size());
        });
        cells = std::move(finer);
    }
    return cells;
}

OwnedMesh refined_mesh(const Far::TopologyRefiner& uniform, const std::vector<Cell>& cells, const Cage& cage,
                       const MeshArrays& mesh) {
    OwnedMesh out;
    take_topology(uniform.GetLevel(uniform.GetMaxLevel()), out);
    const auto per_polygon = [&](const auto& given, auto& values) {
        if (given.empty()) return;
        values.resize(cells.size());
        parallel_for(cells.size(), [&](std::size_t f) { values[f] = given[cells[f].polygon]; });
    };
    per_polygon(mesh.material, out.material);
    per_polygon(mesh.occluding, out.occluding);
    per_polygon(mesh.one_sided, out.one_sided);
    take_edge_marks(uniform, cage, mesh, out);
    return out;
}

}  // namespace fovea::mesh
