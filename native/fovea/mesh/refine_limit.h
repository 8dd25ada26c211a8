// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluates the limit surface of a cage at the vertices of its refined mesh.
#pragma once

#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTable.h>

#include <fovea/mesh/bicubic.h>
#include <fovea/mesh/refine_mesh.h>

namespace fovea::mesh {

/// Patches of the limit surface, and the patch parameters of the refined vertices, which do not change when the cage
/// moves.
class LimitPatches {
   public:
    /// Takes ownership of the cage, whose topology `uniform` shares, and refines it adaptively near features.
    LimitPatches(Cage cage, const Far::TopologyRefiner& uniform, const std::vector<Cell>& cells);

    /// Evaluates positions and jets. Throws std::invalid_argument if the number of positions is not that of the cage's
    /// vertices.
    void evaluate(const std::string& name, In<vec3> cage_positions);

    std::vector<vec3> positions;  ///< per vertex of the refined mesh
    Array<HeightJet> jets;        ///< per vertex of the refined mesh; may be moved out by the caller

   private:
    /// The type that OpenSubdiv interpolates.
    struct Point {
        dvec3 p;
        void Clear() { p = dvec3(0.0); }
        void AddWithWeight(const Point& other, double weight) { p += weight * other.p; }
    };
    /// Parameters of a sample: a patch and (u, v) in [0,1]^2. `weight`: how many quads around the vertex share this
    /// sample.
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

    Cage cage_;  // refined adaptively near features
    std::unique_ptr<Far::PatchTable> table_;
    std::vector<Far::PatchTable::PatchHandle> handles_;  // patches in use
    Array<Index> patch_number_;                          // per patch of the table: its index in handles_, or `none`
    std::vector<Point> points_;                          // of all refinement levels, then local points of patches
    std::vector<Bicubic> bicubic_;                       // per patch in use; unset where it is not bicubic
    Array<Place> anchors_;                               // per vertex: where position and normal are evaluated
    Rows shape_rows_;
    Array<Place> shapes_;  // per vertex (rows shape_rows_): where second and third derivatives are
};

}  // namespace fovea::mesh
