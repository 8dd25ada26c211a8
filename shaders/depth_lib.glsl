// SPDX-License-Identifier: GPL-3.0-or-later
// Access to the depth buffer and to lines, as required by shared/depth.glsl. Facet numbers are exact in floats.

struct Line {
  vec2 facets;
  float steepness;
};

int depth_shows(ivec2 place, Line line)
{
  float facet = texelFetch(depth_buffer, place, 0).w;
  return facet < 0.0 ? -1 : facet == line.facets.x || facet == line.facets.y ? 1 : 0;
}

vec3 depth_plane(ivec2 place)
{
  return texelFetch(depth_buffer, place, 0).xyz;
}

vec2 depth_edges(ivec2 place)
{
  return texelFetch(edge_buffer, place, 0).xy;
}

ivec2 depth_size()
{
  return textureSize(depth_buffer, 0);
}
