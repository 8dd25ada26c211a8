// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulation of a lattice, for tracing curves across it.
#pragma once

#include <cmath>

#include <fovea/image/lattice.h>

namespace fovea::image {

/// Each square of four nodes is split into two triangles. A side is numbered by its first node, the lower or left one.
struct LatticeTriangle {
    Index number;
    Index node[3];
    Index side[3];  ///< from node i to node i + 1
    bool upper;     ///< above the diagonal, else below it

    /// Gradient, per step, of the linear interpolant of values at the nodes.
    vec2 slope(float a, float b, float c) const { return upper ? vec2(b - c, c - a) : vec2(b - a, c - b); }
};

/// `upper` 0 or 1: the triangle of the square whose lower left node is (x, y).
inline LatticeTriangle lattice_triangle(const Lattice& lattice, int x, int y, int upper) {
    const Index n = static_cast<Index>(lattice.at(x, y)), w = static_cast<Index>(lattice.width);
    // Sides from a node: 3n to the right, 3n + 1 upwards, 3n + 2 the diagonal.
    if (upper) return {2 * n + 1, {n, n + w + 1, n + w}, {3 * n + 2, 3 * (n + w), 3 * n + 1}, true};
    return {2 * n, {n, n + 1, n + w + 1}, {3 * n, 3 * (n + 1) + 1, 3 * n + 2}, false};
}

/// Nodes of a side, and the nodes before and after them on the same line.
struct LatticeSide {
    Index before, a, b, after;
};
inline LatticeSide lattice_side(const Lattice& lattice, Index side) {
    const Index n = side / 3, w = static_cast<Index>(lattice.width);
    const Index step = side % 3 == 0 ? 1 : side % 3 == 1 ? w : w + 1;
    return {n - step, n, n + step, n + 2 * step};
}

/// Zero crossing, as a fraction from a (0) to b (1), of the cubic through the values at the four nodes of a side. The
/// values at a and b must differ in sign.
inline float zero_on_side(float before, float a, float b, float after) {
    float low = 0.0f, high = 1.0f, t = a / (a - b);
    for (int step = 0; step < 6; ++step) {
        // Lagrange form with nodes at -1, 0, 1 and 2.
        const float p = t + 1.0f, q = t - 1.0f, r = t - 2.0f;
        const float value = (after * p * t * q - before * t * q * r) / 6.0f + (a * p * q * r - b * p * t * r) / 2.0f;
        if (!std::isfinite(value)) return a / (a - b);
        ((value >= 0.0f) == (a >= 0.0f) ? low : high) = t;
        // Newton step with the chord's slope; bisection if it leaves the bracket.
        const float next = t - value / (b - a);
        t = next >= low && next <= high ? next : 0.5f * (low + high);
    }
    return t;
}

/// Lattice coordinates of a node.
inline vec2 lattice_place(const Lattice& lattice, Index node) {
    return vec2(float(node % lattice.width), float(node / lattice.width));
}

}  // namespace fovea::image
