// SPDX-License-Identifier: GPL-3.0-or-later
// Depth pass: the plane of the surface over the image, and its triangle's packed edges (shared/edges.glsl).
void main()
{
  // gl_FragCoord.w is 1 / w, linear on the screen; so is depth, which thereby keeps its precision far away.
  float depth = depth_w * gl_FragCoord.w;
  texel = vec4(depth, dFdx(depth) * buffer_scale, dFdy(depth) * buffer_scale, facet_number);
  // Barycentric coordinates times 1 / w, linear on the screen, too: each is 0 on the edge opposite to its corner.
  vec3 inside = corner_share * gl_FragCoord.w;
  vec3 right = dFdx(inside), up = dFdy(inside);
  int a = edge_code_of(inside.x, vec2(right.x, up.x));
  int b = edge_code_of(inside.y, vec2(right.y, up.y));
  int c = edge_code_of(inside.z, vec2(right.z, up.z));
  edges = pack_edges(a, b, c);
#ifdef SECTION
  if (before_section > 0.0) {
    discard;
  }
#endif
#ifdef WRITES_DEPTH
  gl_FragDepth = depth;
#endif
}
