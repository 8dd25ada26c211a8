// SPDX-License-Identifier: GPL-3.0-or-later
// Quantized edge equations of the triangle that covers a texel: on which side of an occluder's edge a probe lies.
#pragma once

#include <fovea/base/types.h>

namespace fovea {

/// A triangle's edge beside a texel: (x, y) texels from its centre lie inside where inside + nx x + ny y >= 0;
/// |nx| + |ny| = 1, so that an edge with inside >= 1 cuts nothing off within a texel of the centre.
struct TexelEdge {
    float inside = 1.0f, nx = 1.0f, ny = 0.0f;
};

namespace formulas {

using namespace glm;

struct Edges {
#include <shared/edges.glsl>
};

}  // namespace formulas

/// An edge in 16 bits. It errs by at most 1/64 + 1/510 texel. `along`: what the code is at distance 0; `inside` in the
/// measure of |nx| + |ny| = 1.
inline int edge_code(int along, float inside) { return formulas::Edges().edge_code(along, inside); }

inline int edge_code(TexelEdge edge) { return formulas::Edges().edge_code_of(edge.inside, {edge.nx, edge.ny}); }

inline TexelEdge edge_of_code(int code) {
    const vec3 edge = formulas::Edges().edge_of_code(code);
    return {edge.x, edge.y, edge.z};
}

/// The three edges of a triangle in two integers below 2^24, which floats hold exactly.
inline vec2 pack_edges(int a, int b, int c) { return formulas::Edges().pack_edges(a, b, c); }

/// True where (x, y) texels from the centre lie inside all three.
inline bool edges_hold(vec2 packed, vec2 off) { return formulas::Edges().packed_edges_hold(packed, off); }

}  // namespace fovea
