// A lattice cut into triangles: where curves cross its sides.
#pragma once

#include "image/lattice.h"

namespace fovea {

/// Each square of four nodes is two triangles. A side is numbered by its first node, the lower or left one.
struct LatticeTriangle {
    Index number;
    Index node[3];
    Index side[3];  ///< from node i to node i + 1
    bool upper;     ///< above the diagonal, else below it

    /// Slopes, per step, of the linear function with these values at the nodes.
    vec2 slope(float a, float b, float c) const { return upper ? vec2(b - c, c - a) : vec2(b - a, c - b); }
};

/// `upper` 0 or 1: the triangle of the square whose lower left node is (x, y).
inline LatticeTriangle lattice_triangle(const Lattice& lattice, int x, int y, int upper) {
    const Index n = static_cast<Index>(lattice.at(x, y)), w = static_cast<Index>(lattice.width);
    // Sides from a node: 3n to the right, 3n + 1 upwards, 3n + 2 the diagonal.
    if (upper) return {2 * n + 1, {n, n + w + 1, n + w}, {3 * n + 2, 3 * (n + w), 3 * n + 1}, true};
    return {2 * n, {n, n + 1, n + w + 1}, {3 * n, 3 * (n + 1) + 1, 3 * n + 2}, false};
}

/// Nodes of a side, the first one first.
struct LatticeSide {
    Index a, b;
};
inline LatticeSide lattice_side(const Lattice& lattice, Index side) {
    const Index n = side / 3, w = static_cast<Index>(lattice.width);
    return {n, side % 3 == 0 ? n + 1 : side % 3 == 1 ? n + w : n + w + 1};
}

/// Place of a node in the lattice.
inline vec2 lattice_place(const Lattice& lattice, Index node) {
    return vec2(float(node % lattice.width), float(node / lattice.width));
}

}  // namespace fovea
