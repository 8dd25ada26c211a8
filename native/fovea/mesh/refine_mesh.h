// SPDX-License-Identifier: GPL-3.0-or-later
// The refined mesh of a cage: all quads, with their parameters in the cage's faces.
#pragma once

#include <fovea/mesh/refine_cage.h>

namespace fovea::mesh {

/// One quad of the refined mesh as a square in the parameters of its cage face (of the sub-face at one corner if the
/// face is not a quad).
struct Cell {
    int polygon = 0;  ///< of the cage
    int face = 0;     ///< in OpenSubdiv's (ptex) numbering, where a non-quad face counts once per corner
    double u = 0, v = 0, size = 1;

    dvec2 corner(int i) const { return {u + (i == 1 || i == 2 ? size : 0.0), v + (i >= 2 ? size : 0.0)}; }
    dvec2 middle() const { return {u + 0.5 * size, v + 0.5 * size}; }
    /// The sub-cell at corner i after one more subdivision of a face with `corners` corners.
    Cell child(int i, int corners) const;
};

/// Cells of the finest level of a uniform refinement, and the refined mesh without positions.
std::vector<Cell> cells_of(const Far::TopologyRefiner& uniform);
OwnedMesh refined_mesh(const Far::TopologyRefiner& uniform, const std::vector<Cell>& cells, const Cage& cage,
                       const MeshArrays& mesh);

}  // namespace fovea::mesh
