// SPDX-License-Identifier: GPL-3.0-or-later
// Depth pass: depth of occluders (native/fovea/visibility/depth.h).
void main()
{
  // (x w, y w, depth w, w): depth is 1 at the near plane, where clipping cuts, and falls to 0; there is no far plane.
  gl_Position = object_to_depth_clip * vec4(position, 1.0);
  depth_w = gl_Position.z;
#ifdef SECTION
  before_section = dot(section, vec4(position, 1.0));
#endif
  // Three vertices per triangle; triangles share none.
  int corner = gl_VertexID % 3;
  corner_share = vec3(corner == 0, corner == 1, corner == 2);
  // Modulo 2^24, so that a float holds it exactly.
  facet_number = float((int(facet) + facet_base) & 0xFFFFFF);
}
