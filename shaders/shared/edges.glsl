// SPDX-License-Identifier: GPL-3.0-or-later
// Quantized edge equations of a texel's triangle near the texel's center (native/fovea/visibility/triangle_edges.h).
// Also compiled as C++, as members of a struct.

// An edge in 16 bits: 256 directions, evenly spread over the diamond |x| + |y| = 1, times 256 + the distance in [0, 1]
// in 1/255. `along`: the code at distance 0.
int edge_code(int along, float inside)
{
  return along + int(clamp(inside, 0.0f, 1.0f) * 255.0f + 0.5f);
}

// `inside`: any linear function that is 0 on the edge and positive inside; `slope`: its gradient. Without a gradient,
// or with one beyond all numbers, the edge excludes nothing.
int edge_code_of(float inside, vec2 slope)
{
  float size = abs(slope.x) + abs(slope.y);
  if (!(size > 0.0f && size < 1e37f)) {
    return 255;
  }
  float x = slope.x / size;
  float turn = slope.y < 0.0f ? 3.0f + x : 1.0f - x;
  return edge_code(int(turn * 64.0f + 0.5f) % 256 * 256, inside / size);
}

// Packs a triangle's three edges into two integers below 2^24, which floats hold exactly: the third is split between
// them.
vec2 pack_edges(int a, int b, int c)
{
  return vec2(float(a * 256 + c / 256), float(b * 256 + c % 256));
}

// (distance, normal) of an edge from its code: (x, y) texels from the center lie inside where distance + normal . (x,
// y) >= 0, |normal.x| + |normal.y| = 1.
vec3 edge_of_code(int code)
{
  float turn = float(code / 256) / 64.0f;
  float x = abs(turn - 2.0f) - 1.0f;
  return vec3(float(code % 256) / 255.0f, x, turn < 2.0f ? 1.0f - abs(turn - 1.0f) : abs(turn - 3.0f) - 1.0f);
}

bool edge_holds(int code, vec2 off)
{
  vec3 edge = edge_of_code(code);
  return edge.x + edge.y * off.x + edge.z * off.y >= 0.0f;
}

// Whether the point `off` texels from the center lies inside all three edges.
bool packed_edges_hold(vec2 packed_edges, vec2 off)
{
  int a = int(packed_edges.x), b = int(packed_edges.y);
  return edge_holds(a / 256, off) && edge_holds(b / 256, off) && edge_holds(a % 256 * 256 + b % 256, off);
}
