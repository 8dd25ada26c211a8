// SPDX-License-Identifier: GPL-3.0-or-later
// Edges of the triangle in two numbers: native/fovea/visibility/triangle_edges.h. Change both.

// `inside`: any linear function that is 0 on the edge and grows inwards.
int edge_code(float inside, vec2 slope)
{
  float size = abs(slope.x) + abs(slope.y);
  if (!(size > 0.0)) {
    return 255;
  }
  float x = slope.x / size;
  float turn = slope.y < 0.0 ? 3.0 + x : 1.0 - x;
  return int(turn * 64.0 + 0.5) % 256 * 256 + int(clamp(inside / size, 0.0, 1.0) * 255.0 + 0.5);
}

void main()
{
  // gl_FragCoord.w is 1 / w, linear on the screen: so is depth, and it keeps its precision far away.
  float depth = depth_w * gl_FragCoord.w;
  texel = vec4(depth, dFdx(depth) * buffer_scale, dFdy(depth) * buffer_scale, facet_number);
  // Shares of the corners, made linear on the screen, too: each is 0 on the edge opposite to its corner.
  vec3 inside = corner_share * gl_FragCoord.w;
  vec3 right = dFdx(inside), up = dFdy(inside);
  int a = edge_code(inside.x, vec2(right.x, up.x));
  int b = edge_code(inside.y, vec2(right.y, up.y));
  int c = edge_code(inside.z, vec2(right.z, up.z));
  edges = vec2(float(a * 256 + c / 256), float(b * 256 + c % 256));
#ifdef WRITES_DEPTH
  gl_FragDepth = depth;
#endif
}
