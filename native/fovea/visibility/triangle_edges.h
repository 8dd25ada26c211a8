// SPDX-License-Identifier: GPL-3.0-or-later
// Where a texel's triangle ends, near the texel: what tells on which side of an occluder's edge a probe lies.
#pragma once

#include <algorithm>
#include <cmath>

#include <fovea/base/types.h>

namespace fovea {

/// A triangle's edge beside a texel: (x, y) texels from its centre lie inside where inside + nx x + ny y >= 0;
/// |nx| + |ny| = 1, so that an edge with inside >= 1 cuts nothing off within a texel of the centre.
struct TexelEdge {
    float inside = 1.0f, nx = 1.0f, ny = 0.0f;
};

/// An edge in 16 bits: 256 directions, evenly spread over the diamond |nx| + |ny| = 1, times 256 + the distance in
/// [0, 1] in 1/255. It errs by at most 1/64 + 1/510 texel. Where a line has no direction, the edge cuts nothing off.
/// `along`: what the code is at distance 0; with `inside` in the measure of |nx| + |ny| = 1.
inline int edge_code(int along, float inside) { return along + int(std::clamp(inside, 0.0f, 1.0f) * 255.0f + 0.5f); }

inline int edge_code(TexelEdge edge) {
    const float length = std::abs(edge.nx) + std::abs(edge.ny);
    if (!(length > 0.0f)) return 255;
    const float x = edge.nx / length;
    const float turn = edge.ny < 0.0f ? 3.0f + x : 1.0f - x;
    return edge_code(int(turn * 64.0f + 0.5f) % 256 * 256, edge.inside / length);
}

inline TexelEdge edge_of_code(int code) {
    const float turn = float(code / 256) / 64.0f;
    const float x = std::abs(turn - 2.0f) - 1.0f;
    return {float(code % 256) / 255.0f, x, turn < 2.0f ? 1.0f - std::abs(turn - 1.0f) : std::abs(turn - 3.0f) - 1.0f};
}

/// The three edges of a triangle in two integers below 2^24, which floats hold exactly: the third is shared out.
inline vec2 pack_edges(int a, int b, int c) { return {float(a * 256 + c / 256), float(b * 256 + c % 256)}; }

/// True where (x, y) texels from the centre lie inside all three.
inline bool edges_hold(vec2 packed, vec2 off) {
    const int a = int(packed.x), b = int(packed.y);
    for (const int code : {a / 256, b / 256, a % 256 * 256 + b % 256}) {
        const TexelEdge edge = edge_of_code(code);
        if (edge.inside + edge.nx * off.x + edge.ny * off.y < 0.0f) return false;
    }
    return true;
}

}  // namespace fovea
