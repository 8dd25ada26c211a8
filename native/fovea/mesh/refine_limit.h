// SPDX-License-Identifier: GPL-3.0-or-later
// The limit surface of a cage at the vertices of its refined mesh.
#pragma once

#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTable.h>

#include <fovea/mesh/bicubic.h>
#include <fovea/mesh/refine_mesh.h>

namespace fovea::mesh {

/// Patches of the limit surface, with the places of vertices in them; the places stay when the cage moves.
class LimitPatches {
   public:
    /// Takes the cage, whose topology `uniform` shares, and refines it near features.
    LimitPatches(Cage cage, const Far::TopologyRefiner& uniform, const std::vector<Cell>& cells);

    /// Throws std::invalid_argument for another number of vertices than the cage's.
    void evaluate(const std::string& name, In<vec3> cage_positions);

    std::vector<vec3> positions;  ///< per vertex of the refined mesh
    Array<HeightJet> jets;        ///< the same; taken away by whoever wants them

   private:
    /// What OpenSubdiv interpolates.
    struct Point {
        dvec3 p;
        void Clear() { p = dvec3(0.0); }
        void AddWithWeight(const Point& other, double weight) { p += weight * other.p; }
    };
    /// Where a vertex, or what stands for it, lies: in a patch, over [0,1]^2. `weight` counts quads around the vertex.
    struct Place {
        Index patch = none;
        float u = 0, v = 0, weight = 1;
        bool same(const Place& other) const { return patch == other.patch && u == other.u && v == other.v; }
    };

    void build_patches(int level);
    Place find(const Far::PatchMap& map, int face, const dvec2& at, const dvec2& towards);
    void add_places(const Far::PatchMap& map, const Far::TopologyLevel& fine, const std::vector<Cell>& cells, int v);
    bool is_bicubic(Index patch) const;
    void evaluate_patches();
    dvec3 by_basis(const Place& place, ParametricJet& jet) const;
    dvec3 point(const Place& place, ParametricJet& jet) const;
    void evaluate_vertex(Index v);

    Cage cage_;  // refined near features
    std::unique_ptr<Far::PatchTable> table_;
    std::vector<Far::PatchTable::PatchHandle> handles_;  // of the patches in use
    Array<Index> patch_number_;                          // of a patch of the table among them
    std::vector<Point> points_;                          // of all levels, then of the patches
    std::vector<Bicubic> bicubic_;                       // per patch in use; void where it is not bicubic
    Array<Place> anchors_;                               // per vertex: position and normal
    Rows shape_rows_;
    Array<Place> shapes_;  // per vertex: second and third derivatives
};

}  // namespace fovea::mesh
