// SPDX-License-Identifier: GPL-3.0-or-later
// The refined mesh of a cage: all quads, and where in the cage's faces they lie.
#pragma once

#include <fovea/mesh/refine_cage.h>

namespace fovea::mesh {

/// One quad of the refined mesh in the parameters of the cage's face (or the part of it at one corner, where the face
/// is no quad).
struct Cell {
    int polygon = 0;  ///< of the cage
    int face = 0;     ///< in OpenSubdiv's numbering, where a face that is no quad counts once per corner
    double u = 0, v = 0, size = 1;

    dvec2 corner(int i) const { return {u + (i == 1 || i == 2 ? size : 0.0), v + (i >= 2 ? size : 0.0)}; }
    dvec2 middle() const { return {u + 0.5 * size, v + 0.5 * size}; }
    /// The one at corner i when a face of so many corners is divided once more.
    Cell child(int i, int corners) const;
};

/// Of the finest level of a uniform refinement; the mesh without positions.
std::vector<Cell> cells_of(const Far::TopologyRefiner& uniform);
OwnedMesh refined_mesh(const Far::TopologyRefiner& uniform, const std::vector<Cell>& cells, const Cage& cage,
                       const MeshArrays& mesh);

}  // namespace fovea::mesh
