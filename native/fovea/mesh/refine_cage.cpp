// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/mesh/refine_cage.h>

#include <algorithm>
#include <cmath>
#include <opensubdiv/far/topologyDescriptor.h>

#include <fovea/base/check.h>

namespace fovea::mesh {
namespace {

using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
constexpr double most_quads = 1 << 28;

/// Blender's crease weight converted to OpenSubdiv's sharpness; infinite above the isolation depth.
float sharpness_of(float weight, int level) {
    const float sharpness = 10.0f * weight * weight;
    return sharpness > float(level + crease_isolation) ? Sdc::Crease::SHARPNESS_INFINITE : sharpness;
}

void check_levels(const std::string& name, const MeshArrays& mesh, int level) {
    check(level >= 1 && level <= Refinement::most_levels,
          name + ": refined by " + std::to_string(level) + " levels; 1 to 7 are possible");
    check(double(mesh.corner_verts.size()) * std::ldexp(1.0, 2 * (level - 1)) < most_quads,
          name + ": refined by " + std::to_string(level) + " levels it has too many faces; choose fewer levels");
}

/// Non-manifold elements, which only OpenSubdiv's topology reveals.
void check_manifold(const std::string& name, const Far::TopologyLevel& base) {
    int edges = 0, vertices = 0;
    for (int e = 0; e < base.GetNumEdges(); ++e) edges += base.IsEdgeNonManifold(e);
    for (int v = 0; v < base.GetNumVertices(); ++v) vertices += base.IsVertexNonManifold(v);
    check(edges == 0,
          name + ": " + std::to_string(edges) +
              " edges lie between more than two faces, or between faces "
              "that disagree about which side is out, so it has no limit surface (Mesh > Normals > Recalculate "
              "Outside, or Select > All by Trait > Non Manifold shows them)");
    check(vertices == 0, name + ": in " + std::to_string(vertices) +
                             " vertices surfaces only touch, so it has no "
                             "limit surface (Select > All by Trait > Non Manifold shows them)");
}

/// The cage's arrays, which OpenSubdiv's descriptor borrows.
struct Description {
    std::vector<int> sizes, corners, crease_pairs, sharp_vertices;
    std::vector<float> creases, vertex_sharpness;

    Far::TopologyDescriptor borrowed(Index vertices) const {
        Far::TopologyDescriptor descriptor;
        descriptor.numVertices = static_cast<int>(vertices);
        descriptor.numFaces = static_cast<int>(sizes.size());
        descriptor.numVertsPerFace = sizes.data();
        descriptor.vertIndicesPerFace = corners.data();
        descriptor.numCreases = static_cast<int>(creases.size());
        descriptor.creaseVertexIndexPairs = crease_pairs.data();
        descriptor.creaseWeights = creases.data();
        descriptor.numCorners = static_cast<int>(sharp_vertices.size());
        descriptor.cornerVertexIndices = sharp_vertices.data();
        descriptor.cornerWeights = vertex_sharpness.data();
        return descriptor;
    }
};

/// Numbers the vertices of polygons by first appearance; returns how many there are.
Index take_polygons(const std::string& name, const MeshArrays& mesh, Array<Index>& number, Description& out) {
    number.assign(mesh.positions.size(), none);
    Index used = 0;
    std::vector<int> sorted;
    for (std::size_t f = 0; f + 1 < mesh.polygon_offsets.size(); ++f) {
        const int begin = mesh.polygon_offsets[f], size = mesh.polygon_offsets[f + 1] - begin;
        const auto polygon = mesh.corner_verts.subspan(begin, size);
        sorted.assign(polygon.begin(), polygon.end());
        std::sort(sorted.begin(), sorted.end());
        check(size >= 3 && std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end(),
              name + ": a face has a vertex twice, so it has no limit surface (Mesh > Clean Up mends it)");
        out.sizes.push_back(size);
        for (int v : polygon) {
            if (number[v] == none) number[v] = used++;
            out.corners.push_back(static_cast<int>(number[v]));
        }
    }
    return used;
}

void take_creases(const MeshArrays& mesh, const Refinement& refinement, const Array<Index>& number, Description& out) {
    for (std::size_t e = 0; e < refinement.edge_crease.size(); ++e) {
        const Index a = number[mesh.edge_verts[e].x], b = number[mesh.edge_verts[e].y];
        if (!(refinement.edge_crease[e] > 0.0f) || a == none || b == none) continue;
        out.crease_pairs.insert(out.crease_pairs.end(), {int(a), int(b)});
        out.creases.push_back(sharpness_of(refinement.edge_crease[e], refinement.level));
    }
    for (std::size_t v = 0; v < refinement.vertex_crease.size(); ++v) {
        if (!(refinement.vertex_crease[v] > 0.0f) || number[v] == none) continue;
        out.sharp_vertices.push_back(static_cast<int>(number[v]));
        out.vertex_sharpness.push_back(sharpness_of(refinement.vertex_crease[v], refinement.level));
    }
}

}  // namespace

Cage cage_of(const std::string& name, const MeshArrays& mesh, const Refinement& refinement) {
    check_mesh(name, mesh);
    check_levels(name, mesh, refinement.level);
    const auto fits = [](In<float> creases, std::size_t count) { return creases.empty() || creases.size() == count; };
    check(fits(refinement.edge_crease, mesh.edge_verts.size()) && fits(refinement.vertex_crease, mesh.positions.size()),
          name + ": creases and edges or vertices differ in number; give one for each, or none");
    Cage cage;
    Description description;
    const Index vertices = take_polygons(name, mesh, cage.number, description);
    take_creases(mesh, refinement, cage.number, description);
    check(vertices > 0, name + ": it has no faces to refine; give it some, or remove its Subdivision Surface");

    Sdc::Options options;
    options.SetVtxBoundaryInterpolation(refinement.round_corners ? Sdc::Options::VTX_BOUNDARY_EDGE_ONLY
                                                                 : Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    cage.refiner.reset(Factory::Create(description.borrowed(vertices), Factory::Options(Sdc::SCHEME_CATMARK, options)));
    check(cage.refiner != nullptr, name + ": it has no limit surface (Mesh > Clean Up may mend it)");
    check_manifold(name, cage.refiner->GetLevel(0));
    return cage;
}

std::unique_ptr<Far::TopologyRefiner> shared(const Cage& cage) {
    return std::unique_ptr<Far::TopologyRefiner>(Factory::Create(*cage.refiner));
}

}  // namespace fovea::mesh
